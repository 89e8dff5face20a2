//! Checks that cost further runs: half the substep, the mirrored scene, no kinetic damping.

use super::checks::repetition_agrees;
use super::observing::observing;
use super::parameters::Parameters;
use super::run::solve_with;
use crate::answer::{Fact, Outcome, PushoverFact, Repetition, SelfCheck, Status};
use crate::method::PushoverSettings;
use crate::scene::Scene;

/// An outcome after [`verify`]: the figures join its checks, and without agreement it loses its
/// number.
pub fn confirmed(scene: &Scene, settings: &PushoverSettings, mut outcome: Outcome) -> Outcome {
    if outcome.bracket().is_none() {
        return outcome;
    }
    let repeated = verify(scene, settings, &outcome);
    let checks = [outcome.evidence.checks(), &repeated].concat();
    if let Some(failed) = repeated.iter().find(|check| !check.passed()) {
        let fact = PushoverFact::VerificationFailed(failed.clone());
        let refused = Outcome {
            work: outcome.work,
            ..Outcome::without_number(Status::Undecided, fact)
        };
        return observing(refused, |observed| observed.checks = checks);
    }
    let agreed = repeated.into_iter().map(PushoverFact::Checked);
    outcome.facts.extend(agreed.map(Fact::from));
    observing(outcome, |observed| observed.checks = checks)
}

/// Repeats a bracketed pushover with half the substep, on the mirrored scene and without kinetic
/// damping. Empty where `outcome` has no bracket.
pub fn verify(scene: &Scene, settings: &PushoverSettings, outcome: &Outcome) -> Vec<SelfCheck> {
    let (Some(bracket), Some(error)) = (outcome.bracket(), outcome.evidence.stated_error()) else {
        return Vec::new();
    };
    let repeated = |with: Repetition| {
        let run = match with {
            Repetition::HalfSubstep => solve_with(scene, settings, |own| own.halved(1)),
            Repetition::Undamped => solve_with(scene, settings, Parameters::undamped),
            Repetition::Mirrored => match scene.mirrored() {
                Ok(mirror) => solve_with(&mirror, settings, |own| own),
                Err(error) => Outcome::without_number(Status::Undecided, error.to_string()),
            },
        };
        let answer = run.bracket().ok_or_else(|| run.reason());
        repetition_agrees(bracket, with, answer, scene.multiplier_unit(), error)
    };
    use Repetition::{HalfSubstep, Mirrored, Undamped};
    [HalfSubstep, Mirrored, Undamped].map(repeated).to_vec()
}

#[cfg(test)]
mod tests {
    use super::super::Pushover;
    use super::*;
    use crate::answer::Bracket;
    use crate::method::{Method, Settings};
    use crate::scene::{HeadJoints, Wall};

    /// A column of five, λ = 0.4 in closed form.
    #[test]
    fn verification_passes_on_a_column_and_fails_on_a_foreign_bracket() {
        let scene = Wall::laid([1.0, 0.5], 0.65, &["1"; 5])
            .scene(HeadJoints::Open)
            .unwrap();
        let all = |outcome: &Outcome, passed: bool| {
            let checks = verify(&scene, &PushoverSettings::default(), outcome);
            checks.iter().all(|check| check.passed() == passed)
        };
        let mut outcome = Pushover.solve(&scene, &Settings::default());
        assert!(all(&outcome, true));
        outcome = observing(outcome, |seen| seen.bracket = Some(Bracket::point(0.41)));
        assert!(all(&outcome, false));
    }
}
