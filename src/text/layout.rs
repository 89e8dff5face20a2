//! How text is laid out on a screen: its width, its colours, wrapped words.

use std::fmt::Display;

use anstyle::Style;

use super::wrap::lines;

/// Least width that text is laid out for, columns.
pub const LEAST_WIDTH: usize = 80;

/// Where text for people goes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Layout {
    /// Columns of the screen; `None` where lines may be of any length, as in a pipe or a file.
    pub width: Option<usize>,
    /// Whether verdicts are coloured.
    pub colours: bool,
}

impl Layout {
    /// The width, where there is one: [`LEAST_WIDTH`] at least.
    pub fn columns(self) -> Option<usize> {
        self.width.map(|width| width.max(LEAST_WIDTH))
    }

    /// Text in this style, where there are colours.
    pub fn painted(self, text: impl Display, style: Style) -> String {
        if self.colours && style != Style::new() {
            format!("{style}{text}{style:#}")
        } else {
            text.to_string()
        }
    }

    /// Words behind a lead: wrapped, where there is a width, with every further line below the first
    /// word. The lead is painted.
    pub fn paragraph(self, lead: &str, style: Style, words: &str) -> String {
        let indent = lead.chars().count();
        let wrapped = match self.columns() {
            Some(width) => lines(words, width.saturating_sub(indent)),
            None => vec![words.to_owned()],
        };
        let joined = wrapped.join(&format!("\n{}", " ".repeat(indent)));
        let text = format!("{}{joined}", self.painted(lead, style));
        text.trim_end().to_owned() + "\n"
    }
}

/// What a heading looks like.
pub fn bold() -> Style {
    Style::new().bold()
}

/// A clause with a full stop behind it.
pub fn ended(clause: &str) -> String {
    let clause = clause.trim();
    match clause.ends_with(['.', '?', '!']) || clause.is_empty() {
        true => clause.to_owned(),
        false => format!("{clause}."),
    }
}

/// A sentence: a clause that begins with a capital, where a word begins it, and ends with a full stop.
pub fn sentence(clause: &str) -> String {
    let clause = ended(clause);
    let word = clause.split([' ', ',']).next().unwrap_or_default();
    match word.chars().all(|c| c.is_ascii_lowercase()) && !clause.is_empty() {
        true => clause[..1].to_ascii_uppercase() + &clause[1..],
        false => clause,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_hang_behind_their_lead_and_fit() {
        let layout = Layout {
            width: Some(1),
            colours: false,
        };
        let words = "twelve letters ".repeat(10);
        let text = layout.paragraph("  contact  ", Style::new(), &words);
        let lines: Vec<&str> = text.lines().collect();
        assert!(lines.len() > 1 && lines.iter().all(|line| line.chars().count() <= LEAST_WIDTH));
        assert!(lines[1].starts_with("           letters"), "{text}");
        let wide = Layout::default().paragraph("  contact  ", bold(), &words);
        assert_eq!(wide.lines().count(), 1);
        assert!(!wide.contains('\u{1b}'));
    }

    #[test]
    fn clauses_become_sentences() {
        assert_eq!(sentence("the wall falls"), "The wall falls.");
        assert_eq!(sentence("λ = 0.5"), "λ = 0.5.");
        assert_eq!(sentence("a1 moves first"), "a1 moves first.");
        assert_eq!(sentence(""), "");
    }
}
