//! Residuals of force states and mechanisms, scaled: total weight, height, and the live power for
//! λ* = 1 are 1.

use serde::{Deserialize, Serialize};
use thiserror::Error;

use super::mechanism::Mechanism;
use super::state::JointForce;
use crate::scene::{Block, Point, Scene, Vector, Wrench};

/// Largest residual of a verified result, with total weight, height and live power scaled to 1.
pub const VERIFIED_RESIDUAL: f64 = 1e-8;

/// Violations of static admissibility, as fractions of the total weight.
#[derive(Clone, Copy, Debug, Default, Error, PartialEq, Serialize, Deserialize)]
#[error("equilibrium {equilibrium:.1e}, tension {tension:.1e}, friction {friction:.1e}")]
pub struct StaticResidual {
    /// Largest unbalanced force, or moment over the height.
    pub equilibrium: f64,
    /// Largest tensile corner force.
    pub tension: f64,
    /// Largest excess of |t| over μ(n1 + n2).
    pub friction: f64,
}

impl StaticResidual {
    /// Violations of a force state at the multiplier `lambda`.
    pub fn of(scene: &Scene, forces: &[JointForce], lambda: f64) -> Self {
        let loads = scene.blocks().iter().map(|block| block.loads_at(lambda));
        Self::under(scene, forces, loads.collect(), scene.total_weight())
    }

    /// Violations of a ray: forces that balance the live load for λ = 1 and nothing else, as
    /// fractions of the total live load, or of the weight where there is none.
    pub fn of_ray(scene: &Scene, ray: &[JointForce]) -> Self {
        let loads = scene.blocks().iter().map(Block::live);
        Self::under(scene, ray, loads.collect(), live_unit(scene))
    }

    fn under(scene: &Scene, forces: &[JointForce], loads: Vec<Wrench>, unit: f64) -> Self {
        let units = [unit, unit, unit * scene.height()];
        let mut out = Self::default();
        for balance in balances(scene, forces, loads) {
            for (value, unit) in balance.iter().zip(units) {
                out.equilibrium = larger(out.equilibrium, value.abs() / unit);
            }
        }
        for (joint, force) in scene.joints().iter().zip(forces) {
            let [n1, n2] = force.normal;
            out.tension = larger(out.tension, -n1 / unit);
            out.tension = larger(out.tension, -n2 / unit);
            let excess = force.shear.abs() - joint.friction * (n1 + n2);
            out.friction = larger(out.friction, excess / unit);
        }
        out
    }

    /// The largest of all.
    pub fn largest(&self) -> f64 {
        self.equilibrium.max(self.tension).max(self.friction)
    }
}

/// Unbalanced wrench of every block, from those of its loads.
pub fn balances(scene: &Scene, forces: &[JointForce], loads: Vec<Wrench>) -> Vec<Wrench> {
    let mut sums = loads;
    for (joint, force) in scene.joints().iter().zip(forces) {
        let tangential = joint.tangent() * force.shear;
        let parts: [(Point, Vector); 3] = [
            (joint.ends[0], joint.normal * force.normal[0]),
            (joint.ends[1], joint.normal * force.normal[1]),
            (joint.ends[0], tangential),
        ];
        for (block, sign) in joint.blocks() {
            let centroid = scene.blocks()[block].shape.centroid();
            let sum = &mut sums[block];
            for (point, part) in parts {
                let (arm, force) = (point - centroid, part * sign);
                sum[0] += force.x;
                sum[1] += force.y;
                sum[2] += arm.perp(&force);
            }
        }
    }
    sums
}

/// Force unit of a ray: the total live load for λ = 1, or the weight where there is none.
pub fn live_unit(scene: &Scene) -> f64 {
    let live = scene.total_live();
    if live == 0.0 {
        scene.total_weight()
    } else {
        live
    }
}

/// Power of the live load (λ = 1) and of the dead load on a mechanism.
fn powers(scene: &Scene, mechanism: &Mechanism) -> (f64, f64) {
    let mut sums = (0.0, 0.0);
    for (block, motion) in scene.blocks().iter().zip(&mechanism.motions) {
        for load in &block.loads {
            let velocity = motion.at(load.point - block.shape.centroid());
            sums.0 += load.live.dot(&velocity);
            sums.1 += load.dead.dot(&velocity);
        }
    }
    sums
}

