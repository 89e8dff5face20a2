//! The verified interval of non-associative friction (zero dilatancy).
//!
//! A non-associative collapse multiplier is not one number: for a given mechanism the admissible λ
//! form an interval, and there are several mechanisms. This method reports the lowest and the
//! highest λ for which it *found* a collapse state, each with forces and mechanism that the judge
//! verifies. They are no bounds: λ_A bounds all of them from above, no useful rigorous lower bound
//! is known.

mod outer;
mod search;
mod starts;

use super::program::Ending;
use super::reduction::{self, Part};
use super::scale::Scale;
use super::standing::{own_weight, without_optimum};
use crate::answer::{
    Bracket, CollapseState, JointForce, Outcome, Status, VELOCITY_THRESHOLDS, Work, crack_slope,
};
use crate::method::{Method, Settings};
use crate::scene::Scene;
use search::{Failure, Search, State};
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
        let aim = Aim {
            settings,
            enough: f64::NEG_INFINITY,
            further,
        };
        aimed(scene, &aim)
    }
}

/// The interval; a search that may stop at the first state below `enough`.
pub(crate) fn lowest(scene: &Scene, settings: &Settings, enough: f64) -> Outcome {
    let aim = Aim {
        settings,
        enough,
        further: &[],
    };
    aimed(scene, &aim)
}

/// What a search is asked for.
struct Aim<'a> {
    settings: &'a Settings,
    /// The first state below this λ is enough.
    enough: f64,
    /// Normal forces to start from after the search's own starts.
    further: &'a [Vec<f64>],
}

fn aimed(scene: &Scene, aim: &Aim) -> Outcome {
    let mut work = Work::default();
    let standing = match own_weight(scene, &mut work) {
        Ok(forces) => forces,
        Err(outcome) => return *outcome,
    };
    let reduce = aim.settings.programs.reduction;
    for part in reduction::parts(scene).into_iter().filter(|_| reduce) {
        let Ok(ends) = search(scene, Some(&part), aim, &mut work) else {
            continue;
        };
        // On 96 courses the whole wall closed no gap either, in minutes more.
        let is_open = |end: &End| matches!(end.states, Err(Failure::Open));
        if ends.iter().all(is_open) {
            return undecided(&ends, work);
        }
        if let Some(outcome) = report(scene, &ends, &standing, &mut work) {
            return outcome;
        }
    }
    match search(scene, None, aim, &mut work) {
        Ok(ends) => {
            report(scene, &ends, &standing, &mut work).unwrap_or_else(|| undecided(&ends, work))
        }
        Err(ending) => without_optimum(scene, &ending, standing, &mut work),
    }
}

fn undecided(ends: &[End], work: Work) -> Outcome {
    Outcome {
        work,
        ..Outcome::without_number(Status::Undecided, endings(ends))
    }
}

/// Where one start ended.
struct End {
    name: &'static str,
    /// States of the whole scene.
    states: Result<Found, Failure>,
}

/// What one start found.
struct Found {
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
    part: Option<&Part>,
    aim: &Aim,
    work: &mut Work,
) -> Result<Vec<End>, Ending> {
    let searched = part.map_or(scene, |part| &part.scene);
    let mut search = Search::new(searched);
    let mut ends = Vec::new();
    let own = starts::starts(searched, &mut search, aim.settings.interval.starts)?;
    let further = aim
        .further
        .iter()
        .map(|normal| neighbour(scene, part, normal));
    for start in own.into_iter().chain(further) {
        let name = start.name;
        let found = follow(&mut search, start, aim.settings.interval.starts, aim.enough);
        let scale = search.program().scale();
        let states = found.and_then(|way| {
            let mut whole = |state| collapse_state(scene, part, scale, state, work);
            Ok(Found {
                lowest: whole(&way.lowest).ok_or(Failure::PartOnly)?,
                same_mechanism: whole(&way.highest),
                first: whole(&way.first),
            })
        });
        let reached = |found: &Found| found.lowest.lambda <= aim.enough;
        let is_enough = states.as_ref().is_ok_and(reached);
        ends.push(End { name, states });
        if is_enough {
            break;
        }
    }
    work.programs += search.work.programs;
    work.iterations += search.work.iterations;
    work.modelled = searched.blocks().len();
    Ok(ends)
}

