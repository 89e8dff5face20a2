//! Facts of the sequential method.

use std::fmt;

use serde::{Deserialize, Serialize};

/// How the sequential method ended, and after how many steps.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct SequentialFacts {
    pub ending: SequentialEnding,
    /// Sub-programs solved after the associative one.
    pub steps: usize,
}

/// How the sequential method ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum SequentialEnding {
    /// λ settled.
    Converged,
    /// λ settled below 0, where a push begins.
    BelowZero,
    /// λ repeats itself.
    Cycling {
        /// Steps after which it does.
        period: usize,
    },
    /// A sub-program has no force state.
    SubProgramInfeasible,
    /// λ of a sub-program grows without limit.
    SubProgramUnbounded,
    /// The solver gave up on a sub-program.
    SubProgramUnsolved,
    /// λ did not settle within the steps allowed.
    StepLimit,
}

impl fmt::Display for SequentialFacts {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        use SequentialEnding::*;
        let steps = self.steps;
        match self.ending {
            Converged => write!(f, "the iteration converged"),
            BelowZero => write!(
                f,
                "the iteration converged to a λ below 0, where a push begins"
            ),
            Cycling { period } => write!(
                f,
                "the iteration repeats itself every {period} steps, which was seen at step {steps}"
            ),
            SubProgramInfeasible => {
                write!(f, "the linear program of step {steps} has no force state")
            }
            SubProgramUnbounded => {
                write!(f, "in the linear program of step {steps} λ has no limit")
            }
            SubProgramUnsolved => write!(
                f,
                "the solver gave up on the linear program of step {steps}"
            ),
            StepLimit => write!(f, "the iteration did not converge within {steps} steps"),
        }
    }
}
