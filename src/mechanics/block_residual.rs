//! Residuals block by block and joint by joint, against what acts on that block alone.
//!
//! Over a whole scene's weight the violations of a light block vanish: a pillar of a millionth of
//! the weight may be out of balance altogether. Here each is measured against the block's own loads
//! and velocities.

use serde::{Deserialize, Serialize};
use thiserror::Error;

use super::mechanism::{JointRate, Mechanism};
use super::residual::{balances, live_unit};
use super::state::{CollapseState, JointForce};
use crate::scene::{Block, Joint, Scene, Wrench};

/// Largest residual of a block in a verified result, over that block's own forces and velocities.
pub const VERIFIED_BLOCK: f64 = 1e-6;

/// Share of the contact forces on a block that its residual is measured against where its own loads
/// are smaller. With [`VERIFIED_BLOCK`] it makes 1e-12 of those forces, which double precision
/// resolves: a light block squeezed by heavy ones must not hide behind what they exert on it.
const OF_CONTACT: f64 = 1e-6;

/// Share of the scene's force unit that stands for the loads of a block that has none at all.
const OF_WEIGHTLESS: f64 = 1e-9;

/// Share of the fastest block's velocity that rates are measured against where both blocks of a
/// joint are slower: what a solver leaves of the motion of blocks at rest is noise. On slower blocks
/// the residual of the whole scene bounds the power of every violation.
const SLOW: f64 = 1e-2;

/// The largest violation of one block's conditions, and which block it is.
#[derive(Clone, Copy, Debug, Default, Error, PartialEq, Serialize, Deserialize)]
#[error(
    "block {} violates its conditions by {value:.1e} of its own forces or velocities, and at most \
     {VERIFIED_BLOCK:.0e} is allowed",
    .block + 1
)]
pub struct BlockResidual {
    /// Violation as a share of the block's own forces, or velocities, or both.
    pub value: f64,
    /// Place of the block in the scene.
    pub block: usize,
}

impl BlockResidual {
    /// Violations of equilibrium, compression and friction at the multiplier `lambda`.
    pub fn of_forces(scene: &Scene, forces: &[JointForce], lambda: f64) -> Self {
        let loads = |block: &Block| block.loads_at(lambda);
        let largest = |block: &Block| {
            let sizes = block.loads.iter();
            let sizes = sizes.map(|load| load.dead.norm().max(lambda.abs() * load.live.norm()));
            sizes.fold(0.0, f64::max)
        };
        Self::under(scene, forces, loads, largest, scene.total_weight())
    }

    /// The same of a ray: forces that balance the live load for λ = 1 and nothing else.
    pub fn of_ray(scene: &Scene, ray: &[JointForce]) -> Self {
        let largest = |block: &Block| {
            let sizes = block.loads.iter().map(|load| load.live.norm());
            sizes.fold(0.0, f64::max)
        };
        Self::under(scene, ray, Block::live, largest, live_unit(scene))
    }

    fn under(
        scene: &Scene,
        forces: &[JointForce],
        loads: impl Fn(&Block) -> Wrench,
        largest: impl Fn(&Block) -> f64,
        unit: f64,
    ) -> Self {
        let contact = contact_forces(scene, forces);
        let units: Vec<f64> = (scene.blocks().iter().zip(&contact))
            .map(|(block, contact)| match largest(block) {
                0.0 => (OF_CONTACT * contact).max(OF_WEIGHTLESS * unit),
                own => own.max(OF_CONTACT * contact),
            })
            .collect();
        let mut out = Self::default();
        let loads = scene.blocks().iter().map(loads).collect();
        for (block, balance) in balances(scene, forces, loads).iter().enumerate() {
            let unit = units[block];
            let of_block = [unit, unit, unit * reach(&scene.blocks()[block])];
            for (value, unit) in balance.iter().zip(of_block) {
                out = out.or(value.abs() / unit, block);
            }
        }
        for (joint, force) in scene.joints().iter().zip(forces) {
            let [n1, n2] = force.normal;
            let excess = force.shear.abs() - joint.friction * (n1 + n2);
            let violation = excess.max(-n1).max(-n2);
            let (unit, block) = lightest(joint, &units);
            out = out.or(violation / unit, block);
        }
        out
    }

