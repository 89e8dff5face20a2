//! One line of the cross-check and what it says.

use crate::scene::HeadJoints;
use crate::text::worded;

worded! {
    /// Result of one check, from good to bad.
    #[derive(PartialOrd, Ord)]
    Verdict {
        /// It holds.
        Holds = "holds",
        /// It holds within a stated allowance that has a known cause.
        Marked = "marked",
        /// A method that the check needs gave no number.
        NotDecided = "not decided",
        /// It does not hold, and the case says why.
        Deviates = "deviates",
        /// It does not hold.
        Violated = "VIOLATED",
    }
}

impl Verdict {
    /// A check without shades.
    pub(super) fn of(holds: bool) -> Self {
        if holds {
            Verdict::Holds
        } else {
            Verdict::Violated
        }
    }
}

/// One line of the cross-check.
#[derive(Clone, Debug, PartialEq)]
pub struct Check {
    /// Head joints of the scene it is about.
    pub head_joints: HeadJoints,
    /// The method whose answer it is about.
    pub method: String,
    /// What is compared, with its figures.
    pub text: String,
    /// The result.
    pub verdict: Verdict,
}
