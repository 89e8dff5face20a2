//! Facts of a scene with a support that moves.

use std::fmt;

use serde::{Deserialize, Serialize};

use super::{AutoFact, PushoverFact};
use crate::certificate::Proved;
use crate::number::{number, short};
use crate::scene::Reaction;

/// What is to be said of a support that moves.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum ReactionFact {
    /// No reaction holds the scene.
    NoneHolds(Reaction),
    /// Between its ends it does not come to rest with this reaction, by the pushover.
    NotAtRest(f64),
    /// The collapse state found is at the reaction that it begins with.
    AtOnce,
    /// Forces carry any change of the reaction.
    WithoutLimit,
    /// What a certificate proves.
    Proved(Reaction, Proved),
    /// A bound is computed alone: scenes that can lock have forces without bounds.
    Uncertified,
    /// Nothing falls while the support is at rest.
    SupportMoves,
    /// What the pushover ends with, each λ a reaction.
    Pushover(PushoverFact),
    /// What `auto` concludes, each λ a reaction.
    Auto(AutoFact),
}

impl fmt::Display for ReactionFact {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            ReactionFact::NoneHolds(reaction) => {
                write!(f, "no reaction of {} holds it", reaction.support)
            }
            ReactionFact::NotAtRest(reaction) => write!(
                f,
                "with a reaction of {}, between the ends that friction admits, it does not come to rest",
                number(*reaction, 5)
            ),
            ReactionFact::AtOnce => {
                write!(
                    f,
                    "it may give way at once, as the forces of friction at rest are not determined"
                )
            }
            ReactionFact::WithoutLimit => {
                write!(
                    f,
                    "the joints can balance every change of the reaction, however large it is"
                )
            }
            ReactionFact::Proved(_, proved) if proved.lower <= 0.0 => {
                write!(f, "nothing is proved of states before it")
            }
            ReactionFact::Proved(reaction, proved) => {
                write!(f, "it is proved that ")?;
                write_motion_cap(f, reaction, proved.lower, proved.cap)
            }
            ReactionFact::Uncertified => write!(
                f,
                "the bound is computed and not certified: the scene can lock, so that its forces have no limit"
            ),
            ReactionFact::SupportMoves => {
                write!(f, "nothing falls while the support stays where it is")
            }
            ReactionFact::Pushover(fact) => write_pushover(f, fact),
            ReactionFact::Auto(fact) => write_auto(f, fact),
        }
    }
}

/// What the pushover says, where its own words speak of a multiplier.
fn write_pushover(f: &mut fmt::Formatter<'_>, fact: &PushoverFact) -> fmt::Result {
    match fact {
        PushoverFact::OutOfSteps { lambda } => write!(
            f,
            "the pushover used up the time steps allowed; the last reaction at rest was {}",
            short(*lambda, 5)
        ),
        PushoverFact::StillStands { lambda } => write!(
            f,
            "the scene still stands with a reaction of {}, and no further change is tried",
            short(*lambda, 5)
        ),
        PushoverFact::Unclear { lambda } => write!(
            f,
            "with a reaction of {} the scene neither rests nor collapses within the time allowed",
            short(*lambda, 5)
        ),
        PushoverFact::NearZero { .. } => write!(
            f,
            "the change of the reaction is too near to 0 to tell whether the scene falls without it"
        ),
        other => write!(f, "{other}"),
    }
}

/// What `auto` says, where its own words speak of a multiplier.
fn write_auto(f: &mut fmt::Formatter<'_>, fact: &AutoFact) -> fmt::Result {
    match fact {
        AutoFact::CollapsesWithoutBound { lambda } => write!(
            f,
            "the reaction at collapse is not unique: a collapse state is found at {}, and with \
             associative friction none exists",
            short(*lambda, 5)
        ),
        AutoFact::NoState { associative } => write!(
            f,
            "no collapse state is proved before the associative reaction, {}",
            short(*associative, 5)
        ),
        AutoFact::LowerHeard { lambda, .. } => write!(
            f,
            "it may give way sooner: the sequential method gives {}, and a longer search found no state \
             before that of the answer",
            short(*lambda, 5)
        ),
        AutoFact::Uniqueness(gap) => {
            if !gap.unique {
                write!(f, "the reaction at collapse is not unique: ")?;
            }
            let width = short(100.0 * gap.relative_width, 2);
            write!(
                f,
                "the first state found and that with associative friction are {width} % of the change of \
                 the reaction apart; "
            )?;
            gap.write_search(f)
        }
        other => write!(f, "{other}"),
    }
}

/// That no state lies between the reaction that it begins with and another one, for motions up to a
/// cap where there is one.
pub(crate) fn write_motion_cap(
    f: &mut fmt::Formatter<'_>,
    reaction: &Reaction,
    lambda: f64,
    cap: Option<f64>,
) -> fmt::Result {
    let (from, to) = (reaction.start, reaction.inwards(lambda, 6));
    let from = number(from, 5);
    write!(
        f,
        "no collapse state with a reaction from {from} to {to} exists in which the support moves"
    )?;
    match cap {
        Some(cap) => write!(
            f,
            " and openings and slips add up to no more than {cap:.0e} times the support's own motion"
        ),
        None => Ok(()),
    }
}
