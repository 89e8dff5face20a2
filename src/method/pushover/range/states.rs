//! The range of an open scene on whose multiplier the levels do not agree.

use super::super::levels::{Levels, by_levels};
use super::super::observing::observing;
use super::super::parameters::Asked;
use super::super::portion::Portion;
use crate::answer::{Outcome, PushoverFact};
use crate::scene::Scene;

/// What the last two levels cover. Where blocks had slid out of their place by then, the scene that collapsed is
/// no longer the one that was laid: the load at which the first of them does so counts too, or alone.
pub fn over_states(scene: &Scene, part: &Portion, asked: Asked, levels: Levels) -> Outcome {
    match !levels.sways && levels.slides() && !levels.ran_out {
        true => in_place(scene, part, asked, levels),
        false => levels.measured(),
    }
}

/// What levels saw of a scene that slides before it collapses, and where a block leaves its place.
fn in_place(scene: &Scene, part: &Portion, asked: Asked, levels: Levels) -> Outcome {
    let in_place = Asked {
        in_place: true,
        ..asked
    };
    let why_not = levels.why_not();
    let mut beyond = levels.measured();
    let mut leaving = by_levels(scene, part, in_place).measured();
    leaving.work.block_steps += beyond.work.block_steps;
    let ends = |of: &Outcome| Some((of.bracket()?, of.evidence.stated_error()?));
    match (ends(&beyond), ends(&leaving)) {
        (_, None) => leaving,
        (None, Some(_)) => {
            leaving.facts.insert(0, PushoverFact::SlidesFirst.into());
            leaving
        }
        (Some((one, error)), Some((other, others))) => {
            beyond.facts.insert(0, why_not.into());
            beyond.work = leaving.work;
            observing(beyond, |observed| {
                observed.bracket = Some(one.hull(other));
                observed.stated_error = Some(error.max(others));
            })
        }
    }
}
