//! A point of the iteration: forces and velocities of one scene's program.

use super::joint::{Bodies, Joint};
use super::law::Law;
use super::newton::{Balance, Change, Newton};
use crate::method::limit::numbers::Numbers;

/// The solver of the programs of one scene.
pub(in super::super) struct InteriorPoint {
    pub(super) joints: Vec<Joint>,
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
        let joints = (0..numbers.slopes.len()).map(|j| Joint::new(bodies(|k| column(3 * j + k))));
        let joints: Vec<Joint> = joints.collect();
        let mut live = Vec::new();
        if matrix.n > 3 * joints.len() {
            live.resize(3 * blocks, 0.0);
            for (row, value) in column(3 * joints.len()) {
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
            reaches: reaches(blocks, &joints),
            exact: Vec::new(),
            joints,
        }
    }

    /// Takes the numbers of a program.
    pub(super) fn load(&mut self, problem: &Numbers) {
        let (right, limits) = problem.right.split_at(self.velocities.len());
        self.right.clear();
        self.right.extend(right);
        let numbers =
            (limits.chunks_exact(4).zip(&problem.slopes)).zip(problem.cost.chunks_exact(3));
        for (joint, ((limits, slope), cost)) in self.joints.iter_mut().zip(numbers) {
            joint.law = Law::new(*slope, std::array::from_fn(|k| limits[k]));
            joint.cost = std::array::from_fn(|k| cost[k]);
            if joint.law.is_smooth {
                joint.cost[2] = 0.0;
            }
        }
        let of_multiplier = problem.cost.get(3 * self.joints.len());
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

/// Where a joint's forces act, from the entries of its three columns in the equilibrium rows.
fn bodies<C: Iterator<Item = (usize, f64)>>(column: impl Fn(usize) -> C) -> Bodies {
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
    Bodies {
        to: found[0].0,
        from: other.map(|(block, _)| *block),
        wrench: [found[0].1, other.map_or([0.0; 9], |(_, wrench)| *wrench)],
    }
}

/// Largest moment about a block's centroid that a force of 1 has in any of its joints.
fn reaches(blocks: usize, joints: &[Joint]) -> Vec<f64> {
    let mut reaches = vec![0.0f64; blocks];
    for Bodies { to, from, wrench } in joints.iter().map(|joint| joint.bodies) {
        for (block, wrench) in [Some(to), from].into_iter().zip(wrench) {
            let Some(block) = block else { continue };
            let moments = wrench[6..].iter().map(|moment| moment.abs());
            reaches[block] = moments.fold(reaches[block], f64::max);
        }
    }
    reaches
}
