//! The table: one line a method and head-joint setting, computed beside published.

use std::fmt::Display;

use crate::run::{CaseResult, Row, column, values};
use crate::scene::HeadJoints;

/// Columns of the table: name and width. The last one ends the line.
const TABLE: [(&str, usize); 12] = [
    ("method", 12),
    ("head_joints", 8),
    ("status", 15),
    ("lambda", 18),
    ("stated_percent", 8),
    ("lambda_reference", 18),
    ("error_percent", 8),
    ("slope", 9),
    ("slope_reference", 10),
    ("width_c", 6),
    ("width_e", 6),
    ("verdict_words", 0),
];

/// What the letters behind references mean.
pub const LEGEND: &str = "Reference: p is a published value, a an analytic one, i one of independent code. \
                          Error: how far the farther end of the answer is from it. Stated: how far off \
                          the method says that its answer may be. c and e: widths of the crack's \
                          triangle along the top of the wall.";

/// Headings of the columns, above the lines of [`lines`], their Greek letters spelled out.
pub fn heading() -> String {
    let headings = TABLE.map(|(name, _)| column(name).heading);
    padded(headings.map(|heading| heading.replace('λ', "lambda").replace('β', "beta")))
}

pub fn lines(result: &CaseResult) -> Vec<String> {
    let line = |row: &Row| {
        let cells = values(row, &TABLE.map(|(name, _)| name));
        padded(cells.iter().map(|cell| cell.shown()))
    };
    result.rows.iter().map(line).collect()
}

#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Note {
    pub method: String,
    /// The head-joint settings of which it is said.
    pub head_joints: Vec<HeadJoints>,
    pub text: String,
}

impl Note {
    pub fn joints(&self) -> Vec<&'static str> {
        self.head_joints
            .iter()
            .map(|joints| joints.name())
            .collect()
    }
}

/// The notes of a case's rows, in their order: what is said of both head-joint settings is said once.
pub fn notes(result: &CaseResult) -> Vec<Note> {
    let mut notes: Vec<Note> = Vec::new();
    for row in &result.rows {
        let text = values(row, &["note"])[0].csv();
        let same = notes
            .iter_mut()
            .find(|note| note.method == row.method && note.text == text);
        match same {
            _ if text.is_empty() => {}
            Some(note) => note.head_joints.push(row.head_joints),
            None => notes.push(Note {
                method: row.method.clone(),
                head_joints: vec![row.head_joints],
                text,
            }),
        }
    }
    notes
}

fn padded(cells: impl IntoIterator<Item = String>) -> String {
    fixed_width(cells.into_iter().zip(TABLE.map(|(_, width)| width)))
}

/// Cells with their widths, as one line without blanks at its end. Widths are fixed, so that lines of
/// two runs differ only where their cells do.
pub(crate) fn fixed_width(cells: impl IntoIterator<Item = (impl Display, usize)>) -> String {
    let cells = cells.into_iter();
    let padded: Vec<String> = cells
        .map(|(cell, width)| format!("{cell:<width$}"))
        .collect();
    padded.join(" ").trim_end().to_owned()
}
