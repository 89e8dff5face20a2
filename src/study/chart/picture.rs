//! The picture: a panel a scene, time and error on log axes.
//!
//! Logarithms are plotted on linear axes whose ticks say what they stand for, so that bars, names
//! and the band of failures are placed in decades.

use std::sync::Arc;

use indexmap::IndexSet;

use kuva::backend::svg::SvgBackend;
use kuva::prelude::{LegendEntry, LegendShape, LinePlot, MarkerShape, ScatterPlot};
use kuva::render::annotations::{ShadedRegion, TextAnnotation};
use kuva::render::figure::Figure;
use kuva::render::layout::{Layout, TickFormat};
use kuva::render::plots::Plot;

use super::table::Entry;
use super::{front, labels};
use crate::method::METHODS;
use crate::number::short;

/// Errors below this are drawn at it: the references have six digits.
pub const FLOOR: f64 = 1e-6;

/// Colours (Okabe & Ito, for all eyes) and markers, in the order of the methods, then of the
/// external ones.
const LOOKS: [(&str, MarkerShape); 8] = [
    ("#999999", MarkerShape::Square),
    ("#0072B2", MarkerShape::Circle),
    ("#E69F00", MarkerShape::Triangle),
    ("#009E73", MarkerShape::Diamond),
    ("#D55E00", MarkerShape::TriangleDown),
    ("#CC79A7", MarkerShape::Star),
    ("#000000", MarkerShape::Plus),
    ("#56B4E9", MarkerShape::Cross),
];

/// Panels in a row.
const COLUMNS: usize = 2;

/// Pixels of a panel, and of the margins inside it that hold title, ticks and axis labels.
const PANEL: [f64; 2] = [660.0, 430.0];
const MARGINS: [f64; 2] = [95.0, 100.0];

/// The plane of all panels, in decades.
#[derive(Clone, Copy)]
struct Plane {
    seconds: [f64; 2],
    errors: [f64; 2],
}

impl Plane {
    fn of(entries: &[Entry]) -> Self {
        let logs = || {
            entries
                .iter()
                .map(|entry| entry.row.seconds.max(1e-9).log10())
        };
        let errors = entries.iter().filter_map(Entry::error);
        let largest = errors.fold(1e-2, f64::max).log10().ceil();
        Self {
            seconds: [
                logs().fold(f64::INFINITY, f64::min).floor(),
                logs().fold(-9.0, f64::max).ceil().max(-8.0),
            ],
            errors: [FLOOR.log10() - 0.5, largest + 1.0],
        }
    }

    /// Height of the band of failures.
    fn failures(&self) -> f64 {
        self.errors[1] - 0.5
    }

    fn place(&self, entry: &Entry) -> [f64; 2] {
        let y = match entry.error() {
            Some(error) => error.max(FLOOR).log10(),
            None => self.failures(),
        };
        [entry.row.seconds.max(1e-9).log10(), y]
    }

    fn size() -> [f64; 2] {
        [PANEL[0] - MARGINS[0], PANEL[1] - MARGINS[1]]
    }

    fn to_pixels(self, [x, y]: [f64; 2]) -> [f64; 2] {
        let [width, height] = Self::size();
        let part = |value: f64, [low, high]: [f64; 2]| (value - low) / (high - low);
        [
            part(x, self.seconds) * width,
            (1.0 - part(y, self.errors)) * height,
        ]
    }

    fn to_decades(self, [x, y]: [f64; 2]) -> [f64; 2] {
        let [width, height] = Self::size();
        let at = |part: f64, [low, high]: [f64; 2]| low + part * (high - low);
        [
            at(x / width, self.seconds),
            at(1.0 - y / height, self.errors),
        ]
    }
}

