//! Ranges below one another over one axis.

use super::axes::{Area, round_ticks};
use super::path::Path;
use super::svg::{Anchor, Svg, style};

/// Pixels of a range, of what is left of, above, right of and below all of them, and of the width.
const LINE: f64 = 24.0;
const MARGINS: [f64; 4] = [150.0, 10.0, 16.0, 54.0];
const WIDTH: f64 = 560.0;

/// Ranges below one another over one axis that begins at 0.
pub struct Ranges {
    /// The ranges, from top to bottom.
    pub ranges: Vec<RangeMark>,
    /// Ends of the shaded range behind them.
    pub shaded: [f64; 2],
    /// Its colour, which is thinned.
    pub shade: &'static str,
    /// Where the axis ends; no range reaches beyond it.
    pub largest: f64,
    /// What the axis shows.
    pub label: &'static str,
}

/// One range.
pub struct RangeMark {
    /// Its name.
    pub name: String,
    /// Its ends.
    pub ends: [f64; 2],
    /// Its colour.
    pub colour: &'static str,
    /// Whether its middle is marked: in a wide range that would look like an answer.
    pub marked: bool,
}

/// The ranges as a whole SVG file. `title` is its name for those who cannot see it.
pub fn ranges(picture: &Ranges, title: &str) -> String {
    let [left, top, right, bottom] = MARGINS;
    let count = picture.ranges.len() as f64;
    let area = Area {
        corner: [left, top],
        size: [WIDTH - left - right, LINE * count],
        x: [0.0, picture.largest],
        y: [count, 0.0],
    };
    let mut svg = Svg::default();
    let mut ticks = round_ticks(area.x);
    ticks.retain(|(value, _)| *value <= picture.largest);
    let [from, to] = picture.shaded.map(|end| area.at([end, 0.0]));
    let shade = style().fill(picture.shade).fill_opacity(0.14);
    svg.rect(from, [to[0] - from[0], area.size[1]], shade);
    area.x_axis(&mut svg, &ticks, picture.label);
    for (line, range) in picture.ranges.iter().enumerate() {
        let middle = line as f64 + 0.5;
        let [[from, y], [to, _]] = range.ends.map(|end| area.at([end, middle]));
        let mut path = Path::through(&[[from, y], [to, y]], false);
        for x in [from, to] {
            path.add(&[[x, y - 4.0], [x, y + 4.0]], false);
        }
        let stroke = style().hollow().stroke(range.colour).stroke_width(2.2);
        svg.path(&path, stroke, "");
        if range.marked {
            let corner = [(from + to) / 2.0 - 4.0, y - 4.0];
            svg.rect(corner, [8.0, 8.0], style().fill(range.colour));
        }
        let style = style().font_size(12.0);
        svg.text([left - 9.0, y + 4.0], Anchor::End, style, &range.name);
    }
    svg.document([WIDTH, area.bottom() + bottom], title)
}
