//! Ranges below one another over one axis, near enough to be told apart; above them, where one range
//! is much wider than the others, all of them over its whole length (the paper's Fig. 6).

use super::axes::{Area, round_ticks};
use super::legend::{self, Sample};
use super::marks::{Filling, mark};
use super::palette::{FAINT, INK};
use super::svg::{Anchor, Path, Pixel, Svg, style};
use super::words::text_width;
use super::words::written;
use crate::method::{Look, Mark, look};
use crate::number::{ends_of, number};

/// Pixels of the picture, of a range, and of what is left, right of and below all of them.
const WIDTH: f64 = 480.0;
const LINE: f64 = 24.0;
const LEFT: f64 = 148.0;
const RIGHT: f64 = 30.0;
const BELOW: f64 = 50.0;
const BORDER: f64 = 12.0;

const FONT: f64 = 12.0;

/// Pixels of the strip that shows everything at once.
const STRIP: f64 = 62.0;

/// Part of what is to be seen that stays free beside it.
const FREE: f64 = 0.12;

/// Narrowest part of the axis that is shown, as a part of the values.
const NARROWEST: f64 = 1e-3;

pub struct Ranges {
    pub ranges: Vec<RangeMark>,
    /// The shaded range behind them: its name, its ends and its colour, which is thinned.
    pub shaded: Option<(String, [f64; 2], &'static str)>,
    pub bounds: Vec<f64>,
    pub label: String,
}

pub struct RangeMark {
    pub name: String,
    pub ends: [f64; 2],
    pub look: Look,
    pub filling: Filling,
    /// Values of others about it.
    pub known: Vec<f64>,
}

pub const KNOWN: Look = look(INK, Mark::Cross);

/// The ranges as a whole SVG file. `title` is its name for those who cannot see it.
pub fn ranges(picture: &Ranges, entries: &[(Sample, &str)], title: &str) -> String {
    let mut svg = Svg::default();
    let (at, wide) = ([BORDER, BORDER + 12.0], WIDTH - 2.0 * BORDER);
    let mut y = BORDER + 2.0 + written(&mut svg, at, title, (14.0, true), wide, 18.0);
    let near = near(picture);
    if let Some((name, ends, colour)) = &picture.shaded {
        strip(&mut svg, picture, (name, *ends, colour), near, y);
        y += STRIP;
    }
    let ticks = round_ticks(near);
    let count = picture.ranges.len() as f64;
    let area = Area {
        corner: [LEFT, y],
        size: [WIDTH - LEFT - RIGHT, LINE * count],
        x: near,
        y: [count, 0.0],
    };
    shade(&mut svg, picture, &area);
    let inside = ticks
        .into_iter()
        .filter(|(value, _)| (near[0]..=near[1]).contains(value));
    area.x_axis(&mut svg, &inside.collect::<Vec<_>>(), &picture.label);
    for &value in &picture.bounds {
        let [x, _] = area.at([value, 0.0]);
        let line = Path::through(&[[x, area.corner[1]], [x, area.bottom()]], false);
        svg.path(&line, style().line(INK, 1.1).dashes("5 3"), "");
    }
    for (line, range) in picture.ranges.iter().enumerate() {
        let middle = line as f64 + 0.5;
        one(&mut svg, range, &area, middle);
        let text = style().font_size(FONT);
        let y = area.at([near[0], middle])[1];
        svg.text([LEFT - 9.0, y + 4.0], Anchor::End, text, &range.name);
    }
    let top = area.bottom() + BELOW;
    let used = legend::draw(&mut svg, entries, [BORDER, top], WIDTH - 2.0 * BORDER);
    svg.document([WIDTH, top + used + 6.0], title)
}

/// What the axis shows: all values but the shaded range, and something beside them.
fn near(picture: &Ranges) -> [f64; 2] {
    let ranges = picture.ranges.iter();
    let values = ranges.flat_map(|range| range.ends.iter().chain(&range.known));
    let mut ends = ends_of(values.chain(&picture.bounds).copied());
    if ends[0] > ends[1] {
        let shaded = picture.shaded.as_ref();
        ends = shaded.map_or([0.0, 1.0], |(_, ends, _)| *ends);
    }
    let [low, high] = ends;
    let width = (high - low).max(NARROWEST * high.abs()).max(1e-9);
    let (middle, half) = ((low + high) / 2.0, width * (0.5 + FREE));
    [middle - half, middle + half]
}

/// Everything at once: the shaded range with its ends, the other values as thin lines, and which part
/// of it is shown below.
fn strip(
    svg: &mut Svg,
    picture: &Ranges,
    (name, ends, colour): (&str, [f64; 2], &str),
    near: [f64; 2],
    top: f64,
) {
    let high = ends[1].max(near[1]);
    let low = ends[0].min(near[0]);
    let reach = 0.06 * (high - low);
    let area = Area {
        corner: [LEFT, top],
        size: [WIDTH - LEFT - RIGHT, 18.0],
        x: [low - reach, high + reach],
        y: [0.0, 1.0],
    };
    let [from, to] = ends.map(|end| area.at([end, 1.0]));
    let fill = style().fill(colour).fill_opacity(0.3);
    svg.rect(from, [to[0] - from[0], area.size[1]], fill);
    let mut lines = Path::default();
    for range in &picture.ranges {
        for end in range.ends {
            lines.add(&[area.at([end, 0.0]), area.at([end, 1.0])], false);
        }
    }
    svg.path(&lines, style().line(INK, 0.7), "");
    // What is shown below, as a window that opens downwards.
    let [left, right] = near.map(|end| area.at([end, 0.0])[0]);
    let bottom = top + STRIP;
    let window = [
        [LEFT, bottom],
        [left, top + 20.0],
        [right, top + 20.0],
        [LEFT + area.size[0], bottom],
    ];
    let line = style().line(FAINT, 0.8).dashes("3 2");
    svg.path(&Path::through(&window, false), line, "");
    let text = style().font_size(FONT).halo();
    svg.text([LEFT - 9.0, top + 13.0], Anchor::End, text.clone(), name);
    let [least, most] = ends.map(|end| number(end, 4));
    let room = text_width(&least, FONT) + text_width(&most, FONT) + 12.0;
    if to[0] - from[0] > room {
        for (x, anchor, words) in [(from[0], Anchor::Start, least), (to[0], Anchor::End, most)] {
            svg.text([x, top + 31.0], anchor, text.clone(), &words);
        }
    } else {
        let words = if least == most {
            least
        } else {
            format!("{least} to {most}")
        };
        let half = text_width(&words, FONT) / 2.0;
        let middle = (from[0] + to[0]) / 2.0;
        let middle = middle.clamp(LEFT + half, WIDTH - RIGHT - half);
        svg.text([middle, top + 31.0], Anchor::Middle, text.clone(), &words);
    }
}

/// The shaded range as far as the axis shows it.
fn shade(svg: &mut Svg, picture: &Ranges, area: &Area) {
    let Some((_, ends, colour)) = &picture.shaded else {
        return;
    };
    let [low, high] = area.x;
    let seen = [ends[0].clamp(low, high), ends[1].clamp(low, high)];
    let [from, to] = seen.map(|end| area.at([end, 0.0]));
    let fill = style().fill(colour).fill_opacity(0.16);
    svg.rect(from, [to[0] - from[0], area.size[1]], fill);
}

fn one(svg: &mut Svg, range: &RangeMark, area: &Area, middle: f64) {
    let [[from, y], [to, _]]: [Pixel; 2] = range.ends.map(|end| area.at([end, middle]));
    if to - from > 3.0 {
        let mut path = Path::through(&[[from, y], [to, y]], false);
        for x in [from, to] {
            path.add(&[[x, y - 5.0], [x, y + 5.0]], false);
        }
        svg.path(&path, style().line(range.look.colour, 2.2), "");
    } else {
        mark(svg, [(from + to) / 2.0, y], range.look, range.filling);
    }
    for value in &range.known {
        mark(svg, area.at([*value, middle]), KNOWN, Filling::Open);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_axis_shows_the_values_and_not_zero() {
        let range = |ends| RangeMark {
            name: "one".to_owned(),
            ends,
            look: KNOWN,
            filling: Filling::Full,
            known: vec![0.6398],
        };
        let picture = Ranges {
            ranges: vec![range([0.639, 0.643]), range([0.64, 0.64])],
            shaded: Some(("wide".to_owned(), [0.48, 0.95], FAINT)),
            bounds: Vec::new(),
            label: "λ".to_owned(),
        };
        let [low, high] = near(&picture);
        assert!(
            (0.638..0.639).contains(&low) && (0.643..0.644).contains(&high),
            "{low} {high}"
        );
        let svg = ranges(&picture, &[], "ranges");
        for words in [">0.639<", ">0.640<", ">0.4800<", ">0.9500<"] {
            assert!(svg.contains(words), "{words} in {svg}");
        }
    }
}
