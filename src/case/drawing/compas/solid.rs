//! A block in space.

use std::ops::Range;

use crate::case::complaint::Complaint;
use crate::number::ends_of;

/// A point in space; z points up.
pub(super) type Point3 = [f64; 3];

/// A block of a model, in the model's coordinates.
#[derive(Default)]
pub(super) struct Solid {
    pub name: String,
    /// COMPAS's own name for it, which no other object has.
    pub guid: String,
    /// Where it stands in the file.
    pub place: Range<usize>,
    pub vertices: Vec<Point3>,
    /// Places of each face's corners among the vertices.
    pub faces: Vec<Vec<usize>>,
    pub is_support: bool,
    /// Mass over volume of its material.
    pub density: Option<f64>,
}

impl Solid {
    /// What is wrong with it.
    pub fn complain(&self, title: &str) -> Complaint {
        Complaint::at(
            self.place.clone(),
            title,
            format!("the block `{}`", self.name),
        )
    }

    /// The diagonal of the box that holds it.
    pub fn extent(&self) -> f64 {
        let range = |axis: usize| {
            let [least, largest] = ends_of(self.vertices.iter().map(|vertex| vertex[axis]));
            largest - least
        };
        [0, 1, 2]
            .map(range)
            .iter()
            .map(|side| side * side)
            .sum::<f64>()
            .sqrt()
    }
}
