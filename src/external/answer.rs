//! The answer as JSON.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// The answer to one scene, in its units: one JSON object. Forces and velocities come in the order
/// of the scene's joints and blocks. What an answer claims to prove is recomputed from them.
#[derive(Clone, Debug, Default, PartialEq, Deserialize, Serialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(title = "trilith answer")]
pub struct AnswerFile {
    /// What the answer is; where it is left out, an estimate.
    #[serde(default)]
    pub kind: AnswerKind,
    /// The multiplier; with `upper`, the lower end of a bracket.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub lambda: Option<f64>,
    /// The upper end of a bracket; only with the kind "estimate".
    #[serde(skip_serializing_if = "Option::is_none")]
    pub upper: Option<f64>,
    /// Error of the multiplier that the program itself states, relative to it (0.002 is 0.2 %); only
    /// with the kind "estimate".
    #[serde(skip_serializing_if = "Option::is_none")]
    pub stated_error: Option<f64>,
    /// [n1, n2, t] of every joint: normal forces at its two ends, compression positive, and the
    /// shear on the block that the normal points into, along the tangent.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub forces: Option<Vec<[f64; 3]>>,
    /// [x, y, rotation] of every block: velocity of its centroid and rotation rate. Only ratios
    /// count.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub velocities: Option<Vec<[f64; 3]>>,
    /// With the kinds "stands": forces as in `forces` that balance the live load for λ = 1 and
    /// nothing else.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub ray: Option<Vec<[f64; 3]>>,
    /// With the kind "enclosed": velocities as in `velocities` that open every joint by at least the
    /// coefficient of friction times its slip.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub ceiling: Option<Vec<[f64; 3]>>,
    /// Why, in words.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub reason: Option<String>,
}

impl AnswerFile {
    /// An answer that is nothing but its kind, to be filled in.
    pub(super) fn of(kind: AnswerKind) -> Self {
        Self {
            kind,
            ..Self::default()
        }
    }
}

/// What an answer is, and which of the other keys it needs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize, Serialize, JsonSchema)]
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
    /// A collapse state without dilatancy at `lambda` as above, and a `ceiling`, whose multiplier
    /// bounds every collapse multiplier from above.
    Enclosed,
    /// A number without a proof: `lambda`, or `lambda` to `upper`, and `stated_error` where the
    /// program knows it. Forces and velocities may come along; should they be a collapse state, the
    /// answer is verified after all.
    #[default]
    Estimate,
    /// No multiplier is too large for associative friction: `forces` at λ = 0 and a `ray`. Methods of trilith
    /// without dilatancy answer so where a certificate, a file of its own, proves that no collapse state exists.
    Stands,
    /// No multiplier is too large for friction without dilatancy: as "stands", and the `ray` holds
    /// without friction, so that every shear in it is 0.
    StandsWithoutDilatancy,
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
