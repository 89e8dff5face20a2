//! What a plot holds: points, lines and bands with their colours, in the units of their axes.

use super::marks::Filling;
use crate::method::Look;

/// Lines and points over two axes.
#[derive(Default)]
pub struct Plot {
    /// Heading; may be empty.
    pub title: String,
    /// What stands below it in small print; may be empty.
    pub about: String,
    /// From left to right.
    pub x: PlotAxis,
    /// From bottom to top.
    pub y: PlotAxis,
    /// Shaded from one height to another over the whole width, behind everything.
    pub bands: Vec<Band>,
    /// Shaded between two lines.
    pub ranges: Vec<Between>,
    /// Lines, under the points.
    pub lines: Vec<Line>,
    /// Points of one look each.
    pub marks: Vec<Marks>,
}

/// An axis.
#[derive(Default)]
pub struct PlotAxis {
    /// What it shows, with its unit.
    pub label: String,
    /// What part of it is shown and how it is labelled.
    pub ticks: Ticks,
}

/// What part of an axis is shown and how it is labelled.
#[derive(Default)]
pub enum Ticks {
    /// As the data ask for, with round numbers.
    #[default]
    Fitting,
    /// Values are powers of ten, from one end to the other; ticks at whole powers up to the last,
    /// labelled with the number.
    Decades([f64; 2], i32),
    /// From one end to the other, with these words at these values.
    Words([f64; 2], Vec<(f64, String)>),
}

/// A shaded part of a plot.
pub struct Band {
    /// Lower and upper end.
    pub ends: [f64; 2],
    /// Its colour, which is thinned.
    pub colour: &'static str,
}

/// What lies between two lines of the same abscissas.
pub struct Between {
    /// Abscissa, lower and upper value.
    pub points: Vec<[f64; 3]>,
    /// Its colour, which is thinned.
    pub colour: &'static str,
}

/// A line.
pub struct Line {
    /// What it goes through.
    pub points: Vec<[f64; 2]>,
    pub colour: &'static str,
    /// A name at its right end, if it has one.
    pub name: Option<String>,
    /// Whether it is broken.
    pub dashed: bool,
}

/// Points of one look.
pub struct Marks {
    pub look: Look,
    pub points: Vec<PlotPoint>,
}

/// A point.
pub struct PlotPoint {
    /// Where it is.
    pub at: [f64; 2],
    /// How far a bar reaches down from it; 0 for none.
    pub below: f64,
    /// How it is filled.
    pub filling: Filling,
    /// A name that is placed beside it, if it has one.
    pub name: Option<String>,
    /// What a pointer over it shows; may be empty.
    pub tooltip: String,
}

impl Plot {
    /// All values along one axis, 0 for x and 1 for y.
    pub(super) fn values(&self, axis: usize) -> impl Iterator<Item = f64> + '_ {
        let lines = self.lines.iter().flat_map(|line| &line.points);
        let points = self.marks.iter().flat_map(|marks| &marks.points);
        let ranges = self.ranges.iter().flat_map(|range| &range.points);
        let ends = ranges.flat_map(|&[x, low, high]| [[x, low], [x, high]]);
        lines
            .copied()
            .chain(points.map(|point| point.at))
            .chain(ends)
            .map(move |at| at[axis])
    }
}
