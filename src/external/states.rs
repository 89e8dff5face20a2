//! What a method of our own answers, in the format of outside answers: whatever can be recomputed
//! from forces and velocities, by any program.

use super::answer::{AnswerFile, AnswerKind};
use crate::answer::{Claim, Outcome, Status};
use crate::mechanics::{CollapseState, JointForce, Mechanism};

/// The judged outcome as answers: none where it answers nothing, several where it rests on several
/// collapse states, lowest λ first.
pub fn answers(outcome: &Outcome) -> Vec<AnswerFile> {
    if !outcome.states.is_empty() && outcome.bracket.is_some() {
        return outcome.states.iter().map(state).collect();
    }
    kind(outcome).map_or_else(Vec::new, |kind| vec![answer(outcome, kind)])
}

fn state(state: &CollapseState) -> AnswerFile {
    AnswerFile {
        lambda: Some(state.lambda),
        forces: Some(forces(&state.forces)),
        velocities: Some(velocities(&state.mechanism)),
        ..AnswerFile::of(AnswerKind::CollapseState)
    }
}

/// What the outcome is put forward as; `None` where it is no answer.
fn kind(outcome: &Outcome) -> Option<AnswerKind> {
    let by_claim = match outcome.claim {
        Claim::Associative => AnswerKind::Associative,
        Claim::CollapseState => AnswerKind::CollapseState,
        Claim::Enclosed => AnswerKind::Enclosed,
        // The lower bound has a file of its own; the state is at the upper end.
        Claim::Bounded => AnswerKind::CollapseState,
        Claim::Observed => AnswerKind::Estimate,
    };
    match outcome.status {
        Status::Verified | Status::Bracketed => Some(by_claim),
        // Both ends are proved, and far apart.
        Status::Undecided if outcome.claim == Claim::Enclosed && outcome.bracket.is_some() => {
            Some(by_claim)
        }
        Status::Estimate => Some(AnswerKind::Estimate),
        Status::Stands if outcome.claim == Claim::Associative => Some(AnswerKind::Stands),
        Status::Stands => Some(AnswerKind::StandsWithoutDilatancy),
        Status::Falls => Some(AnswerKind::Falls),
        Status::Undecided | Status::NotApplicable | Status::Failed => None,
    }
}

fn answer(outcome: &Outcome, kind: AnswerKind) -> AnswerFile {
    let estimate = kind == AnswerKind::Estimate;
    let bracket = outcome.bracket;
    AnswerFile {
        lambda: bracket.map(|bracket| bracket.lower),
        upper: bracket.map(|bracket| bracket.upper).filter(|_| estimate),
        stated_error: outcome.stated_error.filter(|_| estimate),
        forces: outcome.forces.as_deref().map(forces),
        velocities: outcome.mechanism.as_ref().map(velocities),
        ray: outcome.ray.as_deref().map(forces),
        ceiling: outcome.ceiling.as_ref().map(velocities),
        ..AnswerFile::of(kind)
    }
}

fn forces(list: &[JointForce]) -> Vec<[f64; 3]> {
    let numbers = |force: &JointForce| [force.normal[0], force.normal[1], force.shear];
    list.iter().map(numbers).collect()
}

fn velocities(mechanism: &Mechanism) -> Vec<[f64; 3]> {
    let motions = mechanism.motions.iter();
    motions
        .map(|m| [m.velocity.x, m.velocity.y, m.rotation])
        .collect()
}
