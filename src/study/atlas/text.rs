//! The atlas as a table for people and as CSV.

use super::cell::{Cell, Verdict};
use super::grid::Grid;
use crate::number::nine_digits;
use crate::picture::lines;

/// Cells as CSV, one line each.
///
/// # Errors
/// Those of the CSV writer; none is expected in memory.
pub fn csv(cells: &[Cell]) -> Result<String, csv::Error> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    writer.write_record([
        "grid",
        "method",
        "x",
        "y",
        "verdict",
        "status",
        "lower",
        "upper",
        "reference",
        "error",
        "reason",
    ])?;
    for cell in cells {
        let text = |value: Option<f64>| value.map_or(String::new(), nine_digits);
        writer.write_record([
            cell.grid,
            &cell.method,
            &cell.x,
            &cell.y,
            cell.verdict.name(),
            cell.status.name(),
            &text(cell.bracket.map(|b| b.lower)),
            &text(cell.bracket.map(|b| b.upper)),
            &nine_digits(cell.reference),
            &text(cell.error()),
            &cell.reason,
        ])?;
    }
    let bytes = writer
        .into_inner()
        .map_err(|e| csv::Error::from(e.into_error()))?;
    Ok(String::from_utf8_lossy(&bytes).into_owned())
}

/// Counts by grid and method, the causes under each grid, and every wrong cell.
pub fn table(grids: &[Grid], cells: &[Cell]) -> String {
    let mut text = String::new();
    for grid in grids {
        text.push_str(&format!("{}: {} x {}\n", grid.name, grid.x, grid.y));
        for method in methods(grid, cells) {
            let own = cells
                .iter()
                .filter(|c| c.grid == grid.name && c.method == method);
            let own: Vec<&Cell> = own.collect();
            let counts = Verdict::ALL.map(|verdict| {
                let count = own.iter().filter(|cell| cell.verdict == verdict).count();
                format!("{count:>3} {}", verdict.name())
            });
            text.push_str(&format!("  {method:<12} {}\n", counts.join("  ")));
        }
        for line in lines(grid.causes, 96) {
            text.push_str(&format!("  {line}\n"));
        }
        text.push('\n');
    }
    let wrong: Vec<&Cell> = cells
        .iter()
        .filter(|c| c.verdict == Verdict::Wrong)
        .collect();
    text.push_str(&format!("{} cells, {} wrong\n", cells.len(), wrong.len()));
    for cell in wrong {
        let ends = cell.bracket.map_or(String::from("no number"), |b| {
            format!("{} to {}", nine_digits(b.lower), nine_digits(b.upper))
        });
        let Cell {
            grid,
            method,
            x,
            y,
            reference,
            ..
        } = cell;
        let status = cell.status.name();
        text.push_str(&format!(
            "WRONG {grid}: {method} at {x}, {y}: {status} {ends}, where it is {reference}\n"
        ));
    }
    text
}

/// Methods with cells on a grid, as they first come.
pub(super) fn methods<'a>(grid: &Grid, cells: &'a [Cell]) -> Vec<&'a str> {
    let mut names: Vec<&str> = Vec::new();
    for cell in cells.iter().filter(|cell| cell.grid == grid.name) {
        if !names.contains(&cell.method.as_str()) {
            names.push(&cell.method);
        }
    }
    names
}
