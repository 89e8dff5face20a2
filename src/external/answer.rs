//! The answer as JSON, and the outcome that it becomes.

use schemars::JsonSchema;
use serde::Deserialize;

use crate::answer::{
    Bracket, Claim, JointForce, Mechanism, Motion, Outcome, Status, VELOCITY_THRESHOLDS,
    crack_slope, kinematic_multiplier,
};
use crate::scene::{Scene, Vector};

/// The answer to one scene, in its units: one JSON object. Forces and velocities come in the order
/// of the scene's joints and blocks. What an answer claims to prove is recomputed from them.
#[derive(Clone, Debug, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(title = "trilith answer")]
pub struct AnswerFile {
    /// What the answer is.
    pub kind: Kind,
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
pub enum Kind {
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
    /// No multiplier is too large: `forces` at λ = 0 and a `ray`.
    Stands,
    /// The scene does not stand under its dead load: `velocities`.
    Falls,
    /// No answer; say why in `reason`.
    Undecided,
    /// The scene is outside what the program can treat; say why in `reason`.
    NotApplicable,
}

/// Longest reason that is kept, in characters.
const LONGEST: usize = 300;

/// The outcome of an answer.
///
/// # Errors
/// What is wrong with it, in words.
pub(super) fn outcome(scene: &Scene, output: &[u8]) -> Result<Outcome, String> {
    let answer: AnswerFile = serde_json::from_slice(output).map_err(|error| {
        let text = String::from_utf8_lossy(output);
        let begins = super::process::shown(text.trim(), 60);
        match begins.is_empty() {
            true => "wrote nothing to standard output".to_owned(),
            false => format!("its output is no answer: {error}; it begins with `{begins}`"),
        }
    })?;
    let forces = answer
        .forces
        .as_deref()
        .map(|list| forces(scene, list, "forces"));
    let ray = answer.ray.as_deref().map(|list| forces_of_ray(scene, list));
    let velocities = answer.velocities.as_deref();
    let mechanism = velocities.map(|list| mechanism(scene, list)).transpose()?;
    let reason = super::process::shown(answer.reason.as_deref().unwrap_or_default(), LONGEST);
    let whole = Outcome {
        claim: match answer.kind {
            Kind::Associative => Claim::Associative,
            _ => Claim::CollapseState,
        },
        bracket: bracket(scene, &answer, mechanism.as_ref())?,
        crack: (mechanism.as_ref()).and_then(|m| crack_slope(scene, m, VELOCITY_THRESHOLDS)),
        mechanism,
        forces: forces.transpose()?,
        ray: ray.transpose()?,
        ..Outcome::without_number(status(answer.kind), reason)
    };
    Ok(whole)
}

fn status(kind: Kind) -> Status {
    match kind {
        Kind::Associative | Kind::CollapseState => Status::Verified,
        Kind::Estimate => Status::Estimate,
        Kind::Stands => Status::Stands,
        Kind::Falls => Status::Falls,
        Kind::Undecided => Status::Undecided,
        Kind::NotApplicable => Status::NotApplicable,
    }
}

/// The multiplier that an answer of its kind has to have.
fn bracket(
    scene: &Scene,
    answer: &AnswerFile,
    mechanism: Option<&Mechanism>,
) -> Result<Option<Bracket>, String> {
    let needs = |what: &str| format!("an answer of this kind needs {what}");
    let one = answer.lambda.ok_or_else(|| needs("`lambda`"));
    if answer.upper.is_some() && answer.kind != Kind::Estimate {
        return Err("`upper` goes with the kind `estimate` only".to_owned());
    }
    let proof = answer.forces.is_some() && mechanism.is_some();
    match answer.kind {
        Kind::Associative | Kind::CollapseState if !proof => Err(needs(
            "`forces` and `velocities`; a number alone is an `estimate`",
        )),
        Kind::Associative => {
            let lower = one?;
            let upper = mechanism.map_or(f64::NAN, |m| kinematic_multiplier(scene, m));
            // Ends that cross by rounding are one number.
            let rounding = lower > upper && lower - upper <= 1e-9 * upper.abs().max(1e-3);
            Ok(Some(Bracket {
                lower: if rounding { upper } else { lower },
                upper,
            }))
        }
        Kind::CollapseState => Ok(Some(Bracket::point(one?))),
        Kind::Estimate => {
            let lower = one?;
            let upper = answer.upper.unwrap_or(lower);
            match lower <= upper {
                true => Ok(Some(Bracket { lower, upper })),
                false => Err(format!("`lambda` {lower} is above `upper` {upper}")),
            }
        }
        Kind::Stands | Kind::Falls | Kind::Undecided | Kind::NotApplicable => Ok(None),
    }
}

fn counted<T>(list: &[T], count: usize, what: &str, of: &str) -> Result<(), String> {
    match list.len() == count {
        true => Ok(()),
        false => Err(format!(
            "`{what}` has {} entries, the scene has {count} {of}",
            list.len()
        )),
    }
}

fn forces(scene: &Scene, list: &[[f64; 3]], what: &str) -> Result<Vec<JointForce>, String> {
    counted(list, scene.joints().len(), what, "joints")?;
    let force = |&[n1, n2, shear]: &[f64; 3]| JointForce {
        normal: [n1, n2],
        shear,
    };
    Ok(list.iter().map(force).collect())
}

fn forces_of_ray(scene: &Scene, list: &[[f64; 3]]) -> Result<Vec<JointForce>, String> {
    forces(scene, list, "ray")
}

fn mechanism(scene: &Scene, list: &[[f64; 3]]) -> Result<Mechanism, String> {
    counted(list, scene.blocks().len(), "velocities", "blocks")?;
    let motion = |&[x, y, rotation]: &[f64; 3]| Motion {
        velocity: Vector::new(x, y),
        rotation,
    };
    Ok(Mechanism {
        motions: list.iter().map(motion).collect(),
    })
}
