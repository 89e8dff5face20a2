//! Plots as drawings: alone, or below one another with a common legend.

use super::axes::{Area, scale};
use super::legend::{self, Sample};
use super::marks::{Filling, mark};
use super::names::{self, HEIGHT, Rectangle, SIZE as NAME, spread};
use super::palette::LEADER;
use super::plot::{Line, Plot, PlotPoint, Ticks};
use super::svg::{Anchor, Path, Pixel, Style, Svg, style};
use super::words::{text_width, written};
use crate::method::{Look, Mark, look};

/// Pixels of a plot: narrow enough to be read on a telephone and beside text in print.
const SIZE: [f64; 2] = [480.0, 350.0];

/// Pixels between the edges of a plot and its area: left, top, right, bottom.
const MARGINS: [f64; 4] = [66.0, 12.0, 18.0, 52.0];

/// Pixels from the left edge to the base line of the left axis' label.
const LABEL: f64 = 18.0;

/// Pixels around plots and their legend, and what is left between them.
const BORDER: f64 = 14.0;
const INSIDE: f64 = SIZE[0] - 2.0 * BORDER;

/// Pixels below which two lines cover each other, and from the end of a line to that of its plot.
const COVERS: f64 = 1.2;
const AT_EDGE: f64 = 3.0;

/// Pixels between a line's end and its name.
const LEADER_WIDTH: f64 = 16.0;

/// Plots below one another below a title, which may be empty, and a legend, as a whole SVG file.
pub fn plots(title: &str, plots: &[Plot], entries: &[(Sample, &str)]) -> String {
    let mut svg = Svg::default();
    let at = [BORDER, BORDER + 14.0];
    let mut y = BORDER + written(&mut svg, at, title, (15.0, true), INSIDE, 19.0);
    if !title.is_empty() {
        y += 4.0;
    }
    y += legend::draw(&mut svg, entries, [BORDER, y], INSIDE);
    for plot in plots {
        y += BORDER;
        y += panel(&mut svg, plot, y);
    }
    let first = plots.first().map_or("", |plot| plot.title.as_str());
    let name = if title.is_empty() { first } else { title };
    svg.document([SIZE[0], y], name)
}

/// Gives plots that have the same label along an axis the same axis.
pub fn share_axes(plots: &mut [Plot]) {
    for axis in [0, 1] {
        let label = |plot: &Plot| [&plot.x, &plot.y][axis].label.clone();
        let is_alike = plots
            .windows(2)
            .all(|pair| label(&pair[0]) == label(&pair[1]));
        let fits = |plot: &Plot| matches!([&plot.x, &plot.y][axis].ticks, Ticks::Fitting);
        if !is_alike || !plots.iter().all(fits) {
            continue;
        }
        let values = plots.iter().flat_map(|plot| plot.values(axis));
        let (ends, ticks) = scale(&Ticks::Fitting, values);
        for plot in plots.iter_mut() {
            let own = if axis == 0 { &mut plot.x } else { &mut plot.y };
            own.ticks = Ticks::Words(ends, ticks.clone());
        }
    }
}

