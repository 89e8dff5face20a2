//! The verified interval of non-associative friction (zero dilatancy).
//!
//! A non-associative collapse multiplier is not one number: for a given mechanism the admissible λ
//! form an interval, and there are several mechanisms. This method reports the lowest and the
//! highest λ for which it *found* a collapse state, each with forces and mechanism that the judge
//! verifies. They are no bounds: λ_A bounds all of them from above, and the method `bound` proves a
//! lower bound of small scenes. Where λ_A has no limit and none is found, a lifted program of that method
//! is asked whether there can be any, if it is cheap.

mod descent;
mod explore;
mod found;
mod numerics;
mod outer;
mod parameters;
mod place;
mod search;
mod starts;

use super::bound::standing;
use super::ending::Ending;
use super::own_weight::{own_weight, ray, stands_without_dilatancy, without_optimum};
use super::reduction;
use crate::answer::{
    BoundFact, Evidence, Fact, LimitFact, Outcome, SearchFailure, SolverEnding, Status, Work,
};
use crate::mechanics::JointForce;
use crate::method::{Method, Settings};
use crate::scene::Scene;
use explore::{Explored, Request, explore, follow};
use numerics::{Numerics, Refinement};
use place::Place;
use search::Search;
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
    /// As [`Method::solve`], starting also from normal forces of `neighbours`, states of scenes that
    /// differ little: N of every joint over the scene's total weight. They come beside the starts
    /// that the settings ask for.
    pub fn solve_from(
        &self,
        scene: &Scene,
        settings: &Settings,
        neighbours: &[Vec<f64>],
    ) -> Outcome {
        let request = Request {
            neighbours,
            ..Request::of(settings)
        };
        solve(scene, &request)
    }
}

/// The interval; a search that stops at the first state below `stop_below`.
pub(crate) fn lowest(scene: &Scene, settings: &Settings, stop_below: f64) -> Outcome {
    let request = Request {
        stop_below,
        ..Request::of(settings)
    };
    solve(scene, &request)
}

fn solve(scene: &Scene, request: &Request) -> Outcome {
    let mut work = Work::default();
    searched(scene, request, &mut work).after(work)
}

fn searched(scene: &Scene, request: &Request, work: &mut Work) -> Outcome {
    let at_rest = match own_weight(scene, work) {
        Ok(forces) => forces,
        Err(outcome) => return *outcome,
    };
    let reduce = request.settings.programs.reduction;
    let engine = request.settings.programs.engine;
    let mut unclosed = None;
    for part in reduction::parts(scene).into_iter().filter(|_| reduce) {
        let place = Place::part(scene, &part);
        let Ok(explored) = explore(place, Numerics::first(engine), request, &at_rest, work) else {
            continue;
        };
        if let Some(outcome) = report(scene, &explored, &at_rest, work) {
            return outcome;
        }
        let mut ends = explored.facts.starts.iter();
        let closes_none = ends.all(|end| *end == Err(SearchFailure::GapOpen));
        unclosed = closes_none.then_some(explored);
    }
    // The whole wall is not searched where no part closes a gap: on 96 courses its gap ended at 1.4e-6 as
    // that of the part did, after 490 s of CPU instead of 44 s (measured).
    if let Some(explored) = unclosed {
        return undecided(explored);
    }
    let mut first = None;
    for numerics in Numerics::of(scene, engine) {
        let explored = explore(Place::whole(scene), numerics, request, &at_rest, work);
        match explored {
            Ok(explored) => match report(scene, &explored, &at_rest, work) {
                Some(outcome) => return outcome,
                None => first = first.or(Some(Ok(explored))),
            },
            Err(Ending::Unbounded) => return without_bound(scene, request, &at_rest, work),
            Err(ending) => first = first.or(Some(Err(ending))),
        }
    }
    match first.expect("there is one way at least") {
        Ok(explored) => undecided(explored),
        Err(ending) => without_optimum(scene, &ending, at_rest, work),
    }
}

/// The outcome where nothing collapses by associative friction. That says nothing of friction
/// without dilatancy, of which either forces without friction prove that the scene stands, or a
/// search may find states.
fn without_bound(
    scene: &Scene,
    request: &Request,
    at_rest: &[JointForce],
    work: &mut Work,
) -> Outcome {
    if let Some(outcome) = stands_without_dilatancy(scene, at_rest, work) {
        return outcome;
    }
    // That λ_A has no limit is said where forces prove it; else it is the solver's word.
    let ray = ray(scene, work);
    let is_proved = ray.is_some();
    let said = |fact: LimitFact| {
        if is_proved {
            fact
        } else {
            LimitFact::NoOptimum(SolverEnding::Unbounded)
        }
    };
    let place = Place::whole(scene);
    let numerics = Numerics {
        refinement: Refinement::Full,
        ..Numerics::first(request.settings.programs.engine)
    };
    let mut search = Search::new(scene, numerics, request.tuned);
    let starts = Starts::without_associative(&mut search, place.normal(at_rest));
    let explored = follow(place, request, search, starts, work);
    match report(scene, &explored, at_rest, work) {
        Some(outcome) => Outcome {
            facts: vec![
                said(LimitFact::FoundWithoutBound).into(),
                explored.facts.into(),
            ],
            ..outcome
        },
        None => {
            let none = said(LimitFact::NoneFoundWithoutBound);
            let asked = ray.map_or(Err(None), |ray| {
                let settings = request.settings;
                standing::stands(scene, settings, STANDING_STEP, (at_rest, ray), work)
            });
            asked.unwrap_or_else(|why| {
                // What the lift would need is told by the method that is made of lifts.
                let why =
                    why.filter(|why| matches!(why, BoundFact::NoOpening | BoundFact::MayCollapse));
                let facts = [Some(Fact::from(none)), why.map(Fact::from)];
                let mut outcome = undecided(explored);
                outcome.facts.splice(0..0, facts.into_iter().flatten());
                outcome
            })
        }
    }
}

/// Products of numbers that a step of the lifted program takes at most that is asked, where no state is found,
/// whether there can be any. Walls of up to some 14 blocks in contact take so many, and the program about a second of
/// CPU, as the search does (of 14 and 27 blocks it took 0.6 s for 1e9 products a step).
const STANDING_STEP: f64 = 2e9;

fn undecided(explored: Explored) -> Outcome {
    let unresolved = explored.unresolved.map(LimitFact::Unresolved);
    let facts = unresolved.map(LimitFact::into).into_iter();
    Outcome {
        facts: facts.chain([explored.facts.into()]).collect(),
        ..Outcome::of(Status::Undecided)
    }
}

/// The outcome, or `None` where no start found a state.
fn report(
    scene: &Scene,
    explored: &Explored,
    at_rest: &[JointForce],
    work: &mut Work,
) -> Option<Outcome> {
    let states = explored.states.clone();
    let lowest = states.first()?.lambda;
    let found = LimitFact::FoundNoBounds {
        frictionless: outer::frictionless(scene, at_rest, work),
    };
    let at_rest = (lowest == 0.0).then_some(LimitFact::AtRest.into());
    let facts = at_rest
        .into_iter()
        .chain([found.into(), explored.facts.clone().into()]);
    Some(Outcome {
        facts: facts.collect(),
        evidence: Evidence::States { states },
        ..Outcome::of(Status::Verified)
    })
}
