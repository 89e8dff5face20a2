//! A second scaling of the program, block by block and joint by joint, for scenes whose blocks differ
//! in weight or size by orders of magnitude, or whose joints hardly slip.
//!
//! A solver leaves violations of 1e-12 of the total weight, which is more than everything that acts
//! on a block of a millionth of it. Units of the blocks' own make the forces of light blocks exact,
//! and what is left of their velocities is divided by the same units, so that neither extreme will do:
//! a unit is a power of the block's force, between 0 (the scene's unit) and 1 (the block's). On blocks
//! of much the same weight own units do harm, as [`Scale`] says.

use super::columns::Entries;
use super::scale::Scale;
use super::vertical;
use crate::mechanics::{JointForce, reach};
use crate::scene::{Block, Joint, Scene};

/// Which power of a block's own force its unit is. Of 45 walls and arches whose blocks' weights spread
/// over 8 decades the cube root answered all, the square root 38, the whole force 10; of 200 loose
/// towers over 12 decades 181, 200 and 200; a pillar of 1e-5 of a block's size takes the whole force.
/// So where one fails, the next is tried.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum UnitPower {
    CubeRoot,
    SquareRoot,
    Whole,
    /// One unit for all blocks, however unequal they are.
    Common,
}

/// The powers that are tried on a scene, in that order; one where no block has units of its own.
pub(super) fn unit_powers(scene: &Scene) -> &'static [UnitPower] {
    const ALL: [UnitPower; 3] = [UnitPower::CubeRoot, UnitPower::SquareRoot, UnitPower::Whole];
    if needs_own_units(scene) {
        &ALL
    } else {
        &ALL[..1]
    }
}

impl UnitPower {
    fn unit(self, value: f64) -> f64 {
        power_of_two(match self {
            UnitPower::CubeRoot => value.cbrt(),
            UnitPower::SquareRoot => value.sqrt(),
            UnitPower::Whole => value,
            UnitPower::Common => 1.0,
        })
    }
}

/// Units inside a program: powers of two, so that scaling rounds nothing.
#[derive(Clone, Debug)]
pub(super) struct Equilibration {
    /// Force and length unit of every block, in those of the [`Scale`].
    blocks: Vec<[f64; 2]>,
    /// Force unit of every joint, in that of the [`Scale`].
    pub(super) joints: Vec<f64>,
    /// Unit of every joint's shear, in that of the joint.
    pub(super) shears: Vec<f64>,
}

/// Share of the scene's force times length below which the moments of a block need units of their
/// own: what the solver leaves is 1e-12 of that, a proof takes 1e-6 of the block's, and a thousand
/// joints may add to it.
const LIGHT: f64 = 1e-3;

/// The same as a share of the largest block's: on many blocks of much the same size each is a small
/// part of the scene, and none is lost.
const UNEQUAL: f64 = 1e-3;

impl Equilibration {
    /// Units for a scene that needs them.
    pub(super) fn of(scene: &Scene, scale: &Scale, power: UnitPower) -> Option<Self> {
        let (own, reaches) = (own_loads(scene, scale), reaches(scene, scale));
        let shears = shear_units(scene);
        if power != UnitPower::Common && are_unequal(&own, &reaches) {
            let joints = joint_forces(scene, scale, &own);
            Some(Self {
                blocks: block_units(scene, &own, &joints, &reaches, power),
                joints: joints.into_iter().map(|force| power.unit(force)).collect(),
                shears,
            })
        } else if are_sticky(&shears) {
            Some(Self {
                blocks: vec![[1.0; 2]; own.len()],
                joints: vec![1.0; shears.len()],
                shears,
            })
        } else {
            None
        }
    }

    /// Scales a value of every equilibrium row.
    pub(super) fn scale_rows(&self, values: &mut [f64]) {
        for (row, value) in values.iter_mut().enumerate() {
            *value *= self.of_row(row);
        }
    }

    /// Factor of one of the program's equilibrium rows, three a block.
    pub(super) fn of_row(&self, row: usize) -> f64 {
        let [force, length] = self.blocks[row / 3];
        match row % 3 {
            2 => 1.0 / (force * length),
            _ => 1.0 / force,
        }
    }