/// One plot below a height; the pixels that it takes downwards.
fn panel(svg: &mut Svg, plot: &Plot, y: f64) -> f64 {
    let [left, top, right, bottom] = MARGINS;
    let mut words = 0.0;
    for (text, size) in [(&plot.title, (14.0, true)), (&plot.about, (12.0, false))] {
        words += written(svg, [BORDER, y + words + 13.0], text, size, INSIDE, 17.0);
    }
    let widest = |words: &mut dyn Iterator<Item = &str>| {
        let widths = words.map(|name| text_width(name, NAME));
        widths.fold(0.0, f64::max)
    };
    let names = widest(&mut plot.lines.iter().filter_map(|line| line.name.as_deref()));
    let (y_ends, y_ticks) = scale(&plot.y.ticks, plot.values(1));
    let labels = widest(&mut y_ticks.iter().map(|(_, words)| words.as_str()));
    let label = if plot.y.label.is_empty() { 0.0 } else { LABEL };
    let left = left.max(labels + 14.0 + label);
    let (x_ends, x_ticks) = scale(&plot.x.ticks, plot.values(0));
    let last = widest(&mut x_ticks.last().into_iter().map(|(_, words)| words.as_str()));
    let right = match names > 0.0 {
        true => LEADER_WIDTH + names + 6.0,
        false => right.max(last / 2.0 + 6.0),
    };
    let area = Area {
        corner: [left, y + words + top],
        size: [SIZE[0] - left - right, SIZE[1] - top - bottom],
        x: x_ends,
        y: y_ends,
    };
    if let Some((ends, colour)) = plot.band {
        let [low, high] = ends.map(|end| area.at([area.x[0], end]));
        let fill = style().fill(colour).fill_opacity(0.12);
        svg.rect(high, [area.size[0], low[1] - high[1]], fill);
    }
    area.x_axis(svg, &x_ticks, &plot.x.label);
    area.y_axis(svg, &y_ticks, &plot.y.label, left - LABEL);
    for (points, colour) in &plot.ranges {
        let lower = points.iter().map(|&[x, low, _]| area.at([x, low]));
        let upper = points.iter().map(|&[x, _, high]| area.at([x, high]));
        let outline: Vec<Pixel> = lower.chain(upper.rev()).collect();
        let fill = style().class("range").fill(colour).fill_opacity(0.22);
        svg.path(&Path::through(&outline, true), fill, "");
    }
    lines(svg, &plot.lines, &area);
    missing(svg, &plot.missing, &area);
    line_names(svg, &plot.lines, &area);
    let named = named(plot, &area);
    for (_, point, middle) in &named {
        let leader = style().stroke(LEADER).stroke_width(0.6);
        svg.path(&Path::through(&[*point, *middle], false), leader, "");
    }
    for (look, marks) in &plot.marks {
        points(svg, *look, marks, &area);
    }
    for (name, _, [x, y]) in &named {
        let halo = style().class("name").font_size(NAME).halo();
        svg.text([*x, *y + 4.0], Anchor::Middle, halo, name);
    }
    words + SIZE[1]
}

pub fn solid_line(colour: &str) -> Style {
    style().line(colour, 1.8)
}

pub fn dashed_line(colour: &str) -> Style {
    style().line(colour, 1.1).dashes("6 4")
}

/// Lines as curves, those of one point as discs.
fn lines(svg: &mut Svg, lines: &[Line], area: &Area) {
    for (index, line) in lines.iter().enumerate() {
        let points: Vec<Pixel> = line.points.iter().map(|&point| area.at(point)).collect();
        let before = lines[..index].iter();
        let below =
            before.filter(|other| other.dashed == line.dashed && coincide(line, other, area));
        let style = match (line.dashed, below.count()) {
            (true, _) => dashed_line(line.colour),
            (false, 0) => solid_line(line.colour),
            // What lies below is seen between the dashes.
            (false, 1) => solid_line(line.colour).dashes("8 8"),
            (false, _) => solid_line(line.colour).dashes("3 13"),
        };
        svg.path(&Path::through(&points, false), style.class("curve"), "");
        if let [point] = points[..] {
            mark(svg, point, look(line.colour, Mark::Circle), Filling::Full);
        }
    }
}

/// Whether lines lie on each other wherever both have points, at two points or more.
fn coincide(one: &Line, other: &Line, area: &Area) -> bool {
    let pairs = one.points.iter().flat_map(|a| {
        let mut others = other.points.iter();
        others
            .find(|b| b[0] == a[0])
            .map(|b| (area.at(*a)[1], area.at(*b)[1]))
    });
    let apart: Vec<f64> = pairs.map(|(a, b)| (a - b).abs()).collect();
    apart.len() > 1 && apart.iter().all(|apart| *apart < COVERS)
}

