//! Facts of the search for collapse states.

use std::fmt;

use serde::{Deserialize, Serialize};

use crate::answer::bracket::is_same_multiplier;
use crate::text::{counted, worded};

/// How every start of a search for collapse states ended, in the order in which they ran.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct SearchFacts {
    /// One ending a start; a search that may stop early has fewer than it was allowed. With collapse
    /// states it is λ of the lowest one. Where a part of the scene is searched, these are proved as states
    /// of the part: one lower than all before it is completed to a state of the whole scene at once, any
    /// other later, where the answer rests on it.
    pub starts: Vec<Result<f64, SearchFailure>>,
    /// Unit of λ of the scene, which tells small differences of λ.
    pub multiplier_unit: f64,
}

worded! {
    /// Why a start gave no state; in the order in which they are counted, each with what is said of it.
    #[derive(Serialize, Deserialize)]
    SearchFailure {
        /// The gap stayed open.
        GapOpen = "did not close the gap between forces and mechanism",
        /// A program with frozen capacities has no force state.
        Infeasible = "met a linear program without a force state",
        /// A program is unbounded.
        Unbounded = "met a linear program without a limit of λ",
        /// The solver gave up on a program.
        Unsolved = "met a linear program that the solver gave up",
        /// The state found for a part of the scene is none of the whole scene.
        PartOnly = "reached a state of a part that is none of the whole scene",
        /// The state found leaves residuals that prove nothing.
        Unproved = "reached a state that is not proved",
        /// All states of the mechanism lie below λ = 0, where a push begins.
        BelowZero = "reached a mechanism whose states lie below λ = 0, where a push begins",
    }
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
        let failed = self.starts.iter().filter(|start| **start == Err(failure));
        failed.count()
    }

    /// λ of the verified starts, ascending.
    fn lambdas(&self) -> Vec<f64> {
        let mut lambdas: Vec<f64> = self.starts.iter().copied().flatten().collect();
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
                write!(f, "; {} {}", counted(count, "start"), failure.name())?;
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
        let starts = lambdas.map(|lambda| lambda.ok_or(SearchFailure::GapOpen));
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
