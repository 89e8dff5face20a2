//! The numbers of a linear program and what a solver says of it.

use clarabel::algebra::CscMatrix;

use crate::answer::SolverEnding;
use crate::method::settings::Engine;

/// The numbers of a program over the joints of one scene, in its own units: two corner forces and a
/// shear a joint, then λ or the slack where there is one.
pub(super) struct Numbers {
    /// Three equilibrium rows a block, then four inequalities a joint.
    pub(super) matrix: CscMatrix<f64>,
    pub(super) right: Vec<f64>,
    /// Cost of every variable, the sum to be smallest.
    pub(super) cost: Vec<f64>,
    /// Slope of the friction law of every joint.
    pub(super) slopes: Vec<f64>,
    pub(super) rows_of_blocks: usize,
    /// Relative tolerance of gap and residuals.
    pub(super) tolerance: f64,
    /// Relative width of λ* that is enough where rounding leaves no better answer; whoever sets it
    /// tests what the answer proves.
    pub(super) width: f64,
    /// Cost above which an optimum is of no use: once it is known to lie there, the solver may end with any
    /// forces in equilibrium.
    pub(super) useless_above: f64,
    /// Whether blocks or joints have units of their own.
    pub(super) has_own_units: bool,
    /// Whether there is a slack that all inequalities share.
    pub(super) has_slack: bool,
}

impl Numbers {
    /// What solves the program where nothing else is asked for: Clarabel where blocks or joints have units
    /// of their own, as it leaves the least of them, or where inequalities share a slack.
    pub(super) fn engine(&self) -> Engine {
        if self.has_own_units || self.has_slack {
            Engine::Clarabel
        } else {
            Engine::Structured
        }
    }
}

pub(super) struct Solved {
    pub(super) ending: SolverEnding,
    /// Values of all variables at an optimum.
    pub(super) variables: Vec<f64>,
    /// Velocities at an optimum, or those by which the solver shows that there are no forces.
    pub(super) velocities: Vec<f64>,
    pub(super) iterations: usize,
    pub(super) engine: Engine,
}
