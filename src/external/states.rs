//! What a method of our own answers, in the format of outside answers: whatever can be recomputed
//! from forces and velocities, by any program.

use super::answer::{AnswerFile, AnswerKind};
use crate::answer::{Bracket, Evidence, Outcome, Standing, Status};
use crate::mechanics::{CollapseState, JointForce, Mechanism};

/// The judged outcome as answers: none where it answers nothing, several where it rests on several
/// collapse states, lowest λ first. What is an estimate says so, with all that came along.
pub fn answers(outcome: &Outcome) -> Vec<AnswerFile> {
    match outcome.status {
        Status::Falls if outcome.evidence.observed().is_some() => {
            vec![AnswerFile::of(AnswerKind::Falls)]
        }
        Status::Verified | Status::Bracketed | Status::Falls | Status::Stands => {
            proofs(&outcome.evidence)
        }
        // Both ends are proved, and far apart.
        Status::Undecided => match &outcome.evidence {
            enclosed @ Evidence::Enclosed { .. } => proofs(enclosed),
            _ => Vec::new(),
        },
        Status::Estimate => vec![estimate(&outcome.evidence)],
        Status::NotApplicable | Status::Failed => Vec::new(),
    }
}

/// What evidence proves, each set of forces with its own multiplier.
fn proofs(evidence: &Evidence) -> Vec<AnswerFile> {
    match evidence {
        Evidence::Nothing => Vec::new(),
        // The lower end of `Bounded` has a file of its own, the certificate.
        Evidence::States { .. } | Evidence::State { .. } | Evidence::Bounded { .. } => {
            evidence.states().iter().map(state).collect()
        }
        Evidence::Number { bracket, .. } => {
            let kind = AnswerKind::CollapseState;
            vec![AnswerFile {
                lambda: Some(bracket.lower),
                ..what_came(evidence, kind)
            }]
        }
        Evidence::Bounds { below, above, .. } => vec![AnswerFile {
            lambda: Some(below.lambda),
            forces: Some(forces(&below.forces)),
            velocities: Some(velocities(&above.mechanism)),
            ..AnswerFile::of(AnswerKind::Associative)
        }],
        Evidence::Enclosed {
            state: of, ceiling, ..
        } => vec![AnswerFile {
            kind: AnswerKind::Enclosed,
            ceiling: Some(velocities(&ceiling.mechanism)),
            ..state(of)
        }],
        Evidence::ClosedForm { .. } | Evidence::Observed(_) => vec![estimate(evidence)],
        Evidence::Falls { mechanism } => vec![AnswerFile {
            velocities: Some(velocities(mechanism)),
            ..AnswerFile::of(AnswerKind::Falls)
        }],
        Evidence::Stands {
            standing,
            at_rest,
            ray,
        } => vec![AnswerFile {
            forces: Some(forces(at_rest)),
            ray: Some(forces(ray)),
            // A certificate, beside a ray that needs friction, has a file of its own.
            ..AnswerFile::of(match standing {
                Standing::Associative | Standing::Certified { .. } => AnswerKind::Stands,
                Standing::WithoutFriction => AnswerKind::StandsWithoutDilatancy,
            })
        }],
    }
}

fn state(state: &CollapseState) -> AnswerFile {
    AnswerFile {
        lambda: Some(state.lambda),
        forces: Some(forces(&state.forces)),
        velocities: Some(velocities(&state.mechanism)),
        ..AnswerFile::of(AnswerKind::CollapseState)
    }
}

/// A number without a proof. Forces go with it only where they belong to its lower end.
fn estimate(evidence: &Evidence) -> AnswerFile {
    let Some(Bracket { lower, upper }) = evidence.bracket() else {
        return AnswerFile::of(AnswerKind::Estimate);
    };
    AnswerFile {
        lambda: Some(lower),
        upper: Some(upper),
        stated_error: evidence.stated_error(),
        ..what_came(evidence, AnswerKind::Estimate)
    }
}

/// Velocities, and the forces that belong to the lower end of the bracket.
fn what_came(evidence: &Evidence, kind: AnswerKind) -> AnswerFile {
    let lower = evidence.bracket().map(|bracket| bracket.lower);
    let at_lower = evidence.forces();
    let at_lower = at_lower.filter(|(lambda, _)| Some(*lambda) == lower);
    AnswerFile {
        forces: at_lower.map(|(_, list)| forces(list)),
        velocities: evidence.mechanism().map(velocities),
        ..AnswerFile::of(kind)
    }
}

fn forces(list: &[JointForce]) -> Vec<[f64; 3]> {
    let numbers = |force: &JointForce| [force.normal[0], force.normal[1], force.shear];
    list.iter().map(numbers).collect()
}

fn velocities(mechanism: &Mechanism) -> Vec<[f64; 3]> {
    mechanism.motions.iter().map(|&of| of.into()).collect()
}
