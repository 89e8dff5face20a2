//! Where the iteration starts.

use super::joint::Joints;
use super::law::{Lanes, sum, total};
use super::newton::Balance;
use super::point::{InteriorPoint, LEFT};

impl InteriorPoint {
    /// Mehrotra's point: the forces of least slacks, the velocities of least multipliers, and both
    /// shifted inside.
    pub(super) fn start(&mut self) {
        let zero = vec![0.0; self.right.len()];
        for joints in &mut self.joints {
            joints.inverse_weights = [Lanes::ONE; 4];
        }
        self.newton.factorise(&mut self.joints);
        let balance = Balance {
            blocks: self.right.clone(),
            push: 0.0,
        };
        let limits = |joints: &Joints| {
            let flow = joints.law.flow(joints.law.limits);
            joints.inverse.apply(flow)
        };
        (self.newton).solve(
            &mut self.joints,
            limits,
            &balance,
            LEFT[1],
            &mut self.change,
        );
        self.lambda = self.change.lambda;
        for joints in &mut self.joints {
            joints.forces = joints.step.forces;
            let rates = joints.law.rates(joints.forces);
            joints.slacks = std::array::from_fn(|k| joints.law.limits[k] - rates[k]);
        }
        let balance = Balance {
            blocks: zero,
            push: -self.multiplier_cost,
        };
        let cost = |joints: &Joints| joints.inverse.apply(joints.cost.map(|cost| -cost));
        (self.newton).solve(&mut self.joints, cost, &balance, LEFT[1], &mut self.change);
        self.velocities.clone_from(&self.change.velocities);
        for joints in &mut self.joints {
            joints.multipliers = joints.law.rates(joints.step.forces);
        }
        self.shift_inside();
    }

    fn shift_inside(&mut self) {
        let infinite = f64::INFINITY;
        let mut least = [Lanes::splat(infinite); 2];
        for joints in &self.joints {
            let both = [joints.slacks, joints.multipliers];
            for (least, rows) in least.iter_mut().zip(both) {
                let rows = joints.law.counted_or(rows, infinite);
                *least = rows.into_iter().fold(*least, Lanes::min);
            }
        }
        let least = least.map(|lanes| lanes.as_array().iter().copied().fold(infinite, f64::min));
        let inside = least.map(|least| Lanes::splat((-1.5 * least).max(0.0)));
        let (mut product, mut sums) = (Lanes::ZERO, [Lanes::ZERO; 2]);
        for joints in &mut self.joints {
            joints.slacks = joints.slacks.map(|s| s + inside[0]);
            joints.multipliers = joints.multipliers.map(|z| z + inside[1]);
            product += joints.complementarity();
            sums[0] += sum(joints.law.counted(joints.slacks));
            sums[1] += sum(joints.law.counted(joints.multipliers));
        }
        let product = total(product);
        let further = sums.map(|sum| {
            Lanes::splat(if product > 0.0 {
                0.5 * product / total(sum)
            } else {
                1.0
            })
        });
        for joints in &mut self.joints {
            let slacks = joints.slacks.map(|s| s + further[1]);
            let multipliers = joints.multipliers.map(|z| z + further[0]);
            joints.slacks = joints.law.counted_or(slacks, 1.0);
            joints.multipliers = joints.law.counted_or(multipliers, 1.0);
        }
    }
}
