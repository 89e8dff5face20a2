//! The one row: a method's judged answer on a scene, with everything that tables, files, plots and
//! studies tell of it.

use std::borrow::Cow;

use serde::{Deserialize, Serialize};

use super::ends::{Ends, Side, ends};
use super::sides::{self, OtherSide};
use crate::answer::{Bracket, Fact, Outcome, Status, magnitude, sentence};
use crate::case::{Case, Quantity, Reference};
use crate::judge::{Check, Computed, Recomputed, Verdict, computed};
use crate::mechanics::{Crack, largest};
use crate::method::{Kind, kind};
use crate::number::short;
use crate::scene::{HeadJoints, Push, Reaction};

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
    /// Direction of the push that governs, where the wall is pushed both ways.
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
    /// Where a support moves, what λ says of its reaction.
    #[serde(default)]
    pub reaction: Option<Reaction>,
    /// The answer for that direction, its status set by the judge.
    pub outcome: Outcome,
    /// The answer for the other direction of a wall that is pushed both ways.
    pub other: Option<OtherSide>,
    /// Residuals that the judge computed, where there was something to judge.
    pub residuals: Vec<Recomputed>,
    /// The crack, where there is one.
    pub crack: Option<Crack>,
    /// CPU time of the method over all sides, seconds. The only thing here that is not the same in
    /// every run.
    pub seconds: f64,
    /// The case's values about this row: known deviations last, published ones before others.
    #[serde(skip)]
    pub references: Vec<Reference>,
    /// The λ that the case demands.
    #[serde(skip)]
    pub demand: Option<f64>,
    /// The worst verdict about this row; `None` where there is nothing to compare it with.
    #[serde(skip)]
    pub verdict: Option<Verdict>,
}

impl Row {
    /// The row with what its case says of it, and the worst of the case's checks about it.
    pub(super) fn compare(&mut self, case: &Case, checks: &[Check]) {
        let about = |r: &&Reference| {
            r.method == self.method && r.head_joints.is_none_or(|only| only == self.head_joints)
        };
        self.demand = case.demand;
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

    /// The answers by direction of the push, that of the side that governs first.
    pub fn sides(&self) -> impl Iterator<Item = (Push, &Outcome)> {
        let other = self.other.iter().map(|other| (other.push, &*other.outcome));
        std::iter::once((self.push, &self.outcome)).chain(other)
    }

    /// The answer for one direction of the push.
    pub fn side(&self, push: Push) -> Option<&Outcome> {
        self.sides().find(|side| side.0 == push).map(|side| side.1)
    }

    /// Changes the answer for one direction of the push, where there is one.
    pub(super) fn change_side(&mut self, push: Push, change: impl FnOnce(&mut Outcome)) {
        match &mut self.other {
            Some(other) if other.push == push => change(&mut other.outcome),
            _ if self.push == push => change(&mut self.outcome),
            _ => {}
        }
    }

    /// The row as if the wall had been pushed this way only, where it was; else as it is.
    pub fn of_side(&self, push: Push) -> Cow<'_, Row> {
        match &self.other {
            Some(other) if other.push == push => Cow::Owned(Row {
                push,
                outcome: (*other.outcome).clone(),
                residuals: other.residuals.clone(),
                crack: other.crack,
                other: None,
                ..self.clone()
            }),
            _ => Cow::Borrowed(self),
        }
    }

    fn two_sides(&self) -> (Side<'_>, Option<Side<'_>>) {
        let mut sides = self.sides();
        let governing = sides.next().expect("there is one");
        (governing, sides.next())
    }

    /// What the answer is worth: of a wall that is pushed both ways, what its whole range is.
    pub fn status(&self) -> Status {
        let (governing, other) = self.two_sides();
        sides::status(governing, other, self.multiplier_unit)
    }

    /// The ends of the range of λ, each with the push that it belongs to; of a support that moves, those
    /// of its reaction.
    pub(crate) fn ends(&self) -> Ends {
        let ends = self.multiplier_ends();
        match &self.reaction {
            Some(reaction) => ends.read(reaction),
            None => ends,
        }
        .one_to_the_nearest()
    }

    /// The ends of λ itself.
    fn multiplier_ends(&self) -> Ends {
        let (governing, other) = self.two_sides();
        ends(governing, other)
    }

    /// Whether the ends are one number to what a proof vouches for.
    pub(crate) fn is_one_number(&self) -> bool {
        let multiplier = self.multiplier_ends().bracket();
        multiplier.is_some_and(|of| of.relative_width(self.multiplier_unit) <= SHOWN_AS_ONE)
    }

