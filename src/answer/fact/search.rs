//! Facts of the search for collapse states.

use std::fmt;

/// How every start of a search for collapse states ended, in the order in which they ran.
#[derive(Clone, Debug, PartialEq)]
pub struct SearchFacts {
    /// One ending a start; a search that may stop early has fewer than it was allowed.
    pub starts: Vec<StartEnding>,
}

/// Where one start began and how it ended.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StartEnding {
    /// Where it began.
    pub start: SearchStart,
    /// How it ended.
    pub ending: SearchEnding,
}

/// What the normal forces are that a start begins with.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SearchStart {
    /// Those of the lowest state with open head joints.
    OpenState,
    /// Those of the associative state.
    Associative,
    /// Those after a few programs with frozen shear capacities.
    Frozen,
    /// Those under the own weight, where there is no associative state.
    OwnWeight,
    /// Those of the associative state, or under the own weight, each scaled at random.
    Scaled,
    /// Those of a state of a scene that differs little.
    Neighbour,
}

impl SearchStart {
    fn name(self) -> &'static str {
        match self {
            SearchStart::OpenState => "open state",
            SearchStart::Associative => "associative",
            SearchStart::Frozen => "frozen",
            SearchStart::OwnWeight => "own weight",
            SearchStart::Scaled => "scaled",
            SearchStart::Neighbour => "neighbour",
        }
    }
}

/// How a start ended.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum SearchEnding {
    /// With collapse states.
    Verified {
        /// λ of the lowest one.
        lowest: f64,
        /// λ of the highest one of the same mechanism, where that is a state of the whole scene.
        highest: Option<f64>,
    },
    /// Without.
    Failed(SearchFailure),
}

/// Why a start gave no state.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SearchFailure {
    /// The gap stayed open.
    GapOpen,
    /// A program with frozen capacities has no force state.
    Infeasible,
    /// A program is unbounded.
    Unbounded,
    /// The solver gave up on a program.
    Unsolved,
    /// The state found for a part of the scene is none of the whole scene.
    PartOnly,
    /// The state found leaves residuals that prove nothing.
    Unproved,
}

impl SearchFailure {
    /// Every failure, in the order in which they are counted.
    pub const ALL: [SearchFailure; 6] = [
        SearchFailure::GapOpen,
        SearchFailure::Infeasible,
        SearchFailure::Unbounded,
        SearchFailure::Unsolved,
        SearchFailure::PartOnly,
        SearchFailure::Unproved,
    ];
}

impl fmt::Display for SearchFailure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            SearchFailure::GapOpen => "gap stayed open",
            SearchFailure::Infeasible => "program infeasible",
            SearchFailure::Unbounded => "program unbounded",
            SearchFailure::Unsolved => "program unsolved",
            SearchFailure::PartOnly => "no state of the whole scene",
            SearchFailure::Unproved => "state not proved",
        })
    }
}

impl SearchFacts {
    /// Starts that ended with collapse states.
    pub fn verified(&self) -> usize {
        verified(&self.starts)
    }

    /// Starts that ended with this failure.
    pub fn failed(&self, failure: SearchFailure) -> usize {
        failed(&self.starts, failure)
    }
}

fn verified(starts: &[StartEnding]) -> usize {
    let verified = |start: &&StartEnding| matches!(start.ending, SearchEnding::Verified { .. });
    starts.iter().filter(verified).count()
}

fn failed(starts: &[StartEnding], failure: SearchFailure) -> usize {
    let failed = |start: &&StartEnding| start.ending == SearchEnding::Failed(failure);
    starts.iter().filter(failed).count()
}

/// Starts that a text lists one by one; of the others it gives counts.
const LISTED_STARTS: usize = 8;

impl fmt::Display for SearchFacts {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let listed = self.starts.len().min(LISTED_STARTS);
        let (first, others) = self.starts.split_at(listed);
        let mut texts: Vec<String> = first.iter().map(StartEnding::to_string).collect();
        if !others.is_empty() {
            let count = others.len();
            texts.push(format!("and {count} more: {} verified", verified(others)));
        }
        for failure in SearchFailure::ALL {
            let count = failed(others, failure);
            if count > 0 {
                texts.push(format!("{count} {failure}"));
            }
        }
        f.write_str(&texts.join(", "))
    }
}

impl fmt::Display for StartEnding {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let name = self.start.name();
        match self.ending {
            SearchEnding::Verified { lowest, highest } => {
                write!(f, "{name}: {lowest:.5}")?;
                highest.map_or(Ok(()), |highest| write!(f, " to {highest:.5}"))
            }
            SearchEnding::Failed(failure) => write!(f, "{name}: {failure}"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn many_starts_are_listed_first_and_then_counted() {
        let ending = |k: usize| match k % 3 {
            0 => SearchEnding::Verified {
                lowest: 0.5,
                highest: (k == 0).then_some(0.6),
            },
            1 => SearchEnding::Failed(SearchFailure::GapOpen),
            _ => SearchEnding::Failed(SearchFailure::Infeasible),
        };
        let starts = (0..12).map(|k| StartEnding {
            start: SearchStart::Scaled,
            ending: ending(k),
        });
        let facts = SearchFacts {
            starts: starts.collect(),
        };
        assert_eq!(facts.verified(), 4);
        assert_eq!(facts.failed(SearchFailure::GapOpen), 4);
        let text = facts.to_string();
        assert!(text.starts_with("scaled: 0.50000 to 0.60000, scaled: gap stayed open, "));
        assert!(
            text.ends_with(", and 4 more: 1 verified, 1 gap stayed open, 2 program infeasible")
        );
    }
}
