//! Facts of a scene with a support that moves. Methods speak of λ, the change of its reaction, and
//! people read the reaction itself.

use serde::{Deserialize, Serialize};
use thiserror::Error;

use super::bound::capped;
use super::{AutoFact, BoundFact, Fact, LimitFact, PushoverFact};
use crate::answer::{Bracket, Checked, SelfCheck};
use crate::number::{number, short};
use crate::scene::Reaction;

/// What only a support that moves has.
#[derive(Clone, Debug, Error, PartialEq, Serialize, Deserialize)]
pub enum ReactionFact {
    /// Between its ends it does not come to rest with this reaction, by the pushover.
    #[error(
        "with a reaction of {}, between the ends that friction admits, it does not come to rest",
        number(*.0, 5)
    )]
    NotAtRest(f64),
}

impl Fact {
    /// The same in words where λ is the change of this reaction.
    pub(crate) fn of_reaction(&self, reaction: &Reaction) -> String {
        match self {
            Fact::Limit(LimitFact::MovesUnpushed { .. }) => {
                format!("no reaction of {} holds it", reaction.support)
            }
            Fact::Limit(LimitFact::AtRest) => {
                "it may give way at once, as the forces of friction at rest are not determined"
                    .into()
            }
            Fact::Limit(LimitFact::ForcesWithoutLimit) => {
                "the joints can balance every change of the reaction, however large it is".into()
            }
            // Its number is that of forces without friction, seldom near any state.
            Fact::Limit(LimitFact::FoundNoBounds { .. }) => {
                LimitFact::FoundNoBounds { frictionless: None }.to_string()
            }
            Fact::Bound(BoundFact::Proved(proved)) if proved.lower <= 0.0 => {
                "nothing is proved of states before it".into()
            }
            Fact::Bound(BoundFact::Proved(proved)) => {
                let floor = reaction_floor(reaction, proved.lower, proved.cap);
                format!("it is proved that {floor}")
            }
            Fact::Bound(BoundFact::PushMoves) => {
                "nothing falls while the support stays where it is".into()
            }
            Fact::Auto(fact) => fact.of_reaction(&|lambda| short(reaction.at(lambda), 5)),
            Fact::Pushover(fact) => {
                let fact = fact.clone().with_lambda(&|lambda| reaction.at(lambda));
                fact.of_reaction()
            }
            other => other.to_string(),
        }
    }
}

impl AutoFact {
    /// The same in words, with this reaction for each λ.
    fn of_reaction(&self, at: &dyn Fn(f64) -> String) -> String {
        match self {
            AutoFact::CollapsesWithoutBound { lambda } => format!(
                "the reaction at collapse is not unique: a collapse state is found at {}, and with \
                 associative friction none exists",
                at(*lambda)
            ),
            AutoFact::NoState { associative } => format!(
                "no collapse state is proved before the associative reaction, {}",
                at(*associative)
            ),
            AutoFact::LowerHeard { lambda, .. } => format!(
                "it may give way sooner: the sequential method gives {}, and a longer search found no \
                 state before that of the answer",
                at(*lambda)
            ),
            AutoFact::Uniqueness(gap) => format!(
                "{}the first state found and that with associative friction are {} % of the change of \
                 the reaction apart; {}",
                match gap.unique {
                    true => "",
                    false => "the reaction at collapse is not unique: ",
                },
                short(100.0 * gap.relative_width, 2),
                gap.search()
            ),
            AutoFact::SettledByAssociative | AutoFact::Saved { .. } => self.to_string(),
        }
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
            PushoverFact::LevelsDisagree { brackets }
            | PushoverFact::RangeUnfinished { so_far: brackets } => {
                brackets.iter_mut().for_each(ends);
            }
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
            | PushoverFact::Range
            | PushoverFact::Jumps { .. }
            | PushoverFact::SlidesFirst
            | PushoverFact::Without(_) => {}
        }
        self
    }

    /// In words, each λ being a reaction.
    fn of_reaction(&self) -> String {
        match self {
            PushoverFact::OutOfSteps { lambda } => format!(
                "the pushover used up the time steps allowed; the last reaction at rest was {}",
                short(*lambda, 5)
            ),
            PushoverFact::StillStands { lambda } => format!(
                "the scene still stands with a reaction of {}, and no further change is tried",
                short(*lambda, 5)
            ),
            PushoverFact::Unclear { lambda } => format!(
                "with a reaction of {} the scene neither rests nor collapses within the time allowed",
                short(*lambda, 5)
            ),
            PushoverFact::NearZero { .. } => {
                "the change of the reaction is too near to 0 to tell whether the scene falls without it"
                    .into()
            }
            other => other.to_string(),
        }
    }
}

/// That no state lies between the reaction that it begins with and another one, for motions up to a
/// cap where there is one.
pub(crate) fn reaction_floor(reaction: &Reaction, lambda: f64, cap: Option<f64>) -> String {
    let (from, to) = (number(reaction.start, 5), reaction.inwards(lambda, 6));
    format!(
        "no collapse state with a reaction from {from} to {to} exists in which the support moves{}",
        capped(cap, "support")
    )
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
            assert_eq!(fact.of_reaction(&reaction), expected);
        }
    }
}
