//! The conditions of a scene as sparse rows, without dimensions: forces over the total weight,
//! lengths over the height, λ over its unit.

use std::collections::VecDeque;

use crate::scene::{Joint, Point, Scene, Side, Vector};

/// One entry of a sparse row: its place and its value.
pub(crate) type Entry = (usize, f64);

/// A joint's conditions.
#[derive(Clone, Debug)]
pub(crate) struct JointRows {
    /// How the first corner's opening, the second's and the slip follow from the velocities, three a
    /// block; the same numbers are what a unit of either corner force and of the shear puts on the
    /// blocks.
    pub(crate) rates: [Vec<Entry>; 3],
    /// Coefficient of friction.
    pub(crate) friction: f64,
}

/// That a joint's forward slip is no more than what the joints along another way between its sides
/// add to it: Σ share · rate − g⁺ ≥ 0. Slips are split with g⁺ g⁻ = 0 here.
#[derive(Clone, Debug)]
pub(crate) struct SlipBound {
    /// The joint.
    pub(crate) joint: usize,
    /// Rates, four a joint, and their positive shares.
    pub(crate) shares: Vec<Entry>,
    /// What rounding may leave of each velocity between the slip and what it is made of, at most.
    pub(super) rounding: Vec<Entry>,
}

/// All conditions of a scene.
#[derive(Clone, Debug)]
pub(crate) struct Conditions {
    /// Joints in the scene's order.
    pub(crate) joints: Vec<JointRows>,
    /// Dead load on the blocks, three numbers a block.
    pub(crate) dead: Vec<f64>,
    /// Live load for λ* = 1.
    pub(crate) live: Vec<f64>,
    /// λ for λ* = 1.
    pub(crate) unit: f64,
    /// What limits slips.
    pub(crate) slip_bounds: Vec<SlipBound>,
}

impl Conditions {
    /// Those of a scene.
    pub(crate) fn of(scene: &Scene) -> Self {
        let (force, length) = (scene.total_weight(), scene.height());
        let unit = scene.multiplier_unit();
        let scaled = |[x, y, moment]: [f64; 3], factor: f64| {
            [x, y, moment / length].map(|part| part * factor / force)
        };
        let blocks = scene.blocks().iter();
        let dead = blocks.clone().flat_map(|block| scaled(block.dead(), 1.0));
        let live = blocks.flat_map(|block| scaled(block.live(), unit));
        let rows = |joint: &Joint| JointRows {
            rates: [
                (joint.ends[0], joint.normal),
                (joint.ends[1], joint.normal),
                (joint.ends[0], joint.tangent()),
            ]
            .map(|(point, direction)| rate_row(scene, joint, point, direction)),
            friction: joint.friction,
        };
        Self {
            joints: scene.joints().iter().map(rows).collect(),
            dead: dead.collect(),
            live: live.collect(),
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

/// Velocity of a joint's block `to` against its `from`, at a point and in a direction.
fn rate_row(scene: &Scene, joint: &Joint, point: Point, direction: Vector) -> Vec<Entry> {
    let mut row = Vec::with_capacity(6);
    let mut add = |block: usize, sign: f64| {
        let arm = (point - scene.blocks()[block].shape.centroid()) / scene.height();
        let parts = [direction.x, direction.y, arm.perp(&direction)];
        for (k, part) in parts.into_iter().enumerate() {
            if part != 0.0 {
                row.push((3 * block + k, sign * part));
            }
        }
    };
    if let Side::Block(from) = joint.from {
        add(from, -1.0);
    }
    add(joint.to, 1.0);
    row
}

/// A velocity of a block per unit of a rate: x, y and rotation.
pub(super) type Share = [f64; 3];

/// How the velocities of each block follow from the rates along one chain of joints from a support
/// to it: joint, kind of rate (opening, opening, slip) and what a unit of it adds. `None` where a
/// block hangs on no such chain.
pub(super) fn chains(scene: &Scene) -> Option<Vec<Vec<(usize, usize, Share)>>> {
    let count = scene.blocks().len();
    let mut joints_of: Vec<Vec<usize>> = vec![Vec::new(); count];
    let mut queue = VecDeque::new();
    let mut chains: Vec<Option<Vec<(usize, usize, Share)>>> = vec![None; count];
    let centroid = |block: usize| scene.blocks()[block].shape.centroid();
    for (j, joint) in scene.joints().iter().enumerate() {
        joints_of[joint.to].push(j);
        match joint.from {
            Side::Block(from) => joints_of[from].push(j),
            Side::Support(_) if chains[joint.to].is_none() => {
                chains[joint.to] = Some(relative(scene, j, centroid(joint.to), 1.0));
                queue.push_back(joint.to);
            }
            Side::Support(_) => {}
        }
    }
    while let Some(parent) = queue.pop_front() {
        for &j in &joints_of[parent] {
            let joint = &scene.joints()[j];
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
            let carried = carried.map(|&(joint, kind, [x, y, turn])| {
                (joint, kind, [x - turn * arm.y, y + turn * arm.x, turn])
            });
            let own = relative(scene, j, centroid(child), sign);
            chains[child] = Some(carried.chain(own).collect());
            queue.push_back(child);
        }
    }
    chains.into_iter().collect()
}

/// Motion of a joint's two sides against each other, at a point, per unit of each rate.
pub(super) fn relative(
    scene: &Scene,
    j: usize,
    point: Point,
    sign: f64,
) -> Vec<(usize, usize, Share)> {
    let joint = &scene.joints()[j];
    let across = (joint.ends[1] - joint.ends[0]) / scene.height();
    let lever = joint.normal.y * across.x - joint.normal.x * across.y;
    let arm = (point - joint.ends[0]) / scene.height();
    let turned = |turn: f64, at: Vector| {
        let [x, y] = [at.x - turn * arm.y, at.y + turn * arm.x];
        [x, y, turn].map(|part| sign * part)
    };
    vec![
        (j, 0, turned(-1.0 / lever, joint.normal)),
        (j, 1, turned(1.0 / lever, Vector::zeros())),
        (j, 2, turned(0.0, joint.tangent())),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::certificate::walls::wall;
    use crate::scene::Piece;

    /// Kinematics: rates of any velocities give these velocities back, to rounding.
    #[test]
    fn rates_along_a_chain_give_the_velocities_back() {
        use Piece::{Half, Unit};
        let scene = wall(&[&[Half, Unit, Half], &[Unit, Unit], &[Half, Unit, Half]]);
        let conditions = Conditions::of(&scene);
        let velocity: Vec<f64> = (0..conditions.velocities())
            .map(|k| ((k * k + 3) as f64 * 0.7).sin())
            .collect();
        let rate = |row: &[Entry]| -> f64 { row.iter().map(|&(k, v)| v * velocity[k]).sum() };
        for (block, chain) in chains(&scene).unwrap().iter().enumerate() {
            for k in 0..3 {
                let parts = chain.iter();
                let sum: f64 = parts
                    .map(|&(j, kind, share)| share[k] * rate(&conditions.joints[j].rates[kind]))
                    .sum();
                assert!((sum - velocity[3 * block + k]).abs() < 1e-12);
            }
        }
    }
}
