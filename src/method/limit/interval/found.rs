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

/// Starts are dear where the first one takes more programs than this over blocks^[`SHARE`], whatever
/// the budget (chosen: on walls of 150 blocks and more small steps from the lowest state found more
/// than further starts did).
const DEAR: f64 = 2_000.0;

/// Programs of a search times blocks^[`SHARE`] (chosen for time: about a second for 15 to 40 blocks).
const PROGRAMS: f64 = 20_000.0;

/// A program's time grows with the blocks by a power of about 1.5, a search's by 0.9.
const SHARE: f64 = 0.6;

/// Programs of a search for each joint at most: a scene of few joints has few states to look for
/// (chosen).
const OF_JOINT: usize = 60;

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
        /// Programs of the first start beyond which starts are dear.
        cheap: usize,
        /// Whether they are.
        dear: bool,
    },
}

impl Budget {
    /// The budget of a scene. Where Clarabel solves the programs there are fewer.
    pub(super) fn of(scene: &Scene, engine: Engine) -> Self {
        let size = (scene.blocks().len() as f64).powf(SHARE);
        let programs = (PROGRAMS / size) as usize;
        let programs = match engine {
            Engine::Structured => programs,
            Engine::Clarabel => programs / CLARABEL,
        };
        Budget::Programs {
            programs: programs.min(OF_JOINT * scene.joints().len()),
            cheap: (DEAR / size) as usize,
            dear: false,
        }
    }

    /// Learns from the first start, which took so many programs, whether starts are dear.
    pub(super) fn learn(&mut self, first: usize) {
        if let Budget::Programs { cheap, dear, .. } = self {
            *dear = first > *cheap;
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
            Budget::Programs { programs, dear, .. } if found.is_lowest_met_again() => {
                spent < programs / if dear { 2 } else { 1 }
            }
            Budget::Programs { programs, .. } => 2 * spent < 3 * programs,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::method::limit::walls::wall;
    use crate::scene::Push;

    #[test]
    fn which_starts_are_dear_does_not_depend_on_the_budget() {
        let scene = wall(50, Push::Right);
        // 150 blocks, whose 0.6th power is 20.2.
        for engine in [Engine::Structured, Engine::Clarabel] {
            let dear = |first| {
                let mut budget = Budget::of(&scene, engine);
                budget.learn(first);
                budget.is_dear()
            };
            assert!(!dear(98));
            assert!(dear(99));
        }
    }
}
