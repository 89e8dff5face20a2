//! The conditions of a scene as sparse rows, without dimensions: forces over the total weight,
//! lengths over the height, λ over its unit.

use std::collections::VecDeque;

use crate::scene::{Block, Joint, Point, Scene, Side, Vector};

/// One entry of a sparse row: its place and its value.
pub(crate) type Entry = (usize, f64);

/// A joint's conditions.
#[derive(Clone, Debug)]
pub(crate) struct JointRows {
    /// How the first corner's opening, the second's and the slip follow from the velocities; the same numbers are what a unit of either corner force and of the shear puts on the
    /// blocks.
    pub(crate) rates: [Vec<Entry>; 3],
    /// Coefficient of friction.
    pub(crate) friction: f64,
}

/// That a joint's forward slip is no more than what the joints along another way between its sides
/// add to it: Σ share · rate − g⁺ ≥ 0. Slips are split with g⁺ g⁻ = 0 here.
#[derive(Clone, Debug)]
pub(crate) struct SlipBound {
    pub(crate) joint: usize,
    /// Whether that way has three joints, so that it is used where shorter ones do not suffice.
    pub(crate) is_long: bool,
    /// Rates, four a joint, and their positive shares.
    pub(crate) shares: Vec<Entry>,
    /// What rounding may leave of each velocity between the slip and what it is made of, at most.
    pub(super) rounding: Vec<Entry>,
}

/// All conditions of a scene. Its velocities are three a block, and one of all supports that move, whose
/// guides are no joints here: they do no work, and hold whatever the others do not.
#[derive(Clone, Debug)]
pub(crate) struct Conditions {
    /// Joints in the scene's order.
    pub(crate) joints: Vec<JointRows>,
    /// Dead load, by velocity.
    pub(crate) dead: Vec<f64>,
    /// Live load for λ* = 1.
    pub(crate) live: Vec<f64>,
    /// λ for λ* = 1.
    pub(crate) unit: f64,
    pub(crate) slip_bounds: Vec<SlipBound>,
}

impl Conditions {
    pub(crate) fn of(scene: &Scene) -> Self {
        let (force, length) = (scene.total_weight(), scene.height());
        let unit = scene.multiplier_unit();
        let unknown = Unknown::of(scene);
        let scaled = |[x, y, moment]: [f64; 3], factor: f64| {
            [x, y, moment / length].map(|part| part * factor / force)
        };
        let of = |load: fn(&Block) -> [f64; 3], factor: f64| {
            let blocks = scene.blocks().iter();
            let loads = blocks.map(|block| scaled(load(block), factor));
            unknown.powers(&loads.collect::<Vec<_>>())
        };
        let rows = |joint: &Joint| JointRows {
            rates: [
                (joint.ends[0], joint.normal),
                (joint.ends[1], joint.normal),
                (joint.ends[0], joint.tangent()),
            ]
            .map(|(point, direction)| rate_row(scene, &unknown, joint, (point, direction))),
            friction: joint.friction,
        };
        Self {
            joints: scene.contacts().iter().map(rows).collect(),
            dead: of(Block::dead, 1.0),
            live: of(Block::live, unit),
            unit,
            slip_bounds: Vec::new(),
        }
    }

    /// Number of velocities, and of equilibrium conditions.
    pub(crate) fn velocities(&self) -> usize {
        self.dead.len()
    }

    /// Number of force conditions: four a joint, then 1, λ − a and b − λ.
    pub(crate) fn force_rows(&self) -> usize {
        4 * self.joints.len() + 3
    }

    /// Row of the live load's power among the rates, behind four a joint.
    pub(crate) fn power(&self) -> usize {
        4 * self.joints.len()
    }

    /// Number of rates: four a joint, the power of the live load, then what slips may grow by up to
    /// their bounds.
    pub(crate) fn rate_rows(&self) -> usize {
        self.power() + 1 + self.slip_bounds.len()
    }

    /// A rate of a joint, or the power, in the kinematic unknowns.
    pub(crate) fn rate_row(&self, rate: usize) -> Vec<Entry> {
        let (joint, kind) = (rate / 4, rate % 4);
        let Some(rows) = self.joints.get(joint) else {
            let live = self.live.iter().copied().enumerate();
            return live.filter(|entry| entry.1 != 0.0).collect();
        };
        let forward = (self.velocities() + joint, 1.0);
        match kind {
            0 | 1 => rows.rates[kind].clone(),
            2 => vec![forward],
            _ => {
                let slip = rows.rates[2].iter().map(|&(k, value)| (k, -value));
                slip.chain([forward]).collect()
            }
        }
    }

