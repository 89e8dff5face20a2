//! Head joints in contact: a range over what nobody knows of a real wall.
//!
//! What a perpend carries before the push depends on how tightly it was closed, so the collapse
//! load is not unique. Direction and contact stiffness stand for that here.

use super::parameters::Parameters;
use super::run::solve_with;
use crate::answer::{Bracket, Fact, Outcome, PushoverFact, SelfCheck, Status, Variation};
use crate::method::PushoverSettings;
use crate::scene::{HeadJoints, Joint, JointClass, Scene};

/// Blocks beyond which the variations are run only on request.
const BLOCKS: usize = 200;

/// Contact stiffnesses, as multiples of what the substep allows; the softest is last.
const STIFFNESSES: [f64; 3] = [1.0, 0.5, SOFTEST];

const SOFTEST: f64 = 0.25;

/// Whether head joints are in contact: what they carry depends on how the wall came to be. An arch
/// has none, as its radial joints carry the thrust.
pub fn is_needed(scene: &Scene) -> bool {
    let head = |joint: &Joint| joint.class == JointClass::Head;
    scene.head_joints() == HeadJoints::Contact && scene.joints().iter().any(head)
}

/// The lowest lower and the highest upper value over both directions and several stiffnesses.
pub fn over_variations(scene: &Scene, settings: &PushoverSettings) -> Outcome {
    let undecided = |fact: PushoverFact| Outcome::without_number(Status::Undecided, fact);
    let blocks = scene.blocks().len();
    if blocks > BLOCKS && !settings.long_ranges {
        let pushovers = 2 * STIFFNESSES.len();
        return undecided(PushoverFact::RangeNotRun { pushovers, blocks });
    }
    let Ok(mirror) = scene.mirrored() else {
        return undecided(PushoverFact::NoMirror);
    };
    let mut runs = Vec::new();
    for stiffness in STIFFNESSES {
        // Stiffness goes with the square of the frequency.
        let change = |parameters: Parameters| Parameters {
            contact_frequency: parameters.contact_frequency * stiffness.sqrt(),
            ..parameters
        };
        for (side, mirrored) in [(scene, false), (&mirror, true)] {
            let variation = Variation {
                stiffness,
                mirrored,
            };
            runs.push((variation, solve_with(side, settings, change)));
        }
    }
    joined(runs)
}

/// One outcome of all; without a number where one of them has none.
fn joined(runs: Vec<(Variation, Outcome)>) -> Outcome {
    let block_steps = runs.iter().map(|(_, run)| run.work.block_steps).sum();
    let checks = runs.iter().flat_map(|(variation, run)| {
        run.checks.iter().map(|check| SelfCheck {
            variation: Some(*variation),
            ..check.clone()
        })
    });
    let checks: Vec<SelfCheck> = checks.collect();
    let brackets: Option<Vec<Bracket>> = runs.iter().map(|(_, run)| run.bracket).collect();
    let mut outcome = match brackets {
        Some(brackets) => Outcome {
            checks,
            ..range(&runs, &brackets)
        },
        None => Outcome {
            checks,
            facts: why_none(&runs),
            ..Outcome::of(Status::Undecided)
        },
    };
    outcome.work.block_steps = block_steps;
    outcome
}

fn why_none(runs: &[(Variation, Outcome)]) -> Vec<Fact> {
    let mut facts = Vec::new();
    for (variation, run) in runs.iter().filter(|(_, run)| run.bracket.is_none()) {
        facts.push(PushoverFact::Without(*variation).into());
        facts.extend(run.facts.clone());
    }
    facts
}

fn range(runs: &[(Variation, Outcome)], brackets: &[Bracket]) -> Outcome {
    let lowers = brackets.iter().map(|b| b.lower);
    let uppers = brackets.iter().map(|b| b.upper);
    let cracks: Vec<_> = runs.iter().map(|(_, run)| run.crack).collect();
    let same = cracks.windows(2).all(|pair| pair[0] == pair[1]);
    let fact = PushoverFact::Range { softest: SOFTEST };
    Outcome {
        bracket: Some(Bracket {
            lower: lowers.fold(f64::INFINITY, f64::min),
            upper: uppers.fold(0.0, f64::max),
        }),
        stated_error: runs.iter().find_map(|(_, run)| run.stated_error),
        crack: cracks.first().copied().flatten().filter(|_| same),
        ..Outcome::without_number(Status::Bracketed, fact)
    }
}
