//! One search: starts followed down to their lowest states until the budget ends.

use super::descent::Branch;
use super::found::{Budget, Found};
use super::numerics::Numerics;
use super::parameters::Tuned;
use super::place::Place;
use super::search::{Search, State};
use super::starts::Starts;
use crate::answer::{SearchFacts, SearchFailure, Work};
use crate::mechanics::{BlockResidual, CollapseState, JointForce};
use crate::method::Settings;
use crate::method::limit::ending::{Ending, Solution, totals};
use crate::method::limit::equilibration::needs_own_units;
use crate::method::settings::Engine;
use crate::scene::Scene;

/// What a search is asked for.
pub(super) struct Request<'a> {
    pub(super) settings: &'a Settings,
    pub(super) tuned: Tuned,
    /// The search stops at the first state below this λ.
    pub(super) stop_below: f64,
    /// Normal forces of neighbours: N of every joint over the whole scene's weight. The search
    /// starts from them too, beside the starts that its settings ask for.
    pub(super) neighbours: &'a [Vec<f64>],
}

impl<'a> Request<'a> {
    /// All that these settings ask for, from no neighbours and to no end before theirs.
    pub(super) fn of(settings: &'a Settings) -> Self {
        Self {
            settings,
            tuned: Tuned::TUNED,
            stop_below: f64::NEG_INFINITY,
            neighbours: &[],
        }
    }
}

/// What a search has found.
pub(super) struct Explored {
    /// Verified states of the whole scene, the lowest first.
    pub(super) states: Vec<CollapseState>,
    pub(super) facts: SearchFacts,
    /// Where a state was none because of one block: its residual.
    pub(super) unresolved: Option<BlockResidual>,
}

/// Searches a part of the scene, or the whole of it.
pub(super) fn explore(
    place: Place,
    numerics: Numerics,
    request: &Request,
    at_rest: &[JointForce],
    work: &mut Work,
) -> Result<Explored, Ending> {
    let (mut search, associative) = begin(place.searched(), numerics, request.tuned)?;
    let starts = Starts::of(&mut search, associative, place.normal(at_rest));
    Ok(follow(place, request, search, starts, work))
}

/// A search and N of the associative state. Where the structured engine gives up the first program of
/// unequal blocks, or leaves more of it than a proof takes, Clarabel solves all of them.
fn begin(
    scene: &Scene,
    numerics: Numerics,
    tuned: Tuned,
) -> Result<(Search<'_>, Vec<f64>), Ending> {
    let mut search = Search::new(scene, numerics, tuned);
    let mut associative = search.associative()?;
    let is_structured = numerics.engine == Engine::Structured;
    if is_structured && needs_own_units(scene) && !is_exact(&search, &associative) {
        let engine = Engine::Clarabel;
        let work = search.work;
        search = Search::new(scene, Numerics { engine, ..numerics }, tuned);
        search.work = work;
        associative = search.associative()?;
    }
    Ok((search, totals(&associative.forces)))
}

/// Whether the structured engine has solved the program of λ_A, block by block as far as a proof asks.
fn is_exact(search: &Search, associative: &Solution) -> bool {
    let scale = search.program().scale();
    let forces = scale.forces(&associative.forces);
    let lambda = associative.lambda * scale.multiplier;
    let mechanism = scale.mechanism(&associative.velocity);
    let of_forces = BlockResidual::of_forces(search.scene, &forces, lambda);
    let left = of_forces.worse(BlockResidual::of_flow(search.scene, &mechanism));
    associative.engine == Engine::Structured && left.is_small()
}