/// −f_D·u / f_L·u: an upper bound of λ_A where the mechanism is admissible and the live load does
/// positive work on it; NaN where it does none.
pub fn kinematic_multiplier(scene: &Scene, mechanism: &Mechanism) -> f64 {
    let (live, dead) = powers(scene, mechanism);
    if live > 0.0 { -dead / live } else { f64::NAN }
}

/// Power of the live load on a mechanism, for λ = 1.
pub fn live_power(scene: &Scene, mechanism: &Mechanism) -> f64 {
    powers(scene, mechanism).0
}

/// Power of the dead load on a mechanism.
pub fn dead_power(scene: &Scene, mechanism: &Mechanism) -> f64 {
    powers(scene, mechanism).1
}

/// Factor on rates that makes the live power equal the total live load; NaN, so that every residual
/// fails, where the live load does no positive work.
fn rate_unit(scene: &Scene, mechanism: &Mechanism) -> f64 {
    let live = powers(scene, mechanism).0;
    if live > 0.0 {
        live_unit(scene) / live
    } else {
        f64::NAN
    }
}

/// The larger of a running maximum and a value, where `f64::max` would pass over a NaN.
fn larger(maximum: f64, value: f64) -> f64 {
    if value.is_nan() {
        f64::INFINITY
    } else {
        maximum.max(value)
    }
}

/// Largest violation of opening ≥ μ|slip|, the associative flow rule.
pub fn associative_violation(scene: &Scene, mechanism: &Mechanism) -> f64 {
    flow_violation(scene, mechanism, rate_unit(scene, mechanism))
}

/// Largest violation of opening ≥ μ|slip| of a mechanism that proves a fall: the dead load alone
/// does positive work on it. Scaled so that this work is 1 for the total weight; infinite where
/// there is none. Forces that held the scene would have to be 1/violation times its weight.
pub fn falling_violation(scene: &Scene, mechanism: &Mechanism) -> f64 {
    let dead = dead_power(scene, mechanism);
    if dead > 0.0 {
        flow_violation(scene, mechanism, scene.total_weight() / dead)
    } else {
        f64::INFINITY
    }
}

fn flow_violation(scene: &Scene, mechanism: &Mechanism, unit: f64) -> f64 {
    let rates = mechanism.joint_rates(scene);
    let violations = scene.joints().iter().zip(&rates).flat_map(|(joint, rate)| {
        let opening = rate.opening;
        opening.map(|opening| (joint.friction * rate.slip.abs() - opening) * unit)
    });
    violations.fold(0.0, larger)
}

/// Violations of the zero-dilatancy collapse conditions, beyond static admissibility.
#[derive(Clone, Copy, Debug, Default, Error, PartialEq, Serialize, Deserialize)]
#[error(
    "penetration {penetration:.1e}, force at an opening {open_contact:.1e}, \
     idle friction {idle_friction:.1e}, gap {gap:.1e}"
)]
pub struct CollapseResidual {
    /// Largest closing rate.
    pub penetration: f64,
    /// Largest n · opening at a corner.
    pub open_contact: f64,
    /// Largest μN|slip| − (power that the joint's shear takes out).
    pub idle_friction: f64,
    /// Sum of the last two over all joints: the complementarity gap, in units of λ*. Many joints
    /// that each violate little do not pass.
    pub gap: f64,
}

impl CollapseResidual {
    /// Violations of a force state together with a mechanism.
    pub fn of(scene: &Scene, forces: &[JointForce], mechanism: &Mechanism) -> Self {
        let unit = rate_unit(scene, mechanism);
        let weight = scene.total_weight();
        let mut out = Self::default();
        let rates = mechanism.joint_rates(scene);
        for ((joint, force), rate) in scene.joints().iter().zip(forces).zip(&rates) {
            for corner in 0..2 {
                let opening = rate.opening[corner] * unit;
                let normal = force.normal[corner] / weight;
                out.penetration = larger(out.penetration, -opening);
                out.open_contact = larger(out.open_contact, (normal * opening).abs());
                out.gap += (normal * opening).abs();
            }
            let capacity = joint.friction * (force.normal[0] + force.normal[1]) / weight;
            let slip = rate.slip * unit;
            let idle = capacity * slip.abs() + force.shear / weight * slip;
            out.idle_friction = larger(out.idle_friction, idle.abs());
            out.gap += idle.abs();
        }
        out
    }

    /// The largest of all.
    pub fn largest(&self) -> f64 {
        self.penetration
            .max(self.open_contact)
            .max(self.idle_friction)
            .max(self.gap)
    }
}
