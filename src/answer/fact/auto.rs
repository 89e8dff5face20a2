//! Facts of the method that picks among the others.

use serde::{Deserialize, Serialize};
use thiserror::Error;

use super::super::bracket::Bracket;
use crate::number::short;

/// What `auto` concludes from the other methods.
#[derive(Clone, Copy, Debug, Error, PartialEq, Serialize, Deserialize)]
#[allow(missing_docs, reason = "the sentence of each says it")]
pub enum AutoFact {
    /// The program for λ_A settles the scene, as the facts after this one say.
    #[error("the linear program with associative friction settles it")]
    SettledByAssociative,
    /// No collapse state is proved, for the reasons after this one.
    #[error(
        "no collapse state is proved below the associative multiplier, {}",
        short(*.associative, 5)
    )]
    NoState {
        /// λ_A, below which all of them would lie.
        associative: f64,
    },
    #[error(
        "the multiplier is not unique: a collapse state is found at λ = {}, and with associative \
         friction none exists",
        short(*.lambda, 5)
    )]
    CollapsesWithoutBound {
        /// λ of the lowest state found.
        lambda: f64,
    },
    /// How far the multiplier is from being unique.
    #[error("{0}")]
    Uniqueness(Uniqueness),
    /// Another method lies below the lowest state, and a longer search found none that low.
    #[error(
        "a lower state may exist: the sequential method gives {}, which is {} % below the lowest \
         state found",
        short(*.lambda, 5),
        short(100.0 * .below, 1)
    )]
    LowerHeard {
        lambda: f64,
        /// How far below the lowest state, relative to that.
        below: f64,
    },
    /// What was not needed, beside the pushover, which never is.
    #[error(
        "the {} not needed{}",
        if *.sequential { "sequential method and the pushover were" } else { "pushover was" },
        match .blocks {
            0 => String::new(),
            blocks => format!(", and {blocks} of {of_blocks} blocks were not modelled"),
        }
    )]
    Saved {
        /// Whether the sequential method was not.
        sequential: bool,
        /// Blocks that were not modelled.
        blocks: usize,
        of_blocks: usize,
    },
}

/// The gap between the lowest collapse state found and λ_A.
#[derive(Clone, Copy, Debug, Error, PartialEq, Serialize, Deserialize)]
#[error(
    "{}the lowest state found and the associative multiplier are {} % apart; the closed form {}; {}",
    if *.unique { "" } else { "the multiplier is not unique: " },
    short(100.0 * .relative_width, 2),
    match .closed_form {
        Some(range) => format!("estimates {} to {}", short(range.lower, 4), short(range.upper, 4)),
        None => "does not apply".to_owned(),
    },
    self.search()
)]
pub struct Uniqueness {
    /// Whether the gap is within the tolerance.
    pub unique: bool,
    /// Width of the gap relative to max(λ_A, 1e-3).
    pub relative_width: f64,
    /// λ_low and λ_upp of the closed form, where it applies.
    pub closed_form: Option<Bracket>,
    /// Starts that the search was allowed.
    pub starts: usize,
    /// Whether a state was low enough to end the search early.
    pub ended_early: bool,
}

impl Uniqueness {
    /// What the search for lower states came to.
    pub(super) fn search(&self) -> String {
        match self.ended_early {
            true => "a state as low ended the search".to_owned(),
            false => format!(
                "one start may miss a lower state, and {} found none",
                self.starts
            ),
        }
    }
}
