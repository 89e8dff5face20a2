//! A second scaling of the program, block by block and joint by joint, for scenes whose blocks differ
//! in weight or size by orders of magnitude.
//!
//! A solver leaves violations of 1e-12 of the total weight, which is more than everything that acts
//! on a block of a millionth of it. Where every block's forces and lengths are of order 1, they are
//! as small beside each of them. On blocks of much the same weight this scaling is the worse one, as
//! [`Scale`] says, so that it is kept for those that need it.

use super::scale::Scale;
use super::vertical;
use crate::answer::{JointForce, reach};
use crate::scene::{Joint, Scene, Side};

/// Powers of two, so that scaling rounds nothing.
#[derive(Clone, Debug)]
pub(super) struct Equilibration {
    /// Force and length unit of every block, in those of the [`Scale`].
    pub(super) blocks: Vec<[f64; 2]>,
    /// Force unit of every joint, in that of the [`Scale`].
    pub(super) joints: Vec<f64>,
}

/// Share of the scene's force times length below which the moments of a block need units of their
/// own: what the solver leaves is 1e-12 of that, and a proof takes 1e-6 of the block's.
const LIGHT: f64 = 1e-3;

/// The same as a share of the largest block's: on many blocks of much the same size each is a small
/// part of the scene, and none is lost.
const UNEQUAL: f64 = 1e-3;

impl Equilibration {
    /// Units for a scene with blocks so light or small that they need them.
    pub(super) fn of(scene: &Scene, scale: &Scale) -> Option<Self> {
        let own = own_loads(scene, scale);
        let reaches = scene.blocks().iter().map(|b| reach(b) / scale.length);
        let reaches: Vec<f64> = reaches.collect();
        let sizes = own
            .iter()
            .zip(&reaches)
            .map(|(force, length)| force * length);
        let (least, largest) = sizes
            .filter(|&size| size > 0.0)
            .fold((f64::INFINITY, 0.0f64), |(a, b), size| {
                (a.min(size), b.max(size))
            });
        let needed = least < LIGHT && least < UNEQUAL * largest;
        needed.then(|| Self::around(scene, scale, &own, &reaches))
    }

    fn around(scene: &Scene, scale: &Scale, own: &[f64], reaches: &[f64]) -> Self {
        let carried = carried(scene, scale);
        let joints: Vec<f64> = (scene.joints().iter().zip(carried))
            .map(|(joint, carried)| {
                let loads = bodies(joint)
                    .map(|block| own[block])
                    .filter(|&own| own > 0.0);
                let least = loads.fold(f64::INFINITY, f64::min);
                power_of_two(if least.is_finite() {
                    least.max(carried)
                } else {
                    carried
                })
            })
            .collect();
        let mut forces = own.to_vec();
        for (joint, unit) in scene.joints().iter().zip(&joints) {
            for block in bodies(joint) {
                forces[block] = forces[block].max(*unit);
            }
        }
        let blocks = forces.iter().zip(reaches);
        Self {
            blocks: blocks
                .map(|(&force, &length)| [force, length].map(power_of_two))
                .collect(),
            joints,
        }
    }

    /// Scales a value of every equilibrium row.
    pub(super) fn scale_rows(&self, values: &mut [f64]) {
        for (row, value) in values.iter_mut().enumerate() {
            *value *= self.of_block_row(row);
        }
    }

    /// Factor of a row of the program: of a block's three, or one of a joint's.
    pub(super) fn of_block_row(&self, row: usize) -> f64 {
        let [force, length] = self.blocks[row / 3];
        match row % 3 {
            2 => 1.0 / (force * length),
            _ => 1.0 / force,
        }
    }
}

/// Largest load of every block, dead or live for λ* = 1.
fn own_loads(scene: &Scene, scale: &Scale) -> Vec<f64> {
    let of_block = |block: &crate::scene::Block| {
        let sizes = block.loads.iter();
        let sizes = sizes.map(|load| load.dead.norm().max(load.live.norm() * scale.multiplier));
        sizes.fold(0.0, f64::max) / scale.force
    };
    scene.blocks().iter().map(of_block).collect()
}

/// Roughly what every joint carries under the own weight; nothing where only a program could tell.
fn carried(scene: &Scene, scale: &Scale) -> Vec<f64> {
    let of_joint = |force: JointForce| force.normal[0].abs().max(force.normal[1].abs());
    match vertical::forces(scene) {
        Some(forces) => (forces.into_iter())
            .map(|force| of_joint(force) / scale.force)
            .collect(),
        None => vec![0.0; scene.joints().len()],
    }
}

fn bodies(joint: &Joint) -> impl Iterator<Item = usize> {
    let from = match joint.from {
        Side::Block(from) => Some(from),
        Side::Support(_) => None,
    };
    std::iter::once(joint.to).chain(from)
}

/// The nearest power of two; 1 of what is no positive number.
fn power_of_two(value: f64) -> f64 {
    if value > 0.0 && value.is_finite() {
        value.log2().round().exp2()
    } else {
        1.0
    }
}
