//! Plots as drawings: alone, or below one another with a common legend.

use super::axes::{Area, scale};
use super::legend::{self, LegendEntry};
use super::marks::mark;
use super::metrics::{Rectangle, spread, text_width};
use super::names;
use super::palette::LEADER;
use super::path::{Path, Pixel};
use super::plot::{Line, Marks, Plot, PlotPoint};
use super::svg::{Anchor, Style, Svg, style};
use super::words::fitting;

/// Pixels of a plot: narrow enough to be read on a telephone and beside text in print.
const SIZE: [f64; 2] = [480.0, 350.0];

/// Pixels between the edges of a plot and its area: left, top, right, bottom.
const MARGINS: [f64; 4] = [66.0, 12.0, 18.0, 52.0];

/// Pixels of a line of a heading.
const HEADING: f64 = 19.0;

/// Pixels from the left edge to the base line of the left axis' label.
const LABEL: f64 = 18.0;

/// Pixels around plots and their legend.
const BORDER: f64 = 14.0;

/// Font size of names at lines, and pixels from one to the next.
const NAME: f64 = 12.0;
const NAME_LINE: f64 = 14.0;

/// Pixels between a line's end and its name.
const LEADER_WIDTH: f64 = 16.0;

/// Plots below one another below a title, which may be empty, and a legend, as a whole SVG file.
pub fn plots(title: &str, plots: &[Plot], entries: &[LegendEntry]) -> String {
    let mut svg = Svg::default();
    let width = SIZE[0] - 2.0 * BORDER;
    let mut y = BORDER;
    for line in fitting(title, 15.0 * 1.06, width) {
        y += HEADING;
        let heading = style().font_size(15.0).bold();
        svg.text([BORDER, y - 5.0], Anchor::Start, heading, &line);
    }
    if !title.is_empty() {
        y += 4.0;
    }
    y += legend::draw(&mut svg, entries, [BORDER, y], width);
    for plot in plots {
        y += BORDER;
        y += panel(&mut svg, plot, [0.0, y]);
    }
    let first = plots.first().map_or("", |plot| plot.title.as_str());
    let name = if title.is_empty() { first } else { title };
    svg.document([SIZE[0], y], name)
}

/// One plot below a corner; the pixels that it takes downwards.
fn panel(svg: &mut Svg, plot: &Plot, [x, y]: Pixel) -> f64 {
    let [left, top, right, bottom] = MARGINS;
    let words = headings(svg, plot, [x, y]);
    let names = plot.lines.iter().filter_map(|line| line.name.as_deref());
    let widest = names.map(|name| text_width(name, NAME)).fold(0.0, f64::max);
    let (y_ends, y_ticks) = scale(&plot.y.ticks, plot.values(1));
    let labels = y_ticks.iter().map(|(_, words)| text_width(words, NAME));
    let label = if plot.y.label.is_empty() { 0.0 } else { LABEL };
    let left = left.max(labels.fold(0.0, f64::max) + 14.0 + label);
    let (x_ends, x_ticks) = scale(&plot.x.ticks, plot.values(0));
    let last = x_ticks
        .last()
        .map_or(0.0, |(_, words)| text_width(words, NAME));
    let right = match widest > 0.0 {
        true => LEADER_WIDTH + widest + 6.0,
        false => right.max(last / 2.0 + 6.0),
    };
    let area = Area {
        corner: [x + left, y + words + top],
        size: [SIZE[0] - left - right, SIZE[1] - top - bottom],
        x: x_ends,
        y: y_ends,
    };
    for band in &plot.bands {
        let [low, high] = band.ends.map(|end| area.at([area.x[0], end]));
        let fill = style().fill(band.colour).fill_opacity(0.12);
        svg.rect(high, [area.size[0], low[1] - high[1]], fill);
    }
    area.x_axis(svg, &x_ticks, &plot.x.label);
    area.y_axis(svg, &y_ticks, &plot.y.label, left - LABEL);
    for range in &plot.ranges {
        let lower = range.points.iter().map(|&[x, low, _]| area.at([x, low]));
        let upper = range.points.iter().rev();
        let upper = upper.map(|&[x, _, high]| area.at([x, high]));
        let outline: Vec<Pixel> = lower.chain(upper).collect();
        let fill = style().class("range").fill(range.colour).fill_opacity(0.22);
        svg.path(&Path::through(&outline, true), fill, "");
    }
    for line in &plot.lines {
        let points: Vec<Pixel> = line.points.iter().map(|&point| area.at(point)).collect();
        svg.path(&Path::through(&points, false), stroke(line), "");
    }
    line_names(svg, plot, &area);
    let named = named(plot, &area);
    for (_, point, middle) in &named {
        let leader = style().stroke(LEADER).stroke_width(0.6);
        svg.path(&Path::through(&[*point, *middle], false), leader, "");
    }
    for marks in &plot.marks {
        points(svg, marks, &area);
    }
    for (name, _, [x, y]) in &named {
        let halo = style().class("name").font_size(names::SIZE).halo();
        svg.text([*x, *y + 4.0], Anchor::Middle, halo, name);
    }
    words + SIZE[1]
}

