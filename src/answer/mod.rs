//! What a method returns. Mechanism, forces, residuals and certificates are of the rooms below.

pub(crate) mod bracket;
mod evidence;
pub(crate) mod fact;
mod observed;
mod outcome;
mod recording;
mod self_check;
pub(crate) mod standing;
mod status;
mod work;

pub use crate::certificate::Certificate;
pub use crate::mechanics::{
    Ceiling, CollapseResidual, CollapseState, Crack, ForceState, JointForce, JointRate, Mechanism,
    Motion, StaticResidual,
};
pub use bracket::Bracket;
pub(crate) use bracket::{VERIFIED_WIDTH, is_same_multiplier, magnitude};
pub use evidence::Evidence;
pub use fact::Fact;
pub(crate) use fact::{
    AutoFact, BoundFact, Budget, Coverage, InapplicableForm, Invalid, JudgedFact, LimitFact,
    ProgramEnding, ProgramFailure, PushoverFact, ReactionFact, SearchFacts, SearchFailure,
    SequentialEnding, SequentialFacts, SideFact, SolverEnding, Uniqueness, floor_words,
    reaction_floor, sentence,
};
pub use observed::Observed;
pub use outcome::Outcome;
pub use recording::Recording;
pub use self_check::{Checked, Repetition, SelfCheck, Variation};
pub(crate) use standing::Standing;
pub use status::Status;
pub use work::Work;
