//! Self-checks that can fail: pure functions of figures, run on every bracket.

use super::physics::Contact;
use crate::answer::{Bracket, Checked, Repetition, SelfCheck, magnitude};
use crate::scene::{Joint, Scene, Side};

/// Which state at rest a check is about.
#[derive(Clone, Copy)]
pub enum AtRest {
    /// Settled under the own weight.
    Settled,
    /// At the last load at rest.
    Last,
}

/// A figure and what it may be: of the settled scene its speed, in √(g·H_c), and its displacement under
/// the own weight, in course heights, where contacts too soft for the scene, too few substeps and blocks
/// that overlap at the start show; of the last state at rest its displacement since then.
pub fn check(what: Checked, value: f64, limit: f64) -> SelfCheck {
    SelfCheck {
        variation: None,
        what,
        value,
        limit,
    }
}

/// Rapier has a contact with the right normal for every joint of the scene that is not
/// between two `fixed` bodies. Exactly touching polygons can give it arbitrary normals.
pub fn sees_joints<'a>(
    joints: impl Iterator<Item = &'a Joint> + Clone,
    contacts: &[Contact],
    fixed: impl Fn(Side) -> bool,
) -> SelfCheck {
    let seen = |joint: &&Joint| {
        let pair = [joint.from, Side::Block(joint.to)];
        contacts.iter().any(|contact| {
            let along = contact.normal[0] * joint.normal.x + contact.normal[1] * joint.normal.y;
            let [a, b] = contact.between;
            (pair == [a, b] && along > 0.999) || (pair == [b, a] && along < -0.999)
        })
    };
    let free = |joint: &&Joint| !(fixed(joint.from) && fixed(Side::Block(joint.to)));
    let joints = joints.filter(free);
    let of = joints.clone().count();
    let found = joints.filter(seen).count();
    check(Checked::UnseenJoints { of }, (of - found) as f64, 0.0)
}

/// What is fixed carries what loads the blocks: the sum of both, relative to the weight.
pub fn supports_carry(
    load: [f64; 2],
    reaction: [f64; 2],
    weight: f64,
    at: AtRest,
    limit: f64,
) -> SelfCheck {
    let sum = [load[0] + reaction[0], load[1] + reaction[1]];
    let miss = (sum[0] * sum[0] + sum[1] * sum[1]).sqrt() / weight;
    let what = match at {
        AtRest::Settled => Checked::SettledBalance,
        AtRest::Last => Checked::LastBalance,
    };
    check(what, miss, limit)
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
    let apart = answer.as_ref().map_or(f64::INFINITY, |other| {
        (first.lower - other.upper)
            .max(other.lower - first.upper)
            .max(0.0)
    });
    let relative = apart / magnitude(first.upper, unit);
    check(Checked::Repetition { with, answer }, relative, tolerance)
}

/// Force of everything fixed on the blocks that may move.
pub fn reaction(contacts: &[Contact], fixed: impl Fn(Side) -> bool) -> [f64; 2] {
    let mut sum = [0.0; 2];
    for contact in contacts {
        let sign = match contact.between.map(&fixed) {
            [true, false] => 1.0,
            [false, true] => -1.0,
            _ => continue,
        };
        sum = [
            sum[0] + sign * contact.force[0],
            sum[1] + sign * contact.force[1],
        ];
    }
    sum
}

/// Sum of normal forces between bodies that share no joint of the scene.
pub fn off_joints(scene: &Scene, contacts: &[Contact]) -> f64 {
    let ordered = |[a, b]: [Side; 2]| if a < b { [a, b] } else { [b, a] };
    let joints = scene.joints().iter();
    let mut joined: Vec<[Side; 2]> = joints
        .map(|joint| ordered([joint.from, Side::Block(joint.to)]))
        .collect();
    joined.sort_unstable();
    let off = contacts
        .iter()
        .filter(|contact| joined.binary_search(&ordered(contact.between)).is_err());
    // Not `sum`, which makes −0 of nothing.
    off.map(|contact| contact.pressure).fold(0.0, |a, b| a + b)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_missing_tenth_of_the_weight_is_noticed() {
        let weight = 33.0;
        let carry =
            |load, reaction| supports_carry(load, reaction, weight, AtRest::Last, 1e-4).passed();
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

    #[test]
    fn a_contact_with_a_wrong_normal_is_no_joint() {
        use crate::scene::{JointClass, Point, Vector};
        let joint = Joint {
            from: Side::Support(0),
            to: 0,
            ends: [Point::new(0.0, 0.0), Point::new(1.0, 0.0)],
            normal: Vector::new(0.0, 1.0),
            friction: 0.5,
            class: JointClass::Base,
        };
        let contact = |between, normal| Contact {
            between,
            normal,
            pressure: 1.0,
            force: [0.0, 1.0],
        };
        let (ground, block) = (Side::Support(0), Side::Block(0));
        let sees = |contact| {
            let fixed = |side| matches!(side, Side::Support(_));
            sees_joints(std::iter::once(&joint), &[contact], fixed).passed()
        };
        assert!(sees(contact([ground, block], [0.0, 1.0])));
        assert!(sees(contact([block, ground], [0.0, -1.0])));
        assert!(!sees(contact([ground, block], [0.6, 0.8])));
        assert!(!sees(contact([ground, Side::Block(1)], [0.0, 1.0])));
    }
}
