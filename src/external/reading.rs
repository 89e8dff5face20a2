//! The outcome that an answer becomes.

use super::answer::{AnswerFile, AnswerKind};
use super::text::shortened;
use crate::answer::{Bracket, Claim, Fact, Outcome, ProgramFailure, Status};
use crate::mechanics::{
    JointForce, Mechanism, Motion, VELOCITY_THRESHOLDS, crack_slope, kinematic_multiplier,
};
use crate::scene::{Scene, Vector};

/// Longest reason that is kept, in characters.
const REASON_LENGTH: usize = 300;

/// Characters of an output that is no answer, which a failure shows.
const BEGINNING: usize = 60;

/// The outcome of an answer.
///
/// # Errors
/// What is wrong with it.
pub(super) fn outcome(scene: &Scene, output: &[u8]) -> Result<Outcome, ProgramFailure> {
    let answer: AnswerFile =
        serde_json::from_slice(output).map_err(|error| no_answer(&error, output))?;
    let of_joints = |list: &Option<Vec<[f64; 3]>>, key| {
        let list = list.as_deref();
        list.map(|list| forces(scene, list, key))
    };
    let forces = of_joints(&answer.forces, "forces");
    let ray = of_joints(&answer.ray, "ray");
    let of_blocks = |list: &Option<Vec<[f64; 3]>>, key| {
        let list = list.as_deref();
        list.map(|list| mechanism(scene, list, key)).transpose()
    };
    let mechanism = of_blocks(&answer.velocities, "velocities")?;
    let ceiling = of_blocks(&answer.ceiling, "ceiling")?;
    let reason = shortened(answer.reason.as_deref().unwrap_or_default(), REASON_LENGTH);
    let claim = match answer.kind {
        // A ray within friction proves that no multiplier is too large for associative friction.
        AnswerKind::Associative | AnswerKind::Stands => Claim::Associative,
        AnswerKind::Enclosed => Claim::Enclosed,
        AnswerKind::CollapseState
        | AnswerKind::Estimate
        | AnswerKind::StandsWithoutDilatancy
        | AnswerKind::Falls
        | AnswerKind::Undecided
        | AnswerKind::NotApplicable => Claim::CollapseState,
    };
    if answer.kind != AnswerKind::Estimate
        && (answer.upper.is_some() || answer.stated_error.is_some())
    {
        return Err(ProgramFailure::UpperOfAProof);
    }
    if let Some(error) = answer
        .stated_error
        .filter(|error| !(0.0..=1.0).contains(error))
    {
        return Err(ProgramFailure::NoRelativeError { error });
    }
    Ok(Outcome {
        claim,
        bracket: bracket(scene, &answer, mechanism.as_ref(), ceiling.as_ref())?,
        stated_error: answer.stated_error,
        crack: (mechanism.as_ref()).and_then(|m| crack_slope(scene, m, VELOCITY_THRESHOLDS)),
        mechanism,
        forces: forces.transpose()?,
        ray: ray.transpose()?,
        ceiling,
        ..Outcome::without_number(status(answer.kind), Fact::Words(reason))
    })
}

fn no_answer(error: &serde_json::Error, output: &[u8]) -> ProgramFailure {
    let text = String::from_utf8_lossy(output);
    let begins = shortened(text.trim(), BEGINNING);
    if begins.is_empty() {
        return ProgramFailure::NoOutput;
    }
    let error = error.to_string();
    ProgramFailure::NotAnAnswer { error, begins }
}

fn status(kind: AnswerKind) -> Status {
    match kind {
        AnswerKind::Associative | AnswerKind::CollapseState | AnswerKind::Enclosed => {
            Status::Verified
        }
        AnswerKind::Estimate => Status::Estimate,
        AnswerKind::Stands | AnswerKind::StandsWithoutDilatancy => Status::Stands,
        AnswerKind::Falls => Status::Falls,
        AnswerKind::Undecided => Status::Undecided,
        AnswerKind::NotApplicable => Status::NotApplicable,
    }
}

/// The multiplier that an answer of its kind has to have.
fn bracket(
    scene: &Scene,
    answer: &AnswerFile,
    mechanism: Option<&Mechanism>,
    ceiling: Option<&Mechanism>,
) -> Result<Option<Bracket>, ProgramFailure> {
    let needs = |keys: &'static str| ProgramFailure::MissingKeys { keys: keys.into() };
    let one = answer.lambda.ok_or(needs("`lambda`"));
    let proof = answer.forces.is_some() && mechanism.is_some();
    match answer.kind {
        AnswerKind::Associative | AnswerKind::CollapseState if !proof => Err(needs(
            "`forces` and `velocities`; a number alone is an `estimate`",
        )),
        AnswerKind::Enclosed if !proof || ceiling.is_none() => {
            Err(needs("`forces`, `velocities` and `ceiling`"))
        }
        AnswerKind::Associative => Ok(Some(below(scene, one?, mechanism))),
        AnswerKind::Enclosed => Ok(Some(below(scene, one?, ceiling))),
        AnswerKind::CollapseState => Ok(Some(Bracket::point(one?))),
        AnswerKind::Estimate => {
            let lower = one?;
            let upper = answer.upper.unwrap_or(lower);
            if lower <= upper {
                Ok(Some(Bracket { lower, upper }))
            } else {
                Err(ProgramFailure::EndsCross { lower, upper })
            }
        }
        AnswerKind::Stands
        | AnswerKind::StandsWithoutDilatancy
        | AnswerKind::Falls
        | AnswerKind::Undecided
        | AnswerKind::NotApplicable => Ok(None),
    }
}

/// From a multiplier to that of a mechanism that bounds it from above.
fn below(scene: &Scene, lower: f64, ceiling: Option<&Mechanism>) -> Bracket {
    let upper = ceiling.map_or(f64::NAN, |m| kinematic_multiplier(scene, m));
    // Ends that cross by rounding are one number.
    let rounding = lower > upper && lower - upper <= 1e-9 * upper.abs().max(1e-3);
    Bracket {
        lower: if rounding { upper } else { lower },
        upper,
    }
}

fn check_length<T>(
    list: &[T],
    expected: usize,
    key: &'static str,
    of: &'static str,
) -> Result<(), ProgramFailure> {
    if list.len() == expected {
        Ok(())
    } else {
        Err(ProgramFailure::WrongLength {
            key: key.into(),
            entries: list.len(),
            expected,
            of: of.into(),
        })
    }
}

fn forces(
    scene: &Scene,
    list: &[[f64; 3]],
    key: &'static str,
) -> Result<Vec<JointForce>, ProgramFailure> {
    check_length(list, scene.joints().len(), key, "joints")?;
    let force = |&[n1, n2, shear]: &[f64; 3]| JointForce {
        normal: [n1, n2],
        shear,
    };
    Ok(list.iter().map(force).collect())
}

fn mechanism(
    scene: &Scene,
    list: &[[f64; 3]],
    key: &'static str,
) -> Result<Mechanism, ProgramFailure> {
    check_length(list, scene.blocks().len(), key, "blocks")?;
    let motion = |&[x, y, rotation]: &[f64; 3]| Motion {
        velocity: Vector::new(x, y),
        rotation,
    };
    Ok(Mechanism {
        motions: list.iter().map(motion).collect(),
    })
}