/// A start from normal forces of the whole scene, over its total weight.
fn neighbour(scene: &Scene, part: Option<&Part>, normal: &[f64]) -> Start {
    let normal = match part {
        None => normal.to_vec(),
        Some(part) => {
            let unit = scene.total_weight() / part.scene.total_weight();
            let joints = part.joints.iter();
            joints.map(|&joint| normal[joint] * unit).collect()
        }
    };
    Start {
        name: "neighbour",
        normal,
    }
}

/// A state in the case's units, completed to one of the whole scene.
fn collapse_state(
    scene: &Scene,
    part: Option<&Part>,
    scale: Scale,
    state: &State,
    work: &mut Work,
) -> Option<CollapseState> {
    let lambda = state.lambda;
    let forces = scale.forces(&state.forces);
    let mechanism = scale.mechanism(&state.velocity);
    let (forces, mechanism) = match part {
        None => (forces, mechanism),
        Some(part) => (
            part.complete(scene, lambda, &forces, work)?,
            part.lift(scene, &mechanism),
        ),
    };
    Some(CollapseState {
        lambda,
        forces,
        mechanism,
    })
}

/// Smallest relative fall of λ that counts as one.
const FALL: f64 = 1e-7;

/// Starts beyond which more of them no longer mean more patience with each.
const PATIENT: usize = 12;

/// From a start to a state, then down: the lowest state of each mechanism, and on to a neighbour of
/// that mechanism until λ stops falling or is low enough. One start asks for a first state only; with more of them
/// each one is followed the more patiently.
fn follow(search: &mut Search, start: Start, starts: usize, enough: f64) -> Result<Way, Failure> {
    let first = search.close(start.normal)?;
    let mut lowest = search.extreme_of(&first, -1.0);
    let patience = starts.min(PATIENT);
    let (mut idle, mut step) = (0, 0);
    while idle + 1 < patience && step < 6 * patience && lowest.lambda > enough {
        match search.neighbour(&lowest, step) {
            Some(next) if next.lambda < lowest.lambda * (1.0 - FALL) => {
                lowest = next;
                idle = 0;
            }
            _ => idle += 1,
        }
        step += 1;
    }
    Ok(Way {
        highest: search.extreme_of(&lowest, 1.0),
        first,
        lowest,
    })
}

/// The states that a start leads to, of the scene that is searched.
struct Way {
    first: State,
    lowest: State,
    /// The highest one of the lowest one's mechanism.
    highest: State,
}

/// The outcome, or `None` where no start found a state.
fn report(
    scene: &Scene,
    ends: &[End],
    standing: &[JointForce],
    work: &mut Work,
) -> Option<Outcome> {
    let mut states: Vec<CollapseState> = Vec::new();
    for found in ends.iter().filter_map(|end| end.states.as_ref().ok()) {
        states.push(found.lowest.clone());
        states.extend(found.same_mechanism.iter().chain(&found.first).cloned());
    }
    states.sort_by(|a, b| a.lambda.total_cmp(&b.lambda));
    let (low, high) = (states.first()?, states.last()?);
    let outer = match outer::frictionless(scene, standing, work) {
        Some(lambda) => format!("rigorous are {lambda:.5} and associative"),
        None => "rigorous is associative alone".to_owned(),
    };
    let reason = format!("found, no bounds ({outer}); {}", endings(ends));
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
        ..Outcome::without_number(Status::Verified, reason)
    })
}

/// Starts that are told one by one.
const TOLD: usize = 8;

/// Which start ended where: λ of its lowest state, and how far up that mechanism goes; of many
/// starts the first ones, then how many of the others ended how.
fn endings(ends: &[End]) -> String {
    let (first, others) = ends.split_at(ends.len().min(TOLD));
    let texts = first.iter().map(|end| match &end.states {
        Ok(found) => {
            let range = found.same_mechanism.as_ref();
            let range = range.map_or(String::new(), |high| format!(" to {:.5}", high.lambda));
            format!("{}: {:.5}{range}", end.name, found.lowest.lambda)
        }
        Err(failure) => format!("{}: {}", end.name, failure.in_words()),
    });
    let mut texts: Vec<String> = texts.collect();
    let verified = others.iter().filter(|end| end.states.is_ok()).count();
    if !others.is_empty() {
        texts.push(format!("and {} more: {verified} verified", others.len()));
    }
    for failure in Failure::ALL {
        let failed = |end: &&End| end.states.as_ref().err() == Some(&failure);
        match others.iter().filter(failed).count() {
            0 => {}
            count => texts.push(format!("{count} {}", failure.in_words())),
        }
    }
    texts.join(", ")
}
