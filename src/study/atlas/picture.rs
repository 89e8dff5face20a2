//! One picture a grid: a field of cells a method, and the causes of its failures below.

use super::cell::{Cell, CellVerdict};
use super::grid::Grid;
use super::text::{between, methods};
use crate::picture::palette::{INACCURATE, REFUSED, RIGHT, Tone, WRONG};
use crate::picture::{self, Cells, Field, LegendEntry, Sample};
use crate::run::{Partial, titled};

/// The picture of one grid as SVG: the same bytes for the same cells. It says so where it is partial.
pub fn picture(grid: &Grid, cells: &[Cell], partial: Option<&Partial>) -> String {
    let (xs, ys) = axes(grid);
    let place = |cell: &Cell| {
        let column = xs.iter().position(|x| *x == cell.x)?;
        let row = ys.iter().position(|y| *y == cell.y)?;
        Some([column, row])
    };
    let field = |name| {
        let of_method = |cell: &&Cell| cell.grid == grid.name && cell.row.method == name;
        let own = cells.iter().filter(of_method);
        let shown = own.filter_map(|cell| {
            Some(picture::PictureCell {
                place: place(cell)?,
                tone: tone(cell.verdict),
                word: word(cell),
                tooltip: tooltip(cell),
            })
        });
        Field {
            name,
            cells: shown.collect(),
        }
    };
    picture::cells(&Cells {
        title: titled(
            &format!("{} (to the right) × {} (upwards)", grid.x, grid.y),
            partial,
        ),
        legend: CellVerdict::ALL
            .map(|verdict| {
                LegendEntry::new(Sample::Shade(tone(verdict).fill, 1.0), meaning(verdict))
            })
            .into(),
        x_label: grid.x,
        fields: methods(grid, cells).into_iter().map(field).collect(),
        xs: xs.clone(),
        ys: ys.clone(),
        words: grid.causes,
    })
}

fn tone(verdict: CellVerdict) -> Tone {
    match verdict {
        CellVerdict::Right => RIGHT,
        CellVerdict::Inaccurate => INACCURATE,
        CellVerdict::Refused => REFUSED,
        CellVerdict::Wrong => WRONG,
    }
}

fn meaning(verdict: CellVerdict) -> &'static str {
    match verdict {
        CellVerdict::Right => "right: within 1 %",
        CellVerdict::Inaccurate => "inaccurate: farther off, and claims no more",
        CellVerdict::Refused => "refused: no answer",
        CellVerdict::Wrong => "WRONG: a claim refuted",
    }
}

/// Values along both axes, as they first come.
fn axes(grid: &Grid) -> (Vec<&str>, Vec<&str>) {
    let (mut xs, mut ys): (Vec<&str>, Vec<&str>) = (Vec::new(), Vec::new());
    for place in &grid.cells {
        if !xs.contains(&place.x.as_str()) {
            xs.push(&place.x);
        }
        if !ys.contains(&place.y.as_str()) {
            ys.push(&place.y);
        }
    }
    (xs, ys)
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
