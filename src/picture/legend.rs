//! What the marks of drawings and plots mean.

use super::marks::{Filling, mark};
use super::metrics::text_width;
use super::palette::{OPENING, SQUARE_LINE, WHITE};
use super::path::{Path, Pixel};
use super::svg::{Anchor, Style, Svg, style};
use crate::method::Look;

/// Pixels of a line of the legend, between two entries, and the size of its words.
const LINE: f64 = 20.0;
const APART: f64 = 18.0;
const FONT: f64 = 12.0;

/// What stands before the words.
pub enum Sample {
    /// Squares of these colours, one a kind of part.
    Tints(Vec<&'static str>),
    /// Squares of these colours without a gap, and words at both ends: a scale.
    Scale(&'static [&'static str], [String; 2]),
    /// A line in this style.
    Line(Style),
    /// A line in this style over a white one.
    Haloed(Style),
    /// An arrow in this colour, so many pixels long.
    Arrow(&'static str, f64),
    /// A length, so many pixels long.
    Length(&'static str, f64),
    /// A filled gap.
    Gap,
    /// A point of a plot.
    Point(Look, Filling),
    /// A point with a bar below it.
    Bar(&'static str),
    /// A shaded field.
    Shade(&'static str, f64),
}

/// One entry: what is seen and what it means.
pub struct LegendEntry {
    sample: Sample,
    words: String,
}

impl LegendEntry {
    /// An entry of these words.
    pub fn new(sample: Sample, words: impl Into<String>) -> Self {
        let words = words.into();
        Self { sample, words }
    }

    fn sample_width(&self) -> f64 {
        match &self.sample {
            Sample::Point(..) | Sample::Bar(_) => 12.0,
            Sample::Tints(colours) => 13.0 * colours.len() as f64,
            Sample::Scale(colours, [from, to]) => {
                let words = text_width(from, FONT) + text_width(to, FONT);
                13.0 * colours.len() as f64 + words + 10.0
            }
            Sample::Arrow(_, pixels) | Sample::Length(_, pixels) => *pixels,
            _ => 24.0,
        }
    }

    fn width(&self) -> f64 {
        self.sample_width() + 6.0 + text_width(&self.words, FONT) + APART
    }

    fn draw(&self, svg: &mut Svg, [x, y]: Pixel) {
        let middle = y - 4.0;
        let line = Path::through(&[[x, middle], [x + 24.0, middle]], false);
        match &self.sample {
            Sample::Tints(colours) => squares(svg, colours, [x, middle], 11.0),
            Sample::Scale(colours, [from, to]) => {
                let text = |svg: &mut Svg, x, words| {
                    svg.text([x, y], Anchor::Start, style().font_size(FONT), words);
                };
                text(svg, x, from);
                let left = x + text_width(from, FONT) + 5.0;
                squares(svg, colours, [left, middle], 13.0);
                text(svg, left + 13.0 * colours.len() as f64 + 5.0, to);
            }
            Sample::Line(style) => svg.path(&line, style.clone(), ""),
            Sample::Haloed(over) => {
                let white = style().hollow().stroke(WHITE).stroke_width(5.0);
                svg.path(&line, white, "");
                svg.path(&line, over.clone(), "");
            }
            Sample::Arrow(colour, pixels) => {
                arrow(svg, [x, middle], [x + pixels, middle], colour, 1.2)
            }
            Sample::Length(colour, pixels) => {
                let mut path = Path::through(&[[x, middle], [x + pixels, middle]], false);
                for end in [x, x + pixels] {
                    path.add(&[[end, middle - 4.0], [end, middle + 4.0]], false);
                }
                svg.path(&path, style().hollow().stroke(colour).stroke_width(1.2), "");
            }
            Sample::Point(look, filling) => mark(svg, [x + 6.0, middle], *look, *filling),
            Sample::Bar(colour) => {
                let mut path =
                    Path::through(&[[x + 6.0, middle - 6.0], [x + 6.0, middle + 6.0]], false);
                for end in [middle - 6.0, middle + 6.0] {
                    path.add(&[[x + 2.0, end], [x + 10.0, end]], false);
                }
                svg.path(&path, style().hollow().stroke(colour).stroke_width(1.1), "");
            }
            Sample::Shade(colour, part) => {
                let fill = style().fill(colour).fill_opacity(*part);
                svg.rect([x, middle - 6.0], [24.0, 12.0], fill);
            }
            Sample::Gap => {
                let [right, bottom] = [x + 24.0, middle + 4.0];
                let corners = [[x, bottom], [right, bottom], [right, middle - 5.0]];
                let style = style().fill(OPENING).fill_opacity(0.5).stroke(OPENING);
                svg.path(&Path::through(&corners, true), style.dashes("1 2"), "");
            }
        }
        let at = [x + self.sample_width() + 6.0, y];
        svg.text(at, Anchor::Start, style().font_size(FONT), &self.words);
    }
}

/// Squares beside one another around the height of their middle, so many pixels from one to the next.
fn squares(svg: &mut Svg, colours: &[&str], [x, middle]: Pixel, side: f64) {
    for (index, colour) in colours.iter().enumerate() {
        let left = x + 13.0 * index as f64;
        let [top, bottom, right] = [middle - 5.5, middle + 5.5, left + side];
        let corners = [[left, top], [right, top], [right, bottom], [left, bottom]];
        let style = style().fill(colour).stroke(SQUARE_LINE).stroke_width(0.6);
        svg.path(&Path::through(&corners, true), style, "");
    }
}

/// An arrow from one point to another.
fn arrow(svg: &mut Svg, from: Pixel, to: Pixel, colour: &str, width: f64) {
    let (mut shaft, mut head) = (Path::default(), Path::default());
    arrow_paths(from, to, width, &mut shaft, &mut head);
    let line = style().hollow().stroke(colour).stroke_width(width);
    svg.path(&shaft, line, "");
    svg.path(&head, style().fill(colour), "");
}

/// Adds shaft and head of an arrow to the paths of many; short arrows have small heads.
pub fn arrow_paths(from: Pixel, to: Pixel, width: f64, shafts: &mut Path, heads: &mut Path) {
    let [dx, dy] = [to[0] - from[0], to[1] - from[1]];
    let length = dx.hypot(dy);
    if length <= 0.0 {
        return;
    }
    let [ux, uy] = [dx / length, dy / length];
    let head = (5.0 * width).min(0.5 * length);
    let foot = [to[0] - head * ux, to[1] - head * uy];
    let half = 0.38 * head;
    let corners = [
        to,
        [foot[0] - half * uy, foot[1] + half * ux],
        [foot[0] + half * uy, foot[1] - half * ux],
    ];
    shafts.add(&[from, foot], false);
    heads.add(&corners, true);
}

/// Draws the entries from left to right, in as many lines as `width` asks for; the pixels used.
pub fn draw(svg: &mut Svg, entries: &[LegendEntry], corner: Pixel, width: f64) -> f64 {
    let [left, top] = corner;
    let (mut x, mut y) = (left, top + LINE - 5.0);
    for entry in entries {
        if x > left && x + entry.width() - APART > left + width {
            (x, y) = (left, y + LINE);
        }
        entry.draw(svg, [x, y]);
        x += entry.width();
    }
    match entries {
        [] => 0.0,
        _ => y + 5.0 - top,
    }
}
