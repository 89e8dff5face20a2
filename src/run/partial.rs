//! Results of work that did not come to its end, marked as such inside every file.

use thiserror::Error;

/// Why results are not complete, and how far they go.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
#[error("PARTIAL: {why}, {finished} of {of} results are finished")]
pub struct Partial {
    /// What ended the work, such as `interrupted by SIGTERM`.
    pub why: String,
    /// Results that are finished.
    pub finished: usize,
    /// Results that were to be.
    pub of: usize,
}

/// What the last line of a partial CSV begins with.
pub const PARTIAL_MARK: &str = "# PARTIAL";

impl Partial {
    /// The text of a CSV with a last line that says so in its first cell; the others are empty.
    pub fn mark_csv(&self, csv: &str) -> String {
        let heading = csv.lines().next().unwrap_or_default();
        format!("{csv}{}", self.csv_line(heading.matches(',').count()))
    }

    /// The line that a partial CSV ends with, so many commas long.
    pub fn csv_line(&self, commas: usize) -> String {
        // Quoted: the words hold commas.
        let words = self.to_string().replace('"', "'");
        format!("\"# {words}\"{}\n", ",".repeat(commas))
    }
}

/// A title, behind the words that say that what it stands above is partial.
pub fn titled(title: &str, partial: Option<&Partial>) -> String {
    match partial {
        Some(partial) => format!("{partial}. {title}"),
        None => title.to_owned(),
    }
}

/// A CSV, with a last line that says so where it is partial.
pub fn marked(csv: String, partial: Option<&Partial>) -> String {
    match partial {
        Some(partial) => partial.mark_csv(&csv),
        None => csv,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_marked_csv_has_one_more_line_of_as_many_cells() {
        let partial = Partial {
            why: "interrupted by SIGTERM".to_owned(),
            finished: 1,
            of: 2,
        };
        let text = partial.mark_csv("a,b,c\n1,2,3\n");
        let mut reader = csv::Reader::from_reader(text.as_bytes());
        let rows: Vec<csv::StringRecord> = reader.records().map(Result::unwrap).collect();
        let words = "# PARTIAL: interrupted by SIGTERM, 1 of 2 results are finished";
        assert_eq!(&rows[1], vec![words, "", ""].as_slice());
        assert!(words.starts_with(PARTIAL_MARK));
    }
}
