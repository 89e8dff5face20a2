//! What the judge computed of one answer.

use serde::{Deserialize, Serialize};

use crate::answer::Status;
use crate::mechanics::{Recomputed, largest};

/// What the judge says of an answer.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Judgement {
    /// What the answer is worth.
    pub status: Status,
    /// What was recomputed, in the order of the evidence; empty where there is nothing to vouch for.
    pub residuals: Vec<Recomputed>,
}

impl Judgement {
    /// The largest residual; `None` where there is none.
    pub fn residual(&self) -> Option<f64> {
        largest(&self.residuals)
    }
}
