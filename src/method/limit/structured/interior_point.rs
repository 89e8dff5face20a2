//! The iteration: a prediction, a correction and a step towards the optimum.

use super::joint::{JointStep, Joints};
use super::law::{LANES, Lanes, total};
use super::measure::Measure;
use super::point::{InteriorPoint, LEFT};
use crate::answer::{SolverEnding, magnitude};
use crate::method::limit::numbers::{Numbers, Solved};
use crate::method::settings::Engine;

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

impl InteriorPoint {
    /// The optimum, or the iterations after which this solver gave up.
    pub(in super::super) fn solve(&mut self, problem: &Numbers) -> Result<Solved, usize> {
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
            if measure.least_cost > problem.useless_above && measure.is_balanced {
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
    fn is_almost(&self, measure: &Measure, problem: &Numbers) -> bool {
        let violation = ALMOST * problem.tolerance;
        let width = problem.width * magnitude(self.lambda, 1.0);
        measure.is_balanced
            && measure.forces.max(measure.velocities) <= violation
            && measure.gap <= violation.max(width / measure.size)
    }

    /// One iteration, from the sum of slacks times multipliers.
    fn step(&mut self, complementarity: f64) {
        let rows = self.rows as f64;
        for joints in &mut self.joints {
            for k in 0..4 {
                joints.inverse_weights[k] = joints.slacks[k] / joints.multipliers[k];
                joints.aim[k] = -joints.slacks[k] * joints.multipliers[k];
            }
        }
        self.newton.factorise(&mut self.joints);
        self.set_direction(f64::INFINITY);
        let lengths = self.lengths().map(|length| length.min(1.0));
        let after = self.joints.iter().map(|joints| joints.after(lengths));
        let predicted = total(after.fold(Lanes::ZERO, |sum, lanes| sum + lanes));
        let centred = (predicted / complementarity).powi(3).clamp(1e-8, 1.0);
        let aim = centred * complementarity / rows;
        for joints in &mut self.joints {
            let JointStep {
                slacks,
                multipliers,
                ..
            } = joints.step;
            joints.aim = std::array::from_fn(|k| {
                joints.aim[k] + Lanes::splat(aim) - slacks[k] * multipliers[k]
            });
        }
        let exact = self.exact.iter().copied().fold(LEFT[1], f64::min);
        let small = (0.1 * exact).max(LEFT[0]).max(1e-3 * self.left.size());
        self.set_direction(small);
        let share = (1.0 - complementarity / rows).clamp(SHARES[0], SHARES[1]);
        let [forces, velocities] = self.lengths().map(|length| (share * length).min(1.0));
        self.go(forces, velocities);
    }

    /// The step that reaches the aims of all joints.
    fn set_direction(&mut self, small: f64) {
        let joints = &mut self.joints;
        (self.newton).solve(
            joints,
            Joints::held_change,
            &self.left,
            small,
            &mut self.change,
        );
        for joints in joints {
            joints.complete_step(joints.bodies.pull(&self.change.velocities));
        }
    }

    /// How far forces and velocities can go until one of their limits is met.
    fn lengths(&self) -> [f64; 2] {
        let mut fastest = [Lanes::ZERO; 2];
        for joints in &self.joints {
            for k in 0..4 {
                fastest[0] = fastest[0].max(-joints.step.slacks[k] / joints.slacks[k]);
                fastest[1] = fastest[1].max(-joints.step.multipliers[k] / joints.multipliers[k]);
            }
        }
        fastest.map(|lanes| 1.0 / lanes.as_array().iter().copied().fold(0.0, f64::max))
    }

    fn go(&mut self, forces: f64, velocities: f64) {
        let [of_forces, of_velocities] = [forces, velocities].map(Lanes::splat);
        for joints in &mut self.joints {
            let step = &joints.step;
            for k in 0..3 {
                joints.forces[k] += of_forces * step.forces[k];
            }
            for k in 0..4 {
                joints.slacks[k] += of_forces * step.slacks[k];
                joints.multipliers[k] += of_velocities * step.multipliers[k];
            }
        }
        self.lambda += forces * self.change.lambda;
        for (velocity, change) in self.velocities.iter_mut().zip(&self.change.velocities) {
            *velocity += velocities * change;
        }
    }

    fn answer(&self, iterations: usize) -> Solved {
        let forces = self.joints.iter().flat_map(|joints| {
            let [n1, n2, t] = joints.forces.map(Lanes::to_array);
            (0..LANES).flat_map(move |lane| [n1[lane], n2[lane], t[lane]])
        });
        let mut variables: Vec<f64> = forces.take(3 * self.count).collect();
        if !self.newton.live().is_empty() {
            variables.push(self.lambda);
        }
        Solved {
            ending: SolverEnding::Optimum,
            variables,
            velocities: self.velocities.clone(),
            iterations,
            engine: Engine::Structured,
        }
    }
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
            least_cost: 0.0,
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
