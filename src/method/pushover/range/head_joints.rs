//! The range over what perpends in contact carry: what the levels of the scene and of its mirror image see.

use super::super::levels::{by_levels, jump_of, state_jump};
use super::super::model::Model;
use super::super::observing::observing;
use super::super::parameters::Asked;
use super::super::portion::Portion;
use super::super::run::Trial;
use super::super::tuned::Tuned;
use crate::answer::{Fact, Observed, Outcome, PushoverFact, SelfCheck, Status, Variation};
use crate::method::at_once::both;
use crate::scene::Scene;

/// What three levels of both directions cost, in first levels: the second knows where to look.
const FIRST_LEVELS: usize = 2 * (1 + 1 + 2);

/// What the levels of the scene and of its mirror image see, of which each may meet another state.
pub fn over_head_joints(scene: &Scene, part: &Portion, asked: Asked) -> Outcome {
    let tuned = asked.tuned;
    let undecided = |fact| Outcome::without_number(Status::Undecided, fact);
    let Ok(mirror) = scene.mirrored() else {
        return undecided(PushoverFact::NoMirror);
    };
    let blocks = part.present(scene).count();
    let model = Model::new(scene, part, &tuned);
    let courses = model.map_or(1.0, |model| model.courses);
    let costs = FIRST_LEVELS as f64 * blocks as f64 * tuned.substeps_of_course * courses;
    if costs > tuned.range_budget as f64 && !asked.settings.long_ranges {
        return undecided(PushoverFact::RangeNotRun { blocks });
    }
    let (one, other) = both(
        || levelled(scene, part, asked, false),
        || levelled(&mirror, part, asked, true),
    );
    joined([one, other])
}

/// The levels of one direction, or its only one where a user asks for such.
fn levelled(scene: &Scene, part: &Portion, asked: Asked, mirrored: bool) -> (Variation, Outcome) {
    let mut variation = Variation {
        stiffness: 1.0,
        mirrored,
    };
    if asked.has_one_level() {
        let trial = Trial::new(scene, part, asked);
        return (variation, trial.run(&|own| own));
    }
    let tuned = Tuned {
        budget: asked.tuned.range_budget / 2,
        ..asked.tuned
    };
    let levels = by_levels(scene, part, Asked { tuned, ..asked });
    // Contacts stiffen with the square of the substep.
    variation.stiffness = 4f64.powi(levels.halvings as i32);
    (variation, levels.measured())
}

/// One outcome of both; without a number where one of them has none.
fn joined(runs: [(Variation, Outcome); 2]) -> Outcome {
    let block_steps = runs.iter().map(|(_, run)| run.work.block_steps).sum();
    let checks = runs.iter().flat_map(|(variation, run)| {
        run.evidence.checks().iter().map(|check| SelfCheck {
            variation: Some(*variation),
            ..check.clone()
        })
    });
    let checks: Vec<SelfCheck> = checks.collect();
    let [(_, one), (_, other)] = &runs;
    let crack = |run: &Outcome| run.evidence.observed()?.crack;
    let outcome = match (one.bracket(), other.bracket()) {
        (Some(bracket), Some(others)) => {
            let errors = [one, other].map(|run| run.evidence.stated_error());
            let error = errors[0].zip(errors[1]).map(|(one, other)| one.max(other));
            let observed = Observed {
                bracket: Some(bracket.hull(others)),
                stated_error: error,
                crack: crack(one).filter(|_| crack(one) == crack(other)),
                ..Observed::default()
            };
            let status = error.map_or(Status::Estimate, |_| Status::Bracketed);
            let mut facts = vec![PushoverFact::Range.into()];
            state_jump(&mut facts, jump_of(&one.facts).max(jump_of(&other.facts)));
            Outcome {
                facts,
                ..Outcome::with(status, observed)
            }
        }
        _ => without(&runs),
    };
    let mut outcome = observing(outcome, |observed| observed.checks = checks);
    outcome.work.block_steps = block_steps;
    outcome
}

/// Why there is no range. A scene that falls whichever way it is pushed falls.
fn without(runs: &[(Variation, Outcome)]) -> Outcome {
    if runs.iter().all(|(_, run)| run.status == Status::Falls) {
        return Outcome {
            facts: runs[0].1.facts.clone(),
            ..Outcome::of(Status::Falls)
        };
    }
    let unanswered = runs.iter().filter(|(_, run)| run.bracket().is_none());
    let facts = unanswered.flat_map(|(variation, run)| {
        let without = Fact::from(PushoverFact::Without(*variation));
        [vec![without], run.facts.clone()].concat()
    });
    Outcome {
        facts: facts.collect(),
        ..Outcome::of(Status::Undecided)
    }
}
