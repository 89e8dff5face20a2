//! One outcome of all pushovers of a range.

use super::super::agreement::rounded_up;
use super::super::observing::observing;
use crate::answer::{
    Bracket, Fact, Observed, Outcome, PushoverFact, SelfCheck, Status, Variation, magnitude,
};
use crate::mechanics::Crack;

/// The pushovers of a range.
pub type Runs = Vec<(Variation, Outcome)>;

/// Blocks times substeps of all runs.
pub fn steps(runs: &Runs) -> usize {
    runs.iter().map(|(_, run)| run.work.block_steps).sum()
}

/// What all brackets cover; `None` where a run has none.
pub fn covered(runs: &Runs) -> Option<Bracket> {
    let brackets: Option<Vec<Bracket>> = runs.iter().map(|(_, run)| run.bracket()).collect();
    brackets?.into_iter().reduce(Bracket::hull)
}

/// How far a shorter substep moved the ends of a range that was `coarse` without it, or the width of
/// the widest bracket: the error that is stated, relative to λ, which is measured in the `unit`.
pub fn moved(coarse: Bracket, runs: &Runs, unit: f64) -> Option<f64> {
    let all = covered(runs)?;
    let widths = runs.iter().filter_map(|(_, run)| run.bracket());
    let width = widths.map(|b| b.width()).fold(0.0, f64::max);
    let ends = (coarse.lower - all.lower).max(all.upper - coarse.upper);
    Some(rounded_up(ends.max(width) / magnitude(all.upper, unit)))
}

/// One outcome of all; without a number where one of them has none.
pub fn joined(runs: Runs, spent: usize, error: Option<f64>, facts: Vec<Fact>) -> Outcome {
    let block_steps = spent + steps(&runs);
    let checks = runs.iter().flat_map(|(variation, run)| {
        run.evidence.checks().iter().map(|check| SelfCheck {
            variation: Some(*variation),
            ..check.clone()
        })
    });
    let checks: Vec<SelfCheck> = checks.collect();
    let mut outcome = match covered(&runs) {
        Some(range) => {
            let observed = Observed {
                bracket: Some(range),
                stated_error: error,
                crack: crack(&runs[0]).filter(|_| same_crack(&runs)),
                ..Observed::default()
            };
            Outcome {
                facts,
                ..Outcome::with(Status::Bracketed, observed)
            }
        }
        None => Outcome {
            facts: [why_none(&runs), facts].concat(),
            ..Outcome::of(status_without(&runs))
        },
    };
    outcome.work.block_steps = block_steps;
    observing(outcome, |observed| observed.checks = checks)
}

/// A scene that falls however it is varied falls.
fn status_without(runs: &Runs) -> Status {
    match runs.iter().all(|(_, run)| run.status == Status::Falls) {
        true => Status::Falls,
        false => Status::Undecided,
    }
}

fn same_crack(runs: &Runs) -> bool {
    runs.windows(2)
        .all(|pair| crack(&pair[0]) == crack(&pair[1]))
}

fn crack((_, run): &(Variation, Outcome)) -> Option<Crack> {
    run.evidence.observed()?.crack
}

fn why_none(runs: &Runs) -> Vec<Fact> {
    if status_without(runs) == Status::Falls {
        return runs[0].1.facts.clone();
    }
    let mut facts = Vec::new();
    for (variation, run) in runs.iter().filter(|(_, run)| run.bracket().is_none()) {
        facts.push(PushoverFact::Without(*variation).into());
        facts.extend(run.facts.clone());
    }
    facts
}

#[cfg(test)]
mod tests {
    use super::*;

    fn run(lower: f64, upper: f64) -> (Variation, Outcome) {
        let variation = Variation {
            stiffness: 1.0,
            mirrored: false,
        };
        let observed = Observed {
            bracket: Some(Bracket { lower, upper }),
            ..Observed::default()
        };
        let outcome = Outcome::with(Status::Bracketed, observed);
        (variation, outcome)
    }

    /// A range whose lower end a shorter substep lowered by 1 %, whatever the live load's unit.
    #[test]
    fn the_stated_error_is_relative_in_every_unit_of_the_live_load() {
        for unit in [1e-6, 1.0, 1e6] {
            let coarse = Bracket {
                lower: 0.5 * unit,
                upper: 0.501 * unit,
            };
            let runs = vec![
                run(coarse.lower, coarse.upper),
                run(0.49501 * unit, 0.4955 * unit),
            ];
            // 0.00499 of 0.501, rounded up.
            assert_eq!(moved(coarse, &runs, unit), Some(1e-2));
        }
    }
}