/// The chart as SVG: the same bytes for the same table.
pub fn picture(entries: &[Entry]) -> String {
    let cases: IndexSet<String> = entries.iter().map(|e| e.row.scene_name()).collect();
    let methods = methods(entries);
    let plane = Plane::of(entries);
    let (mut plots, mut layouts) = (Vec::new(), Vec::new());
    for case in &cases {
        let own: Vec<&Entry> = entries
            .iter()
            .filter(|e| e.row.scene_name() == *case)
            .collect();
        let (panel, layout) = panel(&own, &methods, plane);
        plots.push(panel);
        layouts.push(layout);
    }
    let rows = cases.len().div_ceil(COLUMNS);
    let legend = methods.iter().enumerate().map(|(index, name)| {
        let (color, marker) = look(index);
        LegendEntry {
            label: (*name).to_owned(),
            color: color.to_owned(),
            shape: LegendShape::Marker(marker),
            dasharray: None,
        }
    });
    let figure = Figure::new(rows, COLUMNS.min(cases.len().max(1)))
        .with_title("Speed against accuracy: CPU time, and error of the farther end of the bracket")
        .with_title_size(18)
        .with_plots(plots)
        .with_layouts(layouts)
        .with_cell_size(PANEL[0], PANEL[1])
        .with_shared_legend_right_top()
        .with_shared_legend_entries(legend.collect());
    settled(&SvgBackend::new().render_scene(&figure.render()))
}

fn look(index: usize) -> (&'static str, MarkerShape) {
    LOOKS[index.min(LOOKS.len() - 1)]
}

/// Names of the methods, those of the list first and in its order.
fn methods(entries: &[Entry]) -> Vec<&str> {
    let mut names: Vec<&str> = METHODS.iter().map(|method| method.name()).collect();
    for entry in entries {
        if !names.contains(&entry.row.method.as_str()) {
            names.push(&entry.row.method);
        }
    }
    names
}

/// One scene: points with bars, the front with names, the band of failures.
fn panel(own: &[&Entry], methods: &[&str], plane: Plane) -> (Vec<Plot>, Layout) {
    let mut plots = Vec::new();
    let front = front(own);
    let steps = steps(&front, plane);
    plots.push(Plot::Line(
        LinePlot::new()
            .with_data(steps)
            .with_color("#bbbbbb")
            .with_stroke_width(2.0),
    ));
    for (index, method) in methods.iter().enumerate() {
        let of_method: Vec<&&Entry> = own.iter().filter(|e| e.row.method == *method).collect();
        if of_method.is_empty() {
            continue;
        }
        let (color, marker) = look(index);
        let bars = of_method.iter().map(|entry| (below(entry), 0.0));
        let data = of_method.iter().map(|entry| plane.place(entry).into());
        let data: Vec<(f64, f64)> = data.collect();
        plots.push(Plot::Scatter(
            ScatterPlot::new()
                .with_data(data)
                .with_y_err_asymmetric(bars)
                .with_color(color)
                .with_marker(marker)
                .with_size(4.5)
                .with_marker_opacity(0.85),
        ));
    }
    let points: Vec<[f64; 2]> = own.iter().flat_map(|entry| marks(entry, plane)).collect();
    let names: Vec<String> = front.iter().map(|entry| entry.name()).collect();
    let named: Vec<([f64; 2], &str)> = (front.iter().zip(&names))
        .map(|(entry, name)| (plane.to_pixels(plane.place(entry)), name.as_str()))
        .collect();
    let placed = labels::place(&named, &points, Plane::size());
    let mut layout = layout(own, plane);
    for (&(point, name), middle) in named.iter().zip(placed) {
        let (from, to) = (plane.to_decades(point), plane.to_decades(middle));
        plots.push(Plot::Line(
            LinePlot::new()
                .with_data([(from[0], from[1]), (to[0], to[1])])
                .with_color("#888888")
                .with_stroke_width(0.6),
        ));
        // Text stands 6 pixels above its anchor.
        let anchor = plane.to_decades([middle[0], middle[1] + 10.0]);
        layout = layout
            .with_annotation(TextAnnotation::new(name, anchor[0], anchor[1]).with_font_size(11));
    }
    (plots, layout)
}

/// Pixels that a point and its bar cover, a mark every ten.
fn marks(entry: &Entry, plane: Plane) -> Vec<[f64; 2]> {
    let [x, y] = plane.place(entry);
    let [top, bottom] = [y, y - below(entry)].map(|y| plane.to_pixels([x, y]));
    let count = ((bottom[1] - top[1]) / 10.0).floor().max(0.0) as usize;
    (0..=count)
        .map(|mark| [top[0], top[1] + 10.0 * mark as f64])
        .collect()
}

/// From the error down to the nearer end of the bracket, in decades; nothing for what is one number.
fn below(entry: &Entry) -> f64 {
    match (entry.error(), entry.nearest()) {
        (Some(error), Some(nearest)) => error.max(FLOOR).log10() - nearest.max(FLOOR).log10(),
        _ => 0.0,
    }
}

