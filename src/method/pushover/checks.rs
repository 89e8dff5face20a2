//! Self-checks that can fail: pure functions of figures, run on every bracket.

use crate::answer::Bracket;
use crate::scene::{Joint, Side};

use super::engine::Contact;

/// A check with its figures in words, and whether it passed.
#[derive(Clone, Debug, PartialEq)]
pub struct Check {
    /// Whether the figures are as they must be.
    pub passed: bool,
    /// The figures.
    pub text: String,
}

/// The engine has a contact with the right normal for every joint of the scene that is not
/// between two `fixed` bodies. Exactly touching polygons can give an engine arbitrary normals.
pub fn sees_joints(joints: &[Joint], contacts: &[Contact], fixed: impl Fn(Side) -> bool) -> Check {
    let seen = |joint: &&Joint| {
        let pair = [joint.from, Side::Block(joint.to)];
        contacts.iter().any(|contact| {
            let along = contact.normal[0] * joint.normal.x + contact.normal[1] * joint.normal.y;
            let [a, b] = contact.between;
            (pair == [a, b] && along > 0.999) || (pair == [b, a] && along < -0.999)
        })
    };
    let free = |joint: &&Joint| !(fixed(joint.from) && fixed(Side::Block(joint.to)));
    let needed = joints.iter().filter(free).count();
    let found = joints.iter().filter(free).filter(seen).count();
    Check {
        passed: found == needed,
        text: format!("the engine sees {found} of {needed} joints"),
    }
}

/// Speed of the settled scene, in √(g·H_c).
pub fn at_rest(speed: f64) -> Check {
    let limit = 1e-6;
    Check {
        passed: speed <= limit,
        text: format!("settled at a speed of {speed:.1e} √(g·H_c), at most {limit:.0e}"),
    }
}

/// Displacement under the own weight alone, in course heights: contacts too soft for the scene,
/// too few substeps and blocks that overlap at the start show here.
pub fn settles_little(settlement: f64, limit: f64) -> Check {
    Check {
        passed: settlement <= limit,
        text: format!("settled by {settlement:.1e} H_c, at most {limit:.1e}"),
    }
}

/// What is fixed carries what loads the blocks: the sum of both, relative to the weight.
pub fn supports_carry(load: [f64; 2], reaction: [f64; 2], weight: f64, when: &str) -> Check {
    let limit = 1e-4;
    let sum = [load[0] + reaction[0], load[1] + reaction[1]];
    let miss = (sum[0] * sum[0] + sum[1] * sum[1]).sqrt() / weight;
    Check {
        passed: miss <= limit,
        text: format!(
            "{when} the supports miss {miss:.1e} of the weight in carrying the loads, at most \
             {limit:.0e}"
        ),
    }
}

/// Normal force between bodies that share no joint of the scene, relative to the weight.
pub fn open_stays_open(closed: f64, weight: f64) -> Check {
    let limit = 1e-3;
    let part = closed / weight;
    Check {
        passed: part <= limit,
        text: format!("open joints carry {part:.1e} of the weight, at most {limit:.0e}"),
    }
}

/// Displacement of the last rest state since the scene settled, in course heights.
pub fn small_drift(drift: f64, limit: f64) -> Check {
    Check {
        passed: drift <= limit,
        text: format!("drift up to the last load at rest: {drift:.1e} H_c, at most {limit:.2}"),
    }
}

/// Two runs that must agree, such as one with half the substep: the distance between their
/// brackets, relative to λ.
pub fn agree(one: Bracket, other: Bracket, tolerance: f64, what: &str) -> Check {
    let apart = (one.lower - other.upper)
        .max(other.lower - one.upper)
        .max(0.0);
    let relative = apart / one.upper.abs().max(1e-3);
    Check {
        passed: relative <= tolerance,
        text: format!(
            "{what}: [{:.5}, {:.5}], {relative:.1e} of λ away, at most {tolerance:.0e}",
            other.lower, other.upper
        ),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_missing_tenth_of_the_weight_is_noticed() {
        let weight = 33.0;
        assert!(supports_carry([0.0, -weight], [1e-6, weight], weight, "").passed);
        assert!(!supports_carry([0.0, -weight], [0.0, 0.9 * weight], weight, "").passed);
        assert!(!supports_carry([3.0, -weight], [3.0, weight], weight, "").passed);
        assert!(!supports_carry([0.0, -weight], [f64::NAN, weight], weight, "").passed);
    }

    #[test]
    fn every_other_check_can_fail() {
        assert!(at_rest(1e-7).passed && !at_rest(1e-5).passed && !at_rest(f64::NAN).passed);
        assert!(settles_little(1e-3, 2e-3).passed && !settles_little(f64::NAN, 2e-3).passed);
        assert!(small_drift(0.05, 0.1).passed && !small_drift(0.2, 0.1).passed);
        assert!(open_stays_open(0.0, 1.0).passed && !open_stays_open(0.01, 1.0).passed);
        let at = |lower, upper| Bracket { lower, upper };
        assert!(agree(at(0.5, 0.501), at(0.5015, 0.502), 2e-3, "").passed);
        assert!(!agree(at(0.5, 0.501), at(0.503, 0.504), 2e-3, "").passed);
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
            sees_joints(std::slice::from_ref(&joint), &[contact], fixed).passed
        };
        assert!(sees(contact([ground, block], [0.0, 1.0])));
        assert!(sees(contact([block, ground], [0.0, -1.0])));
        assert!(!sees(contact([ground, block], [0.6, 0.8])));
        assert!(!sees(contact([ground, Side::Block(1)], [0.0, 1.0])));
    }
}
