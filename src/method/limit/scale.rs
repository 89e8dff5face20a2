//! Units of the dimensionless program, and the way back to the case's own.

use crate::mechanics::{CollapseState, JointForce, Mechanism, Motion, live_power};
use crate::scene::{Scene, Vector};

/// Units of the dimensionless program. Without them Clarabel reports "solved" far from the
/// optimum: on paper-3 1 % away at tolerance 1e-6 (measured: total weight 1 cures it, weight of
/// each block 1 does not).
#[derive(Clone, Copy, Debug)]
pub(super) struct Scale {
    /// Force unit: the scene's total weight.
    pub(super) force: f64,
    /// Length unit: the height of the blocks.
    pub(super) length: f64,
    /// Unit of λ: the one at which the live loads add up to the dead ones, so that live loads of any
    /// size make the same program.
    pub(super) multiplier: f64,
}

impl Scale {
    pub(super) fn of(scene: &Scene) -> Self {
        Self {
            force: scene.total_weight(),
            length: scene.height(),
            multiplier: scene.multiplier_unit(),
        }
    }

    /// Forces back in the case's unit.
    pub(super) fn forces(&self, forces: &[JointForce]) -> Vec<JointForce> {
        let back = |force: &JointForce| JointForce {
            normal: force.normal.map(|n| n * self.force),
            shear: force.shear * self.force,
        };
        forces.iter().map(back).collect()
    }

    /// A state in the case's units.
    pub(super) fn state(
        &self,
        lambda: f64,
        forces: &[JointForce],
        velocity: &[f64],
    ) -> CollapseState {
        CollapseState {
            lambda: lambda * self.multiplier,
            forces: self.forces(forces),
            mechanism: self.mechanism(velocity),
        }
    }

    /// A mechanism's velocities, on which the live load does unit work.
    pub(super) fn velocity(&self, scene: &Scene, mechanism: &Mechanism) -> Vec<f64> {
        let power = live_power(scene, mechanism) * self.multiplier / self.force;
        let motions = mechanism.motions.iter();
        let velocity = motions.flat_map(|motion| {
            let Motion { velocity, rotation } = motion;
            [velocity.x, velocity.y, rotation * self.length].map(|rate| rate / power)
        });
        velocity.collect()
    }

    /// Velocities as a mechanism in the case's length unit.
    pub(super) fn mechanism(&self, velocity: &[f64]) -> Mechanism {
        let motion = |u: &[f64]| Motion {
            velocity: Vector::new(u[0], u[1]),
            rotation: u[2] / self.length,
        };
        Mechanism {
            motions: velocity.chunks_exact(3).map(motion).collect(),
        }
    }
}
