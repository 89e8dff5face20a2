//! The table: one line a method and head-joint setting, computed beside published.

use std::fmt::Display;

use crate::run::{CaseResult, Row, values};

/// Columns of the table: name, heading, width. The last one ends the line.
const TABLE: [(&str, &str, usize); 12] = [
    ("method", "method", 12),
    ("head_joints", "joints", 8),
    ("status", "status", 15),
    ("lambda", "lambda", 18),
    ("lambda_reference", "reference", 18),
    ("error_percent", "error %", 8),
    ("slope", "tan beta", 9),
    ("slope_reference", "reference", 10),
    ("width_c", "c", 6),
    ("width_e", "e", 6),
    ("verdict", "verdict", 12),
    ("note", "note", 0),
];

/// What the letters behind references mean.
pub const LEGEND: &str = "references: p published, a analytic, i independent code; error: the farther \
                          end of the bracket; c, e: widths of the crack's triangle along the top";

/// Column names, above the lines of [`lines`].
pub fn heading() -> String {
    padded(TABLE.map(|(_, heading, _)| heading.to_owned()))
}

/// One fixed-width line a row.
pub fn lines(result: &CaseResult) -> Vec<String> {
    result.rows.iter().map(line).collect()
}

fn line(row: &Row) -> String {
    let cells = values(row, &TABLE.map(|(name, _, _)| name));
    padded(cells.iter().map(|cell| cell.shown()))
}

fn padded(cells: impl IntoIterator<Item = String>) -> String {
    fixed_width(cells.into_iter().zip(TABLE.map(|(_, _, width)| width)))
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
