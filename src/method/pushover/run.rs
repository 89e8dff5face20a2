//! One pushover of one scene: search, self-checks, outcome.

use super::checks::{self, AtRest};
use super::engine::{BodyState, Engine};
use super::freeze::{Freeze, beyond_stagger};
use super::measure;
use super::model::Model;
use super::parameters::{GRID, Parameters};
use super::search::{Observation, SearchEnd, search};
use crate::answer::{
    Bracket, Mechanism, Motion, Outcome, PushoverFact, SelfCheck, Status, Work, crack_slope_by_gap,
};
use crate::method::PushoverSettings;
use crate::scene::{Scene, Vector};

/// Natural frequency of the contacts times the substep beyond which walls jitter, with a margin
/// for rounding.
const MOST_STIFF: f64 = 0.2501;

/// The pushover with its parameters, which follow from settings and scene, changed.
pub fn solve_with(
    scene: &Scene,
    settings: &PushoverSettings,
    change: impl Fn(Parameters) -> Parameters,
) -> Outcome {
    let parameters = |model: &Model| change(Parameters::new(model, settings));
    let Some(freeze) = beyond_stagger(scene) else {
        return run(scene, &parameters, &Freeze::default()).0;
    };
    let (outcome, moved) = run(scene, &parameters, &freeze);
    if !moved {
        return outcome;
    }
    let spent = outcome.work.block_steps;
    let mut outcome = run(scene, &parameters, &Freeze::default()).0;
    outcome.work.block_steps += spent;
    outcome
}

/// One search with a part of the scene held fixed, and whether that part might have moved.
fn run(
    scene: &Scene,
    parameters: &impl Fn(&Model) -> Parameters,
    freeze: &Freeze,
) -> (Outcome, bool) {
    let undecided = |fact: PushoverFact| Outcome::without_number(Status::Undecided, fact);
    let model = match Model::new(scene, &freeze.frozen) {
        Ok(model) => model,
        Err(fact) => return (undecided(fact), false),
    };
    let parameters = parameters(&model);
    if parameters.contact_frequency * parameters.substep > MOST_STIFF {
        return (undecided(PushoverFact::TooStiff), false);
    }
    let Some(mut engine) = Engine::new(&model, &parameters) else {
        return (undecided(PushoverFact::ShapeRefused), false);
    };
    let laid = engine.states();
    engine.step();
    let fixed = |side| freeze.is_fixed(side);
    let sees = checks::sees_joints(scene.joints(), &engine.contacts(), fixed);
    if !sees.passed() {
        return (undecided(PushoverFact::Checked(sees)), false);
    }
    let slip = |from: &[BodyState], to: &[BodyState]| {
        let rates = mechanism(scene, &model, from, to).joint_rates(scene);
        let slips = rates.iter().map(|rate| rate.slip.abs() / model.length);
        slips.fold(0.0, f64::max)
    };
    let mut moved = !freeze.frozen.is_empty();
    let mut outcome = match search(&mut engine, &model, &parameters, slip) {
        SearchEnd::Bracketed(seen) => {
            moved &= freeze.moved(&model, &seen.settled.states, &seen.collapsed);
            let settlement = measure::displacement(&model, &laid, &seen.settled.states);
            let mut checks = vec![
                sees,
                checks::settles_little(settlement, parameters.settlement),
            ];
            checks.extend(self_checks(scene, &model, &parameters, freeze, &seen));
            judged(scene, &model, &parameters, &seen, checks)
        }
        SearchEnd::Undecided(fact) => undecided(fact),
        SearchEnd::Falls(fact) => Outcome::without_number(Status::Falls, fact),
    };
    outcome.work = Work {
        block_steps: engine.steps * parameters.substeps * model.blocks.len(),
        ..Work::default()
    };
    (outcome, moved)
}

/// The outcome of a bracket, after the self-checks.
fn judged(
    scene: &Scene,
    model: &Model,
    parameters: &Parameters,
    seen: &Observation,
    checks: Vec<SelfCheck>,
) -> Outcome {
    let failed = checks.iter().find(|check| !check.passed());
    if let Some(failed) = failed.filter(|_| parameters.self_checks) {
        let fact = PushoverFact::SelfCheckFailed(failed.clone());
        return Outcome {
            checks,
            ..Outcome::without_number(Status::Undecided, fact)
        };
    }
    let moved = |frame: &Vec<BodyState>| mechanism(scene, model, &seen.settled.states, frame);
    let mechanism = mechanism(scene, model, &seen.rest.states, &seen.collapsed);
    Outcome {
        bracket: Some(Bracket {
            lower: seen.lower as f64 / GRID * model.multiplier,
            upper: seen.upper as f64 / GRID * model.multiplier,
        }),
        stated_error: Some(parameters.stated_error),
        crack: crack_slope_by_gap(scene, &mechanism),
        mechanism: Some(mechanism),
        recording: seen.frames.iter().map(moved).collect(),
        checks,
        ..Outcome::of(Status::Bracketed)
    }
}

fn self_checks(
    scene: &Scene,
    model: &Model,
    parameters: &Parameters,
    freeze: &Freeze,
    seen: &Observation,
) -> [SelfCheck; 5] {
    let [x, y] = model.dead;
    let weight = (x * x + y * y).sqrt();
    let lambda = seen.lower as f64 / GRID;
    let pushed = [x + lambda * model.live[0], y + lambda * model.live[1]];
    let fixed = |side| freeze.is_fixed(side);
    let settled = checks::reaction(&seen.settled.contacts, fixed);
    let carried = checks::reaction(&seen.rest.contacts, fixed);
    let closed = checks::off_joints(scene, &seen.rest.contacts);
    let drift = measure::displacement(model, &seen.settled.states, &seen.rest.states);
    [
        checks::at_rest(measure::speed(model, &seen.settled.states)),
        checks::supports_carry(model.dead, settled, weight, AtRest::Settled),
        checks::supports_carry(pushed, carried, weight, AtRest::Last),
        checks::open_stays_open(closed, weight),
        checks::small_drift(drift, parameters.drift),
    ]
}

/// Displacements from one state to another, in the scene's length unit.
fn mechanism(scene: &Scene, model: &Model, from: &[BodyState], to: &[BodyState]) -> Mechanism {
    let mut motions = vec![Motion::default(); scene.blocks().len()];
    for ((a, b), block) in from.iter().zip(to).zip(&model.blocks) {
        let moved = Vector::new(b.position[0] - a.position[0], b.position[1] - a.position[1]);
        motions[block.index] = Motion {
            velocity: moved * model.length,
            rotation: b.rotation - a.rotation,
        };
    }
    Mechanism { motions }
}
