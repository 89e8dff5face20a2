//! Facts of the lower bound by a lifted program.

use std::fmt;

use serde::{Deserialize, Serialize};
use thiserror::Error;

use crate::certificate::Proved;
use crate::number::below;

/// What a lifted program proves, or why it proves nothing.
#[derive(Clone, Copy, Debug, Error, PartialEq, Serialize, Deserialize)]
pub enum BoundFact {
    #[error("{0}")]
    Proved(Proved),
    /// It is computed alone: scenes that can lock have forces without limit, so that rounding is not
    /// bounded either.
    #[error(
        "the bound is computed and not certified: no motion was found that opens every joint, so that its forces \
         have no known limit"
    )]
    Uncertified,
    #[error(
        "the lifted program was not solved: it would have {unknowns} unknowns, and `lift-unknowns` \
         allows {most}"
    )]
    TooLarge {
        unknowns: usize,
        /// Largest number of them that the settings allow.
        most: usize,
    },
    /// Nothing falls on which the push does no work: then what is proved is proved of every collapse.
    #[error("nothing falls on which the push does no work")]
    PushMoves,
    /// It ended before the bound met the lowest state.
    #[error("the proof ended after {programs} programs, {budget}")]
    OutOfBudget {
        /// What it had no more of.
        budget: Budget,
        programs: usize,
    },
    #[error("no collapse state is verified that could be bounded")]
    NoState,
    /// Where joints need friction to carry the push, however large it is.
    #[error("it is proved that {NO_STATE}")]
    ExcludesAll,
    #[error(
        "that it stands is not proved: no motion was found that opens every joint, so that its forces have no known \
         limit"
    )]
    NoOpening,
    #[error("that it stands is not proved: the lifted program does not exclude collapse states")]
    MayCollapse,
}

/// What limits a proof.
#[derive(Clone, Copy, Debug, Error, PartialEq, Eq, Serialize, Deserialize)]
pub enum Budget {
    /// The number of lifted programs.
    #[error("as many as `lifts` allows")]
    Programs,
    /// Interior-point steps of all of them.
    #[error("and `lift-steps` allows too few steps for another one")]
    Steps,
    /// Arithmetic of all of them.
    #[error("and `lift-work` allows too little work for another one")]
    Work,
}

impl fmt::Display for Proved {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.lower <= 0.0 {
            return f.write_str("nothing is proved of lower states");
        }
        let floor = match self.lower.is_finite() {
            true => floor_words(&below(self.lower, 6), self.cap),
            false => NO_STATE.to_owned(),
        };
        write!(f, "it is proved that {floor}")
    }
}

/// What a lower bound says that is proved for motions up to a cap, where it needs one.
pub(crate) fn floor_words(lower: &str, cap: Option<f64>) -> String {
    let capped = capped(cap, "push");
    format!("no collapse state with 0 ≤ λ < {lower} exists in which the push does work{capped}")
}

/// What a slice without an upper end proves.
const NO_STATE: &str = "no collapse state with λ ≥ 0 exists, but for motions against the push";

/// The cap on motions, as the end of a sentence.
pub(super) fn capped(cap: Option<f64>, of: &str) -> String {
    cap.map_or_else(String::new, |cap| {
        format!(
            " and openings and slips add up to no more than {cap:.0e} times the {of}'s own motion"
        )
    })
}
