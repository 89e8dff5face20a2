//! What the marks of a drawing mean.

use super::marks::mark;
use super::palette::{
    BEFORE, CRACK, FORCE, LARGEST, MACRO_CRACK, OPENING, PARTS, SLIDING, SQUARE_LINE, STILL, THRUST,
};
use super::path::{Path, Pixel};
use super::svg::{Anchor, Style, Svg, style};
use crate::method::Look;

/// Pixels of a line of the legend.
const LINE: f64 = 20.0;

/// What stands before the words.
enum Sample {
    /// Squares of these colours, one a kind of part.
    Tints(&'static [&'static str]),
    /// A line in this style.
    Line(Style),
    /// A filled gap.
    Gap,
    /// A point of a plot.
    Point(Look),
}

/// One entry: what is seen and what it means.
pub struct LegendEntry {
    sample: Sample,
    words: String,
}

/// What a drawing holds, which its legend explains.
#[derive(Clone, Copy, Debug, Default)]
pub struct Holds {
    /// A mechanism.
    pub mechanism: bool,
    /// The lines of c and e.
    pub crack: bool,
    /// The crack of the macro-block model.
    pub macro_crack: bool,
    /// Contact forces.
    pub forces: bool,
}

/// The entries that explain what is there.
pub fn entries(holds: Holds) -> Vec<LegendEntry> {
    let line = |colour: &str, width: f64| style().hollow().stroke(colour).stroke_width(width);
    let mut entries = Vec::new();
    let mut add = |there: bool, sample: Sample, words: &str| {
        if there {
            let words = words.to_owned();
            entries.push(LegendEntry { sample, words });
        }
    };
    let moving: &[&str] = &[LARGEST, PARTS[0], PARTS[1], PARTS[2]];
    add(holds.mechanism, Sample::Tints(&[STILL]), "stands still");
    add(
        holds.mechanism,
        Sample::Tints(moving),
        "a tint moves as one body",
    );
    add(
        holds.mechanism,
        Sample::Line(line(SLIDING, 2.4)),
        "joint slides",
    );
    add(holds.mechanism, Sample::Gap, "joint opens");
    add(holds.mechanism, Sample::Line(line(BEFORE, 1.2)), "before");
    add(
        holds.crack,
        Sample::Line(line(CRACK, 1.4)),
        "crack of c and e",
    );
    add(
        holds.macro_crack,
        Sample::Line(line(MACRO_CRACK, 1.5).dashes("7 4")),
        "macro-block crack",
    );
    add(
        holds.forces,
        Sample::Line(line(FORCE, 1.6)),
        "contact force, by length",
    );
    add(
        holds.forces,
        Sample::Line(line(THRUST, 1.2)),
        "thrust, or resultants",
    );
    entries
}

impl LegendEntry {
    /// A line in a style.
    pub fn line(style: Style, words: String) -> Self {
        let sample = Sample::Line(style);
        Self { sample, words }
    }

    /// A point of a plot.
    pub fn point(look: Look, words: String) -> Self {
        let sample = Sample::Point(look);
        Self { sample, words }
    }

    fn sample_width(&self) -> f64 {
        match &self.sample {
            Sample::Point(_) => 12.0,
            Sample::Tints(colours) => 13.0 * colours.len() as f64,
            _ => 24.0,
        }
    }

    fn width(&self) -> f64 {
        self.sample_width() + 6.0 + 6.3 * self.words.chars().count() as f64 + 18.0
    }

    fn draw(&self, svg: &mut Svg, [x, y]: Pixel) {
        let middle = y - 4.0;
        match &self.sample {
            Sample::Tints(colours) => {
                for (index, colour) in colours.iter().enumerate() {
                    let left = x + 13.0 * index as f64;
                    let [top, bottom, right] = [middle - 5.5, middle + 5.5, left + 11.0];
                    let corners = [[left, top], [right, top], [right, bottom], [left, bottom]];
                    let style = style().fill(colour).stroke(SQUARE_LINE).stroke_width(0.6);
                    svg.path(&Path::through(&corners, true), style, "");
                }
            }
            Sample::Line(style) => {
                let line = Path::through(&[[x, middle], [x + 24.0, middle]], false);
                svg.path(&line, style.clone(), "");
            }
            Sample::Point(look) => mark(svg, [x + 6.0, middle], *look),
            Sample::Gap => {
                let [right, bottom] = [x + 24.0, middle + 4.0];
                let corners = [[x, bottom], [right, bottom], [right, middle - 5.0]];
                let style = style().fill(OPENING).fill_opacity(0.5).stroke(OPENING);
                svg.path(&Path::through(&corners, true), style.dashes("1 2"), "");
            }
        }
        let at = [x + self.sample_width() + 6.0, y];
        svg.text(at, Anchor::Start, style().font_size(12.0), &self.words);
    }
}

/// Draws the entries from left to right, in as many lines as `width` asks for; the pixels used.
pub fn draw(svg: &mut Svg, entries: &[LegendEntry], corner: Pixel, width: f64) -> f64 {
    let [left, top] = corner;
    let (mut x, mut y) = (left, top + LINE - 5.0);
    for entry in entries {
        if x > left && x + entry.width() - 18.0 > left + width {
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
