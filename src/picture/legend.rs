//! What the marks of drawings and plots mean.

use super::marks::{Filling, mark};
use super::palette::{INK, OPENING, SQUARE_LINE, WHITE};
use super::svg::{Anchor, Path, Pixel, Style, Svg, style};
use super::words::text_width;
use crate::method::{Look, Mark, look};

/// Pixels of a line of the legend, between two entries, and the size of its words.
const LINE: f64 = 20.0;
const APART: f64 = 18.0;
const FONT: f64 = 12.0;

/// What stands before the words.
pub enum Sample {
    /// Squares of these colours, one a kind of part.
    Tints(Vec<&'static str>),
    /// Squares of these colours without a gap, and words at both ends.
    Scale(&'static [&'static str], [String; 2]),
    Line(Style),
    /// A line over a white one.
    Haloed(Style),
    Arrow(&'static str, f64),
    Length(&'static str, f64),
    Gap,
    Point(Look, Filling),
    Bar(&'static str),
    /// A field of this colour and opacity.
    Shade(&'static str, f64),
}

impl Sample {
    /// A disc of ink, filled so.
    pub fn disc(filling: Filling) -> Self {
        Self::Point(look(INK, Mark::Circle), filling)
    }

    fn width(&self) -> f64 {
        match self {
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

    fn draw(&self, svg: &mut Svg, [x, y]: Pixel) {
        let middle = y - 4.0;
        let line = Path::through(&[[x, middle], [x + 24.0, middle]], false);
        match self {
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
                svg.path(&line, style().line(WHITE, 5.0), "");
                svg.path(&line, over.clone(), "");
            }
            Sample::Arrow(colour, pixels) => {
                let (mut shaft, mut head) = (Path::default(), Path::default());
                let (from, to) = ([x, middle], [x + pixels, middle]);
                arrow_paths(from, to, 1.2, &mut shaft, &mut head);
                svg.path(&shaft, style().line(colour, 1.2), "");
                svg.path(&head, style().fill(colour), "");
            }
            Sample::Length(colour, pixels) => {
                let mut path = Path::through(&[[x, middle], [x + pixels, middle]], false);
                for end in [x, x + pixels] {
                    path.add(&[[end, middle - 4.0], [end, middle + 4.0]], false);
                }
                svg.path(&path, style().line(colour, 1.2), "");
            }
            Sample::Point(look, filling) => mark(svg, [x + 6.0, middle], *look, *filling),
            Sample::Bar(colour) => {
                let ends = [middle - 6.0, middle + 6.0];
                let mut path = Path::through(&ends.map(|end| [x + 6.0, end]), false);
                for end in ends {
                    path.add(&[[x + 2.0, end], [x + 10.0, end]], false);
                }
                svg.path(&path, style().line(colour, 1.1), "");
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

/// Draws the entries, what is seen and what it means, from left to right, in as many lines as `width`
/// asks for; the pixels used.
pub fn draw(
    svg: &mut Svg,
    entries: &[(Sample, impl AsRef<str>)],
    corner: Pixel,
    width: f64,
) -> f64 {
    let [left, top] = corner;
    let (mut x, mut y) = (left, top + LINE - 5.0);
    for (sample, words) in entries {
        let words = words.as_ref();
        let before = sample.width() + 6.0;
        let wide = before + text_width(words, FONT) + APART;
        if x > left && x + wide - APART > left + width {
            (x, y) = (left, y + LINE);
        }
        sample.draw(svg, [x, y]);
        svg.text(
            [x + before, y],
            Anchor::Start,
            style().font_size(FONT),
            words,
        );
        x += wide;
    }
    match entries {
        [] => 0.0,
        _ => y + 5.0 - top,
    }
}
