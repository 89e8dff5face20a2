//! Pushover: the scene as rigid bodies in contact, pushed harder and harder until it collapses.
//!
//! ```text
//! scene ── model (no dimensions) ──▶ engine (rapier) ◀── search ──▶ checks ──▶ outcome
//! ```
//!
//! λ is the last load at rest and the first that collapsed from there. What the search or its
//! self-checks cannot vouch for is `undecided` with a reason, never a number.

mod checks;
mod engine;
mod freeze;
mod groups;
mod hint;
mod hold;
mod measure;
mod model;
mod parameters;
mod range;
mod search;
#[cfg(test)]
mod tests;
mod verify;

pub use checks::Check;
pub use parameters::Parameters;
pub use verify::verify;

use crate::answer::{Bracket, Claim, Mechanism, Motion, Outcome, Status, Work, crack_slope_by_gap};
use crate::method::{self, Collapse, Method, PushoverSettings};
use crate::scene::{HeadJoints, Joint, JointClass, Scene, Side, Vector};
use engine::{Contact, Engine, State};
use freeze::Freeze;
use model::Model;
use parameters::GRID;
use search::{Found, Search, search};

/// Natural frequency of the contacts times the substep beyond which walls jitter, with a margin
/// for rounding.
const MOST_STIFF: f64 = 0.2501;

/// The pushover method.
#[derive(Clone, Copy, Debug, Default)]
pub struct Pushover;

impl Method for Pushover {
    fn name(&self) -> &str {
        "pushover"
    }

    fn solve(&self, scene: &Scene, settings: &method::Settings) -> Outcome {
        let settings = &settings.pushover;
        let outcome = if has_perpends(scene) {
            range::over_variations(scene, settings)
        } else {
            solve_with(scene, settings, |own| own)
        };
        let outcome = match settings.verify {
            true => verify::confirmed(scene, settings, outcome),
            false => outcome,
        };
        let outcome = match settings.collapse {
            Collapse::FirstSlip if outcome.bracket.is_some() => first_slip(outcome),
            _ if coarser(settings) => without_calibration(outcome),
            _ => outcome,
        };
        Outcome {
            claim: Claim::Observed,
            ..outcome
        }
    }
}

/// Whether the user asks for longer substeps or softer contacts than the stated error was measured
/// with.
fn coarser(settings: &PushoverSettings) -> bool {
    settings.substep > 1.0 || settings.stiffness < 1.0
}

/// Says that nothing is known about the error, so that nobody takes a bracket for one, nor the fall
/// of a wall that such contacts let down for the wall's own.
fn without_calibration(outcome: Outcome) -> Outcome {
    let status = match outcome.status {
        Status::Bracketed => Status::Estimate,
        Status::Falls => Status::Undecided,
        // Without an answer there is nothing to qualify.
        _ => return outcome,
    };
    let why = "substeps longer or contacts softer than the stated error was measured with";
    let mut facts = outcome.facts;
    facts.insert(0, why.into());
    Outcome {
        status,
        stated_error: None,
        facts,
        ..outcome
    }
}

/// Says that the bracket is of the first slip. It states no error of the collapse multiplier, so
/// that nobody compares it with one, and is an estimate: contacts give before they slip, so that it
/// moves with the substep (paper-2: 0.4995, and 0.5443 with half the substep).
fn first_slip(outcome: Outcome) -> Outcome {
    let definition = "first slip of a joint by 1e-3 course heights, not the collapse";
    let mut facts = outcome.facts;
    facts.insert(0, definition.into());
    Outcome {
        status: Status::Estimate,
        stated_error: None,
        facts,
        ..outcome
    }
}

/// Whether head joints are in contact: what they carry depends on how the wall came to be. An arch
/// has none, as its radial joints carry the thrust.
fn has_perpends(scene: &Scene) -> bool {
    let head = |joint: &Joint| joint.class == JointClass::Head;
    scene.head_joints() == HeadJoints::Contact && scene.joints().iter().any(head)
}

/// Every parameter with its unit, one a line, as the pushover of this scene begins with them.
///
/// # Errors
/// A sentence on what this method cannot honour in the scene.
pub fn parameters(scene: &Scene, settings: &PushoverSettings) -> Result<String, String> {
    let freeze = freeze::beyond_stagger(scene).unwrap_or_default();
    let model = Model::new(scene, &freeze.frozen)?;
    let parameters = Parameters::new(&model, settings);
    let mut text = format!(
        "  {:<26} {:<12} case length\n  {:<26} {:<12}\n",
        "course height H_c",
        model.length,
        "blocks that may move",
        model.blocks.len()
    );
    for (name, value, unit) in parameters.listed() {
        text.push_str(&format!("  {name:<26} {value:<12} {unit}\n"));
    }
    Ok(text)
}

