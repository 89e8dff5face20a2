//! The verified interval of non-associative friction (zero dilatancy).
//!
//! A non-associative collapse multiplier is not one number: for a given mechanism the admissible λ
//! form an interval, and there are several mechanisms. This method reports the lowest and the
//! highest λ for which it *found* a collapse state, each with forces and mechanism that the judge
//! verifies. They are no bounds: λ_A bounds all of them from above, no useful rigorous lower bound
//! is known.

mod descent;
mod found;
mod noise;
mod outer;
mod search;
mod starts;

use super::ending::Ending;
use super::equilibration::{Evening, evenings};
use super::own_weight::{own_weight, ray, stands_without_dilatancy, without_optimum};
use super::reduction::{self, ScenePart};
use super::scale::Scale;
use crate::answer::{
    BlockResidual, Bracket, CollapseResidual, CollapseState, JointForce, LimitFact, Outcome,
    SearchEnding, SearchFacts, SearchFailure, SolverEnding, StartEnding, StaticResidual, Status,
    VELOCITY_THRESHOLDS, VERIFIED_RESIDUAL, Work, crack_slope,
};
use crate::method::{Method, Settings};
use crate::scene::Scene;
use descent::Branch;
use found::{Budget, Found};
use search::{Refinement, Search, State, totals};
use starts::Starts;

/// `lower` and `upper` are the lowest and the highest verified λ found.
pub struct Interval;

impl Method for Interval {
    fn name(&self) -> &str {
        "interval"
    }

    fn solve(&self, scene: &Scene, settings: &Settings) -> Outcome {
        lowest(scene, settings, f64::NEG_INFINITY)
    }
}

impl Interval {
    /// As [`Method::solve`], starting from further normal forces too: N of every joint over the
    /// scene's total weight, such as those of a state of a scene that differs little.
    pub fn solve_from(&self, scene: &Scene, settings: &Settings, further: &[Vec<f64>]) -> Outcome {
        let request = Request {
            settings,
            stop_below: f64::NEG_INFINITY,
            further,
        };
        solve(scene, &request)
    }
}

/// The interval; a search that stops at the first state below `stop_below`.
pub(crate) fn lowest(scene: &Scene, settings: &Settings, stop_below: f64) -> Outcome {
    let request = Request {
        settings,
        stop_below,
        further: &[],
    };
    solve(scene, &request)
}

/// What a search is asked for.
struct Request<'a> {
    settings: &'a Settings,
    /// The search stops at the first state below this λ.
    stop_below: f64,
    /// Normal forces to start from after the search's own starts.
    further: &'a [Vec<f64>],
}

fn solve(scene: &Scene, request: &Request) -> Outcome {
    let mut work = Work::default();
    let at_rest = match own_weight(scene, &mut work) {
        Ok(forces) => forces,
        Err(outcome) => return *outcome,
    };
    let reduce = request.settings.programs.reduction;
    for part in reduction::parts(scene).into_iter().filter(|_| reduce) {
        let place = Place::part(scene, &part);
        let Ok(explored) = explore(
            place,
            (Evening::CubeRoot, Refinement::Rough),
            request,
            &at_rest,
            &mut work,
        ) else {
            continue;
        };
        // On 96 courses the whole wall closed no gap either, in minutes more.
        let is_open = |start: &StartEnding| {
            matches!(start.ending, SearchEnding::Failed(SearchFailure::GapOpen))
        };
        if explored.facts.starts.iter().all(is_open) {
            return undecided(explored, work);
        }
        if let Some(outcome) = report(scene, &explored, &at_rest, &mut work) {
            return outcome;
        }
    }
    // Where one way of evening out unequal blocks finds nothing, the next is tried; then with all
    // refinement, which programs of unequal blocks have at once.
    let mut ways: Vec<_> = (evenings(scene).iter())
        .map(|&evening| (evening, Refinement::Rough))
        .collect();
    if ways.len() == 1 {
        ways.push((Evening::CubeRoot, Refinement::Full));
    }
    let mut first = None;
    for way in ways {
        let explored = explore(Place::whole(scene), way, request, &at_rest, &mut work);
        match explored {
            Ok(explored) => match report(scene, &explored, &at_rest, &mut work) {
                Some(outcome) => return outcome,
                None => first = first.or(Some(Ok(explored))),
            },
            Err(Ending::Unbounded) => return without_bound(scene, request, &at_rest, work),
            Err(ending) => first = first.or(Some(Err(ending))),
        }
    }
    match first.expect("there is one way at least") {
        Ok(explored) => undecided(explored, work),
        Err(ending) => without_optimum(scene, &ending, at_rest, &mut work),
    }
}

