//! The states that a search has found, and whether it goes on.

use super::descent::{Branch, is_same};
use super::parameters::Tuned;
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
    /// The lowest state of the part that is searched which is none of the whole scene, and how often starts
    /// have ended on such states.
    of_part: Option<Met>,
    times_of_part: usize,
}

impl Found {
    /// Takes what one start led to; of the first states no more than so many are kept.
    pub(super) fn take(&mut self, branch: Branch, firsts: usize) {
        self.take_first(branch.first, firsts);
        let lambda = branch.lowest.lambda;
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

    /// Takes what one start led to whose lowest state is one of the part alone. Whether it is the lowest of
    /// those.
    pub(super) fn take_of_part(&mut self, branch: &Branch, firsts: usize) -> bool {
        self.take_first(branch.first.clone(), firsts);
        self.times_of_part += 1;
        let state = branch.lowest.clone();
        match &mut self.of_part {
            Some(known) if is_same(state.lambda, known.state.lambda) => known.times += 1,
            Some(known) if state.lambda > known.state.lambda => {}
            _ => {
                self.of_part = Some(Met { state, times: 1 });
                return true;
            }
        }
        false
    }

    /// Takes the first state of a start; of the highest ones no more than so many are kept.
    fn take_first(&mut self, state: State, firsts: usize) {
        let first = state.lambda;
        let at = self.firsts.partition_point(|state| state.lambda > first);
        self.firsts.insert(at, state);
        self.firsts.truncate(firsts);
    }

    /// Whether the part is too small: so many starts have ended on states of it alone, and none on another.
    pub(super) fn is_of_part(&self, times: usize) -> bool {
        self.distinct.is_empty() && self.times_of_part >= times
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

    /// The lowest state, be it one of the part alone, and how often it was met.
    fn lowest_met(&self) -> Option<&Met> {
        let both = self.distinct.first().into_iter().chain(&self.of_part);
        both.min_by(|a, b| a.state.lambda.total_cmp(&b.state.lambda))
    }

    /// The lowest state, be it one of the part alone.
    pub(super) fn lowest_anywhere(&self) -> Option<&State> {
        self.lowest_met().map(|met| &met.state)
    }

    /// Whether that was met by more than one start.
    pub(super) fn is_lowest_met_again(&self) -> bool {
        self.lowest_met().is_some_and(|met| met.times > 1)
    }
}

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
    pub(super) fn of(scene: &Scene, engine: Engine, tuned: &Tuned) -> Self {
        let size = (scene.blocks().len() as f64).powf(tuned.growth);
        let programs = (tuned.programs / size) as usize;
        let programs = match engine {
            Engine::Structured => programs,
            Engine::Clarabel => programs / tuned.clarabel,
        };
        Budget::Programs {
            programs: programs.min(tuned.of_joint * scene.joints().len()),
            cheap: (tuned.dear / size) as usize,
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

    /// Whether a search of so many starts goes on after its work.
    pub(super) fn goes_on(&self, starts: usize, work: &Work, found: &Found, tuned: &Tuned) -> bool {
        let (programs, dear) = match *self {
            Budget::Starts(asked) => return starts < asked,
            Budget::Programs { programs, dear, .. } => (programs, dear),
        };
        let part = match found.lowest() {
            None => 1.0,
            Some(_) if !found.is_lowest_met_again() => tuned.met_once,
            // Where starts are dear, two that end alike are worth more than many elsewhere.
            Some(_) if dear => tuned.dear_part,
            Some(_) => 1.0,
        };
        let spent = work.programs + (tuned.clarabel - 1) * work.fallbacks;
        (spent as f64) < part * programs as f64
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
        // 150 blocks, whose 0.8th power is 55.1.
        for engine in [Engine::Structured, Engine::Clarabel] {
            let dear = |first| {
                let mut budget = Budget::of(&scene, engine, &Tuned::TUNED);
                budget.learn(first);
                budget.is_dear()
            };
            assert!(!dear(92));
            assert!(dear(93));
        }
    }
}
