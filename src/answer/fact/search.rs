//! Facts of the search for collapse states.

use std::fmt;

use serde::{Deserialize, Serialize};
use thiserror::Error;

use crate::answer::bracket::is_same_multiplier;

/// How every start of a search for collapse states ended, in the order in which they ran.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct SearchFacts {
    /// One ending a start; a search that may stop early has fewer than it was allowed.
    pub starts: Vec<StartEnding>,
    /// Unit of λ of the scene, which tells small differences of λ.
    pub multiplier_unit: f64,
}

/// Where one start began and how it ended.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct StartEnding {
    /// Where it began.
    pub start: SearchStart,
    /// How it ended.
    pub ending: SearchEnding,
}

/// What the normal forces are that a start begins with.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum SearchStart {
    /// Those of the lowest state with open head joints.
    OpenState,
    /// Those of the associative state.
    Associative,
    /// Those after a few programs with frozen shear capacities.
    Frozen,
    /// Those under the own weight, where there is no associative state.
    OwnWeight,
    /// Those of a state of a scene that differs little.
    Neighbour,
    /// Those of the lowest state with open head joints, each scaled at random.
    OpenScaled,
    /// Those under the own weight, each reduced at random.
    OwnWeightReduced,
    /// Those under the own weight, half of them reduced to a twentieth.
    OwnWeightThinned,
    /// Of one order of magnitude in all joints, at random.
    Even,
    /// Those of a random force state at a random λ below λ_A.
    Statics,
    /// The same, each scaled at random.
    StaticsScaled,
    /// Those of a random force state at a random λ below the lowest state known.
    StaticsBelow,
    /// Those of the force state with the largest λ less random prices of the normal forces.
    Priced,
    /// Those of the lowest state known, each raised a little at random.
    LowestRaised,
    /// Those of the lowest state known, each scaled at random.
    LowestScaled,
    /// Those of the force state nearest to the lowest state's mechanism with its slips changed at
    /// random.
    LowestRepriced,
}

/// How a start ended.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub enum SearchEnding {
    /// With collapse states. Where a part of the scene is searched, these are proved as states of the
    /// part: one lower than all before it is completed to a state of the whole scene at once, any
    /// other later, where the answer rests on it.
    Verified {
        /// λ of the lowest one.
        lowest: f64,
    },
    /// Without.
    Failed(SearchFailure),
}

/// Why a start gave no state.
#[derive(Clone, Copy, Debug, Error, PartialEq, Eq, Serialize, Deserialize)]
pub enum SearchFailure {
    /// The gap stayed open.
    #[error("did not close the gap between forces and mechanism")]
    GapOpen,
    /// A program with frozen capacities has no force state.
    #[error("met a linear program without a force state")]
    Infeasible,
    /// A program is unbounded.
    #[error("met a linear program without a limit of λ")]
    Unbounded,
    /// The solver gave up on a program.
    #[error("met a linear program that the solver gave up")]
    Unsolved,
    /// The state found for a part of the scene is none of the whole scene.
    #[error("reached a state of a part that is none of the whole scene")]
    PartOnly,
    /// The state found leaves residuals that prove nothing.
    #[error("reached a state that is not proved")]
    Unproved,
    /// All states of the mechanism lie below λ = 0, where a push begins.
    #[error("reached a mechanism whose states lie below λ = 0, where a push begins")]
    BelowZero,
}

impl SearchFailure {
    /// Every failure, in the order in which they are counted.
    pub const ALL: [SearchFailure; 7] = [
        SearchFailure::GapOpen,
        SearchFailure::Infeasible,
        SearchFailure::Unbounded,
        SearchFailure::Unsolved,
        SearchFailure::PartOnly,
        SearchFailure::Unproved,
        SearchFailure::BelowZero,
    ];
}

/// How far the starts of a search cover the states that there are.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Coverage {
    /// Starts.
    pub starts: usize,
    /// Starts that ended with a collapse state.
    pub verified: usize,
    /// States that differ in λ.
    pub distinct: usize,
    /// Starts that ended with the lowest state.
    pub lowest_met: usize,
    /// Share of further starts that would end with a state not met so far, estimated by the share of
    /// starts whose state no other one met (Good 1953, Biometrika 40, 237-264, after Turing).
    pub unseen: f64,
}

