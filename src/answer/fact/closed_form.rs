//! Facts of the closed form.

use serde::{Deserialize, Serialize};

use crate::scene::Irregularity;

/// Why the closed form does not apply.
#[derive(Clone, Debug, PartialEq, thiserror::Error, Serialize, Deserialize)]
pub enum InapplicableForm {
    /// The scene is not a regular wall.
    #[error(transparent)]
    Irregular(#[from] Irregularity),
    /// The wall is outside the limits of validity.
    #[error(transparent)]
    Invalid(#[from] Invalid),
}

/// Where the closed form does not hold.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error, Serialize, Deserialize)]
pub enum Invalid {
    /// α_b > α_p: the stagger line leaves the wall through its side.
    #[error(
        "the wall is shorter than its stagger line: tan α_b = {stagger:.4} exceeds tan α_p = {aspect:.4}"
    )]
    ShortWall {
        /// tan α_b = s/h.
        stagger: f64,
        /// tan α_p = L/H.
        aspect: f64,
    },
    /// α_c > α_b: the crack is flatter than the stagger, so it crosses units.
    #[error(
        "the crack is flatter than the stagger: tan α_c = {crack:.4} exceeds tan α_b = {stagger:.4}"
    )]
    FlatCrack {
        /// tan α_c of Eq. (2).
        crack: f64,
        /// tan α_b = s/h.
        stagger: f64,
    },
    /// Eq. (6) has no root with tan β ≥ 0.
    #[error("Eq. (6) gives tan β = {tan_beta:.4}, which is negative")]
    NegativeSlope {
        /// The root of Eq. (6).
        tan_beta: f64,
    },
}
