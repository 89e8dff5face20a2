//! Facts of a wall that is pushed both ways.

use serde::{Deserialize, Serialize};
use thiserror::Error;

use crate::answer::Status;
use crate::number::{above, percent};
use crate::scene::Push;

/// What both sides of a wall that is pushed both ways come to. The answer that follows is that of the
/// side that governs.
#[derive(Clone, Copy, Debug, Error, PartialEq, Serialize, Deserialize)]
pub enum SideFact {
    /// The wall is weaker when pushed this way: this side's whole range lies below the other's.
    #[error("the wall is weaker when pushed to the {}, by {}", .push.name(), share(*.by))]
    Weaker {
        /// The side that governs.
        push: Push,
        /// How far its λ is below the other side's, relative to that.
        by: f64,
    },
    /// A collapse is known at a lower λ on this side, and the ranges of the two sides overlap.
    #[error(
        "the lowest collapse known is that of the push to the {}, by {}, and the ranges of the two \
         sides overlap",
        .push.name(),
        share(*.by)
    )]
    Lowest {
        /// The side that governs.
        push: Push,
        /// How far its λ is below the other side's, relative to that.
        by: f64,
    },
    /// A collapse is known at the same λ on both sides, and their ranges differ.
    #[error(
        "the lowest collapse known has the same multiplier on both sides, and their ranges differ"
    )]
    SameLowest,
    /// The wall's lower end is that of this side, which does not govern.
    #[error("the lower end is that of the push to the {}", .0.name())]
    LowerEnd(Push),
    /// Both sides have the same range.
    #[error("the wall is as strong when pushed to the right as to the left")]
    Alike,
    /// The other side stands, so that this one governs.
    #[error("only the push to the {} has a limit", .0.name())]
    Only(Push),
    /// This side bounds the wall's multiplier from above, and the other has no answer.
    #[error(
        "pushed to the {}, λ is at most {} ({})",
        .push.name(),
        above(*.lambda, 5),
        .status.name()
    )]
    AtMost {
        push: Push,
        /// The upper end of its range.
        lambda: f64,
        /// What that is worth.
        status: Status,
    },
    /// This side has no multiplier, for the reasons that follow.
    #[error("there is no answer when pushed to the {}", .0.name())]
    Unanswered(Push),
    /// What follows holds for this side of the push.
    #[error("pushed to the {}", .0.name())]
    For(Push),
    /// What follows holds for both sides.
    #[error("for a push to either side")]
    Either,
}

/// A difference that is there, also where it is too small for a digit.
fn share(by: f64) -> String {
    match percent(by).as_str() {
        "0.00 %" => "less than 0.01 %".to_owned(),
        share => share.to_owned(),
    }
}
