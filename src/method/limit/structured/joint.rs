//! One joint in the iteration: where it is, how far its inequalities are from their limits, and its
//! part of a step.

use super::law::{Forces, Inverse, Law, Rows};

#[derive(Clone, Debug)]
pub(super) struct Joint {
    pub(super) bodies: Bodies,
    pub(super) law: Law,
    pub(super) cost: Forces,
    pub(super) forces: Forces,
    /// How far its inequalities are from their limits.
    pub(super) slacks: Rows,
    /// Their multipliers.
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

impl Joint {
    pub(super) fn new(bodies: Bodies) -> Self {
        Self {
            bodies,
            law: Law::default(),
            cost: [0.0; 3],
            forces: [0.0; 3],
            slacks: [1.0; 4],
            multipliers: [0.0; 4],
            left_flow: [0.0; 3],
            left_slacks: [0.0; 4],
            inverse_weights: [1.0; 4],
            inverse: Inverse::default(),
            aim: [0.0; 4],
            step: JointStep::default(),
            unrefined: [0.0; 3],
        }
    }

    /// Values of the inequalities that count; nothing for the others.
    pub(super) fn counted(&self, mut values: Rows) -> Rows {
        values[self.law.rows()..].fill(0.0);
        values
    }

    /// Measures what the joint leaves of its conditions, velocities being this at its forces.
    pub(super) fn measure(&mut self, velocities: Forces) {
        let rates = self.law.rates(self.forces);
        let left = std::array::from_fn(|k| self.law.limits[k] - rates[k] - self.slacks[k]);
        self.left_slacks = self.counted(left);
        let flow = self.law.flow(self.multipliers);
        self.left_flow = std::array::from_fn(|k| -self.cost[k] - velocities[k] - flow[k]);
        if self.law.is_smooth {
            self.left_flow[2] = 0.0;
        }
    }

    /// Sum of slacks times multipliers after a step of these lengths.
    pub(super) fn after(&self, [forces, velocities]: [f64; 2]) -> f64 {
        let after = |k: usize| {
            let slack = self.slacks[k] + forces * self.step.slacks[k];
            slack * (self.multipliers[k] + velocities * self.step.multipliers[k])
        };
        (0..self.law.rows()).map(after).sum()
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
        self.step.slacks = self.counted(slacks);
        self.step.multipliers =
            (self.law).multipliers(flow, self.reference(), self.inverse_weights);
    }
}

/// Where a joint's forces act.
#[derive(Clone, Copy, Debug)]
pub(super) struct Bodies {
    pub(super) to: usize,
    pub(super) from: Option<usize>,
    /// Equilibrium of either body by the forces, row by row.
    pub(super) wrench: [[f64; 9]; 2],
}

impl Bodies {
    /// Adds forces to the equilibrium rows of the bodies.
    pub(super) fn push(&self, forces: Forces, rows: &mut [f64]) {
        push(&self.wrench[0], forces, &mut rows[3 * self.to..][..3]);
        if let Some(from) = self.from {
            push(&self.wrench[1], forces, &mut rows[3 * from..][..3]);
        }
    }

    /// What velocities of the bodies are at the forces.
    pub(super) fn pull(&self, velocities: &[f64]) -> Forces {
        let mut out = pull(&self.wrench[0], &velocities[3 * self.to..][..3]);
        if let Some(from) = self.from {
            let other = pull(&self.wrench[1], &velocities[3 * from..][..3]);
            out = std::array::from_fn(|k| out[k] + other[k]);
        }
        out
    }
}

fn push(wrench: &[f64; 9], [a, b, c]: Forces, rows: &mut [f64]) {
    for (row, w) in rows.iter_mut().zip(wrench.chunks_exact(3)) {
        *row += w[0] * a + w[1] * b + w[2] * c;
    }
}

fn pull(wrench: &[f64; 9], u: &[f64]) -> Forces {
    std::array::from_fn(|k| wrench[k] * u[0] + wrench[3 + k] * u[1] + wrench[6 + k] * u[2])
}
