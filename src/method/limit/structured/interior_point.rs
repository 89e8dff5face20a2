//! The iteration: a prediction, a correction and a step towards the optimum.

use super::joint::{Joint, JointStep};
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

    fn answer(&self, iterations: usize) -> Solved {
        let mut variables: Vec<f64> = self.joints.iter().flat_map(|joint| joint.forces).collect();
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
