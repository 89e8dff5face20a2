//! How far a point is from an optimum.

use super::newton::dot;
use super::point::InteriorPoint;

/// What a point leaves of the conditions of an optimum.
#[derive(Clone, Copy, Debug)]
pub(super) struct Measure {
    /// Sum of slacks times multipliers.
    pub(super) complementarity: f64,
    /// What costs are measured by.
    pub(super) size: f64,
    /// What forces cost at least: the cost of velocities, less what these leave of their conditions at
    /// forces of this size.
    pub(super) least_cost: f64,
    /// Relative gap between the costs of forces and of velocities. Far from the conditions it says
    /// nothing: where forces and velocities both cost next to nothing it is small.
    pub(super) gap: f64,
    /// Relative violation of the conditions on forces.
    pub(super) forces: f64,
    /// Relative violation of the conditions on velocities.
    pub(super) velocities: f64,
    /// Whether every block is in balance, measured against its own loads.
    pub(super) is_balanced: bool,
}

impl Measure {
    pub(super) fn largest(&self) -> f64 {
        self.gap.max(self.forces).max(self.velocities)
    }

    /// The same with complementarity, which every step is to lessen from the first one on.
    pub(super) fn distance(&self) -> f64 {
        self.largest().max(self.complementarity / self.size)
    }
}

impl InteriorPoint {
    /// What the point leaves of the conditions of an optimum, also joint by joint.
    pub(super) fn measure(&mut self) -> Measure {
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
        let mut sum = self.lambda.abs();
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
            sum += joint.forces.iter().map(|force| force.abs()).sum::<f64>();
            sizes[0] = largest(&joint.forces).max(sizes[0]);
            sizes[1] = largest(&joint.multipliers).max(sizes[1]);
        }
        let mut blocks = left.blocks.iter().zip(&self.exact);
        let size = costs[0].abs().min(costs[1].abs()).max(1.0);
        Measure {
            complementarity,
            size,
            least_cost: costs[1] - violated[1] * sum,
            gap: (costs[0] - costs[1]).abs() / size,
            forces: largest(&left.blocks).max(violated[0]) / sizes[0].max(1.0),
            velocities: violated[1] / sizes[1].max(self.multiplier_cost.abs()).max(1.0),
            is_balanced: blocks.all(|(left, exact)| left.abs() <= *exact),
        }
    }
}

/// The largest size of a number.
fn largest(numbers: &[f64]) -> f64 {
    numbers
        .iter()
        .fold(0.0, |most, number| number.abs().max(most))
}
