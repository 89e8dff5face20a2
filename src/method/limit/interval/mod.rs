//! The verified interval of non-associative friction (zero dilatancy).
//!
//! A non-associative collapse multiplier is not one number: for a given mechanism the admissible λ
//! form an interval, and there are several mechanisms. This method reports the lowest and the
//! highest λ for which it *found* a collapse state, each with forces and mechanism that the judge
//! verifies. They are no bounds: λ_A bounds all of them from above, no useful rigorous lower bound
//! is known.

mod descent;
mod noise;
mod outer;
mod search;
mod starts;

use super::ending::Ending;
use super::own_weight::{own_weight, ray, stands_without_dilatancy, without_optimum};
use super::reduction::{self, ScenePart};
use super::scale::Scale;
use crate::answer::{
    BlockResidual, Bracket, CollapseResidual, CollapseState, JointForce, LimitFact, Outcome,
    SearchEnding, SearchFacts, SearchFailure, SearchStart, SolverEnding, StartEnding,
    StaticResidual, Status, VELOCITY_THRESHOLDS, VERIFIED_RESIDUAL, Work, crack_slope,
};
use crate::method::{Method, Settings};
use crate::scene::Scene;
use descent::descend;
use search::{Approach, Search, State, totals};
use starts::Start;

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
        let Ok(ends) = search(scene, Some(&part), request, &mut work) else {
            continue;
        };
        // On 96 courses the whole wall closed no gap either, in minutes more.
        let is_open = |end: &End| matches!(end.states, Err(SearchFailure::GapOpen));
        if ends.iter().all(is_open) {
            return undecided(&ends, work);
        }
        if let Some(outcome) = report(scene, &ends, &at_rest, &mut work) {
            return outcome;
        }
    }
    match search(scene, None, request, &mut work) {
        Ok(ends) => {
            report(scene, &ends, &at_rest, &mut work).unwrap_or_else(|| undecided(&ends, work))
        }
        Err(Ending::Unbounded) => without_bound(scene, request, &at_rest, work),
        Err(ending) => without_optimum(scene, &ending, at_rest, &mut work),
    }
}

/// Starts of a search where λ_A has no limit, at least: it begins under the own weight, far from
/// where it ends.
const STARTS_WITHOUT_BOUND: usize = 8;

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
    let mut search = Search::new(scene);
    let unit = scene.total_weight();
    let normal: Vec<f64> = (totals(at_rest).iter()).map(|n| n / unit).collect();
    let count = request.settings.interval.starts.max(STARTS_WITHOUT_BOUND);
    let starts = starts::starts_at_rest(&mut search, &normal, count);
    let ends = follow(scene, None, request, &mut search, starts, &mut work);
    match report(scene, &ends, at_rest, &mut work) {
        Some(outcome) => Outcome {
            facts: vec![
                said(LimitFact::FoundWithoutBound).into(),
                facts(&ends).into(),
            ],
            ..outcome
        },
        None => {
            let mut outcome = undecided(&ends, work);
            let fact = said(LimitFact::NoneFoundWithoutBound);
            outcome.facts.insert(0, fact.into());
            outcome
        }
    }
}

fn undecided(ends: &[End], work: Work) -> Outcome {
    let unresolved = ends.iter().find_map(|end| end.unresolved);
    let unresolved = unresolved.map(|blocks| LimitFact::Unresolved(blocks).into());
    Outcome {
        work,
        facts: unresolved.into_iter().chain([facts(ends).into()]).collect(),
        ..Outcome::of(Status::Undecided)
    }
}

/// Where one start ended.
struct End {
    start: SearchStart,
    /// States of the whole scene.
    states: Result<States, SearchFailure>,
    /// Where the lowest one is none because of one block: its residual.
    unresolved: Option<BlockResidual>,
}

impl End {
    /// Drops what leaves residuals too large for a proof: where λ is far beyond 1, or blocks are very
    /// unequal, the same digits are larger residuals.
    fn keep_proved(&mut self, scene: &Scene) {
        let Ok(states) = &mut self.states else {
            return;
        };
        let is_proved = |state: &CollapseState| {
            let statics = StaticResidual::of(scene, &state.forces, state.lambda);
            let collapse = CollapseResidual::of(scene, &state.forces, &state.mechanism);
            let of_scene = statics.largest().max(collapse.largest());
            of_scene <= VERIFIED_RESIDUAL && BlockResidual::of_state(scene, state).is_small()
        };
        states.same_mechanism = states.same_mechanism.take().filter(is_proved);
        states.first = states.first.take().filter(is_proved);
        if !is_proved(&states.lowest) {
            let blocks = BlockResidual::of_state(scene, &states.lowest);
            self.unresolved = (!blocks.is_small()).then_some(blocks);
            self.states = Err(SearchFailure::Unproved);
        }
    }
}

/// What one start found, of the whole scene.
struct States {
    /// The lowest state on its way.
    lowest: CollapseState,
    /// The highest state of the same mechanism, where that is one of the whole scene.
    same_mechanism: Option<CollapseState>,
    /// The first state, where that is one of the whole scene.
    first: Option<CollapseState>,
}

