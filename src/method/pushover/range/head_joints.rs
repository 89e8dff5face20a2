//! The range over what perpends in contact carry.

use super::super::levels::{drift, rounded_up, softness};
use super::super::model::Model;
use super::super::parameters::Asked;
use super::joined::{Runs, covered, joined, moved, seen, steps};
use super::{Conditions, End, SOFTEST, STIFFNESSES, Varied};
use crate::answer::{Outcome, PushoverFact, Status, Variation};
use crate::method::at_once::both;

/// Pushovers of a range over head joints in contact.
const PUSHOVERS: usize = 2 * (STIFFNESSES.len() + 1);

impl Varied<'_> {
    /// The lowest lower and the highest upper value over both directions, several stiffnesses and
    /// two substeps.
    pub fn over_head_joints(&self) -> Outcome {
        let Asked { settings, tuned } = self.asked;
        let blocks = self.portion.present(self.scene).count();
        let [courses, extent] = self.courses();
        let costs = PUSHOVERS as f64 * blocks as f64 * tuned.substeps_of_course * courses;
        if costs > tuned.range_budget as f64 && !settings.long_ranges {
            let pushovers = PUSHOVERS;
            let fact = PushoverFact::RangeNotRun { pushovers, blocks };
            return Outcome::without_number(Status::Undecided, fact);
        }
        let (mut spent, mut halvings) = (0, 0);
        // The softest contacts say how short the substep has to be.
        let softest = loop {
            let run = self.run(conditions(SOFTEST, false, halvings), halvings);
            match softness(&run.1, tuned.halvings) {
                Some(more) if halvings + more <= tuned.halvings => {
                    spent += run.1.work.block_steps;
                    halvings += more;
                }
                _ => break run,
            }
        };
        let mut runs = vec![softest];
        // The stiffest and the softest first: they lie furthest apart.
        let varied = [
            (1.0, false),
            (1.0, true),
            (SOFTEST, true),
            (0.5, false),
            (0.5, true),
        ];
        let run = |&(stiffness, mirrored): &(f64, bool)| {
            self.run(conditions(stiffness, mirrored, halvings), halvings)
        };
        for pair in varied.chunks(2) {
            let is_over =
                |runs: &Runs| spent + steps(runs) > tuned.range_budget && !settings.long_ranges;
            if is_over(&runs) {
                return unfinished(runs, spent);
            }
            let (first, second) = match pair {
                [first, second] => {
                    let (first, second) = both(|| run(first), || run(second));
                    (first, Some(second))
                }
                _ => (run(&pair[0]), None),
            };
            runs.push(first);
            // As if one had been run after the other.
            if second.is_some() && is_over(&runs) {
                return unfinished(runs, spent);
            }
            runs.extend(second);
        }
        self.with_shorter_substeps(runs, spent, halvings, extent)
    }

    /// One outcome of pushovers at a level that is halved so many times, and of two more with half its substep,
    /// which tell the error. A scene that slides before it collapses has other lever arms than as it was laid.
    fn with_shorter_substeps(
        &self,
        mut runs: Runs,
        spent: usize,
        halvings: u32,
        extent: f64,
    ) -> Outcome {
        let Some(coarse) = covered(&runs) else {
            return joined(runs, spent, None, Vec::new());
        };
        let finer = |mirrored| {
            let like = |(variation, _): &&(Variation, Outcome)| {
                variation.stiffness == 1.0 && variation.mirrored == mirrored
            };
            let finer = Conditions {
                expected: runs.iter().find(like).and_then(|(_, run)| run.bracket()),
                ..conditions(1.0, mirrored, halvings + 1)
            };
            self.run(finer, halvings)
        };
        let (one, other) = both(|| finer(false), || finer(true));
        let slid = drift(&one.1).max(drift(&other.1)) / extent;
        runs.extend([one, other]);
        let error = moved(coarse, &runs, self.unit());
        let error = error.map(|error| error.max(rounded_up(slid)));
        let fact = PushoverFact::Range { softest: SOFTEST };
        joined(runs, spent, error, vec![fact.into()])
    }

    /// Courses that fit into the height of the portion, and the smaller of its width and height in them.
    fn courses(&self) -> [f64; 2] {
        let model = Model::new(self.scene, self.portion, &self.asked.tuned);
        model.map_or([1.0; 2], |model| [model.courses, model.extent])
    }
}

fn conditions(stiffness: f64, mirrored: bool, halvings: u32) -> Conditions {
    Conditions {
        stiffness,
        mirrored,
        halvings,
        end: End::Collapse,
        expected: None,
    }
}

/// A range that ended before all of its pushovers were run: no number, but how far it got.
fn unfinished(runs: Runs, spent: usize) -> Outcome {
    let fact = PushoverFact::RangeUnfinished {
        run: runs.len(),
        pushovers: PUSHOVERS,
        so_far: seen(&runs),
    };
    let mut outcome = Outcome::without_number(Status::Undecided, fact);
    outcome.work.block_steps = spent + steps(&runs);
    outcome
}
