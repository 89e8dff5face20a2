//! What a certificate is made of, what it proves, and why it may not.

use serde::{Deserialize, Serialize};
use thiserror::Error;

use crate::number::nine_digits;

/// Multipliers of one slice; all numbers without dimension: λ over its unit, forces over the total
/// weight, lengths over the height.
#[derive(Clone, Debug, PartialEq)]
pub struct Slice {
    /// Least λ* of the slice, a.
    pub from: f64,
    /// Largest λ* of the slice, b; infinite where it has no upper end, and then it begins at 0.
    pub to: f64,
    /// What it assumes of products that are zero, one after the other; empty where it speaks of every
    /// collapse state in the slice.
    pub assumed: Vec<Assumption>,
    /// What λ* is at least, but for rounding; more than `to` where no state is in the slice. Without an upper end
    /// it is positive where no state is in the slice.
    pub sigma: f64,
    /// One row a force condition (four a joint in the scene's order, then 1, λ − a, b − λ, which counts for nothing
    /// without an upper end), in it one number a rate (four a joint, then the power of the live load, then those of
    /// slip bounds).
    pub multipliers: Vec<f64>,
    /// One row an equilibrium condition (three a block), in it one number a kinematic unknown
    /// (three velocities a block, then the forward slip of each joint).
    pub balance: Vec<f64>,
}

/// One of the two factors of a product that is zero in every collapse state.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Factor {
    /// The force condition: a corner carries nothing, or friction is used up in one direction.
    Force,
    /// The rate: a corner does not open, or a joint does not slip in one direction.
    Rate,
}

/// That one factor of a product is zero. A collapse state has the one or the other, so that two proofs,
/// one with each, prove it of all states. The one that assumes a zero rate covers every state without that rate.
/// The one that assumes a zero force need only cover the others. Where the rate is a slip, the joint then slips in
/// its direction, and so not in the other one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Assumption {
    /// The product, by the common row of its force condition and its rate: four a joint.
    pub pair: usize,
    pub zero: Factor,
}

/// Which products of a force condition and a rate are zero, in all collapse states or by assumption.
#[derive(Clone, Debug)]
pub(crate) struct Zeros {
    forces: Vec<bool>,
    rates: Vec<bool>,
}

impl Zeros {
    /// Of so many joints.
    pub(crate) fn of(joints: usize, assumed: &[Assumption]) -> Self {
        let mut zeros = Self {
            forces: vec![false; 4 * joints],
            rates: vec![false; 4 * joints],
        };
        for assumed in assumed {
            match assumed.zero {
                Factor::Force => {
                    zeros.forces[assumed.pair] = true;
                    if let Some(other) = other_direction(assumed.pair) {
                        zeros.rates[other] = true;
                    }
                }
                Factor::Rate => zeros.rates[assumed.pair] = true,
            }
        }
        zeros
    }

    /// Whether a rate is zero by assumption.
    pub(crate) fn rate(&self, rate: usize) -> bool {
        self.rates.get(rate) == Some(&true)
    }

    /// Whether a force condition is zero by assumption.
    pub(crate) fn force(&self, force: usize) -> bool {
        self.forces.get(force) == Some(&true)
    }

    /// Whether the product of a force condition and a rate is zero, by their rows.
    pub(crate) fn is_zero(&self, force: usize, rate: usize) -> bool {
        (force == rate && force < self.forces.len()) || self.force(force) || self.rate(rate)
    }
}

/// The rate of the other direction, where a rate is a slip.
fn other_direction(rate: usize) -> Option<usize> {
    (rate % 4 >= 2).then_some(rate ^ 1)
}

/// The left side of a slice's identity: what it has of 1 and of λ* times the power of the live load, and of 1 times
/// that of the dead load.
pub(crate) fn left_side(to: f64, sigma: f64) -> ([f64; 2], f64) {
    match to.is_finite() {
        true => ([-sigma, 1.0], 0.0),
        false => ([-sigma, -2.0 * sigma], -sigma),
    }
}