    /// Violations of opening ≥ μ|slip|, the associative flow rule, over the velocities of the
    /// joint's blocks.
    pub fn of_flow(scene: &Scene, mechanism: &Mechanism) -> Self {
        let rates = mechanism.joint_rates(scene);
        let speeds = Speeds::of(scene, mechanism);
        let mut out = Self::default();
        for (joint, rate) in scene.joints().iter().zip(&rates) {
            let closing = joint.friction * rate.slip.abs() - rate.opening[0].min(rate.opening[1]);
            out = out.or(closing / speeds.at(joint), joint.to);
        }
        out
    }

    /// Violations of the conditions that bind forces and a mechanism without dilatancy: no
    /// penetration, no force at an opening, full friction where a joint slips.
    pub fn of_collapse(scene: &Scene, forces: &[JointForce], mechanism: &Mechanism) -> Self {
        let rates = mechanism.joint_rates(scene);
        let speeds = Speeds::of(scene, mechanism);
        let contact = contact_forces(scene, forces);
        let units: Vec<f64> = (scene.blocks().iter().zip(&contact))
            .map(|(block, contact)| {
                let dead = block.loads.iter().map(|load| load.dead.norm());
                dead.fold(*contact, f64::max)
            })
            .collect();
        let mut out = Self::default();
        for ((joint, force), rate) in scene.joints().iter().zip(forces).zip(&rates) {
            let JointRate { opening, slip } = *rate;
            let (unit, block) = lightest(joint, &units);
            let [n1, n2] = force.normal;
            let idle = joint.friction * (n1 + n2) * slip.abs() + force.shear * slip;
            let powers = [n1 * opening[0], n2 * opening[1], idle];
            let power = powers.into_iter().fold(0.0, |sum, power| sum + power.abs());
            let speed = speeds.at(joint);
            let closing = -opening[0].min(opening[1]);
            out = out
                .or(closing / speed, block)
                .or(power / (unit * speed), block);
        }
        out
    }

    /// Violations of every condition of a collapse state.
    pub fn of_state(scene: &Scene, state: &CollapseState) -> Self {
        let CollapseState {
            lambda,
            forces,
            mechanism,
        } = state;
        let of_forces = Self::of_forces(scene, forces, *lambda);
        of_forces.worse(Self::of_collapse(scene, forces, mechanism))
    }

    /// The larger of two.
    pub fn worse(self, other: Self) -> Self {
        self.or(other.value, other.block)
    }

    /// Whether a result with it may be verified.
    pub fn is_small(&self) -> bool {
        self.value <= VERIFIED_BLOCK
    }

    /// The larger of this and a value at a block; a value that is none, such as what a block
    /// without velocity or force has of nothing, counts as nothing unless something is violated.
    fn or(self, value: f64, block: usize) -> Self {
        if value > self.value {
            Self { value, block }
        } else {
            self
        }
    }
}

/// Largest force that joints exert on every block.
fn contact_forces(scene: &Scene, forces: &[JointForce]) -> Vec<f64> {
    let mut largest = vec![0.0f64; scene.blocks().len()];
    for (joint, force) in scene.joints().iter().zip(forces) {
        let [n1, n2] = force.normal.map(f64::abs);
        let of_joint = n1.max(n2).max(force.shear.abs());
        for (block, _) in joint.blocks() {
            largest[block] = largest[block].max(of_joint);
        }
    }
    largest
}

/// The smallest unit of a joint's blocks, and whose it is.
fn lightest(joint: &Joint, units: &[f64]) -> (f64, usize) {
    let units = joint.blocks().map(|(block, _)| (units[block], block));
    let lightest = units.min_by(|a, b| a.0.total_cmp(&b.0));
    lightest.expect("a joint has a block")
}

/// Largest distance of a corner from the centroid.
pub fn reach(block: &Block) -> f64 {
    let centroid = block.shape.centroid();
    let corners = block.shape.corners().iter();
    corners.map(|c| (c - centroid).norm()).fold(0.0, f64::max)
}

/// Largest corner velocity of every block, and of all.
struct Speeds {
    of_blocks: Vec<f64>,
    fastest: f64,
}

impl Speeds {
    fn of(scene: &Scene, mechanism: &Mechanism) -> Self {
        let of_blocks = mechanism.speeds(scene);
        Self {
            fastest: of_blocks.iter().copied().fold(0.0, f64::max),
            of_blocks,
        }
    }

    /// What rates of a joint are measured against.
    fn at(&self, joint: &Joint) -> f64 {
        let speeds = joint.blocks().map(|(block, _)| self.of_blocks[block]);
        speeds.fold(SLOW * self.fastest, f64::max)
    }
}
