//! Tables as people save them: cells parted by commas, semicolons or tabs, with decimal points or
//! decimal commas, the columns in any order.
//!
//! Read here and not by a CSV crate: a complaint needs the place of every cell, also behind blank
//! lines and remarks.

use std::borrow::Cow;
use std::ops::Range;

use crate::case::complaint::{Complaint, Document, shorten};
use crate::case::suggestion::listed;
use crate::text::worded;

/// A cell: its text without spaces and quotes around it, and its place.
#[derive(Clone, Debug)]
pub(super) struct Cell<'a> {
    pub text: Cow<'a, str>,
    pub place: Range<usize>,
}

/// A line that is neither blank nor a remark.
#[derive(Clone, Debug)]
pub(super) struct Row<'a> {
    pub line: Range<usize>,
    pub cells: Vec<Cell<'a>>,
}

worded! {
    /// What parts the cells of a table.
    Separator {
        Comma = "commas",
        Semicolon = "semicolons",
        Tab = "tabs",
    }
}

impl Separator {
    fn letter(self) -> char {
        match self {
            Separator::Comma => ',',
            Separator::Semicolon => ';',
            Separator::Tab => '\t',
        }
    }
}

/// A table whose header has been understood.
pub(super) struct Table<'a> {
    pub separator: Separator,
    /// The header's line.
    pub header: Range<usize>,
    /// The place of every wanted column, in the order asked for; of optional ones, where there are.
    pub columns: Vec<Option<usize>>,
    /// The names of other columns.
    pub others: Vec<Cell<'a>>,
    /// The rows below the header.
    pub rows: Vec<Row<'a>>,
}

/// Reads a table with these columns, of which the first `needed` must be there.
pub(super) fn table<'a>(
    document: &'a Document,
    wanted: &[&str],
    needed: usize,
    help: &str,
) -> Result<Table<'a>, Complaint> {
    let mut lines = lines(document).peekable();
    // Spreadsheets take a first line such as `sep=;` for the separator.
    let is_hint = |(_, line): &(usize, &str)| {
        let line = line.trim().trim_matches('"').to_lowercase();
        line.strip_prefix("sep=")
            .is_some_and(|rest| rest.len() <= 1)
    };
    let _ = lines.next_if(is_hint);
    let Some((at, header)) = lines.next() else {
        let complaint = Complaint::at(0..0, "a CSV without rows", "nothing in here");
        return Err(complaint.help(help));
    };
    let found = Separator::ALL.map(|separator| {
        let header = row(at, header, separator);
        let column = |name: &&str| {
            let is = |cell: &Cell| cell.text.to_lowercase() == **name;
            header.cells.iter().position(is)
        };
        let columns: Vec<Option<usize>> = wanted.iter().map(column).collect();
        (separator, header, columns)
    });
    let understood = |(_, _, columns): &&(Separator, Row, Vec<Option<usize>>)| {
        columns[..needed].iter().all(Option::is_some)
    };
    let Some((separator, header, columns)) = found.iter().find(understood) else {
        let found = found.map(|(s, row, _)| (s, row));
        return Err(not_understood(&found, &wanted[..needed], help));
    };
    let twice = |name: &&&str| {
        let same = header
            .cells
            .iter()
            .filter(|cell| cell.text.to_lowercase() == ***name);
        same.count() > 1
    };
    if let Some(name) = wanted.iter().find(twice) {
        let title = format!("two columns are named `{name}`");
        let complaint = Complaint::at(header.line.clone(), title, "the first row");
        return Err(complaint.help("name each column once"));
    }
    let others = header.cells.iter().enumerate();
    let others =
        others.filter(|(place, cell)| !columns.contains(&Some(*place)) && !cell.text.is_empty());
    let rows = lines.map(|(at, line)| row(at, line, *separator));
    Ok(Table {
        separator: *separator,
        header: header.line.clone(),
        others: others.map(|(_, cell)| cell.clone()).collect(),
        columns: columns.clone(),
        rows: rows
            .filter(|row| row.cells.iter().any(|cell| !cell.text.is_empty()))
            .collect(),
    })
}

