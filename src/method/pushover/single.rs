//! Pushovers of a single level, whose error nothing measures: for comparisons, and where a user asks
//! for substeps of a certain length.

use super::model::Model;
use super::parameters::Parameters;
use super::parts::weakest;
use super::portion::Portion;
use super::run::Trial;
use crate::answer::Outcome;
use crate::method::PushoverSettings;
use crate::scene::Scene;

/// One pushover of a part.
pub fn solved(
    scene: &Scene,
    portion: &Portion,
    parameters: &impl Fn(&Model) -> Parameters,
) -> Outcome {
    let expected = None;
    let trial = Trial {
        scene,
        portion,
        expected,
    };
    trial.run(parameters)
}

/// One pushover with its parameters, which follow from settings and scene, changed.
pub fn solve_with(
    scene: &Scene,
    settings: &PushoverSettings,
    change: impl Fn(Parameters) -> Parameters,
) -> Outcome {
    let parameters = |model: &Model| change(Parameters::new(model, settings));
    weakest(scene, |part| solved(scene, part, &parameters))
}
