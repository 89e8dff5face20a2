//! What a result may be used for.

use serde::{Deserialize, Serialize};

/// What a result may be used for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Status {
    /// Proved to a residual of 1e-8 by the judge.
    Verified,
    /// λ lies between lower and upper by the method's own evidence, the width is not negligible.
    Bracketed,
    /// A number with no proof behind it.
    Estimate,
    /// No multiplier is too large, for the friction law that the method assumes.
    Stands,
    /// The scene does not stand under its own weight.
    Falls,
    /// The scene is outside the method's limits of validity.
    NotApplicable,
    /// No honest answer; the reason says why.
    Undecided,
    /// The method broke, or the judge refutes it.
    Failed,
}

impl Status {
    /// Every status.
    pub const ALL: [Status; 8] = [
        Status::Verified,
        Status::Bracketed,
        Status::Estimate,
        Status::Stands,
        Status::Falls,
        Status::NotApplicable,
        Status::Undecided,
        Status::Failed,
    ];

    /// The word that tables, CSV and JSON use.
    pub fn name(self) -> &'static str {
        match self {
            Status::Verified => "verified",
            Status::Bracketed => "bracketed",
            Status::Estimate => "estimate",
            Status::Stands => "stands",
            Status::Falls => "falls",
            Status::NotApplicable => "not-applicable",
            Status::Undecided => "undecided",
            Status::Failed => "failed",
        }
    }
}
