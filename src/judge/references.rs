//! What must hold against the references of a case.

use super::check::{Check, Verdict};
use super::cross_check::Answers;
use crate::case::{Case, Quantity, Reference};
use crate::method::{Bracket, Outcome, Status};
use crate::scene::HeadJoints;

/// The computed value that a reference is about, as a bracket.
pub fn computed(outcome: &Outcome, quantity: Quantity) -> Option<Bracket> {
    let crack = |value: fn(&crate::mechanism::Crack) -> Option<f64>| {
        outcome.crack.as_ref().and_then(value).map(Bracket::point)
    };
    match quantity {
        Quantity::Lambda => outcome.bracket,
        Quantity::Lower => outcome.bracket.map(|b| Bracket::point(b.lower)),
        Quantity::Upper => outcome.bracket.map(|b| Bracket::point(b.upper)),
        Quantity::TanBeta => crack(|c| Some(c.tan_beta)),
        Quantity::C => crack(|c| c.c),
        Quantity::E => crack(|c| c.e),
    }
}

/// Every reference of the case that speaks of this scene and of a method that ran.
pub fn reference_checks(case: &Case, head_joints: HeadJoints, answers: &Answers) -> Vec<Check> {
    let mut checks = Vec::new();
    for reference in &case.references {
        if reference
            .head_joints
            .is_some_and(|only| only != head_joints)
        {
            continue;
        }
        let Some((_, outcome)) = answers.iter().find(|(name, _)| *name == reference.method) else {
            continue;
        };
        checks.push(reference_check(reference, head_joints, outcome));
    }
    checks
}

fn reference_check(reference: &Reference, head_joints: HeadJoints, outcome: &Outcome) -> Check {
    let label = format!(
        "{} {} {} {}",
        reference.method,
        reference.quantity.name(),
        reference.kind.name(),
        crate::record::short(reference.value, 6)
    );
    let Some(value) = computed(outcome, reference.quantity) else {
        let text = format!("{label}: no value, {}", outcome.status.name());
        // A method that declines or cannot decide contradicts nothing; one that broke does.
        let verdict = match outcome.status {
            Status::Failed | Status::Falls | Status::Stands => Verdict::Violated,
            _ => Verdict::NotDecided,
        };
        return Check {
            head_joints,
            method: reference.method.clone(),
            text,
            verdict,
        };
    };
    let error = value.error(reference.value);
    // Rounding of the sum must not decide: half a printed digit is a common tolerance.
    let allowed = reference.tolerance * (1.0 + 1e-9) + 1e-12;
    let distance = (value.lower - reference.value)
        .abs()
        .max((value.upper - reference.value).abs());
    let text = format!(
        "{label}: error {} % ({})",
        crate::record::number(100.0 * error, 2),
        reference.source
    );
    let verdict = match (distance <= allowed, &reference.deviation) {
        (true, None) => Verdict::Holds,
        // It is met after all: the case's reason is out of date.
        (true, Some(_)) => Verdict::Marked,
        (false, Some(_)) => Verdict::Deviates,
        (false, None) => Verdict::Violated,
    };
    let text = match (&reference.deviation, verdict) {
        (Some(why), Verdict::Deviates) => format!("{text}: {why}"),
        (Some(_), Verdict::Marked) => {
            format!("{text}: met, although the case calls it a deviation")
        }
        _ => text,
    };
    Check {
        head_joints,
        method: reference.method.clone(),
        text,
        verdict,
    }
}
