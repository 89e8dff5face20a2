//! Joints in the iteration, side by side: where they are, how far their inequalities are from their limits,
//! and their part of a step.

use super::law::{Forces, Inverse, LANES, Lanes, Law, Rows, sum};

/// [`LANES`] joints. Where a scene has no multiple of that, the last lanes hold none: nothing of them counts, and
/// their forces act nowhere.
#[derive(Clone, Debug)]
pub(super) struct Joints {
    pub(super) bodies: Bodies,
    pub(super) law: Law,
    pub(super) cost: Forces,
    pub(super) forces: Forces,
    /// How far the inequalities are from their limits; 1 for those that do not count.
    pub(super) slacks: Rows,
    /// Their multipliers; 1 for those that do not count.
    pub(super) multipliers: Rows,
    /// What is left of the condition on velocities.
    pub(super) left_flow: Forces,
    /// What the slacks leave of the inequalities.
    pub(super) left_slacks: Rows,
    /// One over the weights of the inequalities.
    pub(super) inverse_weights: Rows,
    pub(super) inverse: Inverse,
    /// What slacks times multipliers are to change by.
    pub(super) aim: Rows,
    pub(super) step: JointStep,
    /// Change of the forces before it was refined.
    pub(super) unrefined: Forces,
}

#[derive(Clone, Copy, Debug, Default)]
pub(super) struct JointStep {
    pub(super) forces: Forces,
    pub(super) slacks: Rows,
    pub(super) multipliers: Rows,
}

impl Joints {
    pub(super) fn new(bodies: Bodies) -> Self {
        Self {
            bodies,
            law: Law::default(),
            cost: Forces::default(),
            forces: Forces::default(),
            slacks: [Lanes::ONE; 4],
            multipliers: [Lanes::ONE; 4],
            left_flow: Forces::default(),
            left_slacks: Rows::default(),
            inverse_weights: [Lanes::ONE; 4],
            inverse: Inverse::default(),
            aim: Rows::default(),
            step: JointStep::default(),
            unrefined: Forces::default(),
        }
    }

    /// Sum of slacks times multipliers.
    pub(super) fn complementarity(&self) -> Lanes {
        let products = std::array::from_fn(|k| self.slacks[k] * self.multipliers[k]);
        sum(self.law.counted(products))
    }

    /// Measures what the joints leave of their conditions, velocities being this at their forces.
    pub(super) fn measure(&mut self, velocities: Forces) {
        let rates = self.law.rates(self.forces);
        let left = std::array::from_fn(|k| self.law.limits[k] - rates[k] - self.slacks[k]);
        self.left_slacks = self.law.counted(left);
        let flow = self.law.flow(self.multipliers);
        let left = std::array::from_fn(|k| -self.cost[k] - velocities[k] - flow[k]);
        self.left_flow = self.law.of_variables(left);
    }

    /// Sum of slacks times multipliers after a step of these lengths.
    pub(super) fn after(&self, [forces, velocities]: [f64; 2]) -> Lanes {
        let [forces, velocities] = [Lanes::splat(forces), Lanes::splat(velocities)];
        let after = std::array::from_fn(|k| {
            let slack = self.slacks[k] + forces * self.step.slacks[k];
            slack * (self.multipliers[k] + velocities * self.step.multipliers[k])
        });
        sum(self.law.counted(after))
    }

    /// Change of the multipliers that would reach the aim if the slacks stayed within their limits.
    fn reference(&self) -> Rows {
        std::array::from_fn(|k| {
            (self.aim[k] - self.multipliers[k] * self.left_slacks[k]) / self.slacks[k]
        })
    }

    /// Change of the forces, the bodies being held, that comes nearest to the aim.
    ///
    /// Far more exact than H⁻¹ times its right side, in which rates of order 1 cancel where the
    /// inequalities are at their limits.
    pub(super) fn held_change(&self) -> Forces {
        let to_aim =
            std::array::from_fn(|k| self.left_slacks[k] - self.aim[k] / self.multipliers[k]);
        let held = self.law.forces_of_rates(to_aim, self.inverse_weights);
        let free = self.inverse.apply(self.left_flow);
        std::array::from_fn(|k| held[k] + free[k])
    }

    /// Completes the step of the forces, velocities changing by this at them.
    pub(super) fn complete_step(&mut self, velocities: Forces) {
        let rates = self.law.rates(self.step.forces);
        let flow = std::array::from_fn(|k| self.left_flow[k] - velocities[k]);
        let slacks = std::array::from_fn(|k| self.left_slacks[k] - rates[k]);
        self.step.slacks = self.law.counted(slacks);
        self.step.multipliers =
            (self.law).multipliers(flow, self.reference(), self.inverse_weights);
    }
}

/// Where the forces of joints act.
#[derive(Clone, Copy, Debug)]
pub(super) struct Bodies {
    pub(super) to: [usize; LANES],
    /// The same block as `to` at a support.
    pub(super) from: [usize; LANES],
    /// Equilibrium of either body by the forces, row by row; zero at a support and in lanes without a joint.
    pub(super) wrench: [[Lanes; 9]; 2],
}

impl Bodies {
    /// Adds forces to the equilibrium rows of the bodies.
    pub(super) fn push(&self, forces: Forces, rows: &mut [f64]) {
        push(&self.wrench[0], forces, &self.to, rows);
        push(&self.wrench[1], forces, &self.from, rows);
    }

    /// What velocities of the bodies are at the forces.
    pub(super) fn pull(&self, velocities: &[f64]) -> Forces {
        let to = pull(&self.wrench[0], &self.to, velocities);
        let from = pull(&self.wrench[1], &self.from, velocities);
        std::array::from_fn(|k| to[k] + from[k])
    }
}

fn push(wrench: &[Lanes; 9], [a, b, c]: Forces, blocks: &[usize; LANES], rows: &mut [f64]) {
    let pushed: [[f64; LANES]; 3] = std::array::from_fn(|row| {
        let w = &wrench[3 * row..3 * row + 3];
        (w[0] * a + w[1] * b + w[2] * c).to_array()
    });
    for (lane, &block) in blocks.iter().enumerate() {
        for (row, pushed) in rows[3 * block..][..3].iter_mut().zip(&pushed) {
            *row += pushed[lane];
        }
    }
}

fn pull(wrench: &[Lanes; 9], blocks: &[usize; LANES], velocities: &[f64]) -> Forces {
    let of_blocks = blocks.map(|block| &velocities[3 * block..][..3]);
    let u: [Lanes; 3] = std::array::from_fn(|k| Lanes::new(of_blocks.map(|u| u[k])));
    std::array::from_fn(|k| wrench[k] * u[0] + wrench[3 + k] * u[1] + wrench[6 + k] * u[2])
}