impl SearchFacts {
    /// Starts that ended with collapse states.
    pub fn verified(&self) -> usize {
        self.lambdas().len()
    }

    /// Starts that ended with this failure.
    pub fn failed(&self, failure: SearchFailure) -> usize {
        let failed = |start: &&StartEnding| start.ending == SearchEnding::Failed(failure);
        self.starts.iter().filter(failed).count()
    }

    /// λ of the verified starts, ascending.
    fn lambdas(&self) -> Vec<f64> {
        let verified = self.starts.iter().filter_map(|start| match start.ending {
            SearchEnding::Verified { lowest } => Some(lowest),
            SearchEnding::Failed(_) => None,
        });
        let mut lambdas: Vec<f64> = verified.collect();
        lambdas.sort_by(f64::total_cmp);
        lambdas
    }

    /// How far the starts cover the states.
    pub fn coverage(&self) -> Coverage {
        let lambdas = self.lambdas();
        let same = |a: &f64, b: &f64| is_same_multiplier(*b, *a, self.multiplier_unit);
        let met: Vec<usize> = lambdas.chunk_by(same).map(<[f64]>::len).collect();
        let once = met.iter().filter(|&&times| times == 1).count();
        Coverage {
            starts: self.starts.len(),
            verified: lambdas.len(),
            distinct: met.len(),
            lowest_met: met.first().copied().unwrap_or(0),
            unseen: once as f64 / lambdas.len().max(1) as f64,
        }
    }
}

impl fmt::Display for SearchFacts {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Coverage {
            starts,
            verified,
            distinct,
            lowest_met,
            unseen,
        } = self.coverage();
        let counted = |count: usize, word: &str| match count {
            1 => format!("1 {word}"),
            _ => format!("{count} {word}s"),
        };
        let starts = counted(starts, "start");
        if verified > 0 {
            let (states, times) = (
                counted(distinct, "collapse state"),
                counted(lowest_met, "time"),
            );
            write!(
                f,
                "{verified} of {starts} reached {states}, and the lowest was reached {times}; about \
                 {:.0} % of further starts would reach a new one (Good-Turing estimate)",
                100.0 * unseen
            )?;
        } else {
            write!(f, "{starts} reached no collapse state")?;
        }
        for failure in SearchFailure::ALL {
            let count = self.failed(failure);
            if count > 0 {
                write!(f, "; {} {failure}", counted(count, "start"))?;
            }
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn coverage_counts_states_and_how_often_they_are_met() {
        let lambdas = [Some(0.5), Some(0.5 + 1e-8), Some(0.4), None, Some(0.6)];
        let starts = lambdas.map(|lambda| StartEnding {
            start: SearchStart::Even,
            ending: match lambda {
                Some(lowest) => SearchEnding::Verified { lowest },
                None => SearchEnding::Failed(SearchFailure::GapOpen),
            },
        });
        let facts = SearchFacts {
            starts: starts.to_vec(),
            multiplier_unit: 1.0,
        };
        let expected = Coverage {
            starts: 5,
            verified: 4,
            distinct: 3,
            lowest_met: 1,
            unseen: 0.5,
        };
        assert_eq!(facts.coverage(), expected);
        assert_eq!(
            facts.to_string(),
            "4 of 5 starts reached 3 collapse states, and the lowest was reached 1 time; about 50 % of \
             further starts would reach a new one (Good-Turing estimate); 1 start did not close the \
             gap between forces and mechanism"
        );
        let none = SearchFacts {
            starts: starts[3..4].to_vec(),
            multiplier_unit: 1.0,
        };
        assert_eq!(none.coverage().unseen, 0.0);
        assert_eq!(
            none.to_string(),
            "1 start reached no collapse state; 1 start did not close the gap between forces and \
             mechanism"
        );
    }
}
