//! What all answers about one scene come to, in one line: the best of them, how far those that prove
//! something differ, and whether that is explained.

use std::fmt;

use thiserror::Error;

use super::heard::LowerState;
use crate::answer::{Bracket, Status, floor_words};
use crate::number::{above, below, number, percent};
use crate::scene::{HeadJoints, Push, Reaction};
use crate::text::worded;

/// What the harness answers for one scene.
#[derive(Clone, Debug, PartialEq)]
pub struct Conclusion {
    /// Head joints of the scene.
    pub head_joints: HeadJoints,
    /// Direction of the push that it is about.
    pub push: Push,
    /// Of a wall that is pushed both ways, the conclusion about the side that does not govern.
    pub other: Option<Box<Conclusion>>,
    /// The scene's unit of λ, which tells what a small difference is.
    pub multiplier_unit: f64,
    /// The best answer.
    pub basis: Basis,
    /// Whose it is; several where they say the same without a number; where there is none, who was
    /// asked and did not decline.
    pub methods: Vec<String>,
    /// What the best answer is worth.
    pub status: Status,
    /// Its multiplier: of a collapse state that is one number, of what was seen or estimated may be
    /// a range.
    pub bracket: Option<Bracket>,
    /// Of a lowest state, the highest state that is verified beside it: with head joints in contact,
    /// say, several mechanisms have one.
    pub highest_state: Option<f64>,
    /// Of a lowest state, whether the method that has it left its own answer undecided, as of how far other
    /// states reach.
    pub(crate) is_rest_undecided: bool,
    /// Of several states, what a simulation saw.
    pub(crate) seen: Option<Seen>,
    /// The multiplier below which a proof leaves no collapse state in which the push does work.
    pub floor: Option<Floor>,
    /// What the other proofs say that is not the same.
    pub difference: Option<Difference>,
    /// What speaks against the best answer and is not explained.
    pub doubts: Vec<Doubt>,
    /// Where a support moves, what the multipliers here say of its reaction.
    pub reaction: Option<Reaction>,
}

/// What a simulation saw where there are several collapse states: some of them, and not their range.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Seen {
    pub by: String,
    pub bracket: Bracket,
}

/// A proved lower bound.
#[derive(Clone, Debug, PartialEq)]
pub struct Floor {
    /// Whose proof it is.
    pub by: String,
    /// No collapse state with 0 ≤ λ below this exists in which the push does work.
    pub lower: f64,
    /// What openings and slips add up to at most in the states that it speaks of, over the push's own
    /// motion; `None` where that has no limit.
    pub cap: Option<f64>,
    /// The one side of the push that it speaks of, where the wall has another.
    pub push: Option<Push>,
}

impl fmt::Display for Floor {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let Some(push) = self.push {
            write!(f, "pushed to the {}, ", push.name())?;
        }
        f.write_str(&floor_words(&below(self.lower, 5), self.cap))
    }
}

worded! {
    /// What the best answer rests on, from best to worst.
    Basis {
        /// It falls under its own weight.
        Falls = "falls",
        /// A collapse state without dilatancy: the lowest that anybody verified. No lower bound.
        LowestState = "lowest-state-found",
        /// No push is too large, also without dilatancy.
        Stands = "stands",
        /// A bound that no collapse multiplier exceeds, and no state.
        UpperBound = "upper-bound",
        /// What was seen, without a proof.
        Observed = "observed",
        /// A number without a proof.
        Estimate = "estimate",
        /// No collapse state was found where with associative friction none exists, which proves nothing.
        NoneFound = "no-state-found",
        /// Nothing.
        Nothing = "nothing",
    }
}

