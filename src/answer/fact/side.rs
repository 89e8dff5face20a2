//! Facts of a wall that is pushed both ways.

use std::fmt;

use serde::{Deserialize, Serialize};

use crate::scene::Push;

/// Which side of a wall that is pushed both ways the answer is about.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum SideFact {
    /// The wall is weaker when pushed this way, and this is that side's multiplier.
    Weaker(Push),
    /// Both sides have the same multiplier.
    Alike,
    /// This side has no multiplier, for the reasons that follow, so the wall has none.
    Unanswered(Push),
}

impl SideFact {
    pub(super) fn introduces_next(&self) -> bool {
        matches!(self, SideFact::Unanswered(_))
    }
}

impl fmt::Display for SideFact {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            SideFact::Weaker(push) => {
                write!(f, "the wall is weaker when pushed to the {}", push.name())
            }
            SideFact::Alike => write!(
                f,
                "the wall is as strong when pushed to the right as to the left"
            ),
            SideFact::Unanswered(push) => {
                write!(f, "there is no answer when pushed to the {}", push.name())
            }
        }
    }
}
