//! How far a point is from an optimum.

use super::law::{Lanes, sum, total};
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
        let zero = Lanes::ZERO;
        let (mut complementarity, mut costs, mut sums) = (zero, [zero; 2], zero);
        let (mut violated, mut sizes) = ([zero; 2], [zero; 2]);
        for joints in &mut self.joints {
            let against = joints.forces.map(|force| -force);
            joints.bodies.push(against, &mut left.blocks);
            joints.measure(joints.bodies.pull(&self.velocities));
            complementarity += joints.complementarity();
            costs[0] += products(&joints.cost, &joints.forces);
            costs[1] -= products(&joints.law.limits, &joints.multipliers);
            violated[0] = largest_of(violated[0], &joints.left_slacks);
            violated[1] = largest_of(violated[1], &joints.left_flow);
            sums += sum(joints.forces.map(Lanes::abs));
            sizes[0] = largest_of(sizes[0], &joints.forces);
            sizes[1] = largest_of(sizes[1], &joints.multipliers);
        }
        let costs = [
            self.multiplier_cost * self.lambda + total(costs[0]),
            total(costs[1]) - dot(&self.right, &self.velocities),
        ];
        let [of_slacks, of_flow] = violated.map(|lanes| largest(lanes.as_array()));
        let violated = [of_slacks, of_flow.max(left.push.abs())];
        let [of_forces, of_multipliers] = sizes.map(|lanes| largest(lanes.as_array()));
        let sizes = [
            of_forces.max(self.lambda.abs()),
            of_multipliers.max(largest(&self.velocities)),
        ];
        let forces = self.lambda.abs() + total(sums);
        let complementarity = total(complementarity);
        let mut blocks = left.blocks.iter().zip(&self.exact);
        let size = costs[0].abs().min(costs[1].abs()).max(1.0);
        Measure {
            complementarity,
            size,
            least_cost: costs[1] - violated[1] * forces,
            gap: (costs[0] - costs[1]).abs() / size,
            forces: largest(&left.blocks).max(violated[0]) / sizes[0].max(1.0),
            velocities: violated[1] / sizes[1].max(self.multiplier_cost.abs()).max(1.0),
            is_balanced: blocks.all(|(left, exact)| left.abs() <= *exact),
        }
    }
}

/// The sum of products, joint by joint.
fn products<const N: usize>(a: &[Lanes; N], b: &[Lanes; N]) -> Lanes {
    sum(std::array::from_fn::<_, N, _>(|k| a[k] * b[k]))
}

/// The largest size, joint by joint.
fn largest_of(most: Lanes, numbers: &[Lanes]) -> Lanes {
    numbers
        .iter()
        .fold(most, |most, number| most.max(number.abs()))
}

/// The largest size of a number.
fn largest(numbers: &[f64]) -> f64 {
    numbers
        .iter()
        .fold(0.0, |most, number| number.abs().max(most))
}
