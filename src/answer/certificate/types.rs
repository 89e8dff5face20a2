//! What a certificate is made of, what it proves, and why it may not.

use std::fmt;

use serde::{Deserialize, Serialize};

/// Multipliers of one slice; all numbers without dimension: λ over its unit, forces over the total
/// weight, lengths over the height.
#[derive(Clone, Debug, PartialEq)]
pub struct Slice {
    /// Least λ* of the slice, a.
    pub from: f64,
    /// Largest λ* of the slice, b.
    pub to: f64,
    /// What λ* is at least, but for rounding; more than `to` where no state is in the slice.
    pub sigma: f64,
    /// One row a force condition (four a joint in the scene's order, then 1, λ − a, b − λ), in it one
    /// number a rate (four a joint, then the power of the live load).
    pub multipliers: Vec<f64>,
    /// One row an equilibrium condition (three a block), in it one number a kinematic unknown
    /// (three velocities a block, then the forward slip of each joint).
    pub balance: Vec<f64>,
}

/// A proof that no collapse state of a scene in which the push does work has 0 ≤ λ < `lower`.
#[derive(Clone, Debug, PartialEq)]
pub struct Certificate {
    /// Fingerprint of the scene's conditions.
    pub scene: String,
    /// λ in the case's unit that is claimed to be proved.
    pub lower: f64,
    /// Largest sum of openings and slips of the motions that it speaks of, where it needs one.
    pub cap: f64,
    /// Velocities of a motion that opens every joint by more than μ times its slip.
    pub opening: Vec<f64>,
    /// Slices in ascending order, the first from 0, each from no more than what those before prove.
    pub slices: Vec<Slice>,
}

/// What a certificate proves.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Proved {
    /// No collapse state in which the push does work has 0 ≤ λ below this.
    pub lower: f64,
    /// Sum of openings and slips per unit of the live load's power, without dimension, up to which
    /// that is proved; `None` where there is no limit.
    pub cap: Option<f64>,
    /// Slices of λ.
    pub slices: usize,
    /// Largest entry of what rounding leaves of the identity.
    pub rounding: f64,
}

/// Why a certificate proves nothing.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub enum Refusal {
    /// There is none.
    Missing,
    /// It is about another scene.
    OtherScene,
    /// It has another number of multipliers than the scene has products.
    Size,
    /// One of its numbers is none.
    NotFinite,
    /// A multiplier that must not be negative is.
    Negative {
        /// Slice, from 0.
        slice: usize,
    },
    /// Its motion does not open this joint, from 0, so that forces are not bounded.
    Locks {
        /// Joint, from 0.
        joint: usize,
    },
    /// A block hangs on no chain of joints from a support.
    Unsupported,
    /// A slice begins above what those before it prove.
    Apart {
        /// Slice, from 0.
        slice: usize,
    },
    /// It proves less than it claims.
    Less {
        /// λ that it claims.
        claimed: f64,
        /// λ that it proves.
        proved: f64,
    },
}

impl fmt::Display for Refusal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Refusal::Missing => write!(f, "there is no certificate"),
            Refusal::OtherScene => write!(f, "it is about another scene"),
            Refusal::Size => write!(f, "its size does not match the scene"),
            Refusal::NotFinite => write!(f, "one of its numbers is not finite"),
            Refusal::Negative { slice } => {
                write!(f, "slice {} has a negative multiplier", slice + 1)
            }
            Refusal::Locks { joint } => write!(
                f,
                "its motion does not open joint {}, so that forces have no limit",
                joint + 1
            ),
            Refusal::Unsupported => write!(f, "a block has no chain of joints to a support"),
            Refusal::Apart { slice } => write!(
                f,
                "slice {} begins above what those before it prove",
                slice + 1
            ),
            Refusal::Less { claimed, proved } => {
                write!(f, "it claims {claimed:.9} and proves {proved:.9}")
            }
        }
    }
}
