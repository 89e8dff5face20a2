//! The range of a scene on whose multiplier the levels disagree.

use super::super::levels::Levels;
use super::super::observing::observing;
use super::super::parameters::{Parameters, SLIDE};
use super::super::run::Trial;
use super::Varied;
use super::joined::{Runs, covered, joined, moved};
use crate::answer::{Bracket, Outcome, Status, Variation};

/// Contact stiffnesses, as multiples of what the substep allows.
const STIFFNESSES: [f64; 3] = [1.0, 0.5, 0.25];

/// The conditions of one pushover of a range.
#[derive(Clone, Copy, Debug)]
struct Conditions {
    /// Contact stiffness, as a multiple of what the substep allows.
    stiffness: f64,
    /// Whether the mirror image is pushed.
    mirrored: bool,
    /// Times that the substep is halved.
    halvings: u32,
    /// What ends it.
    end: End,
    /// Where another pushover saw the collapse.
    expected: Option<Bracket>,
}

/// What a pushover of a range counts as the end.
#[derive(Clone, Copy, Debug)]
enum End {
    /// Collapse, wherever the scene has slid until then.
    CollapseAnywhere,
    /// A block has left the place where it was laid.
    LeftPlace,
}

impl Varied<'_> {
    /// The range of levels that disagree: over both directions and several stiffnesses at the last of
    /// them, over the last two, and down to where a block leaves its place. Its error is how far the
    /// ends move with half the substep.
    pub fn over_states(&self, levels: &Levels) -> Outcome {
        let level = levels.halvings;
        let brackets = levels.brackets();
        let last_two = &brackets[brackets.len().saturating_sub(2)..];
        let fact = levels.why_not();
        let spent = levels.last.work.block_steps;
        if spent > self.asked.tuned.budget / 8 {
            return Outcome {
                work: levels.last.work,
                ..Outcome::without_number(Status::Undecided, fact)
            };
        }
        let mut variants = Vec::new();
        for mirrored in [false, true] {
            let own = Conditions {
                stiffness: 1.0,
                mirrored,
                halvings: level,
                end: End::LeftPlace,
                expected: None,
            };
            variants.push(own);
            variants.extend(STIFFNESSES.map(|stiffness| Conditions {
                stiffness,
                end: End::CollapseAnywhere,
                expected: brackets.last().copied(),
                ..own
            }));
        }
        let run = |&conditions: &Conditions| self.run(conditions, level);
        let mut runs: Vec<_> = variants.iter().map(run).collect();
        let Some(coarse) = covered(&runs) else {
            return joined(runs, spent, None, vec![fact.into()]);
        };
        runs.extend(self.finer(&variants, &runs, level));
        let coarse = last_two.iter().copied().fold(coarse, Bracket::hull);
        let error = moved(coarse, &runs, self.unit());
        let outcome = joined(runs, spent, error, vec![fact.into()]);
        observing(outcome, |observed| {
            observed.bracket = observed.bracket.map(|range| range.hull(coarse));
        })
    }

    /// One pushover. Its variation names the stiffness in the measure of a level that is halved
    /// `level` times.
    fn run(&self, conditions: Conditions, level: u32) -> (Variation, Outcome) {
        let trial = Trial {
            expected: conditions.expected,
            ..Trial::new(self.of(conditions.mirrored), self.portion, self.asked)
        };
        let outcome = trial.run(&|own| {
            let own = own.halved(conditions.halvings);
            let own = Parameters {
                // Stiffness goes with the square of the frequency.
                contact_frequency: own.contact_frequency * conditions.stiffness.sqrt(),
                ..own
            };
            match conditions.end {
                End::CollapseAnywhere => Parameters {
                    drift: f64::INFINITY,
                    ..own
                },
                End::LeftPlace => Parameters {
                    slide: SLIDE,
                    ..own
                },
            }
        });
        // Contacts stiffen with the square of the substep.
        let times = 4f64.powi(conditions.halvings.saturating_sub(level) as i32);
        let variation = Variation {
            stiffness: conditions.stiffness * times,
            mirrored: conditions.mirrored,
        };
        (variation, outcome)
    }

    /// The pushovers that gave the ends of a range, with half the substep: what that moves them by is
    /// the error of the range.
    fn finer(&self, variants: &[Conditions], runs: &Runs, level: u32) -> Runs {
        let bracket = |index: &usize| runs[*index].1.bracket();
        let lower = |index: &usize| bracket(index).map_or(f64::INFINITY, |b| b.lower);
        let upper = |index: &usize| bracket(index).map_or(f64::INFINITY, |b| -b.upper);
        let first =
            |of: &dyn Fn(&usize) -> f64| (0..variants.len()).min_by(|a, b| of(a).total_cmp(&of(b)));
        let ends = [first(&lower), first(&upper)].into_iter().flatten();
        let mut ends: Vec<usize> = ends.collect();
        ends.dedup();
        let finer = ends.into_iter().map(|index| {
            let conditions = Conditions {
                halvings: variants[index].halvings + 1,
                expected: bracket(&index),
                ..variants[index]
            };
            self.run(conditions, level)
        });
        finer.collect()
    }
}
