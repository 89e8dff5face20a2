//! The iteration: a prediction, a correction and a step towards the optimum.

use super::joint::{Bodies, Joint, JointStep, Law};
use super::newton::{Balance, Change, Newton, dot};
use super::problem::{Answer, Problem};
use crate::answer::magnitude;

/// The solver of the programs of one scene.
pub(in super::super) struct InteriorPoint {
    joints: Vec<Joint>,
    newton: Newton,
    /// Right sides of the equilibrium rows.
    right: Vec<f64>,
    multiplier_cost: f64,
    lambda: f64,
    velocities: Vec<f64>,
    /// What the point leaves of equilibrium and of the push's unit power.
    left: Balance,
    change: Change,
    /// Largest distance of a block's corner force from its centroid, block by block.
    reaches: Vec<f64>,
    /// What every equilibrium row may leave.
    exact: Vec<f64>,
}

/// What a point leaves of the conditions of an optimum.
#[derive(Clone, Copy, Debug)]
struct Measure {
    /// Sum of slacks times multipliers.
    complementarity: f64,
    /// What costs are measured by.
    size: f64,
    /// Relative gap between the costs of forces and of velocities. Far from the conditions it says
    /// nothing: where forces and velocities both cost next to nothing it is small.
    gap: f64,
    /// Relative violation of the conditions on forces.
    forces: f64,
    /// Relative violation of the conditions on velocities.
    velocities: f64,
    /// Whether every block is in balance, measured against its own loads.
    is_balanced: bool,
}

impl Measure {
    fn largest(&self) -> f64 {
        self.gap.max(self.forces).max(self.velocities)
    }

    /// The same with complementarity, which every step is to lessen from the first one on.
    fn distance(&self) -> f64 {
        self.largest().max(self.complementarity / self.size)
    }
}

/// Iterations after which it gives up.
const ITERATIONS: usize = 100;

/// Iterations without progress after which it gives up, and after which it is content with an answer
/// that is [`ALMOST`] one.
const PATIENCE: usize = 12;
const SOON: usize = 2;

/// Share of the largest violation that counts as progress.
const PROGRESS: f64 = 0.9;

/// Violations, in tolerances, of an answer where no better one is found: near degenerate optima
/// rounding takes over there. Clarabel's own limit is far wider.
const ALMOST: f64 = 10.0;

/// Share of the way to the nearest limit that a step goes, far from the optimum and near it.
const SHARES: [f64; 2] = [0.99, 0.9995];

/// Share of a block's own loads that may be left of its equilibrium; the judge allows 1e-6.
const OF_OWN: f64 = 1e-7;

/// The same for blocks without loads, as a share of the scene's weight.
const OF_WEIGHTLESS: f64 = 1e-13;

/// What a step may leave of equilibrium, whatever the blocks weigh: least, and most.
const LEFT: [f64; 2] = [1e-15, 1e-11];

