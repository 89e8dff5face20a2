//! One line of the cross-check and what it says.

use crate::scene::HeadJoints;

/// Result of one check, from good to bad.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Verdict {
    /// It holds.
    Holds,
    /// It holds within a stated allowance that has a known cause.
    Marked,
    /// A method that the check needs gave no number.
    NotDecided,
    /// It does not hold, and the case says why.
    Deviates,
    /// It does not hold.
    Violated,
}

impl Verdict {
    /// Every verdict.
    pub const ALL: [Verdict; 5] = [
        Verdict::Holds,
        Verdict::Marked,
        Verdict::NotDecided,
        Verdict::Deviates,
        Verdict::Violated,
    ];

    /// A check without shades.
    pub(super) fn of(holds: bool) -> Self {
        if holds {
            Verdict::Holds
        } else {
            Verdict::Violated
        }
    }

    /// The word in records.
    pub fn name(self) -> &'static str {
        match self {
            Verdict::Holds => "holds",
            Verdict::Marked => "marked",
            Verdict::Deviates => "deviates",
            Verdict::Violated => "VIOLATED",
            Verdict::NotDecided => "not decided",
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
