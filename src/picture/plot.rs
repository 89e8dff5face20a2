//! What a plot holds: points, lines and bands with their colours, in the units of their axes.

use super::marks::Filling;
use crate::method::Look;

/// Lines and points over two axes. Title and small print may be empty.
#[derive(Default)]
pub struct Plot {
    pub title: String,
    /// What stands below the title in small print.
    pub about: String,
    pub x: PlotAxis,
    pub y: PlotAxis,
    /// Shaded from one height to another over the whole width, behind everything.
    pub band: Option<([f64; 2], &'static str)>,
    /// Shaded between two lines: abscissa, lower and upper value, and the colour, which is thinned.
    pub ranges: Vec<(Vec<[f64; 3]>, &'static str)>,
    pub lines: Vec<Line>,
    pub marks: Vec<(Look, Vec<PlotPoint>)>,
    /// Where along the axis something has no value, in its colour: marked at the foot of the plot.
    pub missing: Vec<(f64, &'static str)>,
}

#[derive(Default)]
pub struct PlotAxis {
    pub label: String,
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

#[derive(Default)]
pub struct Line {
    pub points: Vec<[f64; 2]>,
    pub colour: &'static str,
    /// A name at its right end, if it has one.
    pub name: Option<String>,
    pub dashed: bool,
}

pub struct PlotPoint {
    pub at: [f64; 2],
    /// How far a bar reaches down from it; 0 for none.
    pub below: f64,
    pub filling: Filling,
    /// A name that is placed beside it, if it has one.
    pub name: Option<String>,
    /// What a pointer over it shows; may be empty.
    pub tooltip: String,
}

impl Plot {
    pub(super) fn points(&self) -> impl Iterator<Item = &PlotPoint> {
        self.marks.iter().flat_map(|(_, points)| points)
    }

    /// All values along one axis, 0 for x and 1 for y.
    pub(super) fn values(&self, axis: usize) -> impl Iterator<Item = f64> + '_ {
        let lines = self.lines.iter().flat_map(|line| &line.points).copied();
        let ranges = self.ranges.iter().flat_map(|(points, _)| points);
        let ends = ranges.flat_map(|&[x, low, high]| [[x, low], [x, high]]);
        let all = lines.chain(self.points().map(|point| point.at)).chain(ends);
        all.map(move |at| at[axis])
    }
}