    /// Number of kinematic unknowns: velocities, then the forward slip of every joint.
    pub(crate) fn motions(&self) -> usize {
        self.velocities() + self.joints.len()
    }

    /// Number of force unknowns that equilibrium leaves free.
    pub(crate) fn free_forces(&self) -> usize {
        self.forces().saturating_sub(self.velocities())
    }

    /// Number of force unknowns: 1, λ, then three a joint.
    pub(crate) fn forces(&self) -> usize {
        2 + 3 * self.joints.len()
    }
}

/// Which velocities are unknown.
pub(crate) struct Unknown {
    /// Blocks that have three of their own.
    free: usize,
    /// Velocities of the supports that move, per unit of the one that is theirs.
    supports: Vec<Share>,
}

impl Unknown {
    pub(crate) fn of(scene: &Scene) -> Self {
        let height = scene.height();
        let supports = scene.support_motion().into_iter();
        let supports: Vec<Share> = supports.map(|[x, y, turn]| [x, y, turn * height]).collect();
        Self {
            free: scene.blocks().len() - supports.len(),
            supports,
        }
    }

    /// What three numbers of a block are by the unknown velocities.
    fn entries(&self, block: usize, parts: Share) -> Vec<Entry> {
        let Some(support) = block.checked_sub(self.free) else {
            return parts
                .into_iter()
                .enumerate()
                .map(|(k, part)| (3 * block + k, part))
                .collect();
        };
        let along = self.supports[support].iter().zip(parts);
        vec![(
            3 * self.free,
            along.map(|(velocity, part)| velocity * part).sum(),
        )]
    }

    /// The power of loads, three a block, by velocity.
    fn powers(&self, loads: &[Share]) -> Vec<f64> {
        let mut powers = vec![0.0; 3 * self.free + usize::from(!self.supports.is_empty())];
        for (block, &load) in loads.iter().enumerate() {
            for (k, part) in self.entries(block, load) {
                powers[k] += part;
            }
        }
        powers
    }

    /// The unknown ones of a motion of all blocks, three each.
    pub(crate) fn velocities(&self, of_blocks: &[f64]) -> Vec<f64> {
        let (free, moving) = of_blocks.split_at(3 * self.free);
        let speed = self.supports.first().map(|support| {
            let along: f64 = support.iter().zip(moving).map(|(a, b)| a * b).sum();
            along / support.iter().map(|part| part * part).sum::<f64>()
        });
        free.iter().copied().chain(speed).collect()
    }
}

/// Velocity of a joint's block `to` against its `from`, at a point and in a direction.
fn rate_row(
    scene: &Scene,
    unknown: &Unknown,
    joint: &Joint,
    (point, direction): (Point, Vector),
) -> Vec<Entry> {
    let mut row = Vec::with_capacity(6);
    let mut add = |block: usize, sign: f64| {
        let arm = (point - scene.blocks()[block].shape.centroid()) / scene.height();
        let parts = [direction.x, direction.y, arm.perp(&direction)];
        let entries = unknown.entries(block, parts).into_iter();
        row.extend(
            entries
                .filter(|entry| entry.1 != 0.0)
                .map(|(k, part)| (k, sign * part)),
        );
    };
    if let Side::Block(from) = joint.from {
        add(from, -1.0);
    }
    add(joint.to, 1.0);
    row
}

/// A velocity of a block per unit of a rate: x, y and rotation.
pub(super) type Share = [f64; 3];

/// Rates that a velocity follows from, four a joint and the power of the live load, and what a unit of each
/// adds to it; of a slip that is both its parts.
pub(super) type Chain = Vec<Entry>;