    /// What people read for a λ: of a support that moves, its reaction.
    pub(crate) fn reads(&self, lambda: f64) -> f64 {
        let reaction = self.reaction.as_ref();
        reaction.map_or(lambda, |reaction| reaction.at(lambda))
    }

    /// The multiplier, where there is one to vouch for.
    pub fn bracket(&self) -> Option<Bracket> {
        self.ends().bracket()
    }

    /// Error that the method states for its range, relative to λ: of both sides the larger. Of a
    /// support that moves, relative to its reaction.
    pub fn stated_error(&self) -> Option<f64> {
        let errors = self
            .sides()
            .filter_map(|(_, outcome)| outcome.evidence.stated_error());
        let error = errors.reduce(f64::max)?;
        let Some(reaction) = &self.reaction else {
            return Some(error);
        };
        let lambda = self.multiplier_ends().upper?.lambda;
        let [change, reaction] =
            [lambda, reaction.at(lambda)].map(|of| magnitude(of, self.multiplier_unit));
        Some(error * change / reaction)
    }

    /// The largest residual; `None` where there was nothing to judge.
    pub fn residual(&self) -> Option<f64> {
        let others = self
            .other
            .iter()
            .filter_map(|other| largest(&other.residuals));
        largest(&self.residuals)
            .into_iter()
            .chain(others)
            .reduce(f64::max)
    }

    /// What references are compared with.
    pub(crate) fn computed(&self) -> Computed<'_> {
        let ends = self.ends();
        Computed {
            status: self.status(),
            lower: ends.lower.map(|end| end.lambda),
            upper: ends.upper.map(|end| end.lambda),
            crack: self.crack.as_ref(),
        }
    }

    /// What is to be said of the answer: of a wall that is pushed both ways, of its sides first.
    fn facts(&self) -> Vec<Fact> {
        let (own, other) = self.two_sides();
        let Some(other) = other.filter(|_| self.reaction.is_none()) else {
            return self.outcome.facts.clone();
        };
        let compared = sides::compared(own, other, self.multiplier_unit).into_iter();
        let compared = compared.map(Fact::from);
        compared.chain(sides::facts(own, other)).collect()
    }

    /// The same in words; empty where there is nothing to say.
    pub fn reason(&self) -> String {
        self.told(&self.facts())
    }

    /// The same without what a search counts, which may differ between machines.
    pub fn settled_reason(&self) -> String {
        let mut facts = self.facts();
        facts.retain(|fact| !matches!(fact, Fact::Search(_)));
        self.told(&facts)
    }

    /// Facts as one text: of a support that moves, in terms of its reaction.
    fn told(&self, facts: &[Fact]) -> String {
        let Some(reaction) = &self.reaction else {
            return sentence(facts);
        };
        let words = facts.iter().map(|fact| fact.of_reaction(reaction));
        let words: Vec<String> = words.filter(|words| !words.is_empty()).collect();
        words.join("; ")
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
        let one = self.reference(Quantity::Lambda);
        let one = one.or(self.reference(Quantity::Reaction)).into_iter();
        let ends = [Quantity::Lower, Quantity::Upper];
        let ends = ends.into_iter().filter_map(|end| self.reference(end));
        let one: Vec<&Reference> = one.collect();
        if one.is_empty() { ends.collect() } else { one }
    }

    /// Error of the multiplier against those references, relative: the farther end counts.
    pub fn error(&self) -> Option<f64> {
        let errors = self.multiplier_references().into_iter().filter_map(|r| {
            let value = computed(&self.computed(), r.quantity)?;
            Some(value.error(r.value, self.multiplier_unit))
        });
        errors.reduce(f64::max)
    }

    /// How many times the demanded λ the lower end reaches, where the case demands one.
    pub fn over_demand(&self) -> Option<f64> {
        Some(self.ends().lower?.lambda / self.demand?)
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

/// Ends nearer than this, relative to λ, are shown as one number.
const SHOWN_AS_ONE: f64 = 2e-6;

/// Name of a case's scene in tables and files: `CASE`, or `CASE@open` where head joints are open.
pub fn scene_name(case: &str, head_joints: HeadJoints) -> String {
    match head_joints {
        HeadJoints::Contact => case.to_owned(),
        HeadJoints::Open => format!("{case}@open"),
    }
}
