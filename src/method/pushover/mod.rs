//! Pushover: the scene as rigid bodies in contact, pushed harder and harder until it collapses.
//!
//! ```text
//! scene ── model (no dimensions) ──▶ physics (rapier) ◀── search ──▶ checks ──▶ outcome
//! ```
//!
//! λ is the last load at rest and the first that collapsed from there. What the search or its
//! self-checks cannot vouch for is `undecided` with a reason, never a number. A tall wall that falls in a
//! large jump is an `estimate`, which states no error.

mod agreement;
mod apart;
mod checks;
#[cfg(test)]
mod doubled;
mod faces;
mod fall;
mod hint;
mod hold;
mod levels;
mod mass;
mod measure;
mod model;
mod moving;
mod observing;
pub(crate) mod parameters;
mod parts;
mod physics;
mod portion;
mod range;
pub(crate) mod run;
mod search;
mod tuned;
mod verify;

pub(crate) use parameters::Parameters;

use crate::answer::{Outcome, PushoverFact, Status};
use crate::method::{Collapse, Method, PushoverSettings, Settings};
use crate::scene::Scene;
use levels::by_levels;
use model::Model;
use moving::from_within;
use observing::observing;
use parameters::{Asked, FIRST_SLIP};
use parts::weakest;
use portion::{Portion, beyond_stagger};
use range::{over_head_joints, over_states};
use run::Trial;

/// The pushover method.
#[derive(Clone, Copy, Debug, Default)]
pub struct Pushover;

impl Method for Pushover {
    fn name(&self) -> &str {
        "pushover"
    }

    fn solve(&self, scene: &Scene, settings: &Settings) -> Outcome {
        let pushed = |scene: &Scene| self.pushed(scene, &settings.pushover);
        from_within(scene, pushed).unwrap_or_else(|| pushed(scene))
    }
}

impl Pushover {
    /// The answer of a scene that begins at rest.
    fn pushed(&self, scene: &Scene, settings: &PushoverSettings) -> Outcome {
        let outcome = weakest(scene, |part| answer(scene, part, Asked::new(settings)));
        let ranges = Portion::default().has_range(scene);
        let outcome = if settings.verify && !ranges {
            verify::confirmed(scene, settings, outcome)
        } else {
            outcome
        };
        let outcome = match settings.collapse {
            Collapse::FirstSlip if outcome.bracket().is_some() => first_slip(outcome),
            _ if Asked::new(settings).is_coarser() => without_calibration(outcome),
            _ => outcome,
        };
        observing(outcome, |_| ())
    }
}

/// The answer of one connected part: levels whose differences tell the error, or a range where there
/// is more than one collapse state.
fn answer(scene: &Scene, part: &Portion, asked: Asked) -> Outcome {
    if part.has_range(scene) {
        return over_head_joints(scene, part, asked);
    }
    if asked.has_one_level() {
        return Trial::new(scene, part, asked).run(&|own| own);
    }
    let levels = by_levels(scene, part, asked);
    match levels.agreed {
        Some(agreed) => levels.with(agreed),
        None => over_states(scene, part, asked, levels),
    }
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
    qualified(outcome, status, PushoverFact::Uncalibrated)
}

/// Says that the bracket is of the first slip. It states no error of the collapse multiplier, so
/// that nobody compares it with one, and is an estimate: contacts give before they slip, so that it
/// moves with the substep (paper-2: 0.4995, and 0.5443 with half the substep).
fn first_slip(outcome: Outcome) -> Outcome {
    let fact = PushoverFact::FirstSlip { slip: FIRST_SLIP };
    qualified(outcome, Status::Estimate, fact)
}

/// The outcome as a status that states no error, and first of all why.
fn qualified(outcome: Outcome, status: Status, fact: PushoverFact) -> Outcome {
    let mut facts = outcome.facts;
    facts.insert(0, fact.into());
    let outcome = Outcome {
        status,
        facts,
        ..outcome
    };
    observing(outcome, |observed| observed.stated_error = None)
}

/// Every parameter with its unit, one a line, as the pushover of this scene begins with them.
///
/// # Errors
/// What this method cannot honour in the scene.
pub(crate) fn parameters(
    scene: &Scene,
    settings: &PushoverSettings,
) -> Result<String, PushoverFact> {
    let asked = Asked::new(settings);
    let portion = beyond_stagger(scene, &Portion::default(), &asked.tuned).unwrap_or_default();
    let model = Model::new(scene, &portion, &asked.tuned)?;
    let parameters = Parameters::new(&model, &asked);
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
