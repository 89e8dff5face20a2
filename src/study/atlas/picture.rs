//! One picture a grid: a field of cells a method, and the causes of its failures below.

use super::cell::{Cell, Verdict};
use super::grid::Grid;
use super::text::{methods, wrapped};

/// Pixels of a cell, of the space left of a field for its values, of that above and below it.
const CELL: [f64; 2] = [58.0, 30.0];
const LEFT: f64 = 150.0;
const ABOVE: f64 = 34.0;
const BELOW: f64 = 48.0;

/// Fields in a row.
const FIELDS: usize = 3;

/// Pixels of a line of text.
const LINE: f64 = 16.0;

/// Fill and text colour of a verdict.
fn colours(verdict: Verdict) -> [&'static str; 2] {
    match verdict {
        Verdict::Right => ["#9ed3b4", "#10331f"],
        Verdict::Inaccurate => ["#f6d58a", "#4a3500"],
        Verdict::Refused => ["#dcdcdc", "#444444"],
        Verdict::Wrong => ["#c1121f", "#ffffff"],
    }
}

/// The picture of one grid as SVG: the same bytes for the same cells.
pub fn picture(grid: &Grid, cells: &[Cell]) -> String {
    let names = methods(grid, cells);
    let (xs, ys) = axes(grid);
    let field = [
        LEFT + CELL[0] * xs.len() as f64 + 20.0,
        ABOVE + CELL[1] * ys.len() as f64 + BELOW,
    ];
    let columns = names.len().clamp(1, FIELDS);
    let rows = names.len().div_ceil(columns);
    let width = (field[0] * columns as f64).max(860.0) + 20.0;
    let causes = wrapped(grid.causes, (width / 6.9) as usize, "");
    let lines: Vec<&str> = causes.lines().collect();
    let head = 74.0;
    let body = field[1] * rows as f64;
    let height = head + body + LINE * lines.len() as f64 + 24.0;
    let mut svg = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width:.0}\" height=\"{height:.0}\" \
         viewBox=\"0 0 {width:.0} {height:.0}\" font-family=\"DejaVu Sans, Arial, sans-serif\" \
         font-size=\"11\">\n<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n"
    );
    let title = format!("{} (to the right) × {} (upwards)", grid.x, grid.y);
    svg.push_str(&text([20.0, 26.0], "start", 15.0, "#000000", &title));
    svg.push_str(&legend());
    for (index, name) in names.iter().enumerate() {
        let corner = [
            10.0 + field[0] * (index % columns) as f64,
            head + field[1] * (index / columns) as f64,
        ];
        let of_method = cells
            .iter()
            .filter(|c| c.grid == grid.name && c.row.method == *name);
        svg.push_str(&one_field(corner, name, [&xs, &ys], grid, of_method));
    }
    for (index, line) in lines.iter().enumerate() {
        let y = head + body + LINE * (index as f64 + 1.0);
        svg.push_str(&text([20.0, y], "start", 11.0, "#333333", line));
    }
    svg.push_str("</svg>\n");
    svg
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

fn legend() -> String {
    let words = [
        "right: within 1 %",
        "inaccurate: outside, and claims no more",
        "refused: no answer",
        "WRONG: a claim refuted",
    ];
    let mut svg = String::new();
    let mut x = 20.0;
    for (verdict, word) in Verdict::ALL.into_iter().zip(words) {
        let [fill, _] = colours(verdict);
        svg.push_str(&format!(
            "<rect x=\"{x:.1}\" y=\"40\" width=\"14\" height=\"14\" fill=\"{fill}\"/>\n"
        ));
        svg.push_str(&text([x + 20.0, 51.0], "start", 11.0, "#333333", word));
        x += 40.0 + 6.6 * word.len() as f64;
    }
    svg
}

/// One method's cells, with the error or the status written in each.
fn one_field<'a>(
    corner: [f64; 2],
    name: &str,
    [xs, ys]: [&[&str]; 2],
    grid: &Grid,
    cells: impl Iterator<Item = &'a Cell>,
) -> String {
    let [left, top] = [corner[0] + LEFT, corner[1] + ABOVE];
    let bottom = top + CELL[1] * ys.len() as f64;
    let mut svg = text([left, top - 10.0], "start", 13.0, "#000000", name);
    for cell in cells {
        let column = xs.iter().position(|x| *x == cell.x).unwrap_or(0);
        let row = ys.iter().position(|y| *y == cell.y).unwrap_or(0);
        let x = left + CELL[0] * column as f64;
        let y = bottom - CELL[1] * (row as f64 + 1.0);
        let [fill, ink] = colours(cell.verdict);
        svg.push_str(&format!(
            "<g><title>{}</title><rect x=\"{:.1}\" y=\"{:.1}\" width=\"{:.1}\" height=\"{:.1}\" \
             fill=\"{fill}\"/>",
            escaped(&tooltip(cell)),
            x + 1.0,
            y + 1.0,
            CELL[0] - 2.0,
            CELL[1] - 2.0
        ));
        let middle = [x + CELL[0] / 2.0, y + CELL[1] / 2.0 + 4.0];
        svg.push_str(&text(middle, "middle", 10.0, ink, &word(cell)));
        svg.push_str("</g>\n");
    }
    for (index, x) in xs.iter().enumerate() {
        let middle = left + CELL[0] * (index as f64 + 0.5);
        svg.push_str(&text([middle, bottom + 15.0], "middle", 10.0, "#333333", x));
    }
    for (index, y) in ys.iter().enumerate() {
        let middle = bottom - CELL[1] * (index as f64 + 0.5) + 4.0;
        svg.push_str(&text([left - 6.0, middle], "end", 10.0, "#333333", y));
    }
    let under = [left + CELL[0] * xs.len() as f64 / 2.0, bottom + 31.0];
    svg.push_str(&text(under, "middle", 10.0, "#333333", grid.x));
    svg
}

/// What stands in a cell: the error, or why there is none.
fn word(cell: &Cell) -> String {
    match cell.error() {
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
    let ends = cell.row.bracket().map_or(String::new(), |b| {
        format!(" {:.6} to {:.6}", b.lower, b.upper)
    });
    format!(
        "{}: {}{ends}, reference {:.6}; {}",
        cell.verdict.name(),
        cell.row.status().name(),
        cell.reference,
        cell.row.outcome.reason()
    )
}

fn text([x, y]: [f64; 2], anchor: &str, size: f64, fill: &str, words: &str) -> String {
    format!(
        "<text x=\"{x:.1}\" y=\"{y:.1}\" text-anchor=\"{anchor}\" font-size=\"{size:.0}\" \
         fill=\"{fill}\">{}</text>\n",
        escaped(words)
    )
}

fn escaped(words: &str) -> String {
    words
        .replace('&', "&amp;")
        .replace('<', "&lt;")
        .replace('>', "&gt;")
}
