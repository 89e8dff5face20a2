//! How far forces that exceed Coulomb's law can raise a multiplier.

use super::mechanism::Mechanism;
use super::residual::live_power;
use super::state::JointForce;
use crate::scene::Scene;

/// By how much the multiplier of a force state can be above that of a mechanism with dilatancy, as
/// its joints carry more shear than μN: Σ (|t| − μN) |slip| over those joints, for a mechanism on
/// which the live load does work 1. By virtual work nothing else that is in equilibrium and in
/// compression can raise it. Infinite where the live load does no positive work on the mechanism.
pub fn friction_excess(scene: &Scene, forces: &[JointForce], mechanism: &Mechanism) -> f64 {
    let live = live_power(scene, mechanism);
    let rates = mechanism.joint_rates(scene);
    let joints = scene.joints().iter().zip(forces).zip(&rates);
    let power = joints.map(|((joint, force), rate)| {
        let capacity = joint.friction * (force.normal[0] + force.normal[1]);
        (force.shear.abs() - capacity).max(0.0) * rate.slip.abs()
    });
    if live > 0.0 {
        power.sum::<f64>() / live
    } else {
        f64::INFINITY
    }
}