/// Crosses at the foot of a plot, above one another at one place.
fn missing(svg: &mut Svg, missing: &[(f64, &'static str)], area: &Area) {
    for (index, (x, colour)) in missing.iter().enumerate() {
        let below = missing[..index]
            .iter()
            .filter(|(other, _)| other == x)
            .count();
        let [x, _] = area.at([*x, area.y[0]]);
        let at = [x, area.bottom() - 7.0 - 9.0 * below as f64];
        svg.open(style().class("missing"), "no answer");
        mark(svg, at, look(colour, Mark::Cross), Filling::Full);
        svg.close();
    }
}

/// Names at the right ends of lines, spread so that none covers another.
fn line_names(svg: &mut Svg, lines: &[Line], area: &Area) {
    let ends = lines.iter().filter_map(|line| {
        let end = area.at(*line.points.last()?);
        Some((line.name.as_deref()?, line.colour, end))
    });
    let ends: Vec<(&str, &str, Pixel)> = ends.collect();
    let wishes: Vec<f64> = ends.iter().map(|(.., [_, y])| *y).collect();
    let room = [area.corner[1] + 4.0, area.bottom() - 4.0];
    let heights = spread(&wishes, HEIGHT, room);
    let right = area.corner[0] + area.size[0];
    for ((name, colour, end), y) in ends.into_iter().zip(heights) {
        let leader = Path::through(&[end, [right + LEADER_WIDTH - 3.0, y]], false);
        // A line that ends before the plot does must not look as if it went on.
        let line = match right - end[0] < AT_EDGE {
            true => style().stroke(colour).stroke_width(0.8),
            false => style().stroke(LEADER).stroke_width(0.7).dashes("1 4"),
        };
        svg.path(&leader, line.class("leader"), "");
        let style = style().class("name").font_size(NAME);
        svg.text([right + LEADER_WIDTH, y + 4.0], Anchor::Start, style, name);
    }
}

/// Points of one look, and their bars below them.
fn points(svg: &mut Svg, look: Look, points: &[PlotPoint], area: &Area) {
    let mut bars = Path::default();
    for PlotPoint { at, below, .. } in points {
        let ([x, top], [_, foot]) = (area.at(*at), area.at([at[0], at[1] - below]));
        if *below > 0.0 {
            bars.add(&[[x, top], [x, foot]], false);
            bars.add(&[[x - 4.0, foot], [x + 4.0, foot]], false);
        }
    }
    svg.path(&bars, style().line(look.colour, 1.1), "");
    for point in points {
        let hinted = !point.tooltip.is_empty();
        if hinted {
            svg.open(style().class("point"), &point.tooltip);
        }
        mark(svg, area.at(point.at), look, point.filling);
        if hinted {
            svg.close();
        }
    }
}

/// Names of points from left to right, each with its point and the middle of its own line.
fn named<'a>(plot: &'a Plot, area: &Area) -> Vec<(&'a str, Pixel, Pixel)> {
    let [left, top] = area.corner;
    let covered = plot.points().map(|point| {
        let [a, b, c, d] = covered(point, area);
        [a - left, b - top, c - left, d - top]
    });
    let covered: Vec<Rectangle> = covered.collect();
    let named = plot.points();
    let named = named.filter_map(|point| Some((point.name.as_deref()?, area.at(point.at))));
    let mut named: Vec<(&str, Pixel)> = named.collect();
    named.sort_by(|(_, a), (_, b)| a[0].total_cmp(&b[0]));
    let inside = named
        .iter()
        .map(|(name, [x, y])| ([x - left, y - top], *name));
    let placed = names::place(&inside.collect::<Vec<_>>(), &covered, area.size);
    let named = named.into_iter().zip(placed);
    let named = named.map(|((name, at), [x, y])| (name, at, [left + x, top + y]));
    named.collect()
}

fn covered(point: &PlotPoint, area: &Area) -> Rectangle {
    let [x, y] = point.at;
    let [top, bottom] = [y, y - point.below].map(|y| area.at([x, y]));
    [top[0] - 5.0, top[1] - 5.0, top[0] + 5.0, bottom[1] + 5.0]
}

#[cfg(test)]
mod tests {
    use super::super::plot::PlotAxis;
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
