//! One outcome of all pushovers of a range.

use super::super::observing::observing;
use crate::answer::{Bracket, Fact, Observed, Outcome, PushoverFact, SelfCheck, Status, Variation};
use crate::mechanics::Crack;

/// The pushovers of a range.
pub type Runs = Vec<(Variation, Outcome)>;

/// What all brackets cover; `None` where a run has none.
fn covered(runs: &Runs) -> Option<Bracket> {
    let brackets: Option<Vec<Bracket>> = runs.iter().map(|(_, run)| run.bracket()).collect();
    brackets?.into_iter().reduce(Bracket::hull)
}

/// One outcome of all; without a number where one of them has none.
pub fn joined(runs: Runs, error: Option<f64>, facts: Vec<Fact>) -> Outcome {
    let block_steps = runs.iter().map(|(_, run)| run.work.block_steps).sum();
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
