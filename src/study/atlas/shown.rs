//! The atlas as a table for people, as CSV, and as one picture a grid: a field of cells a method, and the
//! causes of its failures below.

use anstyle::Style;
use indexmap::{IndexMap, IndexSet};

use super::cell::{Cell, CellVerdict};
use super::grid::Grid;
use crate::answer::Bracket;
use crate::number::nine_digits;
use crate::picture::palette::{INACCURATE, REFUSED, RIGHT, Tone, WRONG};
use crate::picture::{self, Cells, Field, Sample};
use crate::run::{Heading, Partial, Value, csv_of, titled};
use crate::text::{self, Layout, bold, numbers, words};

const COLUMNS: [Heading<Cell>; 12] = [
    ("grid", |cell| cell.grid.into()),
    ("method", |cell| cell.row.value("method")),
    ("x", |cell| cell.x.as_str().into()),
    ("y", |cell| cell.y.as_str().into()),
    ("verdict", |cell| cell.verdict.name().into()),
    ("status", |cell| cell.row.value("status")),
    ("lower", |cell| cell.row.value("lower")),
    ("upper", |cell| cell.row.value("upper")),
    ("reference", |cell| Value::Number(cell.reference.lower)),
    ("error", |cell| cell.error.into()),
    ("reason", |cell| cell.row.value("reason")),
    ("reference_upper", |cell| {
        Value::Number(cell.reference.upper)
    }),
];

pub fn csv(cells: &[Cell]) -> String {
    csv_of(&COLUMNS, cells)
}

/// Counts by grid and method, the causes under each grid, and every wrong cell.
pub fn table(grids: &[Grid], cells: &[Cell], layout: Layout) -> String {
    let mut text = String::new();
    for grid in grids {
        let title = format!(": {} x {}", grid.x, grid.y);
        text.push_str(&layout.paragraph(grid.name, bold(), &title));
        let counts = |(method, own): (&str, Vec<&Cell>)| {
            let counts = CellVerdict::ALL.map(|verdict| {
                let of_verdict = own.iter().filter(|cell| cell.verdict == verdict);
                of_verdict.count().to_string()
            });
            [vec![method.to_owned()], counts.to_vec()].concat()
        };
        let lines: Vec<Vec<String>> = by_method(grid, cells).into_iter().map(counts).collect();
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
    let wrong = cells.iter().filter(|c| c.verdict == CellVerdict::Wrong);
    let wrong: Vec<&Cell> = wrong.collect();
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
fn between(bracket: Bracket) -> String {
    let [lower, upper] = [bracket.lower, bracket.upper].map(nine_digits);
    if lower == upper {
        lower
    } else {
        format!("{lower} to {upper}")
    }
}

/// The cells on a grid by their methods, as these first come.
fn by_method<'a>(grid: &Grid, cells: &'a [Cell]) -> IndexMap<&'a str, Vec<&'a Cell>> {
    let mut all: IndexMap<&str, Vec<&Cell>> = IndexMap::new();
    for cell in cells.iter().filter(|cell| cell.grid == grid.name) {
        all.entry(&cell.row.method).or_default().push(cell);
    }
    all
}

/// The picture of one grid as SVG: the same bytes for the same cells. It says so where it is partial.
pub fn picture(grid: &Grid, cells: &[Cell], partial: Option<&Partial>) -> String {
    // As they first come.
    let xs: IndexSet<&str> = grid.cells.iter().map(|place| place.x.as_str()).collect();
    let ys: IndexSet<&str> = grid.cells.iter().map(|place| place.y.as_str()).collect();
    let shown = |cell: &Cell| {
        let (x, y) = (cell.x.as_str(), cell.y.as_str());
        Some(picture::PictureCell {
            place: [xs.get_index_of(x)?, ys.get_index_of(y)?],
            tone: look(cell.verdict).0,
            word: word(cell),
            tooltip: tooltip(cell),
        })
    };
    let field = |(name, own): (&str, Vec<&Cell>)| Field {
        name: name.to_owned(),
        cells: own.into_iter().filter_map(shown).collect(),
    };
    let title = format!("{} (to the right) × {} (upwards)", grid.x, grid.y);
    let legend = CellVerdict::ALL.map(look);
    let legend = legend.map(|(tone, meaning)| (Sample::Shade(tone.fill, 1.0), meaning));
    picture::cells(&Cells {
        title: titled(&title, partial),
        legend: legend.into(),
        x_label: grid.x,
        fields: by_method(grid, cells).into_iter().map(field).collect(),
        xs: xs.iter().copied().collect(),
        ys: ys.iter().copied().collect(),
        words: grid.causes,
    })
}

/// The colours of a verdict, and what they mean.
fn look(verdict: CellVerdict) -> (Tone, &'static str) {
    match verdict {
        CellVerdict::Right => (RIGHT, "right: within 1 %"),
        CellVerdict::Inaccurate => (INACCURATE, "inaccurate: farther off, and claims no more"),
        CellVerdict::Refused => (REFUSED, "refused: no answer"),
        CellVerdict::Wrong => (WRONG, "WRONG: a claim refuted"),
    }
}

/// What stands in a cell: the error, or why there is none.
fn word(cell: &Cell) -> String {
    match cell.error {
        Some(error) if error < 5e-6 => "exact".to_owned(),
        Some(error) if error < 0.0995 => format!("{:.2} %", 100.0 * error),
        Some(error) => format!("{:.0} %", 100.0 * error),
        None => match cell.row.status().name() {
            "not-applicable" => "n/a".to_owned(),
            status => status.to_owned(),
        },
    }
}

fn tooltip(cell: &Cell) -> String {
    let ends = cell.row.bracket();
    let ends = ends.map_or(String::new(), |ends| format!(" {}", between(ends)));
    format!(
        "{}: {}{ends}, reference {}; {}",
        cell.verdict.name(),
        cell.row.status().name(),
        between(cell.reference),
        cell.row.reason()
    )
}
