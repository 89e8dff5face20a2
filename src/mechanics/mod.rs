//! What follows from scene, forces and motion alone, whoever found them: mechanism, residuals,
//! crack, thrust, and the parts that move as one body, in words too.
//!
//! The residuals stand below the methods on purpose: a method may use them to decide whether to go
//! on, but what counts is the judge's own evaluation, from forces and mechanism alone, on the whole
//! scene and in the units of the case. No matrix, scaling or tolerance of a method enters it.

mod block_residual;
mod crack;
mod friction_excess;
mod mechanism;
mod motion_words;
mod moved;
mod openings;
mod part_words;
mod places;
mod recomputed;
mod residual;
mod rigid_parts;
mod state;
mod thrust;

pub use block_residual::BlockResidual;
pub(crate) use block_residual::reach;
pub use crack::Crack;
pub(crate) use crack::{VELOCITY_THRESHOLDS, crack_slope, crack_slope_by_gap};
pub use friction_excess::friction_excess;
pub use mechanism::{JointRate, Mechanism, Motion};
pub(crate) use motion_words::MovingPart;
pub(crate) use moved::Moved;
pub use recomputed::{Recomputed, largest, residual_words};
pub use residual::{
    CollapseResidual, StaticResidual, dead_power, falling_violation, kinematic_multiplier,
};
pub(crate) use residual::{VERIFIED_RESIDUAL, associative_violation, live_power, live_unit};
pub use rigid_parts::parts;
pub use state::{Ceiling, CollapseState, ForceState, JointForce};
pub(crate) use thrust::CourseResultant;
pub use thrust::{Thrust, thrust};
