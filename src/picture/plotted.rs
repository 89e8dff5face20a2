//! Plots as drawings: alone, or as panels with a common legend.

use indexmap::IndexMap;

use super::axes::{Area, scale};
use super::legend::{self, LegendEntry};
use super::marks::mark;
use super::names;
use super::palette::LEADER;
use super::path::{Path, Pixel};
use super::plot::{Line, Marks, Plot, PlotPoint};
use super::svg::{Anchor, Style, Svg, style};
use crate::method::Look;

/// Pixels of a plot that stands alone, and of one of several panels.
const ALONE: [f64; 2] = [820.0, 440.0];
const PANEL: [f64; 2] = [660.0, 430.0];

/// Pixels between the edges of a plot and its area: left, top, right, bottom.
const MARGINS: [f64; 4] = [78.0, 34.0, 26.0, 62.0];

/// Pixels from the left axis to its label.
const LABEL: f64 = 58.0;

/// Panels in a row.
const COLUMNS: usize = 2;

/// Pixels around panels and their legend.
const BORDER: f64 = 16.0;

/// A plot with the names of its lines below, as a whole SVG file. `title` is its name for those who
/// cannot see it.
pub fn plot(plot: &Plot, title: &str) -> String {
    let mut svg = Svg::default();
    panel(&mut svg, plot, [0.0, 0.0], ALONE);
    let entries = plot.lines.iter().filter_map(|line| {
        let name = line.name.clone()?;
        Some(LegendEntry::line(stroke(line), name))
    });
    let entries: Vec<LegendEntry> = entries.collect();
    let width = ALONE[0] - MARGINS[0] - MARGINS[2];
    let height = legend::draw(&mut svg, &entries, [MARGINS[0], ALONE[1]], width);
    svg.document([ALONE[0], ALONE[1] + height], title)
}

/// Plots in rows of two below a title and a legend of looks, as a whole SVG file.
pub fn panels(title: &str, panels: &[Plot], looks: &IndexMap<&str, Look>) -> String {
    let columns = panels.len().clamp(1, COLUMNS);
    let rows = panels.len().div_ceil(columns);
    let width = columns as f64 * PANEL[0];
    let mut svg = Svg::default();
    let heading = style().font_size(16.0).bold();
    svg.text([BORDER, BORDER + 14.0], Anchor::Start, heading, title);
    let entries = looks.iter();
    let entries: Vec<LegendEntry> = entries
        .map(|(name, look)| LegendEntry::point(*look, (*name).to_owned()))
        .collect();
    let top = BORDER + 28.0;
    let top = top + legend::draw(&mut svg, &entries, [BORDER, top], width - 2.0 * BORDER) + BORDER;
    for (index, one) in panels.iter().enumerate() {
        let [column, row] = [index % columns, index / columns].map(|place| place as f64);
        panel(
            &mut svg,
            one,
            [column * PANEL[0], top + row * PANEL[1]],
            PANEL,
        );
    }
    svg.document([width, top + rows as f64 * PANEL[1]], title)
}

/// One plot in a box.
fn panel(svg: &mut Svg, plot: &Plot, [x, y]: Pixel, [width, height]: [f64; 2]) {
    let [left, top, right, bottom] = MARGINS;
    let (x_ends, x_ticks) = scale(&plot.x.ticks, plot.values(0));
    let (y_ends, y_ticks) = scale(&plot.y.ticks, plot.values(1));
    let area = Area {
        corner: [x + left, y + top],
        size: [width - left - right, height - top - bottom],
        x: x_ends,
        y: y_ends,
    };
    let middle = area.corner[0] + area.size[0] / 2.0;
    if !plot.title.is_empty() {
        let heading = style().font_size(14.0).bold();
        svg.text([middle, y + 20.0], Anchor::Middle, heading, &plot.title);
    }
    for band in &plot.bands {
        let [low, high] = band.ends.map(|end| area.at([area.x[0], end]));
        let fill = style().fill(band.colour).fill_opacity(0.12);
        svg.rect(high, [area.size[0], low[1] - high[1]], fill);
    }
    area.x_axis(svg, &x_ticks, &plot.x.label);
    area.y_axis(svg, &y_ticks, &plot.y.label, LABEL);
    for line in &plot.lines {
        let points: Vec<Pixel> = line.points.iter().map(|&point| area.at(point)).collect();
        svg.path(&Path::through(&points, false), stroke(line), "");
    }
    let named = named(plot, &area);
    for (_, point, middle) in &named {
        let leader = style().stroke(LEADER).stroke_width(0.6);
        svg.path(&Path::through(&[*point, *middle], false), leader, "");
    }
    for marks in &plot.marks {
        points(svg, marks, &area);
    }
    let notes = plot.notes.iter();
    let notes = notes.map(|note| (note.words, area.at(note.at)));
    for (words, [x, y]) in notes.chain(named.iter().map(|(name, _, middle)| (*name, *middle))) {
        let style = style().font_size(11.0);
        svg.text([x, y + 4.0], Anchor::Middle, style, words);
    }
}