/// Title and small print of a plot; the pixels that they take downwards.
fn headings(svg: &mut Svg, plot: &Plot, [x, y]: Pixel) -> f64 {
    let width = SIZE[0] - 2.0 * BORDER;
    let mut taken = 0.0;
    let parts = [
        (&plot.title, style().font_size(14.0).bold(), 14.0 * 1.06),
        (&plot.about, style().font_size(12.0), 12.0),
    ];
    for (text, style, size) in parts {
        for line in fitting(text, size, width) {
            taken += HEADING - 2.0;
            svg.text(
                [x + BORDER, y + taken - 4.0],
                Anchor::Start,
                style.clone(),
                &line,
            );
        }
    }
    taken
}

/// How lines of this colour look.
pub fn solid_line(colour: &str) -> Style {
    style().hollow().stroke(colour).stroke_width(1.8)
}

/// How broken lines of this colour look.
pub fn dashed_line(colour: &str) -> Style {
    style()
        .hollow()
        .stroke(colour)
        .stroke_width(1.1)
        .dashes("6 4")
}

fn stroke(line: &Line) -> Style {
    if line.dashed {
        dashed_line(line.colour)
    } else {
        solid_line(line.colour)
    }
}

/// Names at the right ends of lines, spread so that none covers another.
fn line_names(svg: &mut Svg, plot: &Plot, area: &Area) {
    let ends = plot.lines.iter().filter_map(|line| {
        let end = area.at(*line.points.last()?);
        Some((line.name.as_deref()?, line.colour, end))
    });
    let ends: Vec<(&str, &str, Pixel)> = ends.collect();
    let wishes: Vec<f64> = ends.iter().map(|(.., [_, y])| *y).collect();
    let heights = spread(
        &wishes,
        NAME_LINE,
        [area.corner[1] + 4.0, area.bottom() - 4.0],
    );
    let right = area.corner[0] + area.size[0];
    for ((name, colour, end), y) in ends.into_iter().zip(heights) {
        let leader = Path::through(&[end, [right + LEADER_WIDTH - 3.0, y]], false);
        svg.path(&leader, style().stroke(colour).stroke_width(0.8), "");
        let style = style().class("name").font_size(NAME);
        svg.text([right + LEADER_WIDTH, y + 4.0], Anchor::Start, style, name);
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
        let hinted = !point.tooltip.is_empty();
        if hinted {
            svg.open(style().class("point"), &point.tooltip);
        }
        mark(svg, area.at(point.at), marks.look, point.filling);
        if hinted {
            svg.close();
        }
    }
}

/// Names of points from left to right, each with its point and the middle of its own line.
fn named<'a>(plot: &'a Plot, area: &Area) -> Vec<(&'a str, Pixel, Pixel)> {
    let [left, top] = area.corner;
    let inside = |[x, y]: Pixel| [x - left, y - top];
    let points = || plot.marks.iter().flat_map(|marks| &marks.points);
    let covered = points().map(|point| covered(point, area));
    let covered = covered.map(|[a, b, c, d]| [a - left, b - top, c - left, d - top]);
    let covered: Vec<Rectangle> = covered.collect();
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

/// Pixels that a point and its bar cover.
fn covered(point: &PlotPoint, area: &Area) -> Rectangle {
    let [x, y] = point.at;
    let [top, bottom] = [y, y - point.below].map(|y| area.at([x, y]));
    [top[0] - 5.0, top[1] - 5.0, top[0] + 5.0, bottom[1] + 5.0]
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
            points: vec![[0.0, 0.0], [0.5, 3.0]],
            colour: "#123456",
            name: Some("a <line>".to_owned()),
            dashed: true,
        };
        let words = Ticks::Words([0.0, 0.5], vec![(0.0, "none".to_owned())]);
        let own = Plot {
            x: axis("across", words),
            y: axis("up", Ticks::Fitting),
            lines: vec![line],
            ..Plot::default()
        };
        let svg = plots("a \"plot\"", &[own], &[]);
        for part in [
            "aria-label=\"a &quot;plot&quot;\"",
            "a &lt;line&gt;",
            ">none</text>",
            ">3.0</text>",
            "stroke=\"#123456\" stroke-width=\"1.1\" stroke-dasharray=\"6 4\"",
        ] {
            assert!(svg.contains(part), "{part} in {svg}");
        }
    }
}
