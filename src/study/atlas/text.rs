//! The atlas as a table for people and as CSV.

use anstyle::Style;
use indexmap::IndexSet;

use super::cell::{Cell, CellVerdict};
use super::grid::Grid;
use crate::answer::Bracket;
use crate::number::nine_digits;
use crate::run::{self, Value, values};
use crate::text::{self, Layout, bold, numbers, words};

/// Cells as CSV, one line each.
pub fn csv(cells: &[Cell]) -> Result<String, csv::Error> {
    let headings = [
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
        "reference_upper",
    ];
    run::csv(headings, cells.iter().map(line))
}

fn line(cell: &Cell) -> Vec<Value> {
    let row = |names| values(&cell.row, names);
    [
        vec![cell.grid.into()],
        row(&["method"]),
        [cell.x.as_str(), &cell.y, cell.verdict.name()]
            .map(Value::from)
            .to_vec(),
        row(&["status", "lower", "upper"]),
        vec![Value::Number(cell.reference.lower), cell.error.into()],
        row(&["reason"]),
        vec![Value::Number(cell.reference.upper)],
    ]
    .concat()
}

/// Counts by grid and method, the causes under each grid, and every wrong cell.
pub fn table(grids: &[Grid], cells: &[Cell], layout: Layout) -> String {
    let mut text = String::new();
    for grid in grids {
        let title = format!(": {} x {}", grid.x, grid.y);
        text.push_str(&layout.paragraph(grid.name, bold(), &title));
        let counts = |method: &str| {
            let own = cells
                .iter()
                .filter(|c| c.grid == grid.name && c.row.method == method);
            let own: Vec<&Cell> = own.collect();
            let counts = CellVerdict::ALL.map(|verdict| {
                let of_verdict = own.iter().filter(|cell| cell.verdict == verdict);
                of_verdict.count().to_string()
            });
            [vec![method.to_owned()], counts.to_vec()].concat()
        };
        let lines: Vec<Vec<String>> = methods(grid, cells).into_iter().map(counts).collect();
        let verdicts = CellVerdict::ALL.map(|verdict| numbers(verdict.name()));
        let columns = [vec![words("method")], verdicts.to_vec()].concat();
        text.push_str(&text::grid(layout, 2, &columns, &lines));
        let causes = Layout {
            width: Some(layout.width.unwrap_or(98)),
            ..layout
        };
        text.push_str(&causes.paragraph("  ", Style::new(), grid.causes));
        text.push('\n');
    }
    let wrong: Vec<&Cell> = cells
        .iter()
        .filter(|c| c.verdict == CellVerdict::Wrong)
        .collect();
    text.push_str(&format!("{} cells, {} wrong\n", cells.len(), wrong.len()));
    for cell in wrong {
        let ends = cell.row.bracket().map_or("no number".to_owned(), between);
        let Cell { grid, x, y, .. } = cell;
        let (method, status) = (&cell.row.method, cell.row.status().name());
        let reference = between(cell.reference);
        let said =
            format!("{grid}: {method} at {x}, {y}: {status} {ends}, where it is {reference}");
        text.push_str(&layout.paragraph("WRONG ", bold(), &said));
    }
    text
}

/// One number, or two with what is between them.
pub(super) fn between(bracket: Bracket) -> String {
    let [lower, upper] = [bracket.lower, bracket.upper].map(nine_digits);
    if lower == upper {
        lower
    } else {
        format!("{lower} to {upper}")
    }
}

/// Methods with cells on a grid, as they first come.
pub(super) fn methods<'a>(grid: &Grid, cells: &'a [Cell]) -> Vec<&'a str> {
    let of_grid = cells.iter().filter(|cell| cell.grid == grid.name);
    let names: IndexSet<&str> = of_grid.map(|cell| cell.row.method.as_str()).collect();
    names.into_iter().collect()
}