/// The front as a staircase.
fn steps(front: &[&Entry], plane: Plane) -> Vec<(f64, f64)> {
    let mut steps: Vec<(f64, f64)> = Vec::new();
    for entry in front {
        let [x, y] = plane.place(entry);
        if let Some(&(_, before)) = steps.last() {
            steps.push((x, before));
        }
        steps.push((x, y));
    }
    if let Some(&(_, last)) = steps.last() {
        steps.push((plane.seconds[1], last));
    }
    steps
}

fn layout(own: &[&Entry], plane: Plane) -> Layout {
    let known = own.first().and_then(|entry| entry.reference.as_ref());
    let against = known.map_or(String::new(), |known| {
        let source = format!("{} {}", known.kind.name(), known.method);
        format!(" against {} ({source})", short(known.value, 6))
    });
    let case = own
        .first()
        .map_or(String::new(), |entry| entry.row.scene_name());
    let limit = plane.errors[1] - 1.0;
    let failures = plane.failures();
    let error = move |y: f64| {
        if y > limit + 0.01 || (y - y.round()).abs() > 0.01 {
            return String::new();
        }
        match 10f64.powf(y) {
            floor if floor <= 1.01 * FLOOR => "≤ 1e-6".to_owned(),
            error if error < 0.99e-3 => format!("1e{y:.0}"),
            error => format!("{} %", short(100.0 * error, 1)),
        }
    };
    Layout::new(
        (plane.seconds[0], plane.seconds[1]),
        (plane.errors[0], plane.errors[1]),
    )
    .with_x_axis_min(plane.seconds[0])
    .with_x_axis_max(plane.seconds[1])
    .with_y_axis_min(plane.errors[0])
    .with_y_axis_max(plane.errors[1])
    .with_x_tick_step(1.0)
    .with_y_tick_step(1.0)
    .with_x_tick_format(TickFormat::Custom(Arc::new(duration)))
    .with_y_tick_format(TickFormat::Custom(Arc::new(error)))
    .with_title(format!("{case}{against}"))
    .with_title_size(14)
    .with_label_size(12)
    .with_tick_size(11)
    .with_x_label("CPU time, median")
    .with_y_label("error, relative")
    .with_shaded_region(
        ShadedRegion::horizontal(limit, plane.errors[1])
            .with_color("#dd4444")
            .with_opacity(0.12),
    )
    .with_annotation(
        TextAnnotation::new("no answer", plane.seconds[0] + 0.45, failures - 0.05)
            .with_font_size(11),
    )
}

/// A power of ten in seconds, in words.
fn duration(x: f64) -> String {
    if (x - x.round()).abs() > 0.01 {
        return String::new();
    }
    let x = x.round() as i32;
    let digits = |power: i32| 10i64.pow(power.clamp(0, 18) as u32);
    match x {
        ..-6 => format!("{} ns", digits(x + 9)),
        -6..-3 => format!("{} µs", digits(x + 6)),
        -3..0 => format!("{} ms", digits(x + 3)),
        _ => format!("{} s", digits(x)),
    }
}

/// The picture without what differs from run to run: ids come from a counter of the process, a
/// comment names the version.
fn settled(svg: &str) -> String {
    const ID: &str = "kuva-clip-";
    let mut parts = svg.split(ID);
    let mut text = parts.next().unwrap_or_default().to_owned();
    let mut known: Vec<&str> = Vec::new();
    for part in parts {
        let end = part
            .find(|c: char| !c.is_ascii_digit())
            .unwrap_or(part.len());
        let (number, rest) = part.split_at(end);
        let place = known.iter().position(|other| *other == number);
        let place = place.unwrap_or_else(|| {
            known.push(number);
            known.len() - 1
        });
        text.push_str(&format!("clip-{place}{rest}"));
    }
    match (text.find("<!--"), text.find("-->")) {
        (Some(begin), Some(end)) if begin < end => text.replace_range(begin..end + 3, ""),
        _ => {}
    }
    text.push('\n');
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ticks_say_what_the_decades_are() {
        let words: Vec<String> = [-7.0, -6.0, -4.0, -3.0, -1.0, 0.0, 2.0]
            .map(duration)
            .to_vec();
        assert_eq!(
            words,
            ["100 ns", "1 µs", "100 µs", "1 ms", "100 ms", "1 s", "100 s"]
        );
    }
}