/// Follows every start on a part of the scene, or on the whole of it.
fn search(
    scene: &Scene,
    part: Option<&ScenePart>,
    request: &Request,
    work: &mut Work,
) -> Result<Vec<End>, Ending> {
    let searched = part.map_or(scene, |part| &part.scene);
    let mut search = Search::new(searched);
    let starts = starts::starts(searched, &mut search, request.settings.interval.starts)?;
    Ok(follow(scene, part, request, &mut search, starts, work))
}

/// Follows these starts, and those that the request adds, down to their lowest states.
fn follow(
    scene: &Scene,
    part: Option<&ScenePart>,
    request: &Request,
    search: &mut Search,
    starts: Vec<Start>,
    work: &mut Work,
) -> Vec<End> {
    let mut ends = Vec::new();
    let further = request
        .further
        .iter()
        .map(|normal| neighbour(scene, part, normal));
    for start in starts.into_iter().chain(further) {
        let kind = start.kind;
        let settings = request.settings;
        let scale = search.program().scale();
        let stop_below = request.stop_below / scale.multiplier;
        let branch = descend(search, start, settings.interval.starts, stop_below);
        let states = branch.and_then(|branch| {
            let mut whole = |state| collapse_state(scene, part, scale, state, work);
            Ok(States {
                lowest: whole(&branch.lowest).ok_or(SearchFailure::PartOnly)?,
                same_mechanism: whole(&branch.highest),
                first: whole(&branch.first),
            })
        });
        let mut end = End {
            start: kind,
            states,
            unresolved: None,
        };
        end.keep_proved(scene);
        let reached = |states: &States| states.lowest.lambda <= request.stop_below;
        let stop = end.states.as_ref().is_ok_and(reached);
        ends.push(end);
        if stop {
            break;
        }
    }
    work.programs += search.work.programs;
    work.iterations += search.work.iterations;
    work.modelled = part.map_or(scene, |part| &part.scene).blocks().len();
    ends
}

/// A start from normal forces of the whole scene, over its total weight.
fn neighbour(scene: &Scene, part: Option<&ScenePart>, normal: &[f64]) -> Start {
    let normal = match part {
        None => normal.to_vec(),
        Some(part) => {
            let unit = scene.total_weight() / part.scene.total_weight();
            let joints = part.joints.iter();
            joints.map(|&joint| normal[joint] * unit).collect()
        }
    };
    Start {
        kind: SearchStart::Neighbour,
        normal,
        approach: Approach::Quick,
    }
}

/// A state in the case's units, completed to one of the whole scene.
fn collapse_state(
    scene: &Scene,
    part: Option<&ScenePart>,
    scale: Scale,
    state: &State,
    work: &mut Work,
) -> Option<CollapseState> {
    let lambda = state.lambda * scale.multiplier;
    let forces = scale.forces(&state.forces);
    let mechanism = scale.mechanism(&state.velocity);
    let (forces, mechanism) = match part {
        None => (forces, mechanism),
        Some(part) => {
            let forces = part.complete(scene, lambda, &forces, work)?;
            let statics = StaticResidual::of(scene, &forces, lambda).largest();
            let proved = statics <= VERIFIED_RESIDUAL;
            proved.then(|| (forces, part.extend(scene, &mechanism)))?
        }
    };
    Some(CollapseState {
        lambda,
        forces,
        mechanism,
    })
}

/// The outcome, or `None` where no start found a state.
fn report(scene: &Scene, ends: &[End], at_rest: &[JointForce], work: &mut Work) -> Option<Outcome> {
    let mut states: Vec<CollapseState> = Vec::new();
    for found in ends.iter().filter_map(|end| end.states.as_ref().ok()) {
        states.push(found.lowest.clone());
        states.extend(found.same_mechanism.iter().chain(&found.first).cloned());
    }
    states.sort_by(|a, b| a.lambda.total_cmp(&b.lambda));
    let (low, high) = (states.first()?, states.last()?);
    let found = LimitFact::FoundNoBounds {
        frictionless: outer::frictionless(scene, at_rest, work),
    };
    Some(Outcome {
        bracket: Some(Bracket {
            lower: low.lambda,
            upper: high.lambda,
        }),
        crack: crack_slope(scene, &low.mechanism, VELOCITY_THRESHOLDS),
        mechanism: Some(low.mechanism.clone()),
        forces: Some(low.forces.clone()),
        states,
        work: *work,
        facts: vec![found.into(), facts(ends).into()],
        ..Outcome::of(Status::Verified)
    })
}

/// Which start ended where.
fn facts(ends: &[End]) -> SearchFacts {
    let starts = ends.iter().map(|end| StartEnding {
        start: end.start,
        ending: match &end.states {
            Ok(states) => SearchEnding::Verified {
                lowest: states.lowest.lambda,
                highest: states.same_mechanism.as_ref().map(|high| high.lambda),
            },
            Err(failure) => SearchEnding::Failed(*failure),
        },
    });
    SearchFacts {
        starts: starts.collect(),
    }
}
