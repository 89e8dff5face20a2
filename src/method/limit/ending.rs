//! How a linear program ended.

use crate::answer::SolverEnding;
use crate::mechanics::JointForce;
use crate::method::settings::Engine;

/// N of every joint, negative rounding cut off.
pub(super) fn totals(forces: &[JointForce]) -> Vec<f64> {
    let total = |force: &JointForce| (force.normal[0] + force.normal[1]).max(0.0);
    forces.iter().map(total).collect()
}

/// How a program ended.
#[derive(Clone, Debug)]
pub enum Ending {
    /// The solver reports an optimum. That is no proof.
    Solved(Solution),
    /// No force state satisfies the rows, for any λ; velocities as in a solution by which the
    /// solver shows that. No proof either.
    Infeasible(Vec<f64>),
    /// λ can grow without limit.
    Unbounded,
    /// The solver gave up; its own name for why.
    GaveUp(String),
}

impl Ending {
    /// Velocities: of the mechanism at an optimum, or those by which the solver shows that there are no
    /// forces.
    pub(super) fn velocity(self) -> Option<Vec<f64>> {
        match self {
            Ending::Solved(Solution { velocity, .. }) | Ending::Infeasible(velocity) => {
                Some(velocity)
            }
            Ending::Unbounded | Ending::GaveUp(_) => None,
        }
    }

    /// The ending without its numbers.
    pub fn kind(&self) -> SolverEnding {
        match self {
            Ending::Solved(_) => SolverEnding::Optimum,
            Ending::Infeasible(_) => SolverEnding::Infeasible,
            Ending::Unbounded => SolverEnding::Unbounded,
            Ending::GaveUp(why) => SolverEnding::GaveUp(why.clone()),
        }
    }
}

/// A force state and the mechanism dual to it, in dimensionless form: total weight 1, total live
/// load for λ* = 1 as large, wall height 1, and a mechanism on which that live load does unit work.
#[derive(Clone, Debug)]
pub struct Solution {
    /// Multiplier λ* of the force state.
    pub lambda: f64,
    /// Corner forces and shear of every joint.
    pub forces: Vec<JointForce>,
    /// Velocities (fx, fy about the centroid, rotation times height), three a block.
    pub velocity: Vec<f64>,
    /// Which solver found it.
    pub engine: Engine,
}
