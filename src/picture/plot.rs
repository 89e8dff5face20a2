//! What a plot holds: points, lines and bands with their colours, in the units of their axes.

use crate::method::Look;

/// Lines and points over two axes.
pub struct Plot {
    /// Heading; may be empty.
    pub title: String,
    /// From left to right.
    pub x: PlotAxis,
    /// From bottom to top.
    pub y: PlotAxis,
    /// Shaded from one height to another over the whole width, behind everything.
    pub bands: Vec<Band>,
    /// Lines, under the points.
    pub lines: Vec<Line>,
    /// Points of one look each.
    pub marks: Vec<Marks>,
    /// Words over everything.
    pub notes: Vec<Note>,
}

/// An axis.
pub struct PlotAxis {
    /// What it shows, with its unit.
    pub label: String,
    /// What part of it is shown and how it is labelled.
    pub ticks: Ticks,
}

/// What part of an axis is shown and how it is labelled.
pub enum Ticks {
    /// As the data ask for, with round numbers.
    Fitting,
    /// The same, but with this value among what is shown.
    With(f64),
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

/// A line.
pub struct Line {
    /// What it goes through.
    pub points: Vec<[f64; 2]>,
    /// Its colour.
    pub colour: &'static str,
    /// Its name in the legend, if it has one.
    pub name: Option<String>,
    /// Whether it is broken.
    pub dashed: bool,
}

/// Points of one look.
pub struct Marks {
    /// The look.
    pub look: Look,
    /// The points.
    pub points: Vec<PlotPoint>,
}

/// A point.
pub struct PlotPoint {
    /// Where it is.
    pub at: [f64; 2],
    /// How far a bar reaches down from it; 0 for none.
    pub below: f64,
    /// A name that is placed beside it, if it has one.
    pub name: Option<String>,
}

/// Words in a plot.
pub struct Note {
    /// Middle of their line.
    pub at: [f64; 2],
    /// The words.
    pub words: &'static str,
}

impl Plot {
    /// All values along one axis, 0 for x and 1 for y.
    pub(super) fn values(&self, axis: usize) -> impl Iterator<Item = f64> + '_ {
        let lines = self.lines.iter().flat_map(|line| &line.points);
        let points = self.marks.iter().flat_map(|marks| &marks.points);
        lines
            .copied()
            .chain(points.map(|point| point.at))
            .map(move |at| at[axis])
    }
}
