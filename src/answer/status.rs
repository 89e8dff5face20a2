//! What a result may be used for.

use serde::{Deserialize, Serialize};

use crate::text::worded;

worded! {
    /// What a result may be used for.
    #[derive(Serialize, Deserialize)]
    Status {
        /// Proved to a residual of 1e-8 by the judge.
        Verified = "verified",
        /// λ lies between lower and upper by the method's own evidence, the width is not negligible.
        Bracketed = "bracketed",
        /// A number with no proof behind it.
        Estimate = "estimate",
        /// No multiplier is too large, for the friction law that the method assumes.
        Stands = "stands",
        /// The scene does not stand under its own weight.
        Falls = "falls",
        /// The scene is outside the method's limits of validity.
        NotApplicable = "not-applicable",
        /// No honest answer; the reason says why.
        Undecided = "undecided",
        /// The method broke, or the judge refutes it.
        Failed = "failed",
    }
}
