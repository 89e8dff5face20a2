//! Facts of the lower bound by a lifted program.

use std::fmt;

use serde::{Deserialize, Serialize};

use crate::certificate::Proved;
use crate::number::below;

/// What a lifted program proves, or why it proves nothing.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub enum BoundFact {
    /// What its certificate proves.
    Proved(Proved),
    /// It is computed alone: scenes that can lock have forces without bounds, so that rounding is not
    /// bounded either.
    Uncertified,
    /// No program was solved, as there would be too many unknowns.
    TooLarge {
        /// Unknowns of the program.
        unknowns: usize,
        /// Largest number of them that the settings allow.
        most: usize,
    },
    /// Nothing falls on which the push does no work: then what is proved is proved of every collapse.
    PushMoves,
    /// It ended before the bound met the lowest state.
    OutOfBudget {
        /// What it had no more of.
        budget: Budget,
        /// Programs that it solved.
        programs: usize,
    },
    /// No state is verified, so that there is nothing to bound.
    NoState,
}

/// What limits a proof.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Budget {
    /// The number of lifted programs.
    Programs,
    /// Interior-point steps of all of them.
    Steps,
    /// Arithmetic of all of them.
    Work,
}

impl fmt::Display for BoundFact {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            BoundFact::Proved(proved) => proved.fmt(f),
            BoundFact::Uncertified => write!(
                f,
                "the bound is computed and not certified: the scene can lock, so that its forces have no limit"
            ),
            BoundFact::TooLarge { unknowns, most } => write!(
                f,
                "the lifted program was not solved: it would have {unknowns} unknowns, and `lift-unknowns` \
                 allows {most}"
            ),
            BoundFact::PushMoves => write!(f, "nothing falls on which the push does no work"),
            BoundFact::OutOfBudget { budget, programs } => {
                write!(f, "the proof ended after {programs} programs")?;
                match budget {
                    Budget::Programs => write!(f, ", as many as `lifts` allows"),
                    Budget::Steps => write!(f, ", whose steps are as many as `lift-steps` allows"),
                    Budget::Work => write!(f, ", whose work is as much as `lift-work` allows"),
                }
            }
            BoundFact::NoState => write!(f, "no collapse state is verified that could be bounded"),
        }
    }
}

impl fmt::Display for Proved {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.lower <= 0.0 {
            return write!(f, "nothing is proved of lower states");
        }
        write!(f, "it is proved that ")?;
        write_floor(f, &below(self.lower, 6), self.cap)
    }
}

/// What a lower bound says that is proved for motions up to a cap, where it needs one.
pub(crate) fn write_floor(
    f: &mut fmt::Formatter<'_>,
    lower: &str,
    cap: Option<f64>,
) -> fmt::Result {
    write!(
        f,
        "no collapse state with 0 ≤ λ < {lower} exists in which the push does work"
    )?;
    match cap {
        Some(cap) => write!(
            f,
            " and openings and slips add up to no more than {cap:.0e} times the push's own motion"
        ),
        None => Ok(()),
    }
}