/// How each velocity follows from the rates along one chain of joints from a support to its block.
/// Supports that move have the speed that the power of their live load tells. `None` where a block hangs
/// on no such chain.
pub(super) fn chains(scene: &Scene, conditions: &Conditions) -> Option<Vec<Chain>> {
    let count = scene.blocks().len();
    let unknown = Unknown::of(scene);
    let mut joints_of: Vec<Vec<usize>> = vec![Vec::new(); count];
    let mut queue = VecDeque::new();
    let mut chains: Vec<Option<Vec<(usize, Share)>>> = vec![None; count];
    let centroid = |block: usize| scene.blocks()[block].shape.centroid();
    let of_power = conditions.live.last().map_or(0.0, |live| 1.0 / live);
    for (support, velocity) in unknown.supports.iter().enumerate() {
        let share = velocity.map(|part| part * of_power);
        chains[unknown.free + support] = Some(vec![(conditions.power(), share)]);
    }
    for (j, joint) in scene.contacts().iter().enumerate() {
        joints_of[joint.to].push(j);
        match joint.from {
            Side::Block(from) => joints_of[from].push(j),
            Side::Support(_) if chains[joint.to].is_none() => {
                let own = relative(scene, j, centroid(joint.to), 1.0);
                chains[joint.to] = Some(own.collect());
                queue.push_back(joint.to);
            }
            Side::Support(_) => {}
        }
    }
    queue.extend(unknown.free..count);
    while let Some(parent) = queue.pop_front() {
        for &j in &joints_of[parent] {
            let joint = &scene.contacts()[j];
            let (child, sign) = match joint.from {
                Side::Block(from) if joint.to == parent => (from, -1.0),
                Side::Block(_) => (joint.to, 1.0),
                Side::Support(_) => continue,
            };
            if chains[child].is_some() {
                continue;
            }
            let arm = (centroid(child) - centroid(parent)) / scene.height();
            let carried = chains[parent].iter().flatten();
            let carried = carried
                .map(|&(rate, [x, y, turn])| (rate, [x - turn * arm.y, y + turn * arm.x, turn]));
            let own = relative(scene, j, centroid(child), sign);
            chains[child] = Some(carried.chain(own).collect());
            queue.push_back(child);
        }
    }
    let chains = chains.into_iter().collect::<Option<Vec<_>>>()?;
    let along = |block: usize, k: usize| {
        let parts = chains[block].iter();
        parts.map(|&(rate, share)| (rate, share[k])).collect()
    };
    let of_blocks = (0..unknown.free).flat_map(|block| [0, 1, 2].map(|k| along(block, k)));
    let of_supports = (unknown.free < count).then(|| vec![(conditions.power(), of_power)]);
    Some(of_blocks.chain(of_supports).collect())
}

/// Motion of a joint's two sides against each other, at a point, per unit of each of its rates: of both
/// openings and of the slip.
pub(super) fn relative(
    scene: &Scene,
    j: usize,
    point: Point,
    sign: f64,
) -> impl Iterator<Item = (usize, Share)> {
    let joint = &scene.contacts()[j];
    let across = (joint.ends[1] - joint.ends[0]) / scene.height();
    let lever = joint.normal.y * across.x - joint.normal.x * across.y;
    let arm = (point - joint.ends[0]) / scene.height();
    let turned = |turn: f64, at: Vector| {
        let [x, y] = [at.x - turn * arm.y, at.y + turn * arm.x];
        [x, y, turn].map(|part| sign * part)
    };
    let shares = [
        turned(-1.0 / lever, joint.normal),
        turned(1.0 / lever, Vector::zeros()),
        turned(0.0, joint.tangent()),
    ];
    let rates = shares.into_iter().enumerate();
    rates.map(move |(kind, share)| (4 * j + kind, share))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::{HeadJoints, Wall};

    /// Kinematics: rates of any velocities give these velocities back, to rounding.
    #[test]
    fn rates_along_a_chain_give_the_velocities_back() {
        let wall = Wall::laid([4.0, 1.75], 0.65, &["h1h", "11", "h1h"]);
        let scene = wall.scene(HeadJoints::Contact).unwrap();
        let conditions = Conditions::of(&scene);
        let velocity: Vec<f64> = (0..conditions.velocities())
            .map(|k| ((k * k + 3) as f64 * 0.7).sin())
            .collect();
        let rate = |row: &[Entry]| -> f64 { row.iter().map(|&(k, v)| v * velocity[k]).sum() };
        let chains = chains(&scene, &conditions).unwrap();
        assert_eq!(chains.len(), velocity.len());
        for (chain, expected) in chains.iter().zip(&velocity) {
            let parts = chain.iter();
            let sum: f64 = parts
                .map(|&(at, share)| share * rate(&conditions.joints[at / 4].rates[at % 4]))
                .sum();
            assert!((sum - expected).abs() < 1e-12);
        }
    }
}
