//! Pushovers of a single level, whose error nothing measures: for comparisons, and where a user asks
//! for substeps of a certain length.

use super::parameters::{Asked, Parameters};
use super::parts::weakest;
use super::run::Trial;
use crate::answer::Outcome;
use crate::method::PushoverSettings;
use crate::scene::Scene;

/// One pushover with its parameters, which follow from settings and scene, changed.
pub fn solve_with(
    scene: &Scene,
    settings: &PushoverSettings,
    change: impl Fn(Parameters) -> Parameters,
) -> Outcome {
    weakest(scene, |portion| {
        Trial::new(scene, portion, Asked::new(settings)).run(&change)
    })
}
