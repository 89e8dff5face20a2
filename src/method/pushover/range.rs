//! Head joints in contact: a range over what nobody knows of a real wall.
//!
//! What a perpend carries before the push depends on how tightly it was closed, so the collapse
//! load is not unique. Direction and contact stiffness stand for that here.

use super::parameters::Parameters;
use super::solve_with;
use crate::answer::{Bracket, Outcome, Status};
use crate::method::PushoverSettings;
use crate::scene::Scene;

/// Blocks beyond which the variations are run only on request.
const BLOCKS: usize = 200;

/// Contact stiffnesses, as multiples of what the substep allows.
const STIFFNESSES: [f64; 3] = [1.0, 0.5, 0.25];

/// The lowest lower and the highest upper value over both directions and several stiffnesses.
pub fn over_variations(scene: &Scene, settings: &PushoverSettings) -> Outcome {
    let blocks = scene.blocks().len();
    if blocks > BLOCKS && !settings.long_ranges {
        let reason = format!(
            "not run: with head joints in contact the answer is a range over {} pushovers, which \
             {blocks} blocks make long",
            2 * STIFFNESSES.len()
        );
        return Outcome::without_number(Status::Undecided, reason);
    }
    let Ok(mirror) = scene.mirrored() else {
        let reason = "the scene cannot be mirrored";
        return Outcome::without_number(Status::Undecided, reason);
    };
    let mut runs = Vec::new();
    for stiffness in STIFFNESSES {
        // Stiffness goes with the square of the frequency.
        let change = |parameters: Parameters| Parameters {
            contact_frequency: parameters.contact_frequency * stiffness.sqrt(),
            ..parameters
        };
        for (side, word) in [(scene, "as it is"), (&mirror, "mirrored")] {
            let run = solve_with(side, settings, change);
            runs.push((format!("stiffness × {stiffness}, {word}"), run));
        }
    }
    joined(runs)
}

/// One outcome of all; without a number where one of them has none.
fn joined(runs: Vec<(String, Outcome)>) -> Outcome {
    let block_steps = runs.iter().map(|(_, run)| run.work.block_steps).sum();
    let checks = runs.iter().flat_map(|(what, run)| {
        let checks = run.checks.iter();
        checks.map(move |check| format!("{what}: {check}"))
    });
    let checks: Vec<String> = checks.collect();
    let brackets: Option<Vec<Bracket>> = runs.iter().map(|(_, run)| run.bracket).collect();
    let Some(brackets) = brackets else {
        let failed = runs.iter().filter(|(_, run)| run.bracket.is_none());
        let words: Vec<String> = failed
            .map(|(what, run)| format!("{what}: {}", run.reason()))
            .collect();
        let mut outcome = Outcome::without_number(Status::Undecided, words.join("; "));
        (outcome.checks, outcome.work.block_steps) = (checks, block_steps);
        return outcome;
    };
    let lower = brackets
        .iter()
        .map(|b| b.lower)
        .fold(f64::INFINITY, f64::min);
    let upper = brackets.iter().map(|b| b.upper).fold(0.0, f64::max);
    let reason = format!(
        "a range over both directions and contact stiffnesses 1 to 1/{:.0}: with head joints in \
         contact the answer is not unique",
        1.0 / STIFFNESSES[STIFFNESSES.len() - 1]
    );
    let cracks: Vec<_> = runs.iter().map(|(_, run)| run.crack).collect();
    let same = cracks.windows(2).all(|pair| pair[0] == pair[1]);
    let mut outcome = Outcome {
        bracket: Some(Bracket { lower, upper }),
        stated_error: runs.iter().find_map(|(_, run)| run.stated_error),
        crack: cracks.first().copied().flatten().filter(|_| same),
        checks,
        ..Outcome::without_number(Status::Bracketed, reason)
    };
    outcome.work.block_steps = block_steps;
    outcome
}