impl Slice {
    /// The products that are zero for this slice, of so many joints.
    pub(crate) fn zeros(&self, joints: usize) -> Zeros {
        Zeros::of(joints, &self.assumed)
    }
}

/// How many joints the other ways between the sides of a joint may have that limit its slip. The number of each is
/// that of files: how many bodies such a way leads through.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LongestWay {
    /// Two, as in certificates that were stored before there were longer ones.
    TwoJoints = 1,
    /// Three for joints without a shorter way, as with open head joints.
    ThreeJoints = 2,
}

/// A proof that no collapse state of a scene in which the push does work has 0 ≤ λ < `lower`.
#[derive(Clone, Debug, PartialEq)]
pub struct Certificate {
    /// Fingerprint of the scene's conditions.
    pub scene: String,
    /// λ in the case's unit that is claimed to be proved; infinite where there is no state at all.
    pub lower: f64,
    /// Largest sum of openings and slips of the motions that it speaks of, where it needs one.
    pub cap: f64,
    /// Velocities of a motion that opens every joint by more than μ times its slip.
    pub opening: Vec<f64>,
    /// Which slip bounds its multipliers have.
    pub longest_way: LongestWay,
    /// Slices. Those with the same assumptions stand in ascending order, each from no more than what
    /// is proved before it: by those of the same assumptions, or of fewer.
    pub slices: Vec<Slice>,
}

#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Proved {
    /// No collapse state in which the push does work has 0 ≤ λ below this. Where it is infinite there is none at all
    /// but for motions against the push.
    pub lower: f64,
    /// Sum of openings and slips per unit of the live load's power, without dimension, up to which
    /// that is proved; `None` where there is no limit.
    pub cap: Option<f64>,
    pub slices: usize,
    /// Largest entry of what rounding leaves of the identity.
    pub rounding: f64,
}

impl Proved {
    /// What is proved of both sides of a push: the lower of the bounds, for the motions that both speak
    /// of. A state that moves farther than the smaller cap is excluded for one side only.
    pub fn and(&self, other: &Proved) -> Proved {
        Proved {
            lower: self.lower.min(other.lower),
            cap: self.cap.into_iter().chain(other.cap).reduce(f64::min),
            slices: self.slices + other.slices,
            rounding: self.rounding.max(other.rounding),
        }
    }
}

/// Why a certificate proves nothing.
#[allow(missing_docs, reason = "the sentence of each says it")]
#[derive(Clone, Copy, Debug, Error, PartialEq, Serialize, Deserialize)]
pub enum Refusal {
    #[error("there is no certificate")]
    Missing,
    #[error("it is about another scene")]
    OtherScene,
    #[error("its size does not match the scene")]
    Size,
    #[error("one of its numbers is not finite")]
    NotFinite,
    #[error(
        "it claims that no state has 0 ≤ λ < {}, which says nothing",
        nine_digits(*.claimed)
    )]
    Nothing { claimed: f64 },
    #[error(
        "it speaks of no motion but those whose openings and slips add up to {cap:.0e} times the \
         push's own"
    )]
    Capped { cap: f64 },
    #[error("slice {} has a negative multiplier", .slice + 1)]
    Negative {
        /// Slice, from 0.
        slice: usize,
    },
    /// Its motion does not open this joint, from 0, so that forces are not bounded.
    #[error("its motion does not open joint {}, so that forces have no limit", .joint + 1)]
    Locks {
        /// Joint, from 0.
        joint: usize,
    },
    #[error("a block has no chain of joints to a support")]
    Unsupported,
    #[error("slice {} begins above what those before it prove", .slice + 1)]
    Apart {
        /// Slice, from 0.
        slice: usize,
    },
    #[error("slice {} has no upper end and does not begin at 0", .slice + 1)]
    Endless {
        /// Slice, from 0.
        slice: usize,
    },
    #[error("slice {} assumes something of another product than those beside it", .slice + 1)]
    Divided {
        /// Slice, from 0.
        slice: usize,
    },
    #[error("it claims {claimed:.9} and proves {proved:.9}")]
    Less { claimed: f64, proved: f64 },
}
