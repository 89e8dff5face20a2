//! What facts say of a support that moves: methods speak of λ, the change of its reaction, and people
//! read the reaction itself.

use super::{AutoFact, BoundFact, Fact, LimitFact, PushoverFact, ReactionFact};
use crate::scene::Reaction;

impl Fact {
    /// The same in terms of the reaction.
    pub(crate) fn read(&self, reaction: &Reaction) -> Fact {
        let at = |lambda: f64| reaction.at(lambda);
        match self {
            Fact::Limit(LimitFact::MovesUnpushed { .. }) => {
                ReactionFact::NoneHolds(reaction.clone()).into()
            }
            Fact::Limit(LimitFact::AtRest) => ReactionFact::AtOnce.into(),
            Fact::Limit(LimitFact::ForcesWithoutLimit) => ReactionFact::WithoutLimit.into(),
            // Its number is that of forces without friction, seldom near any state.
            Fact::Limit(LimitFact::FoundNoBounds { .. }) => {
                LimitFact::FoundNoBounds { frictionless: None }.into()
            }
            Fact::Bound(BoundFact::Proved(proved)) => {
                ReactionFact::Proved(reaction.clone(), *proved).into()
            }
            Fact::Bound(BoundFact::Uncertified) => ReactionFact::Uncertified.into(),
            Fact::Bound(BoundFact::PushMoves) => ReactionFact::SupportMoves.into(),
            Fact::Auto(AutoFact::CollapsesWithoutBound { lambda }) => {
                AutoFact::CollapsesWithoutBound {
                    lambda: at(*lambda),
                }
                .into()
            }
            Fact::Auto(AutoFact::NoState { associative }) => AutoFact::NoState {
                associative: at(*associative),
            }
            .into(),
            Fact::Auto(AutoFact::LowerHeard { lambda, below }) => AutoFact::LowerHeard {
                lambda: at(*lambda),
                below: *below,
            }
            .into(),
            Fact::Pushover(fact) => fact.clone().with_lambda(at).into(),
            other => other.clone(),
        }
    }
}

impl PushoverFact {
    /// The same with another number for each λ.
    pub(crate) fn with_lambda(self, at: impl Fn(f64) -> f64) -> Self {
        match self {
            PushoverFact::OutOfSteps { lambda } => PushoverFact::OutOfSteps { lambda: at(lambda) },
            PushoverFact::StillStands { lambda } => {
                PushoverFact::StillStands { lambda: at(lambda) }
            }
            PushoverFact::Unclear { lambda } => PushoverFact::Unclear { lambda: at(lambda) },
            other => other,
        }
    }
}