/// The outcome where nothing collapses by associative friction. That says nothing of friction
/// without dilatancy, of which either forces without friction prove that the scene stands, or a
/// search may find states.
fn without_bound(
    scene: &Scene,
    request: &Request,
    at_rest: &[JointForce],
    mut work: Work,
) -> Outcome {
    if let Some(outcome) = stands_without_dilatancy(scene, at_rest, &mut work) {
        return outcome;
    }
    // That λ_A has no limit is said where forces prove it; else it is the solver's word.
    let proved = ray(scene, &mut work).is_some();
    let said = |fact: LimitFact| {
        if proved {
            fact
        } else {
            LimitFact::NoOptimum(SolverEnding::Unbounded)
        }
    };
    let place = Place::whole(scene);
    let mut search = Search::new(scene);
    let starts = Starts::without_associative(&mut search, place.normal(at_rest));
    let explored = follow(place, request, search, starts, &mut work);
    match report(scene, &explored, at_rest, &mut work) {
        Some(outcome) => Outcome {
            facts: vec![
                said(LimitFact::FoundWithoutBound).into(),
                explored.facts.into(),
            ],
            ..outcome
        },
        None => {
            let mut outcome = undecided(explored, work);
            let fact = said(LimitFact::NoneFoundWithoutBound);
            outcome.facts.insert(0, fact.into());
            outcome
        }
    }
}

fn undecided(explored: Explored, work: Work) -> Outcome {
    let unresolved = explored.unresolved.map(LimitFact::Unresolved);
    let facts = unresolved.map(LimitFact::into).into_iter();
    Outcome {
        work,
        facts: facts.chain([explored.facts.into()]).collect(),
        ..Outcome::of(Status::Undecided)
    }
}

/// Where a search takes place: a scene, or a part of it.
#[derive(Clone, Copy)]
struct Place<'a> {
    whole: &'a Scene,
    part: Option<&'a ScenePart>,
}

impl<'a> Place<'a> {
    fn whole(whole: &'a Scene) -> Self {
        Self { whole, part: None }
    }

    fn part(whole: &'a Scene, part: &'a ScenePart) -> Self {
        let part = Some(part);
        Self { whole, part }
    }

    /// The scene that is searched.
    fn searched(&self) -> &'a Scene {
        self.part.map_or(self.whole, |part| &part.scene)
    }

    /// N of the joints that are searched, over the weight of the scene that is searched, from forces
    /// of the whole scene.
    fn normal(&self, forces: &[JointForce]) -> Vec<f64> {
        let unit = self.whole.total_weight();
        let normal = totals(forces).into_iter().map(|n| n / unit);
        self.normal_of(&normal.collect::<Vec<_>>())
    }

    /// The same from N over the whole scene's weight.
    fn normal_of(&self, normal: &[f64]) -> Vec<f64> {
        let Some(part) = self.part else {
            return normal.to_vec();
        };
        let unit = self.whole.total_weight() / part.scene.total_weight();
        let joints = part.joints.iter();
        joints.map(|&joint| normal[joint] * unit).collect()
    }

    /// A state in the case's units, completed to one of the whole scene; `None` where its residuals
    /// prove nothing.
    fn state(&self, scale: Scale, state: &State, work: &mut Work) -> Option<CollapseState> {
        let mut state = in_units(scale, state);
        if let Some(part) = self.part {
            state.forces = part.complete(self.whole, state.lambda, &state.forces, work)?;
            state.mechanism = part.extend(self.whole, &state.mechanism);
        }
        is_proved(self.whole, &state).then_some(state)
    }

    /// The block that keeps a state of the scene that is searched from being proved.
    fn unresolved(&self, scale: Scale, state: &State) -> Option<BlockResidual> {
        let blocks = BlockResidual::of_state(self.searched(), &in_units(scale, state));
        (!blocks.is_small()).then_some(blocks)
    }

    /// Whether the branch's states are proved in the scene that is searched: what a program calls
    /// solved need not be. A state of a part that is lower than all others must be one of the whole
    /// scene too, as the search goes on from it.
    fn prove(
        &self,
        scale: Scale,
        branch: &mut Branch,
        lowest: f64,
        work: &mut Work,
    ) -> Result<(), SearchFailure> {
        let searched = Place::whole(self.searched());
        let is_proved = |place: &Place, state: &State, work: &mut Work| {
            place.state(scale, state, work).is_some()
        };
        if !is_proved(&searched, &branch.lowest, work) {
            return Err(SearchFailure::Unproved);
        }
        let is_lower = self.part.is_some() && branch.lowest.lambda < lowest;
        if is_lower && !is_proved(self, &branch.lowest, work) {
            return Err(SearchFailure::PartOnly);
        }
        if !is_proved(&searched, &branch.first, work) {
            branch.first = branch.lowest.clone();
        }
        Ok(())
    }
}

/// A state in the case's units.
fn in_units(scale: Scale, state: &State) -> CollapseState {
    CollapseState {
        lambda: state.lambda * scale.multiplier,
        forces: scale.forces(&state.forces),
        mechanism: scale.mechanism(&state.velocity),
    }
}

