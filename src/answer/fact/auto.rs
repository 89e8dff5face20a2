//! Facts of the method that picks among the others.

use std::fmt;

use super::super::bracket::Bracket;
use super::super::status::Status;
use crate::number::short;

/// What `auto` concludes from the other methods.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum AutoFact {
    /// The program for λ_A settles the scene, as the facts after this one say.
    SettledByAssociative,
    /// No collapse state is proved, for the reasons after this one.
    NoState {
        /// λ_A, below which all of them would lie.
        associative: f64,
    },
    /// How far the multiplier is from being unique.
    Uniqueness(Uniqueness),
    /// The pushover's answer, run beside an answer that is not unique.
    Pushover {
        /// Last load at rest and first load that collapsed.
        bracket: Bracket,
        /// What they are worth.
        status: Status,
    },
    /// The pushover gave no multiplier, for the reasons after this one.
    NoPushover,
    /// What was not needed.
    Saved {
        /// Blocks that were not modelled.
        blocks: usize,
        /// All blocks.
        of_blocks: usize,
        /// Whether the pushover was not run; the sequential method never is.
        pushover: bool,
    },
}

/// The gap between the lowest collapse state found and λ_A.
#[derive(Clone, Copy, Debug, PartialEq)]
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

impl AutoFact {
    pub(super) fn introduces_next(&self) -> bool {
        use AutoFact::{NoPushover, NoState, SettledByAssociative};
        matches!(self, SettledByAssociative | NoState { .. } | NoPushover)
    }
}

impl fmt::Display for AutoFact {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            AutoFact::SettledByAssociative => {
                write!(f, "by the program of the associative multiplier")
            }
            AutoFact::NoState { associative } => {
                let lambda = short(associative, 5);
                write!(f, "no collapse state is proved below λ_A = {lambda}")
            }
            AutoFact::Uniqueness(ref gap) => gap.fmt(f),
            AutoFact::Pushover { bracket, status } => {
                let [lower, upper] = [bracket.lower, bracket.upper].map(|end| short(end, 5));
                let status = status.name();
                write!(f, "beside it the pushover: {lower} to {upper}, {status}")
            }
            AutoFact::NoPushover => write!(f, "beside it the pushover"),
            AutoFact::Saved {
                blocks,
                of_blocks,
                pushover,
            } => {
                write!(f, "saved: ")?;
                if blocks > 0 {
                    write!(f, "{blocks} of {of_blocks} blocks, ")?;
                }
                let others = if pushover { " and pushover" } else { "" };
                write!(f, "sequential{others}")
            }
        }
    }
}

impl fmt::Display for Uniqueness {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if !self.unique {
            write!(f, "not unique: ")?;
        }
        let width = short(100.0 * self.relative_width, 2);
        write!(
            f,
            "lowest state found and associative multiplier are {width} % apart ("
        )?;
        match self.closed_form {
            Some(range) => {
                let [lower, upper] = [range.lower, range.upper].map(|end| short(end, 4));
                write!(f, "macro-block says {lower} to {upper}, an estimate; ")?;
            }
            None => write!(f, "macro-block does not apply; ")?,
        }
        if self.ended_early {
            write!(f, "a state as low ends the search)")
        } else {
            let starts = self.starts;
            write!(f, "one start may miss a lower state, {starts} found none)")
        }
    }
}
