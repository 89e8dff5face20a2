//! Fields of coloured cells over two values, with what the colours mean and words below.

use super::legend::{self, Sample};
use super::palette::{INK, Tone};
use super::svg::{Anchor, Pixel, Svg, style};
use super::words::text_width;
use super::words::{fitting, written};

/// Pixels of a cell, of the space above and below a field.
const CELL: [f64; 2] = [58.0, 30.0];
const ABOVE: f64 = 34.0;
const BELOW: f64 = 48.0;

/// Pixels above all fields, for title and legend.
const HEAD: f64 = 74.0;

const FIELDS: usize = 3;

/// Pixels of a line of text, its font size, and those of headings and of small print.
const LINE: f64 = 16.0;
const FONT: f64 = 12.0;
const HEADING: f64 = 13.5;
const SMALL: f64 = 10.5;

/// A picture of fields that share their axes.
pub struct Cells<'a> {
    pub title: String,
    pub legend: Vec<(Sample, &'static str)>,
    /// Name of the values from left to right.
    pub x_label: &'a str,
    /// Values from left to right.
    pub xs: Vec<&'a str>,
    /// Values from bottom to top.
    pub ys: Vec<&'a str>,
    /// The fields, three in a row.
    pub fields: Vec<Field>,
    pub words: &'a str,
}

pub struct Field {
    pub name: String,
    /// In any order; where there is none, the field stays white.
    pub cells: Vec<PictureCell>,
}

pub struct PictureCell {
    /// Its column, from the left, and row, from the bottom.
    pub place: [usize; 2],
    pub tone: Tone,
    pub word: String,
    /// What a pointer over it shows.
    pub tooltip: String,
}

/// The picture as a whole SVG file.
pub fn cells(picture: &Cells) -> String {
    let left = left(picture);
    let field = [
        left + wide(picture) + 20.0,
        ABOVE + CELL[1] * picture.ys.len() as f64 + BELOW,
    ];
    let columns = picture.fields.len().clamp(1, FIELDS);
    let rows = picture.fields.len().div_ceil(columns);
    let width = (field[0] * columns as f64).max(860.0) + 20.0;
    let below = HEAD + field[1] * rows as f64;
    let lines = fitting(picture.words, FONT, width - 40.0).len();
    let height = below + LINE * lines as f64 + 24.0;
    let mut svg = Svg::default();
    let heading = style().font_size(15.0);
    svg.text([20.0, 26.0], Anchor::Start, heading, &picture.title);
    legend::draw(&mut svg, &picture.legend, [20.0, 36.0], width - 40.0);
    for (index, one) in picture.fields.iter().enumerate() {
        let corner = [
            10.0 + field[0] * (index % columns) as f64,
            HEAD + field[1] * (index / columns) as f64,
        ];
        one_field(&mut svg, corner, left, picture, one);
    }
    let at = [20.0, below + LINE];
    written(
        &mut svg,
        at,
        picture.words,
        (FONT, false),
        width - 40.0,
        LINE,
    );
    svg.document([width, height], &picture.title)
}

/// Pixels left of a field, for the words of its values.
fn left(picture: &Cells) -> f64 {
    let widths = picture.ys.iter().map(|words| text_width(words, SMALL));
    widths.fold(30.0, f64::max) + 16.0
}

/// Pixels that a field is wide: its cells, its heading, and what its values are called.
fn wide(picture: &Cells) -> f64 {
    let cells = CELL[0] * picture.xs.len() as f64;
    let headings = picture.fields.iter();
    let headings = headings.map(|field| 1.06 * text_width(&field.name, HEADING));
    let label = text_width(picture.x_label, SMALL);
    headings.fold(cells.max(label), f64::max)
}

fn one_field(svg: &mut Svg, corner: Pixel, left: f64, picture: &Cells, field: &Field) {
    let [left, top] = [corner[0] + left, corner[1] + ABOVE];
    let bottom = top + CELL[1] * picture.ys.len() as f64;
    let heading = style().font_size(HEADING).bold();
    svg.text([left, top - 10.0], Anchor::Start, heading, &field.name);
    for cell in &field.cells {
        let [column, row] = cell.place.map(|index| index as f64);
        let (x, y) = (left + CELL[0] * column, bottom - CELL[1] * (row + 1.0));
        svg.open(style(), &cell.tooltip);
        let fill = style().fill(cell.tone.fill);
        svg.rect([x + 1.0, y + 1.0], [CELL[0] - 2.0, CELL[1] - 2.0], fill);
        let middle = [x + CELL[0] / 2.0, y + CELL[1] / 2.0 + 4.0];
        small(svg, middle, Anchor::Middle, cell.tone.ink, &cell.word);
        svg.close();
    }
    for (index, x) in picture.xs.iter().enumerate() {
        let middle = left + CELL[0] * (index as f64 + 0.5);
        small(svg, [middle, bottom + 15.0], Anchor::Middle, INK, x);
    }
    for (index, y) in picture.ys.iter().enumerate() {
        let middle = bottom - CELL[1] * (index as f64 + 0.5) + 4.0;
        small(svg, [left - 6.0, middle], Anchor::End, INK, y);
    }
    let below = [left, bottom + 31.0];
    small(svg, below, Anchor::Start, INK, picture.x_label);
}

fn small(svg: &mut Svg, at: Pixel, anchor: Anchor, ink: &str, words: &str) {
    svg.text(at, anchor, style().font_size(SMALL).fill(ink), words);
}
