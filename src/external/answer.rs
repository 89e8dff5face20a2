//! The answer as JSON, and the outcome that it becomes.

use schemars::JsonSchema;
use serde::Deserialize;

use super::text::shortened;
use crate::answer::{
    Bracket, Claim, Fact, JointForce, Mechanism, Motion, Outcome, ProgramFailure, Status,
    VELOCITY_THRESHOLDS, crack_slope, kinematic_multiplier,
};
use crate::scene::{Scene, Vector};

/// The answer to one scene, in its units: one JSON object. Forces and velocities come in the order
/// of the scene's joints and blocks. What an answer claims to prove is recomputed from them.
#[derive(Clone, Debug, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(title = "trilith answer")]
pub struct AnswerFile {
    /// What the answer is.
    pub kind: AnswerKind,
    /// The multiplier; with `upper`, the lower end of a bracket.
    pub lambda: Option<f64>,
    /// The upper end of a bracket; only with the kind "estimate".
    pub upper: Option<f64>,
    /// [n1, n2, t] of every joint: normal forces at its two ends, compression positive, and the
    /// shear on the block that the normal points into, along the tangent.
    pub forces: Option<Vec<[f64; 3]>>,
    /// [x, y, rotation] of every block: velocity of its centroid and rotation rate. Only ratios
    /// count.
    pub velocities: Option<Vec<[f64; 3]>>,
    /// With the kind "stands": forces as in `forces` that balance the live load for λ = 1 and
    /// nothing else.
    pub ray: Option<Vec<[f64; 3]>>,
    /// Why, in words.
    pub reason: Option<String>,
}

/// What an answer is, and which of the other keys it needs.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
#[schemars(rename = "Kind")]
pub enum AnswerKind {
    /// Bounds of the multiplier by associative friction: `forces` admissible at `lambda`, and
    /// `velocities` that open every joint by at least the coefficient of friction times its slip.
    /// The upper end is the multiplier of the velocities.
    Associative,
    /// A collapse state without dilatancy: `forces` at `lambda` and `velocities` that do without
    /// any opening under force and any slip below full friction.
    CollapseState,
    /// A number without a proof: `lambda`, or `lambda` to `upper`. Forces and velocities may come
    /// along; should they be a collapse state, the answer is verified after all.
    Estimate,
    /// No multiplier is too large for associative friction: `forces` at λ = 0 and a `ray`.
    Stands,
    /// The scene does not stand under its dead load: `velocities`.
    Falls,
    /// No answer; say why in `reason`.
    Undecided,
    /// The scene is outside what the program can treat; say why in `reason`.
    NotApplicable,
}

/// JSON schema of the answer that a program writes.
pub fn answer_schema() -> schemars::Schema {
    schemars::schema_for!(AnswerFile)
}

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
    let velocities = answer.velocities.as_deref();
    let mechanism = velocities.map(|list| mechanism(scene, list)).transpose()?;
    let reason = shortened(answer.reason.as_deref().unwrap_or_default(), REASON_LENGTH);
    let claim = match answer.kind {
        // A ray within friction proves that no multiplier is too large for associative friction.
        AnswerKind::Associative | AnswerKind::Stands => Claim::Associative,
        _ => Claim::CollapseState,
    };
    Ok(Outcome {
        claim,
        bracket: bracket(scene, &answer, mechanism.as_ref())?,
        crack: (mechanism.as_ref()).and_then(|m| crack_slope(scene, m, VELOCITY_THRESHOLDS)),
        mechanism,
        forces: forces.transpose()?,
        ray: ray.transpose()?,
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
        AnswerKind::Associative | AnswerKind::CollapseState => Status::Verified,
        AnswerKind::Estimate => Status::Estimate,
        AnswerKind::Stands => Status::Stands,
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
) -> Result<Option<Bracket>, ProgramFailure> {
    let needs = |keys| ProgramFailure::MissingKeys { keys };
    let one = answer.lambda.ok_or(needs("`lambda`"));
    if answer.upper.is_some() && answer.kind != AnswerKind::Estimate {
        return Err(ProgramFailure::UpperOfAProof);
    }
    let proof = answer.forces.is_some() && mechanism.is_some();
    match answer.kind {
        AnswerKind::Associative | AnswerKind::CollapseState if !proof => Err(needs(
            "`forces` and `velocities`; a number alone is an `estimate`",
        )),
        AnswerKind::Associative => {
            let lower = one?;
            let upper = mechanism.map_or(f64::NAN, |m| kinematic_multiplier(scene, m));
            // Ends that cross by rounding are one number.
            let rounding = lower > upper && lower - upper <= 1e-9 * upper.abs().max(1e-3);
            Ok(Some(Bracket {
                lower: if rounding { upper } else { lower },
                upper,
            }))
        }
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
        | AnswerKind::Falls
        | AnswerKind::Undecided
        | AnswerKind::NotApplicable => Ok(None),
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
            key,
            entries: list.len(),
            expected,
            of,
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

fn mechanism(scene: &Scene, list: &[[f64; 3]]) -> Result<Mechanism, ProgramFailure> {
    check_length(list, scene.blocks().len(), "velocities", "blocks")?;
    let motion = |&[x, y, rotation]: &[f64; 3]| Motion {
        velocity: Vector::new(x, y),
        rotation,
    };
    Ok(Mechanism {
        motions: list.iter().map(motion).collect(),
    })
}
