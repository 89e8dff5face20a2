//! The whole search: settle, then raise λ from rest to rest until the smallest step collapses.

use super::fall::{Fall, fall};
use super::hint::{Hint, finest_increment};
use super::hold::{Held, Hold, Onset};
use super::measure::{displacement, live_work};
use super::model::{GRID, Model};
use super::parameters::Parameters;
use super::physics::{BodyState, Contact, Physics};
use crate::answer::{PushoverFact, magnitude};

/// A bracket as it was observed, and what the self-checks need to know about it.
pub struct Observation {
    /// Last λ* at rest, and the first that collapsed from there, in grid units.
    pub loads: [u64; 2],
    /// Blocks settled under their weight.
    pub settled: RestState,
    /// Blocks at the last load at rest.
    pub rest: RestState,
    /// Blocks at the onset of the collapse; where it was not seen in time, at the last load at rest.
    pub onset: Vec<BodyState>,
    /// Blocks when the collapse was called.
    pub collapsed: Vec<BodyState>,
    /// What happened then, where frames are asked for.
    pub fall: Option<Fall>,
    /// Part of the work of the push that went into motion at the onset of the fall, beyond what comes of the step
    /// and of lever arms that have changed by then. None does where the scene has but reached a collapse state.
    pub jump: f64,
}

/// Blocks and contacts at rest.
pub struct RestState {
    /// Blocks.
    pub states: Vec<BodyState>,
    /// Contacts.
    pub contacts: Vec<Contact>,
}

impl RestState {
    fn now(physics: &Physics) -> Self {
        Self {
            states: physics.states(),
            contacts: physics.contacts(),
        }
    }
}

/// How a search ended.
pub enum SearchEnd {
    /// With a bracket.
    Bracketed(Box<Observation>),
    /// Without one; why.
    Undecided(PushoverFact),
    /// Under the own weight alone; the evidence.
    Falls(PushoverFact),
}

/// Raises λ from rest to rest: by doubling until a step runs away, then to where the runaways
/// extrapolate the limit. That is only a hint of where to look: the bracket is a proved rest and a
/// collapse from it by a step no longer than the tolerance. A longer step overshoots, so its
/// collapse says no more than that the limit is near.
///
/// `expected` is where a pushover with other parameters saw the collapse: the search begins there.
///
/// A settled scene that is `refused`, with the reason, is not pushed. `slip` gives the largest slip of
/// a joint between two states; a rest with more of it than the parameters allow is a collapse too.
pub fn search(
    physics: &mut Physics,
    model: &Model,
    parameters: &Parameters,
    expected: Option<[u64; 2]>,
    refused: impl FnOnce(&RestState) -> Option<PushoverFact>,
    slip: impl Fn(&[BodyState], &[BodyState]) -> f64,
) -> SearchEnd {
    let mut hold = Hold::new(model, parameters);
    let settled = match settle(physics, &mut hold, model, parameters, refused) {
        Ok(settled) => settled,
        Err(end) => return end,
    };
    let (mut rest, mut seen) = (physics.checkpoint(), RestState::now(physics));
    let mut hint = Hint::new(parameters, expected);
    let (mut lower, mut unclear, mut slow_in_a_row): (u64, bool, usize) = (0, false, 0);
    let left_its_place = |states: &[BodyState]| {
        slip(&settled.states, states) > parameters.slip
            || displacement(model, &settled.states, states) > parameters.slide
    };
    loop {
        let finest = finest_increment(hint.near(lower), parameters.tolerance);
        let target = match unclear {
            true => lower + 2 * finest,
            false => hint.next(lower, finest),
        };
        let last = unclear || target - lower <= finest;
        if let Some(fact) = out_of_reach(physics, model, parameters, [lower, target]) {
            return SearchEnd::Undecided(fact);
        }
        let held = match hold.step(physics, [lower, target], finest, last) {
            Held::Rest if left_its_place(&physics.states()) => Held::Collapse { acceleration: 0.0 },
            held => held,
        };
        match held {
            Held::Rest => {
                (rest, seen) = (physics.checkpoint(), RestState::now(physics));
                (lower, unclear, slow_in_a_row) = (target, false, 0);
                hint.rested(lower, finest);
                continue;
            }
            Held::Collapse { .. } if last => {
                let onset = hold.onset.as_ref();
                // A fall that was half over when it was seen is read from the last rest.
                let moved = |onset: &Onset| displacement(model, &seen.states, &onset.states);
                let early = |onset: &&Onset| moved(onset) < parameters.collapse / 2.0;
                let begun = onset.filter(early).map(|onset| &onset.states);
                return SearchEnd::Bracketed(Box::new(Observation {
                    loads: [lower, target],
                    jump: onset.map_or(0.0, |onset| jump(model, &seen, onset, [lower, target])),
                    onset: begun.unwrap_or(&seen.states).clone(),
                    collapsed: physics.states(),
                    fall: (parameters.frames > 0)
                        .then(|| fall(physics, model, target, &settled.states, parameters.frames)),
                    settled,
                    rest: seen,
                }));
            }
            Held::Collapse { acceleration } => hint.ran_away(target, acceleration),
            Held::Unclear if last && !unclear => {
                // Perhaps too close to the limit to tell; a step twice as long may still tell.
                unclear = true;
                hint.ran_away(target, 0.0);
            }
            Held::Unclear => {
                slow_in_a_row += 1;
                if unclear || slow_in_a_row > parameters.slow_steps[usize::from(lower > 0)] {
                    let lambda = physics.multiplier * model.multiplier;
                    return SearchEnd::Undecided(PushoverFact::Unclear { lambda });
                }
                hint.was_slow(target);
            }
        }
        physics.restore(&rest);
    }
}

