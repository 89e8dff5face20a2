//! What was seen, as in an experiment.

use serde::{Deserialize, Serialize};

use super::bracket::Bracket;
use super::recording::Recording;
use super::self_check::SelfCheck;
use crate::mechanics::{Crack, Mechanism};

/// What a simulation saw.
#[derive(Clone, Debug, Default, Serialize, Deserialize)]
pub struct Observed {
    /// Last load at rest and first that collapsed, where both were seen.
    pub bracket: Option<Bracket>,
    /// Error that is stated for the bracket, relative to λ.
    pub stated_error: Option<f64>,
    /// Displacements from the onset of the collapse on, at the upper end of the bracket.
    pub mechanism: Option<Mechanism>,
    /// Crack of these displacements.
    pub crack: Option<Crack>,
    /// On request, the motion that follows the collapse.
    pub recording: Option<Recording>,
    /// Self-checks that ran, with their figures.
    pub checks: Vec<SelfCheck>,
}