    /// Scales the equilibrium rows (`right` is their right side) by the blocks' units and the joints'
    /// columns by theirs; `friction_at` tells where a joint's friction coefficients stand. A joint's
    /// inequalities have its unit on both sides.
    pub(super) fn scale(
        &self,
        entries: &mut Entries,
        right: &mut [f64],
        friction_at: &[[usize; 4]],
    ) {
        for (at, shear) in friction_at.iter().zip(&self.shears) {
            at.iter().for_each(|&at| entries.values[at] /= shear);
        }
        for column in 0..entries.starts.len() - 1 {
            let of_joint = self.joints.get(column / 3).copied().unwrap_or(1.0);
            let of_shear = self.shears.get(column / 3).filter(|_| column % 3 == 2);
            let unit = of_joint * of_shear.copied().unwrap_or(1.0);
            for at in entries.starts[column]..entries.starts[column + 1] {
                let row = entries.rows[at];
                if row < right.len() {
                    entries.values[at] *= unit * self.of_row(row);
                }
            }
        }
        self.scale_rows(right);
    }
}

/// Whether programs of this scene have units of blocks or joints: those that double precision is
/// known to strain at.
pub(super) fn needs_own_units(scene: &Scene) -> bool {
    let scale = Scale::of(scene);
    let unequal = are_unequal(&own_loads(scene, &scale), &reaches(scene, &scale));
    unequal || are_sticky(&shear_units(scene))
}

fn reaches(scene: &Scene, scale: &Scale) -> Vec<f64> {
    let blocks = scene.blocks().iter();
    blocks.map(|block| reach(block) / scale.length).collect()
}

fn shear_units(scene: &Scene) -> Vec<f64> {
    let joints = scene.joints().iter();
    joints.map(|joint| shear_unit(joint.friction)).collect()
}

fn are_sticky(shears: &[f64]) -> bool {
    shears.iter().any(|&unit| unit > 1.0)
}

fn are_unequal(own: &[f64], reaches: &[f64]) -> bool {
    let sizes = own
        .iter()
        .zip(reaches)
        .map(|(force, length)| force * length);
    let (mut least, mut largest) = (f64::INFINITY, 0.0f64);
    for size in sizes.filter(|&size| size > 0.0) {
        least = least.min(size);
        largest = largest.max(size);
    }
    least < LIGHT && least < UNEQUAL * largest
}

/// What every joint has to carry, roughly: the lighter block's own loads, or what it carries under
/// the own weight where that is more.
fn joint_forces(scene: &Scene, scale: &Scale, own: &[f64]) -> Vec<f64> {
    let of_joint = |(joint, carried): (&Joint, f64)| {
        let loads = joint.blocks().map(|(block, _)| own[block]);
        let least = loads.filter(|&own| own > 0.0).fold(f64::INFINITY, f64::min);
        if least.is_finite() {
            least.max(carried)
        } else {
            carried
        }
    };
    let carried = carried(scene, scale);
    scene.joints().iter().zip(carried).map(of_joint).collect()
}

/// Force and length unit of every block: its own loads, or what its joints carry.
fn block_units(
    scene: &Scene,
    own: &[f64],
    joints: &[f64],
    reaches: &[f64],
    power: UnitPower,
) -> Vec<[f64; 2]> {
    let mut forces = own.to_vec();
    for (joint, &force) in scene.joints().iter().zip(joints) {
        for (block, _) in joint.blocks() {
            forces[block] = forces[block].max(force);
        }
    }
    let units = forces.iter().zip(reaches);
    units
        .map(|(&force, &length)| [power.unit(force), power_of_two(length)])
        .collect()
}

/// Coefficient of friction beyond which a joint's shear has a unit of its own: what the solver leaves
/// of a slip comes back multiplied by the coefficient, as an opening that is missing.
const STICKY: f64 = 100.0;

fn shear_unit(friction: f64) -> f64 {
    if friction > STICKY {
        power_of_two(friction.sqrt())
    } else {
        1.0
    }
}

/// Largest load of every block, dead or live for λ* = 1.
fn own_loads(scene: &Scene, scale: &Scale) -> Vec<f64> {
    let of_block = |block: &Block| {
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

/// The nearest power of two; 1 of what is no positive number.
fn power_of_two(value: f64) -> f64 {
    if value > 0.0 && value.is_finite() {
        value.log2().round().exp2()
    } else {
        1.0
    }
}
