//! Checks that cost further runs: half the substep, the mirrored scene, no kinetic damping.

use super::checks::{Check, agree};
use super::parameters::Parameters;
use super::solve_with;
use crate::answer::{Outcome, Status};
use crate::method::PushoverSettings;
use crate::scene::{PolygonError, Scene};

/// An outcome after [`verify`]: the figures join its checks, and without agreement it loses its
/// number. A range over variations is compared with nothing, it is a comparison already.
pub fn confirmed(scene: &Scene, settings: &PushoverSettings, outcome: Outcome) -> Outcome {
    let (Some(_), false) = (outcome.bracket, super::has_perpends(scene)) else {
        return outcome;
    };
    let checks = verify(scene, settings, &outcome);
    let mut texts = outcome.checks.clone();
    texts.extend(checks.iter().map(|check| check.text.clone()));
    if let Some(failed) = checks.iter().find(|check| !check.passed) {
        let reason = format!("a check under --verify failed: {}", failed.text);
        return Outcome {
            checks: texts,
            work: outcome.work,
            ..Outcome::without_number(Status::Undecided, reason)
        };
    }
    let figures: Vec<&str> = checks.iter().map(|check| check.text.as_str()).collect();
    Outcome {
        facts: vec![figures.join("; ").into()],
        checks: texts,
        ..outcome
    }
}

/// Repeats a bracketed pushover with half the substep, on the mirrored scene and without kinetic
/// damping. Empty where `outcome` has no bracket.
pub fn verify(scene: &Scene, settings: &PushoverSettings, outcome: &Outcome) -> Vec<Check> {
    let (Some(bracket), Some(error)) = (outcome.bracket, outcome.stated_error) else {
        return Vec::new();
    };
    let runs = [
        (
            "half the substep",
            Ok(solve_with(scene, settings, Parameters::halved)),
        ),
        (
            "mirrored",
            scene
                .mirrored()
                .map(|m| solve_with(&m, settings, |own| own)),
        ),
        (
            "undamped",
            Ok(solve_with(scene, settings, Parameters::undamped)),
        ),
    ];
    let check = |(what, run): (&str, Result<Outcome, PolygonError>)| match run {
        Ok(run) => match run.bracket {
            Some(other) => agree(bracket, other, error, what),
            None => failed(what, &run.reason()),
        },
        Err(e) => failed(what, &e.to_string()),
    };
    runs.into_iter().map(check).collect()
}

fn failed(what: &str, reason: &str) -> Check {
    Check {
        passed: false,
        text: format!("{what}: {reason}"),
    }
}
