//! The one row: a method's judged answer on a scene, with everything that tables, files, plots and
//! studies tell of it.

use serde::{Deserialize, Serialize};

use crate::answer::{Bracket, Outcome, Status};
use crate::case::{Case, Quantity, Reference};
use crate::judge::{Check, Recomputed, Verdict, computed, largest};
use crate::mechanics::Crack;
use crate::method::{Kind, kind};
use crate::number::short;
use crate::scene::{HeadJoints, Push};

/// The judged answer of one task. Files keep what its task and method say of it; what its case says is
/// found again when it is compared.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Row {
    /// Id of the task.
    pub id: String,
    /// Name of the case.
    pub case: String,
    /// Head joints of the scene.
    pub head_joints: HeadJoints,
    /// Direction of the push that the answer is about.
    pub push: Push,
    /// Name of the method.
    pub method: String,
    /// What varies in a study, by name.
    pub parameters: Vec<(String, String)>,
    /// Least and largest coefficient of friction of the scene's joints; `None` where it has none.
    pub friction: Option<[f64; 2]>,
    /// Blocks of the scene.
    pub blocks: usize,
    /// Joints of the scene.
    pub joints: usize,
    /// The scene's unit of λ ([`Scene::multiplier_unit`](crate::scene::Scene::multiplier_unit)),
    /// which tells what a small λ is.
    pub multiplier_unit: f64,
    /// The answer, its status set by the judge.
    pub outcome: Outcome,
    /// The answer for the other direction of a wall that is pushed both ways.
    pub stronger: Option<StrongerSide>,
    /// Residuals that the judge computed, where there was something to judge.
    pub residuals: Vec<Recomputed>,
    /// CPU time of the method over all sides, seconds. The only thing here that is not the same in
    /// every run.
    pub seconds: f64,
    /// The case's values about this row: known deviations last, published ones before others.
    #[serde(skip)]
    pub references: Vec<Reference>,
    /// The worst verdict about this row; `None` where there is nothing to compare it with.
    #[serde(skip)]
    pub verdict: Option<Verdict>,
}

/// Of a wall that is pushed both ways, the side that does not count.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct StrongerSide {
    /// Direction of its push.
    pub push: Push,
    /// The judged answer.
    pub outcome: Box<Outcome>,
}

impl Row {
    /// The row with what its case says of it, and the worst of the case's checks about it.
    pub(super) fn compare(&mut self, case: &Case, checks: &[Check]) {
        let about = |r: &&Reference| {
            r.method == self.method && r.head_joints.is_none_or(|only| only == self.head_joints)
        };
        self.references = case.references.iter().filter(about).cloned().collect();
        self.references
            .sort_by_key(|r| (r.deviation.is_some(), r.kind));
        let about =
            |check: &&Check| check.head_joints == self.head_joints && check.method == self.method;
        self.verdict = checks.iter().filter(about).map(|c| c.verdict).max();
    }

    /// Name of the scene: the case's, with `@open` where head joints are open.
    pub fn scene_name(&self) -> String {
        scene_name(&self.case, self.head_joints)
    }

    /// What the answer is worth.
    pub fn status(&self) -> Status {
        self.outcome.status
    }

    /// The multiplier, where there is one to vouch for.
    pub fn bracket(&self) -> Option<Bracket> {
        self.outcome.bracket()
    }

    /// The largest residual; `None` where there was nothing to judge.
    pub fn residual(&self) -> Option<f64> {
        largest(&self.residuals)
    }

    /// The crack, where there is one.
    pub fn crack(&self) -> Option<&Crack> {
        self.outcome.evidence.crack()
    }

    /// What kind of claim the answer is.
    pub fn kind(&self) -> Kind {
        kind(&self.method)
    }

    /// The value of a parameter.
    pub fn parameter(&self, name: &str) -> Option<&str> {
        let found = self.parameters.iter().find(|(known, _)| known == name);
        found.map(|(_, value)| value.as_str())
    }

    /// The first reference of a quantity.
    pub fn reference(&self, quantity: Quantity) -> Option<&Reference> {
        self.references.iter().find(|r| r.quantity == quantity)
    }

    /// The references of the multiplier that stand first: one, or those of the ends of a range.
    pub fn multiplier_references(&self) -> Vec<&Reference> {
        let one = self.reference(Quantity::Lambda).into_iter();
        let ends = [Quantity::Lower, Quantity::Upper];
        let ends = ends.into_iter().filter_map(|end| self.reference(end));
        let one: Vec<&Reference> = one.collect();
        if one.is_empty() { ends.collect() } else { one }
    }

    /// Error of the multiplier against those references, relative: the farther end counts.
    pub fn error(&self) -> Option<f64> {
        let errors = self.multiplier_references().into_iter().filter_map(|r| {
            let value = computed(&self.outcome, r.quantity)?;
            Some(value.error(r.value, self.multiplier_unit))
        });
        errors.reduce(f64::max)
    }

    /// Friction in words: one coefficient, or the least and the largest.
    pub fn friction_words(&self) -> Option<String> {
        let [least, largest] = self.friction?;
        Some(if least == largest {
            short(least, 9)
        } else {
            format!("{} to {}", short(least, 9), short(largest, 9))
        })
    }
}

/// Name of a case's scene in tables and files: `CASE`, or `CASE@open` where head joints are open.
pub fn scene_name(case: &str, head_joints: HeadJoints) -> String {
    match head_joints {
        HeadJoints::Contact => case.to_owned(),
        HeadJoints::Open => format!("{case}@open"),
    }
}