fn stroke(line: &Line) -> Style {
    let style = style().hollow().stroke(line.colour).stroke_width(1.8);
    if line.dashed {
        style.dashes("6 4")
    } else {
        style
    }
}

/// Points of one look, and their bars below them.
fn points(svg: &mut Svg, marks: &Marks, area: &Area) {
    let mut bars = Path::default();
    for PlotPoint { at, below, .. } in &marks.points {
        let ([x, top], [_, foot]) = (area.at(*at), area.at([at[0], at[1] - below]));
        if *below > 0.0 {
            bars.add(&[[x, top], [x, foot]], false);
            bars.add(&[[x - 4.0, foot], [x + 4.0, foot]], false);
        }
    }
    let line = style().hollow().stroke(marks.look.colour).stroke_width(1.1);
    svg.path(&bars, line, "");
    for point in &marks.points {
        mark(svg, area.at(point.at), marks.look);
    }
}

/// Names of points from left to right, each with its point and the middle of its own line.
fn named<'a>(plot: &'a Plot, area: &Area) -> Vec<(&'a str, Pixel, Pixel)> {
    let [left, top] = area.corner;
    let inside = |[x, y]: Pixel| [x - left, y - top];
    let points = || plot.marks.iter().flat_map(|marks| &marks.points);
    let covered: Vec<Pixel> = points()
        .flat_map(|point| covered(point, area))
        .map(inside)
        .collect();
    let mut named: Vec<(&str, Pixel)> = points()
        .filter_map(|point| Some((point.name.as_deref()?, area.at(point.at))))
        .collect();
    named.sort_by(|(_, a), (_, b)| a[0].total_cmp(&b[0]));
    let wanted: Vec<(Pixel, &str)> = named
        .iter()
        .map(|(name, at)| (inside(*at), *name))
        .collect();
    let placed = names::place(&wanted, &covered, area.size);
    let named = named.into_iter().zip(placed);
    named
        .map(|((name, at), [x, y])| (name, at, [left + x, top + y]))
        .collect()
}

/// Pixels that a point and its bar cover, one every ten.
fn covered(point: &PlotPoint, area: &Area) -> Vec<Pixel> {
    let [x, y] = point.at;
    let [top, bottom] = [y, y - point.below].map(|y| area.at([x, y]));
    let count = ((bottom[1] - top[1]) / 10.0).floor().max(0.0) as usize;
    (0..=count)
        .map(|mark| [top[0], top[1] + 10.0 * mark as f64])
        .collect()
}

#[cfg(test)]
mod tests {
    use super::super::plot::{PlotAxis, Ticks};
    use super::*;

    #[test]
    fn a_plot_holds_its_lines_and_ticks_and_escapes_words() {
        let axis = |label: &str, ticks| PlotAxis {
            label: label.to_owned(),
            ticks,
        };
        let line = Line {
            points: vec![[0.0, 1.0], [0.5, 3.0]],
            colour: "#123456",
            name: Some("a <line>".to_owned()),
            dashed: true,
        };
        let words = Ticks::Words([0.0, 0.5], vec![(0.0, "none".to_owned())]);
        let own = Plot {
            title: String::new(),
            x: axis("across", words),
            y: axis("up", Ticks::With(0.0)),
            bands: Vec::new(),
            lines: vec![line],
            marks: Vec::new(),
            notes: Vec::new(),
        };
        let svg = plot(&own, "a \"plot\"");
        for part in [
            "aria-label=\"a &quot;plot&quot;\"",
            "a &lt;line&gt;",
            ">none</text>",
            ">3.0</text>",
            "stroke=\"#123456\" stroke-width=\"1.8\" stroke-dasharray=\"6 4\"",
        ] {
            assert!(svg.contains(part), "{part} in {svg}");
        }
    }
}
