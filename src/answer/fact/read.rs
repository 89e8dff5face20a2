//! What facts say of a support that moves: methods speak of λ, the change of its reaction, and people
//! read the reaction itself.

use super::{AutoFact, BoundFact, Fact, LimitFact, PushoverFact, ReactionFact};
use crate::answer::{Bracket, Checked, SelfCheck};
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
            Fact::Auto(fact) => ReactionFact::Auto((*fact).with_lambda(&at)).into(),
            Fact::Pushover(fact) => ReactionFact::Pushover(fact.clone().with_lambda(&at)).into(),
            other => other.clone(),
        }
    }
}

impl AutoFact {
    /// The same with another number for each λ.
    fn with_lambda(mut self, at: &dyn Fn(f64) -> f64) -> Self {
        match &mut self {
            AutoFact::CollapsesWithoutBound { lambda }
            | AutoFact::LowerHeard { lambda, .. }
            | AutoFact::NoState {
                associative: lambda,
            } => *lambda = at(*lambda),
            AutoFact::SettledByAssociative | AutoFact::Uniqueness(_) | AutoFact::Saved { .. } => {}
        }
        self
    }
}

impl PushoverFact {
    /// The same with another number for each λ.
    pub(crate) fn with_lambda(mut self, at: &dyn Fn(f64) -> f64) -> Self {
        let ends = |bracket: &mut Bracket| {
            let (one, other) = (at(bracket.lower), at(bracket.upper));
            (bracket.lower, bracket.upper) = (one.min(other), one.max(other));
        };
        match &mut self {
            PushoverFact::OutOfSteps { lambda }
            | PushoverFact::StillStands { lambda }
            | PushoverFact::Unclear { lambda } => *lambda = at(*lambda),
            PushoverFact::OneLevel { bracket } | PushoverFact::OfSeveral { states: bracket } => {
                ends(bracket)
            }
            PushoverFact::LevelsDisagree { brackets } => brackets.iter_mut().for_each(ends),
            PushoverFact::RangeUnfinished { so_far, .. } => so_far.iter_mut().for_each(ends),
            PushoverFact::Checked(check)
            | PushoverFact::SelfCheckFailed(check)
            | PushoverFact::VerificationFailed(check) => {
                if let SelfCheck {
                    what:
                        Checked::Repetition {
                            answer: Ok(bracket),
                            ..
                        },
                    ..
                } = check
                {
                    ends(bracket);
                }
            }
            PushoverFact::FirstSlip { .. }
            | PushoverFact::Uncalibrated
            | PushoverFact::NoBlocks
            | PushoverFact::NoWeight
            | PushoverFact::UnequalWeights { .. }
            | PushoverFact::Crowded { .. }
            | PushoverFact::TooStiff
            | PushoverFact::Fell { .. }
            | PushoverFact::NearZero { .. }
            | PushoverFact::NotSettled { .. }
            | PushoverFact::RangeNotRun { .. }
            | PushoverFact::NoMirror
            | PushoverFact::Range { .. }
            | PushoverFact::SlidesFirst
            | PushoverFact::Without(_) => {}
        }
        self
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::Sense;

    #[test]
    fn a_reader_sees_reactions_and_no_multiplier() {
        let reaction = Reaction {
            support: "prop".into(),
            start: 5.0,
            limited: true,
            range: 4.0,
            sense: Sense::Away,
            weight: 10.0,
        };
        let facts: [(Fact, &str); 5] = [
            (
                PushoverFact::OutOfSteps {
                    lambda: 1.25 + 1e-12,
                }
                .into(),
                "the pushover used up the time steps allowed; the last reaction at rest was 3.75",
            ),
            (
                PushoverFact::StillStands { lambda: 1.0 }.into(),
                "the scene still stands with a reaction of 4, and no further change is tried",
            ),
            (
                PushoverFact::OneLevel {
                    bracket: Bracket {
                        lower: 1.0,
                        upper: 1.5,
                    },
                }
                .into(),
                "one length of the substep alone gave an answer, 3.50000-4.00000, and a second one is \
                 needed to measure its error",
            ),
            (
                AutoFact::NoState { associative: 2.0 }.into(),
                "no collapse state is proved before the associative reaction, 3",
            ),
            (
                AutoFact::LowerHeard {
                    lambda: 2.0,
                    below: 0.5,
                }
                .into(),
                "it may give way sooner: the sequential method gives 3, and a longer search found no state \
                 before that of the answer",
            ),
        ];
        for (fact, expected) in facts {
            assert_eq!(fact.read(&reaction).to_string(), expected);
        }
    }
}