/// A header without the wanted columns: says what it was read as.
fn not_understood(found: &[(Separator, Row); 3], needed: &[&str], help: &str) -> Complaint {
    // The separator that parts it into most columns.
    let most = found.iter().rev().max_by_key(|(_, row)| row.cells.len());
    let (separator, row) = most.expect("there are separators");
    let label = match row.cells.len() {
        1 => "one column: no comma, semicolon or tab parts it".to_owned(),
        count => {
            let texts = first_texts(&row.cells);
            format!("{count} columns parted by {}: {texts}", separator.name())
        }
    };
    let title = format!("the header of the CSV is not `{}`", needed.join(","));
    Complaint::at(row.line.clone(), title, label).help(help)
}

/// What stands in the first of some cells.
pub(super) fn first_texts(cells: &[Cell]) -> String {
    let first = cells.iter().take(8);
    let texts: Vec<String> = first.map(|cell| shorten(&cell.text, 20)).collect();
    listed(texts.iter().map(String::as_str))
}

/// Lines with their places that are neither blank nor remarks.
fn lines(document: &Document) -> impl Iterator<Item = (usize, &str)> {
    let mut start = 0;
    let lines = document.text.split('\n').map(move |line| {
        let at = start;
        start += line.len() + 1;
        (at, line.trim_end_matches('\r'))
    });
    let lines = lines.map(|(at, line)| match line.strip_prefix('\u{feff}') {
        // A byte order mark, as spreadsheets write it.
        Some(rest) if at == 0 => (line.len() - rest.len(), rest),
        _ => (at, line),
    });
    lines.filter(|(_, line)| !(line.trim().is_empty() || line.trim().starts_with('#')))
}

/// The cells of a line. A cell in quotes may hold the separator; a quote in it is written twice.
fn row(at: usize, line: &str, separator: Separator) -> Row<'_> {
    let mut cells = Vec::new();
    let mut begin = 0;
    let mut quoted = false;
    let mut close = |from: usize, to: usize| {
        let cell = &line[from..to];
        let lead = cell.len() - cell.trim_start().len();
        let text = cell.trim();
        let place = at + from + lead..at + from + lead + text.len();
        let inner = text
            .strip_prefix('"')
            .and_then(|rest| rest.strip_suffix('"'));
        let text = match inner {
            Some(inner) if text.len() >= 2 => {
                Cow::Owned(inner.replace("\"\"", "\"").trim().to_owned())
            }
            _ => Cow::Borrowed(text),
        };
        cells.push(Cell { text, place });
    };
    for (index, letter) in line.char_indices() {
        if letter == '"' {
            quoted = !quoted;
        } else if letter == separator.letter() && !quoted {
            close(begin, index);
            begin = index + letter.len_utf8();
        }
    }
    close(begin, line.len());
    Row {
        line: at..at + line.len(),
        cells,
    }
}

/// How a table writes its numbers: the first one with a point or a comma decides.
#[derive(Default)]
pub(super) struct Decimals {
    /// The sign and the text of the number that it was seen in.
    seen: Option<(char, String)>,
}

impl Decimals {
    /// The number in a cell, or why it is none: the title, and the help.
    pub fn number(&mut self, text: &str, separator: Separator) -> Result<f64, (String, String)> {
        let shown = shorten(text, 60);
        let sign = match (text.contains('.'), text.contains(',')) {
            (true, true) => {
                let title = format!("`{shown}` has a point and a comma");
                let help = "write one sign, before the decimals, and none between thousands";
                return Err((title, help.into()));
            }
            (true, false) => Some('.'),
            (false, true) => Some(','),
            (false, false) => None,
        };
        let number = text.replacen(',', ".", 1).parse::<f64>();
        let number = number.map_err(|_| {
            let help = match separator {
                Separator::Comma => "write a number with a decimal point, such as `1.75`",
                _ => "write a number, such as `1.75` or `1,75`",
            };
            (format!("`{shown}` is not a number"), help.to_owned())
        })?;
        match (&self.seen, sign) {
            (Some((known, first)), Some(sign)) if *known != sign => {
                let words = |sign: char| if sign == '.' { "point" } else { "comma" };
                let title = format!(
                    "`{shown}` has a decimal {}, and `{first}` above a {}",
                    words(sign),
                    words(*known)
                );
                return Err((title, "write all numbers with one of the two".into()));
            }
            (None, Some(sign)) => self.seen = Some((sign, shown)),
            _ => {}
        }
        Ok(number)
    }
}
