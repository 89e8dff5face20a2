//! What single courses, joints and blocks of a coursed wall have of their own.

use std::collections::{BTreeMap, BTreeSet};

use super::assembly::Forces;
use super::joints::NamedJoint;

/// What differs from one course, joint or block of a coursed wall to the next. Courses count from 1 at
/// the bottom, blocks are named by their place in the scene.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Own {
    /// Heights of the courses from bottom to top; empty where all are as high as a unit.
    pub heights: Vec<f64>,
    /// Coefficients of friction of the joint that a course lies on; of course 1 that is the base.
    pub beds: BTreeMap<usize, f64>,
    /// Courses whose head joints are open, whatever the others carry.
    pub open: BTreeSet<usize>,
    /// Single joints; what they say goes before `beds` and `open`.
    pub joints: Vec<NamedJoint>,
    /// Names of blocks, instead of course and piece.
    pub names: BTreeMap<usize, String>,
    /// Weights, instead of the specific weight of the units times the block's volume; positive.
    pub weights: BTreeMap<usize, f64>,
    /// Coefficients of friction of blocks (see [`NamedBlock`](super::NamedBlock)).
    pub frictions: BTreeMap<usize, f64>,
    /// Forces beside weights and overburden, and how those two are live load as well.
    pub forces: Forces,
}
