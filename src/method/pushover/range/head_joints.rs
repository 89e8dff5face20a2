//! The range over what perpends in contact carry: what the levels of the scene and of its mirror image see.

use super::super::levels::by_levels;
use super::super::model::Model;
use super::super::parameters::Asked;
use super::super::run::Trial;
use super::super::tuned::Tuned;
use super::Varied;
use super::joined::joined;
use crate::answer::{Outcome, PushoverFact, Status, Variation};
use crate::method::at_once::both;

/// What three levels of both directions cost, in first levels: the second knows where to look.
const FIRST_LEVELS: usize = 2 * (1 + 1 + 2);

impl Varied<'_> {
    /// What the levels of the scene and of its mirror image see, of which each may meet another state.
    pub fn over_head_joints(&self) -> Outcome {
        let Asked { settings, tuned } = self.asked;
        let blocks = self.portion.present(self.scene).count();
        let model = Model::new(self.scene, self.portion, &tuned);
        let courses = model.map_or(1.0, |model| model.courses);
        let costs = FIRST_LEVELS as f64 * blocks as f64 * tuned.substeps_of_course * courses;
        if costs > tuned.range_budget as f64 && !settings.long_ranges {
            let fact = PushoverFact::RangeNotRun { blocks };
            return Outcome::without_number(Status::Undecided, fact);
        }
        let (one, other) = both(|| self.levelled(false), || self.levelled(true));
        let runs = vec![one, other];
        let errors = runs.iter().map(|(_, run)| run.evidence.stated_error());
        let error = errors.reduce(|one, other| Some(one?.max(other?))).flatten();
        let fact = error.map(|_| PushoverFact::Range.into());
        joined(runs, 0, error, fact.into_iter().collect())
    }

    /// The levels of one direction, or its only one where a user asks for such.
    fn levelled(&self, mirrored: bool) -> (Variation, Outcome) {
        let scene = self.of(mirrored);
        let Asked { settings, tuned } = self.asked;
        let mut variation = Variation {
            stiffness: 1.0,
            mirrored,
        };
        if self.asked.has_one_level() {
            let trial = Trial::new(scene, self.portion, self.asked);
            return (variation, trial.run(&|own| own));
        }
        let budget = match settings.long_ranges {
            true => usize::MAX,
            false => tuned.range_budget / 2,
        };
        let tuned = Tuned { budget, ..tuned };
        let levels = by_levels(scene, self.portion, Asked { settings, tuned });
        // Contacts stiffen with the square of the substep.
        variation.stiffness = 4f64.powi(levels.halvings as i32);
        (variation, levels.measured())
    }
}
