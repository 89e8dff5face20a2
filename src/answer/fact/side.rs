//! Facts of a wall that is pushed both ways.

use std::fmt;

use serde::{Deserialize, Serialize};

use crate::answer::Status;
use crate::number::{above, percent};
use crate::scene::Push;

/// What both sides of a wall that is pushed both ways come to. The answer that follows is that of the
/// side that governs.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub enum SideFact {
    /// The wall is weaker when pushed this way: this side's whole range lies below the other's.
    Weaker {
        /// The side that governs.
        push: Push,
        /// How far its λ is below the other side's, relative to that.
        by: f64,
    },
    /// A collapse is known at a lower λ on this side, and the ranges of the two sides overlap.
    Lowest {
        /// The side that governs.
        push: Push,
        /// How far its λ is below the other side's, relative to that.
        by: f64,
    },
    /// A collapse is known at the same λ on both sides, and their ranges differ.
    SameLowest,
    /// The wall's lower end is that of this side, which does not govern.
    LowerEnd(Push),
    /// Both sides have the same range.
    Alike,
    /// The other side stands, so that this one governs.
    Only(Push),
    /// This side bounds the wall's multiplier from above, and the other has no answer.
    AtMost {
        /// The side.
        push: Push,
        /// The upper end of its range.
        lambda: f64,
        /// What that is worth.
        status: Status,
    },
    /// This side has no multiplier, for the reasons that follow.
    Unanswered(Push),
    /// What follows holds for this side of the push.
    For(Push),
    /// What follows holds for both sides.
    Either,
}

impl SideFact {
    pub(super) fn introduces_next(&self) -> bool {
        matches!(
            self,
            SideFact::Unanswered(_) | SideFact::For(_) | SideFact::Either
        )
    }
}

impl fmt::Display for SideFact {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            SideFact::Weaker { push, by } => {
                let (push, by) = (push.name(), share(*by));
                write!(f, "the wall is weaker when pushed to the {push}, by {by}")
            }
            SideFact::Lowest { push, by } => {
                let (push, by) = (push.name(), share(*by));
                write!(
                    f,
                    "the lowest collapse known is that of the push to the {push}, by {by}, and the ranges of \
                     the two sides overlap"
                )
            }
            SideFact::SameLowest => write!(
                f,
                "the lowest collapse known has the same multiplier on both sides, and their ranges differ"
            ),
            SideFact::LowerEnd(push) => {
                let push = push.name();
                write!(f, "the lower end is that of the push to the {push}")
            }
            SideFact::Alike => write!(
                f,
                "the wall is as strong when pushed to the right as to the left"
            ),
            SideFact::Only(push) => {
                let push = push.name();
                write!(f, "only the push to the {push} has a limit")
            }
            SideFact::AtMost {
                push,
                lambda,
                status,
            } => write!(
                f,
                "pushed to the {}, λ is at most {} ({})",
                push.name(),
                above(*lambda, 5),
                status.name()
            ),
            SideFact::Unanswered(push) => {
                write!(f, "there is no answer when pushed to the {}", push.name())
            }
            SideFact::For(push) => write!(f, "pushed to the {}", push.name()),
            SideFact::Either => write!(f, "for a push to either side"),
        }
    }
}

/// A difference that is there, also where it is too small for a digit.
fn share(by: f64) -> String {
    match percent(by).as_str() {
        "0.00 %" => "less than 0.01 %".to_owned(),
        share => share.to_owned(),
    }
}