impl InteriorPoint {
    /// A solver for the matrix of a program, in compressed columns.
    pub(in super::super) fn new(
        blocks: usize,
        joints: usize,
        (starts, rows, values): (&[usize], &[usize], &[f64]),
    ) -> Self {
        let column = |c: usize| {
            let range = starts[c]..starts[c + 1];
            let entries = rows[range.clone()].iter().zip(&values[range]);
            entries
                .map(|(&row, &value)| (row, value))
                .filter(move |&(row, _)| row < 3 * blocks)
        };
        let joints = (0..joints).map(|j| Joint::new(bodies(|k| column(3 * j + k))));
        let joints: Vec<Joint> = joints.collect();
        let mut live = Vec::new();
        if starts.len() > 3 * joints.len() + 1 {
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

    /// The optimum, or the iterations after which this solver gave up.
    pub(in super::super) fn solve(&mut self, problem: &Problem) -> Result<Answer, usize> {
        self.load(problem);
        self.start();
        let (mut best, mut since) = (f64::INFINITY, 0);
        let mut almost = None;
        for iterations in 0..ITERATIONS {
            let measure = self.measure();
            let largest = measure.largest();
            // Whatever is no number is none of the gap.
            if !measure.gap.is_finite() {
                return almost.ok_or(iterations);
            }
            if largest <= problem.tolerance && measure.is_balanced {
                return Ok(self.answer(iterations));
            }
            since += 1;
            if measure.distance() < PROGRESS * best {
                (best, since) = (measure.distance(), 0);
                if self.is_almost(&measure, problem) {
                    almost = Some(self.answer(iterations));
                }
            }
            let is_enough = best <= ALMOST * problem.tolerance && almost.is_some();
            let patience = if is_enough { SOON } else { PATIENCE };
            if since > patience {
                return almost.ok_or(iterations);
            }
            self.step(measure.complementarity);
        }
        almost.ok_or(ITERATIONS)
    }

    /// Whether a point is an answer where no better one is found.
    fn is_almost(&self, measure: &Measure, problem: &Problem) -> bool {
        let violation = ALMOST * problem.tolerance;
        let width = problem.width * magnitude(self.lambda, 1.0);
        measure.is_balanced
            && measure.forces.max(measure.velocities) <= violation
            && measure.gap <= violation.max(width / measure.size)
    }

    /// Takes the numbers of a program.
    fn load(&mut self, problem: &Problem) {
        let (right, limits) = problem.right.split_at(self.velocities.len());
        self.right.clear();
        self.right.extend(right);
        let numbers =
            (limits.chunks_exact(4).zip(problem.slopes)).zip(problem.cost.chunks_exact(3));
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

    /// Mehrotra's point: the forces of least slacks, the velocities of least multipliers, and both
    /// shifted inside.
    fn start(&mut self) {
        let zero = vec![0.0; self.right.len()];
        for joint in &mut self.joints {
            joint.inverse_weights = [1.0; 4];
        }
        self.newton.factorise(&mut self.joints);
        let balance = Balance {
            blocks: self.right.clone(),
            push: 0.0,
        };
        let limits = |joint: &Joint| {
            let flow = joint.law.flow(joint.counted(joint.law.limits));
            joint.inverse.apply(flow)
        };
        (self.newton).solve(
            &mut self.joints,
            limits,
            &balance,
            LEFT[1],
            &mut self.change,
        );
        self.lambda = self.change.lambda;
        for joint in &mut self.joints {
            joint.forces = joint.step.forces;
            let rates = joint.law.rates(joint.forces);
            joint.slacks = std::array::from_fn(|k| joint.law.limits[k] - rates[k]);
        }
        let balance = Balance {
            blocks: zero,
            push: -self.multiplier_cost,
        };
        let cost = |joint: &Joint| joint.inverse.apply(joint.cost.map(|cost| -cost));
        (self.newton).solve(&mut self.joints, cost, &balance, LEFT[1], &mut self.change);
        self.velocities.clone_from(&self.change.velocities);
        for joint in &mut self.joints {
            joint.multipliers = joint.law.rates(joint.step.forces);
        }
        self.shift_inside();
    }

    fn shift_inside(&mut self) {
        let pairs = |joints: &[Joint], f: &mut dyn FnMut(f64, f64)| {
            for joint in joints {
                for k in 0..joint.law.rows() {
                    f(joint.slacks[k], joint.multipliers[k]);
                }
            }
        };
        let mut least = [f64::INFINITY; 2];
        pairs(&self.joints, &mut |s, z| {
            least = [least[0].min(s), least[1].min(z)]
        });
        let [slack, multiplier] = least.map(|least| (-1.5 * least).max(0.0));
        let (mut product, mut sums) = (0.0, [0.0; 2]);
        pairs(&self.joints, &mut |s, z| {
            product += (s + slack) * (z + multiplier);
            sums = [sums[0] + s + slack, sums[1] + z + multiplier];
        });
        let further = |sum: f64| {
            if product > 0.0 {
                0.5 * product / sum
            } else {
                1.0
            }
        };
        let (slack, multiplier) = (slack + further(sums[1]), multiplier + further(sums[0]));
        for joint in &mut self.joints {
            let rows = joint.law.rows();
            joint.slacks.iter_mut().for_each(|s| *s += slack);
            joint.multipliers.iter_mut().for_each(|z| *z += multiplier);
            joint.slacks[rows..].fill(1.0);
            joint.multipliers[rows..].fill(0.0);
        }
    }

    /// What the point leaves of the conditions of an optimum, also joint by joint.
    fn measure(&mut self) -> Measure {
        let live = self.newton.live();
        let left = &mut self.left;
        left.blocks.clone_from(&self.right);
        for (left, live) in left.blocks.iter_mut().zip(live) {
            *left -= live * self.lambda;
        }
        left.push = -self.multiplier_cost - dot(live, &self.velocities);
        let mut costs = [
            self.multiplier_cost * self.lambda,
            -dot(&self.right, &self.velocities),
        ];
        let mut complementarity = 0.0;
        let mut violated = [0.0, left.push.abs()];
        let mut sizes = [self.lambda.abs(), largest(&self.velocities)];
        for joint in &mut self.joints {
            let against = joint.forces.map(|force| -force);
            joint.bodies.push(against, &mut left.blocks);
            joint.measure(joint.bodies.pull(&self.velocities));
            let rows = joint.law.rows();
            complementarity += dot(&joint.slacks[..rows], &joint.multipliers[..rows]);
            costs[0] += dot(&joint.cost, &joint.forces);
            costs[1] -= dot(&joint.law.limits[..rows], &joint.multipliers[..rows]);
            violated[0] = largest(&joint.left_slacks).max(violated[0]);
            violated[1] = largest(&joint.left_flow).max(violated[1]);
            sizes[0] = largest(&joint.forces).max(sizes[0]);
            sizes[1] = largest(&joint.multipliers).max(sizes[1]);
        }
        let mut blocks = left.blocks.iter().zip(&self.exact);
        let size = costs[0].abs().min(costs[1].abs()).max(1.0);
        Measure {
            complementarity,
            size,
            gap: (costs[0] - costs[1]).abs() / size,
            forces: largest(&left.blocks).max(violated[0]) / sizes[0].max(1.0),
            velocities: violated[1] / sizes[1].max(self.multiplier_cost.abs()).max(1.0),
            is_balanced: blocks.all(|(left, exact)| left.abs() <= *exact),
        }
    }

    /// One iteration, from the sum of slacks times multipliers.
    fn step(&mut self, complementarity: f64) {
        let rows: usize = self.joints.iter().map(|joint| joint.law.rows()).sum();
        for joint in &mut self.joints {
            for k in 0..joint.law.rows() {
                joint.inverse_weights[k] = joint.slacks[k] / joint.multipliers[k];
                joint.aim[k] = -joint.slacks[k] * joint.multipliers[k];
            }
        }
        self.newton.factorise(&mut self.joints);
        self.set_direction(f64::INFINITY);
        let lengths = self.lengths().map(|length| length.min(1.0));
        let predicted: f64 = self.joints.iter().map(|joint| joint.after(lengths)).sum();
        let centred = (predicted / complementarity).powi(3).clamp(1e-8, 1.0);
        let aim = centred * complementarity / rows as f64;
        for joint in &mut self.joints {
            let JointStep {
                slacks,
                multipliers,
                ..
            } = joint.step;
            joint.aim = std::array::from_fn(|k| joint.aim[k] + aim - slacks[k] * multipliers[k]);
        }
        let exact = self.exact.iter().copied().fold(LEFT[1], f64::min);
        let small = (0.1 * exact).max(LEFT[0]).max(1e-3 * self.left.size());
        self.set_direction(small);
        let share = (1.0 - complementarity / rows as f64).clamp(SHARES[0], SHARES[1]);
        let [forces, velocities] = self.lengths().map(|length| (share * length).min(1.0));
        self.go(forces, velocities);
    }

    /// The step that reaches the aims of all joints.
    fn set_direction(&mut self, small: f64) {
        let joints = &mut self.joints;
        (self.newton).solve(
            joints,
            Joint::held_change,
            &self.left,
            small,
            &mut self.change,
        );
        for joint in joints {
            joint.complete_step(joint.bodies.pull(&self.change.velocities));
        }
    }

    /// How far forces and velocities can go until one of their limits is met.
    fn lengths(&self) -> [f64; 2] {
        let mut fastest = [0.0f64; 2];
        for joint in &self.joints {
            for k in 0..joint.law.rows() {
                fastest[0] = fastest[0].max(-joint.step.slacks[k] / joint.slacks[k]);
                fastest[1] = fastest[1].max(-joint.step.multipliers[k] / joint.multipliers[k]);
            }
        }
        fastest.map(|fastest| 1.0 / fastest)
    }

    fn go(&mut self, forces: f64, velocities: f64) {
        for joint in &mut self.joints {
            let step = &joint.step;
            for k in 0..3 {
                joint.forces[k] += forces * step.forces[k];
            }
            for k in 0..4 {
                joint.slacks[k] += forces * step.slacks[k];
                joint.multipliers[k] += velocities * step.multipliers[k];
            }
        }
        self.lambda += forces * self.change.lambda;
        for (velocity, change) in self.velocities.iter_mut().zip(&self.change.velocities) {
            *velocity += velocities * change;
        }
    }

    fn answer(&self, iterations: usize) -> Answer {
        let mut forces: Vec<f64> = self.joints.iter().flat_map(|joint| joint.forces).collect();
        if !self.newton.live().is_empty() {
            forces.push(self.lambda);
        }
        Answer {
            forces,
            velocities: self.velocities.clone(),
            iterations,
        }
    }
}

/// The largest size of a number.
fn largest(numbers: &[f64]) -> f64 {
    numbers
        .iter()
        .fold(0.0, |most, number| number.abs().max(most))
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_start_without_costs_is_not_near_the_optimum() {
        // The first points of a wall of 20,100 blocks.
        let measure = |complementarity, gap, velocities| Measure {
            complementarity,
            size: 1.0,
            gap,
            forces: 1e-3,
            velocities,
            is_balanced: true,
        };
        let first = measure(42.8, 1.1e-7, 5.5e-2);
        let second = measure(13.6, 3.3, 5.9e-3);
        assert!(second.distance() < PROGRESS * first.distance());
    }
}
