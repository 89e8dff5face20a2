//! Self-checks that can fail: of the settled scene before it is pushed, and of every bracket.

use super::measure;
use super::model::{GRID, Model};
use super::parameters::Parameters;
use super::physics::{BodyState, Contact};
use super::search::{Observation, RestState};
use crate::answer::{Bracket, Checked, PushoverFact, Repetition, SelfCheck, magnitude};
use crate::scene::{Scene, Side};

/// A figure and what it may be: of the settled scene its speed, in √(g·H_c), and its displacement under
/// the own weight, in course heights, where contacts too soft for the scene, too few substeps and blocks
/// that overlap at the start show; of the last state at rest its displacement since then.
fn check(what: Checked, value: f64, limit: f64) -> SelfCheck {
    SelfCheck {
        variation: None,
        what,
        value,
        limit,
    }
}

/// Rapier has a contact with the right normal for each of these joints.
pub fn sees_joints(model: &Model, contacts: &[Contact]) -> SelfCheck {
    let seen = |joint: &&usize| {
        let normal = model.scene.joints()[**joint].normal;
        contacts.iter().any(|contact| {
            let along = contact.normal[0] * normal.x + contact.normal[1] * normal.y;
            contact.joint == **joint && along > 0.999
        })
    };
    let (of, found) = (model.joints.len(), model.joints.iter().filter(seen).count());
    check(Checked::UnseenJoints { of }, (of - found) as f64, 0.0)
}

/// Checks of the scene under its own weight, from as it was `laid`.
pub fn of_settled(
    model: &Model,
    own: &Parameters,
    laid: &[BodyState],
    settled: &RestState,
) -> [SelfCheck; 3] {
    let settlement = measure::displacement(model, laid, &settled.states);
    let speed = measure::speed(model, &settled.states);
    let missing = not_carried(model, 0.0, settled);
    [
        check(Checked::Settlement, settlement, own.settlement),
        check(Checked::SettledSpeed, speed, own.moving),
        check(Checked::SettledBalance, missing, own.missing),
    ]
}

/// Checks of the last load at rest.
pub fn of_rest(model: &Model, own: &Parameters, seen: &Observation) -> [SelfCheck; 2] {
    let drift = measure::displacement(model, &seen.settled.states, &seen.rest.states);
    let missing = not_carried(model, seen.loads[0] as f64 / GRID, &seen.rest);
    [
        check(Checked::LastBalance, missing, own.missing),
        check(Checked::Drift, drift, own.drift),
    ]
}

/// The first check that takes the number away.
pub fn failed(own: &Parameters, checks: &[SelfCheck]) -> Option<PushoverFact> {
    let mut checks = checks.iter();
    let failed = checks.find(|check| own.self_checks && !check.passed());
    failed.map(|check| PushoverFact::SelfCheckFailed(check.clone()))
}

/// The part of the weight by which what is fixed fails to carry what loads the blocks, at rest at some λ*.
fn not_carried(model: &Model, lambda: f64, at: &RestState) -> f64 {
    let fixed = |side| match side {
        Side::Block(block) if model.scene.pin(block).is_some() => true,
        side => model.portion.is_fixed(side),
    };
    let load = [0, 1].map(|axis| model.dead[axis] + lambda * model.live[axis]);
    missing(load, reaction(model.scene, &at.contacts, fixed), model.dead)
}

/// What is missing for the sum of a load and the reaction to it to be nothing, relative to the weight.
fn missing(load: [f64; 2], reaction: [f64; 2], weight: [f64; 2]) -> f64 {
    let size = |[x, y]: [f64; 2]| (x * x + y * y).sqrt();
    size([0, 1].map(|axis| load[axis] + reaction[axis])) / size(weight)
}

/// A repetition that must agree, such as one with half the substep: the distance between both
/// brackets, relative to λ, in a scene with this unit of it. One without a bracket, which says why in words, does not.
pub fn repetition_agrees(
    first: Bracket,
    with: Repetition,
    answer: Result<Bracket, String>,
    unit: f64,
    tolerance: f64,
) -> SelfCheck {
    let between = |other: &Bracket| (first.lower - other.upper).max(other.lower - first.upper);
    let apart = answer.as_ref().map_or(f64::INFINITY, between).max(0.0);
    let relative = apart / magnitude(first.upper, unit);
    check(Checked::Repetition { with, answer }, relative, tolerance)
}

/// Force of everything fixed on the blocks that may move.
fn reaction(scene: &Scene, contacts: &[Contact], fixed: impl Fn(Side) -> bool) -> [f64; 2] {
    let mut sum = [0.0; 2];
    for contact in contacts {
        let joint = &scene.joints()[contact.joint];
        let sign = match [joint.from, Side::Block(joint.to)].map(&fixed) {
            [true, false] => 1.0,
            [false, true] => -1.0,
            _ => continue,
        };
        let force = contact.force.map(|force| sign * force);
        sum = [sum[0] + force[0], sum[1] + force[1]];
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_missing_tenth_of_the_weight_is_noticed() {
        let weight = 33.0;
        let carry = |load, reaction| {
            let missing = missing(load, reaction, [0.0, -weight]);
            check(Checked::LastBalance, missing, 1e-4).passed()
        };
        assert!(carry([0.0, -weight], [1e-6, weight]));
        assert!(!carry([0.0, -weight], [0.0, 0.9 * weight]));
        assert!(!carry([3.0, -weight], [3.0, weight]));
        assert!(!carry([0.0, -weight], [f64::NAN, weight]));
    }

    #[test]
    fn a_figure_beyond_its_limit_or_none_fails() {
        let passed = |value| check(Checked::Drift, value, 0.1).passed();
        assert!(passed(0.05) && !passed(0.2) && !passed(f64::NAN));
    }

    #[test]
    fn brackets_apart_do_not_agree() {
        let at = |lower, upper| Bracket { lower, upper };
        let agrees = |answer| {
            repetition_agrees(at(0.5, 0.501), Repetition::Mirrored, answer, 1.0, 2e-3).passed()
        };
        assert!(agrees(Ok(at(0.5015, 0.502))) && !agrees(Ok(at(0.503, 0.504))));
        assert!(!agrees(Err("it fell".into())));
    }
}