fn is_proved(scene: &Scene, state: &CollapseState) -> bool {
    let statics = StaticResidual::of(scene, &state.forces, state.lambda);
    let collapse = CollapseResidual::of(scene, &state.forces, &state.mechanism);
    let of_scene = statics.largest().max(collapse.largest());
    of_scene <= VERIFIED_RESIDUAL && BlockResidual::of_state(scene, state).is_small()
}

/// What a search has found.
struct Explored {
    /// Verified states of the whole scene, the lowest first.
    states: Vec<CollapseState>,
    facts: SearchFacts,
    /// Where a state was none because of one block: its residual.
    unresolved: Option<BlockResidual>,
}

/// Searches a part of the scene, or the whole of it.
fn explore(
    place: Place,
    program: (Evening, Refinement),
    request: &Request,
    at_rest: &[JointForce],
    work: &mut Work,
) -> Result<Explored, Ending> {
    let mut search = Search::evened(place.searched(), program.0, program.1);
    let associative = search.associative()?;
    let further = request.further.iter();
    let further = further.map(|normal| place.normal_of(normal)).collect();
    let at_rest = place.normal(at_rest);
    let starts = Starts::of(&mut search, associative, at_rest, further);
    Ok(follow(place, request, search, starts, work))
}

/// Follows one start after the other down to its lowest state.
fn follow(
    place: Place,
    request: &Request,
    mut search: Search,
    mut starts: Starts,
    work: &mut Work,
) -> Explored {
    let searched = place.searched();
    let asked = request.settings.interval.starts;
    let mut budget = Budget::of(searched.blocks().len(), searched.joints().len(), asked);
    let scale = search.program().scale();
    let mut found = Found::default();
    let mut endings = Vec::new();
    let mut unresolved = None;
    while budget.goes_on(endings.len(), search.work.programs, &found) {
        let lowest = found.lowest().map_or(f64::INFINITY, |state| state.lambda);
        let before = search.work.programs;
        let (start, branch) = starts.follow_next(&mut search, &found);
        if endings.is_empty() {
            budget.learn(search.work.programs - before);
            starts.dear = budget.dear;
        }
        let branch = branch.and_then(|mut branch| {
            let proof = place.prove(scale, &mut branch, lowest, work);
            if proof == Err(SearchFailure::Unproved) {
                let blocks = place.unresolved(scale, &branch.lowest);
                unresolved = unresolved.or(blocks);
            }
            proof.map(|()| branch)
        });
        let (ending, lambda) = match branch {
            Ok(branch) => {
                let lambda = branch.lowest.lambda;
                found.take(branch);
                let lowest = lambda * scale.multiplier;
                (SearchEnding::Verified { lowest }, lambda)
            }
            Err(failure) => (SearchEnding::Failed(failure), f64::INFINITY),
        };
        endings.push(StartEnding { start, ending });
        starts.go_on(lambda < lowest);
        if lambda * scale.multiplier <= request.stop_below {
            break;
        }
    }
    let states = whole_states(place, &mut search, &found, work);
    work.programs += search.work.programs;
    work.iterations += search.work.iterations;
    work.modelled = searched.blocks().len();
    let facts = SearchFacts {
        starts: endings,
        multiplier_unit: scale.multiplier,
    };
    Explored {
        states,
        facts,
        unresolved,
    }
}

/// How far above λ_A a state may lie, relative to that: what the program for λ_A leaves.
const ABOVE_BOUND: f64 = 1e-8;

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
    let Some((of_part, first)) = lowest.next() else {
        return Vec::new();
    };
    let mut states = vec![first];
    if place.part.is_none() {
        states.extend(lowest.map(|(_, state)| state));
    }
    let mut higher: Vec<State> = vec![search.highest_of(of_part)];
    higher.extend(found.highest().next().map(|state| search.highest_of(state)));
    higher.extend(found.highest().cloned());
    higher.sort_by(|a, b| b.lambda.total_cmp(&a.lambda));
    let known = states[states.len() - 1].lambda;
    // The gap that a state may leave could lift it above λ_A where that is small.
    let bound = search.associative.unwrap_or(f64::INFINITY);
    let bound = bound + ABOVE_BOUND * bound.abs();
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

/// The outcome, or `None` where no start found a state.
fn report(
    scene: &Scene,
    explored: &Explored,
    at_rest: &[JointForce],
    work: &mut Work,
) -> Option<Outcome> {
    let states = explored.states.clone();
    let (low, high) = (states.first()?.clone(), states.last()?);
    let found = LimitFact::FoundNoBounds {
        frictionless: outer::frictionless(scene, at_rest, work),
    };
    Some(Outcome {
        bracket: Some(Bracket {
            lower: low.lambda,
            upper: high.lambda,
        }),
        crack: crack_slope(scene, &low.mechanism, VELOCITY_THRESHOLDS),
        mechanism: Some(low.mechanism),
        forces: Some(low.forces),
        states,
        work: *work,
        facts: vec![found.into(), explored.facts.clone().into()],
        ..Outcome::of(Status::Verified)
    })
}
