//! Facts of the lower bound by a lifted program.

use std::fmt;

use serde::{Deserialize, Serialize};

use super::super::certificate::Proved;
use crate::number::number;

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
    /// It ended before the bound met the lowest state: so many programs, as the settings allow.
    OutOfBudget {
        /// Programs.
        programs: usize,
    },
    /// No state is verified, so that there is nothing to bound.
    NoState,
}

impl fmt::Display for BoundFact {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            BoundFact::Proved(proved) => proved.fmt(f),
            BoundFact::Uncertified => write!(
                f,
                "computed, not certified: the scene can lock, so that forces are not bounded"
            ),
            BoundFact::TooLarge { unknowns, most } => write!(
                f,
                "no lift: it would have {unknowns} unknowns, and `lift-unknowns` allows {most}"
            ),
            BoundFact::OutOfBudget { programs } => {
                write!(f, "ended by its budget after {programs} lifts")
            }
            BoundFact::NoState => write!(f, "no verified state to bound"),
        }
    }
}

impl fmt::Display for Proved {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let lower = number(self.lower, 6);
        write!(
            f,
            "no collapse state with 0 ≤ λ < {lower} in which the push does work, proved"
        )?;
        if let Some(cap) = self.cap {
            write!(
                f,
                " for motions whose openings and slips are at most {cap:.0e} times the push's own"
            )?;
        }
        Ok(())
    }
}
