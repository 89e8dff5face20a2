//! What a method returns. Mechanism, forces, residuals and certificates are of the rooms below.

mod bracket;
mod evidence;
mod fact;
mod outcome;
mod recording;
mod self_check;
mod status;
mod work;

pub use crate::certificate::{
    Assumption, Certificate, Factor, Proved, Refusal, Slice, Unreadable, prove,
};
pub use crate::mechanics::{
    BlockResidual, Ceiling, CollapseResidual, CollapseState, CourseResultant, Crack, ForceState,
    JointForce, JointRate, Mechanism, Motion, RigidPart, StaticResidual, Thrust, dead_power,
    falling_violation, friction_excess, kinematic_multiplier, parts, thrust,
};
pub use bracket::{Bracket, VERIFIED_WIDTH, is_same_multiplier, magnitude};
pub use evidence::{Evidence, Observed};
pub use fact::{
    AutoFact, BoundFact, CeilingSlack, Coverage, Fact, InapplicableForm, Invalid, JudgedFact,
    LimitFact, ProgramEnding, ProgramFailure, PushoverFact, Residuals, SearchEnding, SearchFacts,
    SearchFailure, SearchStart, SequentialEnding, SequentialFacts, SideFact, SolverEnding,
    StartEnding, Uniqueness,
};
pub use outcome::Outcome;
pub use recording::Recording;
pub use self_check::{Checked, Repetition, SelfCheck, Variation};
pub use status::Status;
pub use work::Work;
