//! A row as files keep it, a line each with a sum over its text: whole, or thinned where there are many.

use super::columns::COLUMNS;
use super::row::Row;
use super::sides::{OtherSide, facts};
use crate::answer::{Fact, Outcome};
use crate::fingerprint::Fingerprint;
use crate::judge::Recomputed;

/// How much of a row a journal keeps.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Keeps {
    /// What tables of many rows need: the answers without forces and mechanisms, and their facts in
    /// words.
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
fn thinned(mut row: Row) -> Row {
    if let Some(other) = &row.other {
        // In words, facts of one side would not be told from those of the wall any more.
        let (own, other) = ((row.push, &row.outcome), (other.push, &*other.outcome));
        row.outcome.facts = facts(own, other);
    }
    Row {
        outcome: told(row.outcome),
        other: row.other.map(|other| OtherSide {
            push: other.push,
            outcome: Box::new(told(*other.outcome)),
            residuals: worst(other.residuals),
            crack: other.crack,
        }),
        residuals: worst(row.residuals),
        references: Vec::new(),
        demand: None,
        verdict: None,
        ..row
    }
}

/// The answer without forces and motions, its facts in words.
fn told(outcome: Outcome) -> Outcome {
    let reason = outcome.reason();
    let fact = match outcome.is_refuted() {
        true => Fact::KeptRefutation(reason),
        false => Fact::Words(reason),
    };
    Outcome {
        evidence: outcome.evidence.thinned(),
        facts: vec![fact],
        ..outcome
    }
}

/// The largest residual alone; none where it is infinite, as JSON has no such number.
fn worst(mut residuals: Vec<Recomputed>) -> Vec<Recomputed> {
    residuals.sort_by(|a, b| b.largest().total_cmp(&a.largest()));
    residuals.truncate(1);
    residuals.retain(|of| of.largest().is_finite());
    residuals
}

impl Row {
    /// Whether both rows say the same, to nine digits, but for the time.
    pub fn agrees(&self, other: &Row) -> bool {
        let is_time = |name: &str| ["seconds", "cpu_seconds"].contains(&name);
        let columns = COLUMNS.iter().filter(|column| !is_time(column.name));
        let mut values = columns.map(|column| [self, other].map(|row| (column.value)(row).csv()));
        self.id == other.id && values.all(|[one, other]| one == other)
    }
}
