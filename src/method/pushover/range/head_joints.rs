//! The range over what perpends in contact carry: what the levels of the scene and of its mirror image see.

use super::super::levels::{by_levels, is_jump};
use super::super::model::Model;
use super::super::parameters::Asked;
use super::super::portion::Portion;
use super::super::run::Trial;
use super::super::tuned::Tuned;
use super::joined::joined;
use crate::answer::{Outcome, PushoverFact, Status, Variation};
use crate::method::at_once::both;
use crate::scene::Scene;

/// What three levels of both directions cost, in first levels: the second knows where to look.
const FIRST_LEVELS: usize = 2 * (1 + 1 + 2);

/// What the levels of the scene and of its mirror image see, of which each may meet another state.
pub fn over_head_joints(scene: &Scene, part: &Portion, asked: Asked) -> Outcome {
    let Asked {
        settings, tuned, ..
    } = asked;
    let undecided = |fact| Outcome::without_number(Status::Undecided, fact);
    let Ok(mirror) = scene.mirrored() else {
        return undecided(PushoverFact::NoMirror);
    };
    let blocks = part.present(scene).count();
    let model = Model::new(scene, part, &tuned);
    let courses = model.map_or(1.0, |model| model.courses);
    let costs = FIRST_LEVELS as f64 * blocks as f64 * tuned.substeps_of_course * courses;
    if costs > tuned.range_budget as f64 && !settings.long_ranges {
        return undecided(PushoverFact::RangeNotRun { blocks });
    }
    let levelled = |mirrored| {
        levelled(
            if mirrored { &mirror } else { scene },
            part,
            asked,
            mirrored,
        )
    };
    let (one, other) = both(|| levelled(false), || levelled(true));
    let runs = vec![one, other];
    let errors = runs.iter().map(|(_, run)| run.evidence.stated_error());
    let Some(error) = errors.reduce(|one, other| Some(one?.max(other?))).flatten() else {
        return joined(runs, None, Vec::new());
    };
    let jump = runs.iter().flat_map(|(_, run)| &run.facts).find(is_jump);
    let facts = [Some(PushoverFact::Range.into()), jump.cloned()];
    let facts = facts.into_iter().flatten().collect();
    joined(runs, Some(error), facts)
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
