//! A point of the iteration: forces and velocities of one scene's program.

use super::joint::{Bodies, Joints};
use super::law::{LANES, Lanes, Law};
use super::newton::{Balance, Change, Newton};
use crate::method::limit::numbers::Numbers;

/// The solver of the programs of one scene.
pub(in super::super) struct InteriorPoint {
    pub(super) joints: Vec<Joints>,
    /// How many joints those are.
    pub(super) count: usize,
    /// Inequalities that count.
    pub(super) rows: usize,
    pub(super) newton: Newton,
    /// Right sides of the equilibrium rows.
    pub(super) right: Vec<f64>,
    pub(super) multiplier_cost: f64,
    pub(super) lambda: f64,
    pub(super) velocities: Vec<f64>,
    /// What the point leaves of equilibrium and of the push's unit power.
    pub(super) left: Balance,
    pub(super) change: Change,
    /// Largest distance of a block's corner force from its centroid, block by block.
    reaches: Vec<f64>,
    /// What every equilibrium row may leave.
    pub(super) exact: Vec<f64>,
}

/// Share of a block's own loads that may be left of its equilibrium; the judge allows 1e-6.
const OF_OWN: f64 = 1e-7;

/// The same for blocks without loads, as a share of the scene's weight.
const OF_WEIGHTLESS: f64 = 1e-13;

/// What a step may leave of equilibrium, whatever the blocks weigh: least, and most.
pub(super) const LEFT: [f64; 2] = [1e-15, 1e-11];

impl InteriorPoint {
    /// A solver for the matrix of a program.
    pub(in super::super) fn new(numbers: &Numbers) -> Self {
        let (matrix, blocks) = (&numbers.matrix, numbers.rows_of_blocks / 3);
        let column = |c: usize| {
            let range = matrix.colptr[c]..matrix.colptr[c + 1];
            let entries = matrix.rowval[range.clone()]
                .iter()
                .zip(&matrix.nzval[range]);
            entries
                .map(|(&row, &value)| (row, value))
                .filter(move |&(row, _)| row < 3 * blocks)
        };
        let count = numbers.slopes.len();
        let bodies = (0..count).map(|j| OneJoint::new(|k| column(3 * j + k)));
        let bodies: Vec<OneJoint> = bodies.collect();
        let joints = bodies.chunks(LANES);
        let joints: Vec<Joints> = joints.map(|some| Joints::new(side_by_side(some))).collect();
        let mut live = Vec::new();
        if matrix.n > 3 * count {
            live.resize(3 * blocks, 0.0);
            for (row, value) in column(3 * count) {
                live[row] = value;
            }
        }
        Self {
            newton: Newton::new(blocks, &joints, live),
            right: Vec::new(),
            multiplier_cost: 0.0,
            lambda: 0.0,
            velocities: vec![0.0; 3 * blocks],
            left: Balance::default(),
            change: Change::default(),
            reaches: reaches(blocks, &bodies),
            rows: 0,
            count,
            exact: Vec::new(),
            joints,
        }
    }

    /// Takes the numbers of a program.
    pub(super) fn load(&mut self, problem: &Numbers) {
        let (right, limits) = problem.right.split_at(self.velocities.len());
        self.right.clear();
        self.right.extend(right);
        let (count, mut first) = (self.count, 0);
        self.rows = 0;
        for joints in &mut self.joints {
            let are = std::array::from_fn(|lane| first + lane < count);
            // Of so many numbers a joint, one after the other.
            let each = |numbers: &[f64], of_joint: usize, k: usize| {
                let number = |lane| numbers[of_joint * (first + lane) + k];
                let number = |lane: usize| if are[lane] { number(lane) } else { 0.0 };
                Lanes::new(std::array::from_fn(number))
            };
            let slope = each(&problem.slopes, 1, 0);
            joints.law = Law::new(slope, std::array::from_fn(|k| each(limits, 4, k)), are);
            let cost = std::array::from_fn(|k| each(&problem.cost, 3, k));
            joints.cost = joints.law.of_variables(cost);
            self.rows += joints.law.rows();
            first += LANES;
        }
        let of_multiplier = problem.cost.get(3 * count);
        self.multiplier_cost = of_multiplier.copied().unwrap_or(0.0);
        self.exact.clear();
        for (load, reach) in right.chunks_exact(3).zip(&self.reaches) {
            let force = load[0].abs().max(load[1].abs());
            let force = if force == 0.0 {
                OF_WEIGHTLESS
            } else {
                OF_OWN * force
            };
            self.exact.extend([force, force, force * reach]);
        }
    }
}

/// Where the forces of one joint act.
struct OneJoint {
    to: usize,
    /// `None` at a support.
    from: Option<usize>,
    /// Equilibrium of either body by the forces, row by row.
    wrench: [[f64; 9]; 2],
}

impl OneJoint {
    /// From the entries of the joint's three columns in the equilibrium rows.
    fn new<C: Iterator<Item = (usize, f64)>>(column: impl Fn(usize) -> C) -> Self {
        let mut found: Vec<(usize, [f64; 9])> = Vec::with_capacity(2);
        for k in 0..3 {
            for (row, value) in column(k) {
                let known = found.iter().position(|(block, _)| *block == row / 3);
                let at = known.unwrap_or_else(|| {
                    found.push((row / 3, [0.0; 9]));
                    found.len() - 1
                });
                found[at].1[3 * (row % 3) + k] = value;
            }
        }
        let other = found.get(1);
        Self {
            to: found[0].0,
            from: other.map(|(block, _)| *block),
            wrench: [found[0].1, other.map_or([0.0; 9], |(_, wrench)| *wrench)],
        }
    }
}

/// Joints side by side, [`LANES`] of them or fewer.
fn side_by_side(joints: &[OneJoint]) -> Bodies {
    let blocks =
        |of: fn(&OneJoint) -> usize| std::array::from_fn(|lane| joints.get(lane).map_or(0, of));
    let entries = |body: usize, k: usize| {
        let entry = |lane: usize| joints.get(lane).map_or(0.0, |joint| joint.wrench[body][k]);
        Lanes::new(std::array::from_fn(entry))
    };
    Bodies {
        to: blocks(|joint| joint.to),
        from: blocks(|joint| joint.from.unwrap_or(joint.to)),
        wrench: [0, 1].map(|body| std::array::from_fn(|k| entries(body, k))),
    }
}

/// Largest moment about a block's centroid that a force of 1 has in any of its joints.
fn reaches(blocks: usize, joints: &[OneJoint]) -> Vec<f64> {
    let mut reaches = vec![0.0f64; blocks];
    for OneJoint { to, from, wrench } in joints {
        for (block, wrench) in [Some(*to), *from].into_iter().zip(wrench) {
            let Some(block) = block else { continue };
            let moments = wrench[6..].iter().map(|moment| moment.abs());
            reaches[block] = moments.fold(reaches[block], f64::max);
        }
    }
    reaches
}