/// The pushover with its parameters, which follow from settings and scene, changed.
pub fn solve_with(
    scene: &Scene,
    settings: &PushoverSettings,
    change: impl Fn(Parameters) -> Parameters,
) -> Outcome {
    let parameters = |model: &Model| change(Parameters::new(model, settings));
    let Some(freeze) = freeze::beyond_stagger(scene) else {
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
    let undecided = |reason: String| Outcome::without_number(Status::Undecided, reason);
    let model = match Model::new(scene, &freeze.frozen) {
        Ok(model) => model,
        Err(reason) => return (undecided(reason), false),
    };
    let parameters = parameters(&model);
    if parameters.contact_frequency * parameters.substep > MOST_STIFF {
        let reason = "the contacts are stiffer than the substep can hold";
        return (undecided(reason.into()), false);
    }
    let Some(mut engine) = Engine::new(&model, &parameters) else {
        let reason = "the engine cannot take a shape of the scene";
        return (undecided(reason.into()), false);
    };
    let laid = engine.states();
    engine.step();
    let fixed = |side| freeze.holds(side);
    let sees = checks::sees_joints(scene.joints(), &engine.contacts(), fixed);
    if !sees.passed {
        return (undecided(sees.text), false);
    }
    let slip = |from: &[State], to: &[State]| {
        let rates = mechanism(scene, &model, from, to).joint_rates(scene);
        let slips = rates.iter().map(|rate| rate.slip.abs() / model.length);
        slips.fold(0.0, f64::max)
    };
    let mut moved = !freeze.frozen.is_empty();
    let mut outcome = match search(&mut engine, &model, &parameters, slip) {
        Search::Found(found) => {
            moved &= freeze.moved(&model, &found.settled.states, &found.collapsed);
            let mut checks = self_checks(scene, &model, &parameters, freeze, &found);
            let settlement = measure::displacement(&model, &laid, &found.settled.states);
            checks.splice(
                0..0,
                [
                    sees,
                    checks::settles_little(settlement, parameters.settlement),
                ],
            );
            judged(scene, &model, &parameters, &found, &checks)
        }
        Search::Undecided(reason) => undecided(reason),
        Search::Falls(reason) => Outcome::without_number(Status::Falls, reason),
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
    found: &Found,
    checks: &[Check],
) -> Outcome {
    let texts: Vec<String> = checks.iter().map(|check| check.text.clone()).collect();
    if let Some(failed) = checks
        .iter()
        .find(|check| !check.passed && parameters.self_checks)
    {
        let reason = format!("a self-check failed: {}", failed.text);
        return Outcome {
            checks: texts,
            ..Outcome::without_number(Status::Undecided, reason)
        };
    }
    let moved = |frame: &Vec<State>| mechanism(scene, model, &found.settled.states, frame);
    let mechanism = mechanism(scene, model, &found.rest.states, &found.collapsed);
    Outcome {
        bracket: Some(Bracket {
            lower: found.lower as f64 / GRID,
            upper: found.upper as f64 / GRID,
        }),
        stated_error: Some(parameters.stated_error),
        crack: crack_slope_by_gap(scene, &mechanism),
        mechanism: Some(mechanism),
        recording: found.frames.iter().map(moved).collect(),
        checks: texts,
        ..Outcome::without_number(Status::Bracketed, "")
    }
}

fn self_checks(
    scene: &Scene,
    model: &Model,
    parameters: &Parameters,
    freeze: &Freeze,
    found: &Found,
) -> Vec<Check> {
    let [x, y] = model.dead;
    let weight = (x * x + y * y).sqrt();
    let lambda = found.lower as f64 / GRID;
    let pushed = [x + lambda * model.live[0], y + lambda * model.live[1]];
    let carried = |contacts: &[Contact]| reaction(contacts, |side| freeze.holds(side));
    let drift = measure::displacement(model, &found.settled.states, &found.rest.states);
    let closed = off_joints(scene, &found.rest.contacts);
    vec![
        checks::at_rest(measure::speed(model, &found.settled.states)),
        checks::supports_carry(
            model.dead,
            carried(&found.settled.contacts),
            weight,
            "settled,",
        ),
        checks::supports_carry(
            pushed,
            carried(&found.rest.contacts),
            weight,
            "at the last rest",
        ),
        checks::open_stays_open(closed, weight),
        checks::small_drift(drift, parameters.drift),
    ]
}

/// Force of everything fixed on the blocks that may move.
fn reaction(contacts: &[Contact], fixed: impl Fn(Side) -> bool) -> [f64; 2] {
    let mut sum = [0.0; 2];
    for contact in contacts {
        let sign = match contact.between.map(&fixed) {
            [true, false] => 1.0,
            [false, true] => -1.0,
            _ => continue,
        };
        sum = [
            sum[0] + sign * contact.force[0],
            sum[1] + sign * contact.force[1],
        ];
    }
    sum
}

/// Sum of normal forces between bodies that share no joint of the scene.
fn off_joints(scene: &Scene, contacts: &[Contact]) -> f64 {
    let ordered = |[a, b]: [Side; 2]| if a < b { [a, b] } else { [b, a] };
    let joints = scene.joints().iter();
    let mut joined: Vec<[Side; 2]> = joints
        .map(|joint| ordered([joint.from, Side::Block(joint.to)]))
        .collect();
    joined.sort_unstable();
    let off = contacts
        .iter()
        .filter(|contact| joined.binary_search(&ordered(contact.between)).is_err());
    // Not `sum`, which makes −0 of nothing.
    off.map(|contact| contact.pressure).fold(0.0, |a, b| a + b)
}

/// Displacements from one state to another, in the scene's length unit.
fn mechanism(scene: &Scene, model: &Model, from: &[State], to: &[State]) -> Mechanism {
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
