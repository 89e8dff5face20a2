//! What a method returns, and what can be recomputed from it.
//!
//! Outcome, mechanism, crack and residuals stand below the methods, so that methods and judge speak
//! of the same things. The residuals are shared on purpose: a method may use them to decide whether
//! to go on, but what counts is the judge's own evaluation, from forces and mechanism alone, on the
//! whole scene and in the units of the case. No matrix, scaling or tolerance of a method enters it.

mod block_residual;
mod bracket;
pub(crate) mod certificate;
mod claim;
mod crack;
mod fact;
mod lift;
mod mechanism;
mod outcome;
mod recording;
mod residual;
mod self_check;
mod state;
mod status;
mod thrust;
mod work;

pub use block_residual::BlockResidual;
pub(crate) use block_residual::reach;
pub use bracket::{Bracket, VERIFIED_WIDTH, is_same_multiplier, magnitude};
pub use certificate::{Assumption, Certificate, Factor, Proved, Refusal, Slice, Unreadable, prove};
pub use claim::Claim;
pub use crack::Crack;
pub(crate) use crack::{VELOCITY_THRESHOLDS, crack_slope, crack_slope_by_gap};
pub use fact::{
    AutoFact, BoundFact, CeilingSlack, Coverage, Fact, InapplicableForm, Invalid, JudgedFact,
    LimitFact, ProgramEnding, ProgramFailure, PushoverFact, Residuals, SearchEnding, SearchFacts,
    SearchFailure, SearchStart, SequentialEnding, SequentialFacts, SideFact, SolverEnding,
    StartEnding, Uniqueness,
};
pub use lift::excess_lift;
pub use mechanism::{JointRate, Mechanism, Motion};
pub use outcome::Outcome;
pub use recording::Recording;
pub use residual::{
    CollapseResidual, StaticResidual, dead_power, falling_violation, kinematic_multiplier,
};
pub(crate) use residual::{VERIFIED_RESIDUAL, associative_violation, live_unit};
pub use self_check::{Checked, Repetition, SelfCheck, Variation};
pub use state::{CollapseState, JointForce};
pub use status::Status;
pub use thrust::{CourseResultant, Thrust, thrust};
pub use work::Work;
