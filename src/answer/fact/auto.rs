//! Facts of the method that picks among the others.

use std::fmt;

use serde::{Deserialize, Serialize};

use super::super::bracket::Bracket;
use crate::number::short;

/// What `auto` concludes from the other methods.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub enum AutoFact {
    /// The program for λ_A settles the scene, as the facts after this one say.
    SettledByAssociative,
    /// No collapse state is proved, for the reasons after this one.
    NoState {
        /// λ_A, below which all of them would lie.
        associative: f64,
    },
    /// A collapse state is found, and with associative friction none exists.
    CollapsesWithoutBound {
        /// λ of the lowest state found.
        lambda: f64,
    },
    /// How far the multiplier is from being unique.
    Uniqueness(Uniqueness),
    /// Another method lies below the lowest state, and a longer search found none that low.
    LowerHeard {
        /// Its multiplier.
        lambda: f64,
        /// How far below the lowest state, relative to that.
        below: f64,
    },
    /// What was not needed, beside the pushover, which never is.
    Saved {
        /// Whether the sequential method was not.
        sequential: bool,
        /// Blocks that were not modelled.
        blocks: usize,
        /// All blocks.
        of_blocks: usize,
    },
}

/// The gap between the lowest collapse state found and λ_A.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
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
        use AutoFact::{NoState, SettledByAssociative};
        matches!(self, SettledByAssociative | NoState { .. })
    }
}

impl fmt::Display for AutoFact {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            AutoFact::SettledByAssociative => {
                write!(f, "the linear program with associative friction settles it")
            }
            AutoFact::CollapsesWithoutBound { lambda } => {
                let lambda = short(lambda, 5);
                write!(
                    f,
                    "the multiplier is not unique: a collapse state is found at λ = {lambda}, and with \
                     associative friction none exists"
                )
            }
            AutoFact::NoState { associative } => {
                let lambda = short(associative, 5);
                write!(
                    f,
                    "no collapse state is proved below the associative multiplier, {lambda}"
                )
            }
            AutoFact::Uniqueness(ref gap) => gap.fmt(f),
            AutoFact::LowerHeard { lambda, below } => {
                let (lambda, below) = (short(lambda, 5), short(100.0 * below, 1));
                write!(
                    f,
                    "a lower state may exist: the sequential method gives {lambda}, which is {below} % below \
                     the lowest state found"
                )
            }
            AutoFact::Saved {
                sequential,
                blocks,
                of_blocks,
            } => {
                if sequential {
                    write!(f, "the sequential method and the pushover were not needed")?;
                } else {
                    write!(f, "the pushover was not needed")?;
                }
                if blocks > 0 {
                    write!(f, ", and {blocks} of {of_blocks} blocks were not modelled")?;
                }
                Ok(())
            }
        }
    }
}

impl fmt::Display for Uniqueness {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if !self.unique {
            write!(f, "the multiplier is not unique: ")?;
        }
        let width = short(100.0 * self.relative_width, 2);
        write!(
            f,
            "the lowest state found and the associative multiplier are {width} % apart; "
        )?;
        match self.closed_form {
            Some(range) => {
                let [lower, upper] = [range.lower, range.upper].map(|end| short(end, 4));
                write!(f, "the closed form estimates {lower} to {upper}; ")?;
            }
            None => write!(f, "the closed form does not apply; ")?,
        }
        self.write_search(f)
    }
}

impl Uniqueness {
    /// What the search for lower states came to.
    pub(super) fn write_search(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.ended_early {
            write!(f, "a state as low ended the search")
        } else {
            let starts = self.starts;
            write!(
                f,
                "one start may miss a lower state, and {starts} found none"
            )
        }
    }
}
