//! A row as files keep it, a line each with a sum over its text: whole, or thinned where there are many.

use super::row::Row;
use crate::answer::{Bracket, Fact, Outcome};
use crate::fingerprint::Fingerprint;
use crate::mechanics::Crack;
use crate::number::nine_digits;

/// How much of a row a journal keeps.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Keeps {
    /// What tables of many rows need: the answer without forces, mechanisms and the stronger side, in
    /// nine digits, and its facts in words.
    Numbers,
    /// The whole answer: what a record, a drawing and the judge need.
    Everything,
}

impl Keeps {
    /// What is left of a row, whether it was just answered or is read back.
    pub(super) fn of(self, row: Row) -> Row {
        match self {
            Keeps::Numbers => thinned(row),
            Keeps::Everything => row,
        }
    }

    /// The row as a line; `None` for one that would not be read back as it is, because JSON has no
    /// infinite numbers.
    pub(super) fn line(self, row: &Row) -> serde_json::Result<Option<String>> {
        let text = serde_json::to_string(&self.of(row.clone()))?;
        let line = format!("{} {text}\n", sum(text.as_bytes()));
        let same = || {
            let read = read_line(line.trim_end().as_bytes());
            read.is_some_and(|read| format!("{read:?}") == format!("{row:?}"))
        };
        let kept = self == Keeps::Numbers || same();
        Ok(kept.then_some(line))
    }
}

/// Tells a line that is not the one that was written.
fn sum(text: &[u8]) -> String {
    let mut sum = Fingerprint::new();
    sum.add(text);
    sum.hex()
}

/// The row of a line without its end; `None` where a single character of it has changed.
pub(crate) fn read_line(line: &[u8]) -> Option<Row> {
    let (written, text) = line.split_at_checked(line.iter().position(|&byte| byte == b' ')?)?;
    let text = &text[1..];
    if sum(text).as_bytes() != written {
        return None;
    }
    serde_json::from_slice(text).ok()
}

/// Rows as the lines of a file.
///
/// # Errors
/// Those of the JSON writer; none is expected in memory.
pub(crate) fn lines(rows: &[Row]) -> serde_json::Result<String> {
    let lines = rows.iter().map(|row| Keeps::Numbers.line(row));
    let lines: serde_json::Result<Vec<Option<String>>> = lines.collect();
    Ok(lines?.into_iter().flatten().collect())
}

/// The row without what takes room, as [`Keeps::Numbers`] says.
fn thinned(row: Row) -> Row {
    let reason = row.outcome.reason();
    let fact = match row.outcome.is_refuted() {
        true => Fact::KeptRefutation(reason),
        false => Fact::Words(reason),
    };
    let whole = row.outcome;
    let ends = |Bracket { lower, upper }| {
        let (lower, upper) = (rounded(lower)?, rounded(upper)?);
        Some(Bracket { lower, upper })
    };
    let crack = |crack: Crack| {
        Some(Crack {
            c: crack.c.and_then(rounded),
            e: crack.e.and_then(rounded),
            tan_beta: rounded(crack.tan_beta)?,
            sharp: crack.sharp,
        })
    };
    Row {
        outcome: Outcome {
            claim: whole.claim,
            bracket: whole.bracket.and_then(ends),
            crack: whole.crack.and_then(crack),
            stated_error: whole.stated_error,
            work: whole.work,
            ..Outcome::without_number(whole.status, fact)
        },
        stronger: None,
        residual: row.residual.and_then(rounded),
        seconds: rounded(row.seconds).unwrap_or(0.0),
        references: Vec::new(),
        verdict: None,
        ..row
    }
}

fn rounded(value: f64) -> Option<f64> {
    nine_digits(value).parse().ok()
}

impl Row {
    /// Whether files of many rows keep the same of both, but for the time.
    pub fn agrees(&self, other: &Row) -> bool {
        let text = |row: &Row| {
            let row = Row {
                seconds: 0.0,
                ..thinned(row.clone())
            };
            serde_json::to_string(&row).ok()
        };
        text(self) == text(other)
    }
}
