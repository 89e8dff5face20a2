//! What the marks of a drawing mean.

use super::palette::{BEFORE, CRACK, FORCE, LARGEST, MACRO_CRACK, OPENING, PARTS, SLIDING, STILL};
use super::svg::{Path, Px, Svg};

/// Pixels of a line of the legend.
const LINE: f64 = 20.0;

/// How a mark looks.
enum Mark {
    /// Squares of these colours, one a kind of part.
    Tints(&'static [&'static str]),
    /// A line with further attributes.
    Line(String),
    /// A filled gap.
    Gap,
}

/// One entry: the mark and what it means.
pub struct Entry {
    mark: Mark,
    words: &'static str,
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
pub fn entries(holds: Holds) -> Vec<Entry> {
    let line = |color: &str, more: &str| Mark::Line(format!("stroke=\"{color}\" {more}"));
    let mut entries = Vec::new();
    let mut add = |there: bool, mark: Mark, words| {
        if there {
            entries.push(Entry { mark, words });
        }
    };
    let moving: &[&str] = &[LARGEST, PARTS[0], PARTS[1], PARTS[2]];
    add(holds.mechanism, Mark::Tints(&[STILL]), "stands still");
    add(
        holds.mechanism,
        Mark::Tints(moving),
        "a tint moves as one body",
    );
    add(
        holds.mechanism,
        line(SLIDING, "stroke-width=\"2.4\""),
        "joint slides",
    );
    add(holds.mechanism, Mark::Gap, "joint opens");
    add(
        holds.mechanism,
        line(BEFORE, "stroke-width=\"1.2\""),
        "before",
    );
    add(
        holds.crack,
        line(CRACK, "stroke-width=\"1.4\""),
        "crack of c and e",
    );
    let dashes = "stroke-width=\"1.5\" stroke-dasharray=\"7 4\"";
    add(
        holds.macro_crack,
        line(MACRO_CRACK, dashes),
        "macro-block crack",
    );
    add(
        holds.forces,
        line(FORCE, "stroke-width=\"1.6\""),
        "contact force, by length",
    );
    entries
}

impl Entry {
    fn mark_width(&self) -> f64 {
        match &self.mark {
            Mark::Tints(colors) => 13.0 * colors.len() as f64,
            _ => 24.0,
        }
    }

    fn width(&self) -> f64 {
        self.mark_width() + 6.0 + 6.3 * self.words.chars().count() as f64 + 18.0
    }

    fn draw(&self, svg: &mut Svg, [x, y]: Px) {
        let middle = y - 4.0;
        match &self.mark {
            Mark::Tints(colors) => {
                for (index, color) in colors.iter().enumerate() {
                    let left = x + 13.0 * index as f64;
                    let mut square = Path::default();
                    let [top, bottom, right] = [middle - 5.5, middle + 5.5, left + 11.0];
                    square.add(
                        &[[left, top], [right, top], [right, bottom], [left, bottom]],
                        true,
                    );
                    svg.path(
                        &square,
                        format!("fill=\"{color}\" stroke=\"#777\" stroke-width=\"0.6\""),
                        "",
                    );
                }
            }
            Mark::Line(attributes) => {
                let mut line = Path::default();
                line.add(&[[x, middle], [x + 24.0, middle]], false);
                svg.path(&line, format!("fill=\"none\" {attributes}"), "");
            }
            Mark::Gap => {
                let mut gap = Path::default();
                gap.add(
                    &[
                        [x, middle + 4.0],
                        [x + 24.0, middle + 4.0],
                        [x + 24.0, middle - 5.0],
                    ],
                    true,
                );
                let attributes = format!(
                    "fill=\"{OPENING}\" fill-opacity=\"0.5\" stroke=\"{OPENING}\" \
                     stroke-dasharray=\"1 2\""
                );
                svg.path(&gap, attributes, "");
            }
        }
        svg.text(
            [x + self.mark_width() + 6.0, y],
            "start",
            "font-size=\"12\"",
            self.words,
        );
    }
}

/// Draws the entries from left to right, in as many lines as `width` asks for; the pixels used.
pub fn draw(svg: &mut Svg, entries: &[Entry], corner: Px, width: f64) -> f64 {
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
