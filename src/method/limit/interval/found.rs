//! The states that a search has found, and whether it goes on.

use super::descent::{Branch, is_same};
use super::search::State;

/// A state and how often starts have ended on it.
pub(super) struct Met {
    pub(super) state: State,
    times: usize,
}

/// Distinct states in ascending order of λ, and the highest ones on the way to them.
#[derive(Default)]
pub(super) struct Found {
    distinct: Vec<Met>,
    /// The highest of the first states of the starts, in descending order of λ.
    firsts: Vec<State>,
}

/// First states kept: on a part of a wall the highest ones need not be states of the whole wall.
const KEPT_FIRSTS: usize = 4;

impl Found {
    /// Takes what one start led to.
    pub(super) fn take(&mut self, branch: Branch) {
        let lambda = branch.lowest.lambda;
        let first = branch.first.lambda;
        let at = self.firsts.partition_point(|state| state.lambda > first);
        self.firsts.insert(at, branch.first);
        self.firsts.truncate(KEPT_FIRSTS);
        let known = |met: &&mut Met| is_same(lambda, met.state.lambda);
        if let Some(met) = self.distinct.iter_mut().find(known) {
            met.times += 1;
            return;
        }
        let at = self
            .distinct
            .partition_point(|met| met.state.lambda < lambda);
        let state = branch.lowest;
        self.distinct.insert(at, Met { state, times: 1 });
    }

    pub(super) fn lowest(&self) -> Option<&State> {
        self.distinct.first().map(|met| &met.state)
    }

    /// The highest of the first states of the starts, in descending order of λ.
    pub(super) fn highest(&self) -> impl Iterator<Item = &State> {
        self.firsts.iter()
    }

    /// Distinct states in ascending order of λ.
    pub(super) fn states(&self) -> impl Iterator<Item = &State> {
        self.distinct.iter().map(|met| &met.state)
    }

    pub(super) fn lambdas(&self) -> Vec<f64> {
        self.states().map(|state| state.lambda).collect()
    }

    /// Whether the lowest state was met by more than one start.
    pub(super) fn is_lowest_met_again(&self) -> bool {
        self.distinct.first().is_some_and(|met| met.times > 1)
    }
}

/// How long a search goes on.
pub(super) struct Budget {
    /// Starts that a user asks for; none where the programs decide.
    pub(super) starts: Option<usize>,
    /// Programs after which it ends where the lowest state was met more than once.
    pub(super) programs: usize,
}

impl Budget {
    /// The budget of a scene. A program's time grows with the blocks by a power of about 1.5, so that
    /// a scene of 25 blocks takes 0.8 s, one of 150 blocks 2 s, one of 650 blocks 20 s; a scene of few joints has few states
    /// to look for.
    pub(super) fn of(blocks: usize, joints: usize, starts: usize) -> Self {
        let programs = 5500.0 / (blocks as f64).powf(0.6);
        Self {
            starts: (starts > 0).then_some(starts),
            programs: (programs as usize).min(20 * joints),
        }
    }

    /// Whether a search of so many starts and programs goes on. Where the lowest state was met once
    /// only, others may be missed, and it gets half as many programs again.
    pub(super) fn goes_on(&self, starts: usize, programs: usize, found: &Found) -> bool {
        match self.starts {
            Some(asked) => starts < asked,
            None if found.is_lowest_met_again() => programs < self.programs,
            None => 2 * programs < 3 * self.programs,
        }
    }
}
