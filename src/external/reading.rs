//! The outcome that an answer becomes.

use super::answer::{AnswerFile, AnswerKind};
use super::process::shortened;
use crate::answer::{Bracket, Evidence, Fact, Outcome, ProgramFailure, Standing, Status};
use crate::mechanics::{
    Ceiling, CollapseState, ForceState, JointForce, Mechanism, Motion, kinematic_multiplier,
};
use crate::scene::Scene;

/// Longest reason that is kept, in characters.
const REASON_LENGTH: usize = 300;

/// Characters of an output that is no answer, which a failure shows.
const BEGINNING: usize = 60;

/// The outcome of an answer.
pub(super) fn outcome(scene: &Scene, output: &[u8]) -> Result<Outcome, ProgramFailure> {
    let answer = match serde_json::from_slice(output) {
        Ok(lambda) => AnswerFile {
            lambda: Some(lambda),
            ..AnswerFile::of(AnswerKind::Estimate)
        },
        Err(_) => serde_json::from_slice(output).map_err(|error| no_answer(&error, output))?,
    };
    let reason = shortened(answer.reason.as_deref().unwrap_or_default(), REASON_LENGTH);
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
        evidence: evidence(scene, &answer)?,
        ..Outcome::without_number(status(answer.kind), Fact::Words(reason))
    })
}

/// What an answer of its kind has to have, each list as long as the scene asks for; `Nothing` where
/// what would prove `falls` or `stands` is missing, which is the judge's to say.
fn evidence(scene: &Scene, answer: &AnswerFile) -> Result<Evidence, ProgramFailure> {
    let of_joints = |list, key| list_of(list, scene.joints().len(), [key, "joints"], force);
    let of_blocks = |list, key| {
        let motion = |numbers: &[f64; 3]| Motion::from(*numbers);
        let motions = list_of(list, scene.blocks().len(), [key, "blocks"], motion)?;
        Ok(motions.map(|motions| Mechanism { motions }))
    };
    let velocities = of_blocks(&answer.velocities, "velocities")?;
    let ceiling = of_blocks(&answer.ceiling, "ceiling")?;
    let forces = of_joints(&answer.forces, "forces")?;
    let ray = of_joints(&answer.ray, "ray")?;
    let needs = |keys: &'static str| ProgramFailure::MissingKeys { keys: keys.into() };
    let two = "`forces` and `velocities`; a number alone is an `estimate`";
    let lambda = || answer.lambda.ok_or(needs("`lambda`"));
    Ok(match answer.kind {
        AnswerKind::Associative => {
            let (forces, mechanism) = forces.zip(velocities).ok_or(needs(two))?;
            let (lambda, above) = below(scene, lambda()?, mechanism);
            Evidence::Bounds {
                below: ForceState { lambda, forces },
                above,
            }
        }
        AnswerKind::CollapseState => {
            let (forces, mechanism) = forces.zip(velocities).ok_or(needs(two))?;
            Evidence::State {
                state: CollapseState {
                    lambda: lambda()?,
                    forces,
                    mechanism,
                },
                stated_error: None,
            }
        }
        AnswerKind::Enclosed => {
            let all = forces.zip(velocities).zip(ceiling);
            let ((forces, mechanism), ceiling) =
                all.ok_or(needs("`forces`, `velocities` and `ceiling`"))?;
            let (lambda, ceiling) = below(scene, lambda()?, ceiling);
            Evidence::Enclosed {
                state: CollapseState {
                    lambda,
                    forces,
                    mechanism,
                },
                ceiling,
            }
        }
        AnswerKind::Estimate => Evidence::Number {
            bracket: range(lambda()?, answer.upper)?,
            stated_error: answer.stated_error,
            forces: (forces.zip(answer.lambda))
                .map(|(forces, lambda)| ForceState { lambda, forces }),
            mechanism: velocities,
        },
        AnswerKind::Falls => {
            velocities.map_or(Evidence::Nothing, |mechanism| Evidence::Falls { mechanism })
        }
        AnswerKind::Stands | AnswerKind::StandsWithoutDilatancy => {
            forces.zip(ray).map_or(Evidence::Nothing, |(at_rest, ray)| {
                // A ray within friction proves that no multiplier is too large for associative friction.
                Evidence::Stands {
                    standing: match answer.kind {
                        AnswerKind::Stands => Standing::Associative,
                        _ => Standing::WithoutFriction,
                    },
                    at_rest,
                    ray,
                }
            })
        }
        AnswerKind::Undecided | AnswerKind::NotApplicable => Evidence::Nothing,
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

fn range(lower: f64, upper: Option<f64>) -> Result<Bracket, ProgramFailure> {
    let upper = upper.unwrap_or(lower);
    if lower <= upper {
        Ok(Bracket { lower, upper })
    } else {
        Err(ProgramFailure::EndsCross { lower, upper })
    }
}

/// A multiplier and a mechanism that bounds it from above.
fn below(scene: &Scene, lower: f64, mechanism: Mechanism) -> (f64, Ceiling) {
    let upper = kinematic_multiplier(scene, &mechanism);
    // Ends that cross by rounding are one number.
    let rounding = lower > upper && lower - upper <= 1e-9 * upper.abs().max(1e-3);
    let lower = if rounding { upper } else { lower };
    let lambda = upper;
    (lower, Ceiling { lambda, mechanism })
}

fn force(&[n1, n2, shear]: &[f64; 3]) -> JointForce {
    let normal = [n1, n2];
    JointForce { normal, shear }
}

/// The list of this key, an entry for each of the scene's joints or blocks.
fn list_of<T>(
    list: &Option<Vec<[f64; 3]>>,
    expected: usize,
    [key, of]: [&'static str; 2],
    entry: fn(&[f64; 3]) -> T,
) -> Result<Option<Vec<T>>, ProgramFailure> {
    match list {
        Some(list) if list.len() != expected => Err(ProgramFailure::WrongLength {
            key: key.into(),
            entries: list.len(),
            expected,
            of: of.into(),
        }),
        list => Ok(list.as_ref().map(|list| list.iter().map(entry).collect())),
    }
}
