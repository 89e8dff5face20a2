//! The range of a scene on whose multiplier the levels disagree.

use super::super::levels::Levels;
use super::super::observing::observing;
use super::joined::{covered, hull, joined, moved};
use super::{Conditions, End, STIFFNESSES, Varied};
use crate::answer::{Bracket, Outcome, PushoverFact, Status};

impl Varied<'_> {
    /// The range of levels that disagree: over both directions and several stiffnesses at the last of
    /// them, over the last two, and down to where a block leaves its place. Its error is how far the
    /// ends move with half the substep.
    pub fn over_states(&self, levels: &Levels) -> Outcome {
        let level = levels.halvings;
        let brackets: Vec<Bracket> = levels.seen.iter().map(|level| level.bracket).collect();
        let last_two = &brackets[brackets.len().saturating_sub(2)..];
        let fact = match *brackets {
            [] => PushoverFact::SlidesFirst,
            [bracket] => PushoverFact::OneLevel { bracket },
            _ => PushoverFact::LevelsDisagree {
                brackets: brackets.clone(),
            },
        };
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
        let coarse = last_two.iter().copied().fold(coarse, hull);
        let error = moved(coarse, &runs, self.unit());
        let outcome = joined(runs, spent, error, vec![fact.into()]);
        observing(outcome, |observed| {
            observed.bracket = observed.bracket.map(|range| hull(range, coarse));
        })
    }
}