/// Part of the work of the push that went into motion from rest, beyond what the step and changed lever arms give;
/// nothing where the push does no work.
fn jump(model: &Model, rest: &RestState, onset: &Onset, loads: [u64; 2]) -> f64 {
    let [lower, upper] = loads.map(|load| load as f64 / GRID);
    let push = magnitude(upper, 1.0);
    let work = push * live_work(model, &rest.states, &onset.states);
    if work <= 0.0 {
        return 0.0;
    }
    let step = (upper - lower) / push;
    // A lever arm that changes by a part of the extent changes λ* by as much: of a small λ* that is a large part.
    let moved = displacement(model, &rest.states, &onset.states);
    let arms = moved / (model.extent * push.min(1.0));
    onset.energy / work - step - arms
}

/// Why a search that has come to rest at the first of two loads does not try the other.
fn out_of_reach(
    physics: &Physics,
    model: &Model,
    parameters: &Parameters,
    [lower, target]: [u64; 2],
) -> Option<PushoverFact> {
    let lambda = model.lambda(lower);
    if physics.steps > parameters.budget {
        return Some(PushoverFact::OutOfSteps { lambda });
    }
    (target as f64 > parameters.largest * GRID).then_some(PushoverFact::StillStands { lambda })
}

/// The scene at rest under its weight, with its joints closed; how the search ends where it does not rest or is
/// refused. It falls, unless it stands with a push against its live loads that is as small as the error asked for.
fn settle(
    physics: &mut Physics,
    hold: &mut Hold,
    model: &Model,
    parameters: &Parameters,
    refused: impl FnOnce(&RestState) -> Option<PushoverFact>,
) -> Result<RestState, SearchEnd> {
    let laid = physics.checkpoint();
    match hold.settle(physics, 0.0) {
        Held::Rest => {
            let settled = RestState::now(physics);
            physics.close_joints();
            return match refused(&settled) {
                Some(fact) => Err(SearchEnd::Undecided(fact)),
                None => Ok(settled),
            };
        }
        Held::Collapse { .. } => {}
        Held::Unclear => {
            let time = parameters.patience;
            return Err(SearchEnd::Undecided(PushoverFact::NotSettled { time }));
        }
    }
    let (distance, time) = (parameters.fall, hold.elapsed);
    let resolution = parameters.stated_error;
    physics.restore(&laid);
    Err(match hold.settle(physics, resolution) {
        Held::Rest => SearchEnd::Undecided(PushoverFact::NearZero {
            resolution: resolution * model.multiplier,
        }),
        _ => SearchEnd::Falls(PushoverFact::Fell { distance, time }),
    })
}
