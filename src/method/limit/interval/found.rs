//! The states that a search has found, and whether it goes on.

use super::descent::{Branch, is_same};
use super::search::State;
use crate::answer::Work;
use crate::method::settings::Engine;
use crate::scene::Scene;

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

/// Starts are dear where fewer than so many fit into the budget (chosen: on walls of 150 blocks and
/// more, where small steps from the lowest state found more than further starts did).
const DEAR: usize = 10;

/// What a program costs with Clarabel, in programs of the engine that knows their structure: 3 to 7
/// times as much in searches on walls of 28 to 650 blocks (measured).
const CLARABEL: usize = 4;

/// How long a search goes on.
pub(super) enum Budget {
    /// For so many starts.
    Starts(usize),
    /// For as long as its programs last.
    Programs {
        /// Programs after which it ends where the lowest state was met more than once.
        programs: usize,
        /// Whether starts are dear: fewer than [`DEAR`] fit into the budget.
        dear: bool,
    },
}

impl Budget {
    /// The budget of a scene, chosen for time: about a second for 15 to 40 blocks. A program's time
    /// grows with the blocks by a power of about 1.5, so that a search's grows by 0.9. A scene of few
    /// joints has few states to look for. Where Clarabel solves the programs there are fewer.
    pub(super) fn of(scene: &Scene, engine: Engine) -> Self {
        let programs = 20_000.0 / (scene.blocks().len() as f64).powf(0.6);
        let programs = match engine {
            Engine::Structured => programs as usize,
            Engine::Clarabel => programs as usize / CLARABEL,
        };
        Budget::Programs {
            programs: programs.min(60 * scene.joints().len()),
            dear: false,
        }
    }

    /// Learns from the first start, which took so many programs, whether starts are dear.
    pub(super) fn learn(&mut self, first: usize) {
        if let Budget::Programs { programs, dear } = self {
            *dear = first * DEAR > *programs;
        }
    }

    /// Whether starts are known to be dear.
    pub(super) fn is_dear(&self) -> bool {
        matches!(self, Budget::Programs { dear: true, .. })
    }

    /// Whether a search of so many starts goes on after its work. Where the lowest state was met once
    /// only, others may be missed, and it gets half as many programs again.
    pub(super) fn goes_on(&self, starts: usize, work: &Work, found: &Found) -> bool {
        let spent = work.programs + (CLARABEL - 1) * work.fallbacks;
        match *self {
            Budget::Starts(asked) => starts < asked,
            Budget::Programs { programs, .. } if found.lowest().is_none() => spent < programs,
            // Where starts are dear, two that end alike are worth more than many elsewhere.
            Budget::Programs { programs, dear } if found.is_lowest_met_again() => {
                spent < programs / if dear { 2 } else { 1 }
            }
            Budget::Programs { programs, .. } => 2 * spent < 3 * programs,
        }
    }
}
