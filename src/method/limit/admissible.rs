//! Mechanisms made exactly admissible, so that their multiplier is a true upper bound of λ_A.

use crate::mechanism::{JointRate, Mechanism, Motion};
use crate::scene::{Joint, Scene, Vector};

/// How far every corner of a joint opens beyond μ|slip|; associative flow needs this ≥ 0.
fn margin(joint: &Joint, rate: &JointRate) -> f64 {
    rate.opening[0].min(rate.opening[1]) - joint.friction * rate.slip.abs()
}

/// Adds the smallest multiple of a strictly opening motion with which every corner opens by at
/// least μ|slip|, or `None` where no such motion is known.
///
/// A solver's mechanism closes some corners by 1e-10 or so; without this its multiplier is no
/// bound. Margins are concave in the motion, so those of the sum are at least the sum of margins.
pub fn admissible(scene: &Scene, mechanism: &Mechanism) -> Option<Mechanism> {
    let margins = |m: &Mechanism| -> Vec<f64> {
        let rates = m.joint_rates(scene);
        let pairs = scene.joints.iter().zip(&rates);
        pairs.map(|(joint, rate)| margin(joint, rate)).collect()
    };
    let opening = opening_motion(scene)?;
    let (own, spare) = (margins(mechanism), margins(&opening));
    let needed = own.iter().zip(&spare).map(|(m, s)| -m / s);
    let share = needed.fold(0.0, f64::max);
    // Doubled, so that rounding in the sum cannot leave a corner closed.
    let sum = add(mechanism, &opening, 2.0 * share);
    margins(&sum).iter().all(|&m| m >= 0.0).then_some(sum)
}

fn add(mechanism: &Mechanism, other: &Mechanism, share: f64) -> Mechanism {
    let pairs = mechanism.motions.iter().zip(&other.motions);
    let motion = |(a, b): (&Motion, &Motion)| Motion {
        velocity: a.velocity + b.velocity * share,
        rotation: a.rotation + b.rotation * share,
    };
    Mechanism {
        motions: pairs.map(motion).collect(),
    }
}

/// The expansion u = (x, k y) of the centroids with the smallest k (a power of 2) that opens every
/// joint, or `None` where no k does.
///
/// Blocks in level courses always have one: head joints open by x, bed joints by k y, and k makes
/// up for the slip of the widest base joint.
fn opening_motion(scene: &Scene) -> Option<Mechanism> {
    let (low, high) = scene.bounds();
    let origin = Vector::new((low.x + high.x) / 2.0, low.y);
    let expansion = |k: f64| Mechanism {
        motions: scene
            .blocks
            .iter()
            .map(|block| {
                let from = block.shape.centroid().coords - origin;
                Motion {
                    velocity: Vector::new(from.x, k * from.y),
                    rotation: 0.0,
                }
            })
            .collect(),
    };
    let opens = |motion: &Mechanism| {
        let rates = motion.joint_rates(scene);
        let mut pairs = scene.joints.iter().zip(&rates);
        // Beyond rounding of the slip itself.
        pairs.all(|(joint, rate)| margin(joint, rate) > 1e-9 * joint.length())
    };
    let mut steepness = (0..40).map(|power| expansion(f64::from(1u32 << power.min(31))));
    steepness.find(opens)
}