/// Follows one start after the other down to its lowest state.
pub(super) fn follow(
    place: Place,
    request: &Request,
    mut search: Search,
    mut starts: Starts,
    work: &mut Work,
) -> Explored {
    let searched = place.searched();
    let neighbours = request.neighbours.iter();
    let neighbours: Vec<_> = neighbours.map(|n| place.normal_of(n)).collect();
    let asked = request.settings.interval.starts;
    let mut budget = match asked {
        0 => Budget::of(searched, search.program().engine(), &request.tuned),
        asked => Budget::Starts(asked + neighbours.len()),
    };
    let after = if asked > 0 { asked } else { usize::MAX };
    starts.add_neighbours(after, neighbours);
    let scale = search.program().scale();
    let mut reached = Reached::default();
    let mut endings = Vec::new();
    while budget.goes_on(endings.len(), &search.work, &reached.found, &request.tuned) {
        let lowest = reached.found.lowest();
        let lowest = lowest.map_or(f64::INFINITY, |state| state.lambda);
        let before = search.work.programs;
        let branch = starts.follow_next(&mut search, &reached.found);
        if endings.is_empty() {
            budget.learn(search.work.programs - before);
            starts.dear = budget.is_dear();
        }
        let lambda = branch.and_then(|branch| reached.take(place, &mut search, branch, work));
        endings.push(lambda.map(|lambda| lambda * scale.multiplier));
        starts.go_on(lambda.is_ok_and(|lambda| lambda < lowest));
        let of_whole = reached.lowest(scale.multiplier);
        let is_too_small = || reached.found.is_of_part(request.tuned.of_part);
        if of_whole.map_or_else(is_too_small, |lambda| lambda <= request.stop_below) {
            break;
        }
    }
    let mut states = Vec::new();
    if reached.lowest(scale.multiplier).is_some() {
        states = whole_states(place, &mut search, &reached.found, work);
    }
    for beyond in reached.beyond {
        let ending = beyond.as_ref().map(|states| states[0].lambda);
        endings.push(ending.map_err(|&why| why));
        states.extend(beyond.unwrap_or_default());
    }
    states.sort_by(|a, b| a.lambda.total_cmp(&b.lambda));
    *work = *work + search.work;
    work.modelled = searched.blocks().len();
    Explored {
        states,
        facts: SearchFacts {
            starts: endings,
            multiplier_unit: scale.multiplier,
        },
        unresolved: reached.unresolved,
    }
}

/// What the starts of a search have led to.
#[derive(Default)]
struct Reached {
    found: Found,
    /// States of the whole scene to which states of the part alone have led, the lowest of each first.
    beyond: Vec<Result<Vec<CollapseState>, SearchFailure>>,
    unresolved: Option<BlockResidual>,
}

impl Reached {
    /// λ of the lowest state of the whole scene, from λ in this unit; `None` where no start has led to one.
    fn lowest(&self, unit: f64) -> Option<f64> {
        let found = self.found.lowest().map(|state| state.lambda * unit);
        let beyond = self.beyond.iter().flatten().map(|states| states[0].lambda);
        found.into_iter().chain(beyond).min_by(f64::total_cmp)
    }

    /// Takes what one start led to, if that is proved: λ of its lowest state. From one of the part alone,
    /// where it is the lowest of those, a descent goes on in the whole scene.
    fn take(
        &mut self,
        place: Place,
        search: &mut Search,
        mut branch: Branch,
        work: &mut Work,
    ) -> Result<f64, SearchFailure> {
        let firsts = search.tuned.firsts;
        let scale = search.program().scale();
        let lowest = self
            .found
            .lowest()
            .map_or(f64::INFINITY, |state| state.lambda);
        match place.prove(scale, &mut branch, lowest, work) {
            Ok(()) => {
                let lambda = branch.lowest.lambda;
                self.found.take(branch, firsts);
                Ok(lambda)
            }
            Err(failure) => {
                if failure == SearchFailure::Unproved {
                    let blocks = place.unresolved(scale, &branch.lowest);
                    self.unresolved = self.unresolved.take().or(blocks);
                } else if self.found.take_of_part(&branch, firsts) {
                    // The budget counts these programs too.
                    let mut own = Work::default();
                    self.beyond
                        .push(place.beyond_part(search, &branch.lowest, &mut own));
                    search.work = search.work + own;
                }
                Err(failure)
            }
        }
    }
}

/// The states found that are states of the whole scene. Each one of a part costs a program, so that
/// of those only the lowest and the highest are completed.
fn whole_states(
    place: Place,
    search: &mut Search,
    found: &Found,
    work: &mut Work,
) -> Vec<CollapseState> {
    let scale = search.program().scale();
    let mut whole = |state: &State| place.state(scale, state, work);
    let mut lowest = found
        .states()
        .filter_map(|state| Some((state, whole(state)?)));
    let mut states = Vec::new();
    let mut higher: Vec<State> = Vec::new();
    if let Some((of_part, first)) = lowest.next() {
        states.push(first);
        higher.push(search.highest_of(of_part));
    }
    if !place.is_part() {
        states.extend(lowest.map(|(_, state)| state));
    }
    higher.extend(found.highest().next().map(|state| search.highest_of(state)));
    higher.extend(found.highest().cloned());
    higher.sort_by(|a, b| b.lambda.total_cmp(&a.lambda));
    let known = states
        .last()
        .map_or(f64::NEG_INFINITY, |state| state.lambda);
    // The gap that a state may leave could lift it above λ_A where that is small.
    let bound = search.associative.unwrap_or(f64::INFINITY);
    let bound = bound + search.tuned.above_bound * bound.abs();
    let higher = higher
        .iter()
        .filter(|state| state.lambda * scale.multiplier > known && state.lambda <= bound);
    states.extend(
        higher
            .filter_map(|state| place.state(scale, state, work))
            .next(),
    );
    states
}
