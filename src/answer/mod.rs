//! What a method returns, and what can be recomputed from it.
//!
//! Outcome, mechanism, crack and residuals stand below the methods, so that methods and judge speak
//! of the same things. The residuals are shared on purpose: a method may use them to decide whether
//! to go on, but what counts is the judge's own evaluation, from forces and mechanism alone, on the
//! whole scene and in the units of the case. No matrix, scaling or tolerance of a method enters it.

mod crack;
mod fact;
mod mechanism;
mod outcome;
mod residual;

pub use crack::{Crack, VELOCITY_THRESHOLDS, crack_slope, crack_slope_by_gap};
pub use fact::Fact;
pub use mechanism::{JointRate, Mechanism, Motion};
pub use outcome::{Bracket, Claim, CollapseState, JointForce, Outcome, Status, Work};
pub use residual::{
    CollapseResidual, StaticResidual, associative_violation, dead_power, falling_violation,
    kinematic_multiplier, live_unit,
};

/// Largest residual of a verified result, with total weight, height and live power scaled to 1.
pub const VERIFIED_RESIDUAL: f64 = 1e-8;

/// Relative width up to which two proved ends count as one number.
pub const VERIFIED_WIDTH: f64 = 1e-6;

/// Whether two ends are one number: NaN is none, nor are ends that cross by more than rounding.
pub fn is_one_number(bracket: &Bracket) -> bool {
    (-1e-9..=VERIFIED_WIDTH).contains(&bracket.relative_width())
}