/// How far proofs are apart from the lowest state, explained by what they prove: with dilatancy a
/// joint opens as it slips, which takes more push, so that λ_A bounds what happens without.
#[derive(Clone, Debug, PartialEq)]
pub struct Difference {
    /// Whose upper bound by associative friction it is.
    pub method: String,
    /// The bound; `None` where it stands, so that there is none.
    pub associative: Option<f64>,
    /// How far it is above the state, relative to that.
    pub relative: Option<f64>,
    /// Why that is no contradiction.
    pub explanation: Explanation,
}

worded! {
    /// Why associative friction gives more than the lowest state.
    #[derive(Error)]
    Explanation {
        /// With dilatancy joints open as they slip, which takes more push than any state found.
        #[error("its joints open as they slip")]
        Dilatancy = "dilatancy",
        /// States are verified up to there: which of them happens nobody knows of a real wall.
        #[error("other verified collapse states reach that value")]
        SeveralStates = "several-states",
    }
}

/// What is not explained.
#[derive(Clone, Debug, Error, PartialEq)]
#[allow(missing_docs, reason = "the sentence of each says it")]
pub enum Doubt {
    #[error(
        "{} gives {}, which is {} lower, so that a lower state may exist",
        .0.by,
        number(.0.lambda, .0.decimals),
        percent(.0.below)
    )]
    Lower(LowerState),
    /// A proof contradicts: it bounds the multiplier by less.
    #[error("{by} proves that none is above {}", above(*.lambda, 5))]
    Bound { by: String, lambda: f64 },
    #[error(
        "{by} gives {}, which is {} above what no collapse multiplier exceeds",
        number(*.lambda, 4),
        percent(*.above)
    )]
    Above {
        by: String,
        lambda: f64,
        /// How far above, relative to the bound.
        above: f64,
    },
    #[error(
        "{by} gives {}, and {floor} proves that no collapse is below {}",
        number(*.lambda, 4),
        below(*.least, 5)
    )]
    Excluded {
        by: String,
        lambda: f64,
        floor: String,
        least: f64,
    },
    #[error("{by} gives {lambda:.1e}, which can be no multiplier")]
    Impossible { by: String, lambda: f64 },
    /// This method proves that nothing collapses.
    #[error("{by} says that it stands")]
    Stands { by: String },
    #[error("{by} says that it falls under its own weight")]
    Falls { by: String },
}

impl Conclusion {
    /// Whether nothing speaks against the best answer but what is explained.
    pub fn is_explained(&self) -> bool {
        let other = self.other.as_ref();
        self.doubts.is_empty() && other.is_none_or(|other| other.is_explained())
    }

    /// The multiplier at which a collapse is known: of an upper bound alone that bound, else the lower
    /// end.
    pub(crate) fn collapse_known(&self) -> Option<f64> {
        self.bracket.map(|bracket| match self.basis {
            Basis::UpperBound => bracket.upper,
            _ => bracket.lower,
        })
    }

    /// Both ends of the range, the lower first: of a support that moves, of its reaction.
    pub(crate) fn range(&self) -> Option<(f64, f64)> {
        let Bracket { lower, upper } = self.bracket?;
        let reads = |lambda| self.reaction.as_ref().map_or(lambda, |of| of.at(lambda));
        let (one, other) = (reads(lower), reads(upper));
        Some((one.min(other), one.max(other)))
    }
}

/// Differences below this are none: λ with the digits that tables show.
pub(super) const ALIKE: f64 = 1e-4;

impl fmt::Display for Difference {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (method, explanation) = (&self.method, self.explanation);
        let (Some(lambda), Some(relative)) = (self.associative, self.relative) else {
            return write!(f, "{method} stands: {explanation}");
        };
        if relative.abs() <= ALIKE {
            return write!(f, "{method} gives the same");
        }
        write!(f, "{method} gives {}", number(lambda, 5))?;
        if relative > 10.0 {
            // Beside a state at 0, say, a percentage says nothing.
            write!(f, ": {explanation}")
        } else if relative > 0.0 {
            let above = percent(relative);
            write!(f, ", {above} higher: {explanation}")
        } else {
            Ok(())
        }
    }
}
