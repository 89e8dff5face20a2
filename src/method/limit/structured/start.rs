//! Where the iteration starts.

use super::joint::Joint;
use super::newton::Balance;
use super::point::{InteriorPoint, LEFT};

impl InteriorPoint {
    /// Mehrotra's point: the forces of least slacks, the velocities of least multipliers, and both
    /// shifted inside.
    pub(super) fn start(&mut self) {
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
}
