//! What changes of a program from one solution to the next: margins, friction laws, loads and costs.

use super::{FrictionLaw, Goal, Margins, Program};
use crate::method::limit::columns::right_side;
use crate::method::limit::solver::Change;
use crate::scene::Scene;

impl Program {
    /// Asks for a little more than admissible: every force inequality to hold with [`Margins::force`]
    /// to spare, every corner to open by [`Margins::opening`] beyond what the flow rule needs.
    ///
    /// The solver's own violations of 1e-12 then stay inside the margins, so forces and mechanism
    /// are admissible exactly and their multipliers are bounds, from the one solve. The price is a
    /// bracket of 1e-9 (33 blocks) to 6e-9 (1176 blocks) instead of 1e-12, at the same number of
    /// iterations (measured); margins ten times larger cost ten times the width and save nothing.
    pub(in super::super) fn set_margins(&mut self, margins: Margins) {
        for right in &mut self.numbers.right[self.numbers.rows_of_blocks..] {
            *right -= margins.force;
        }
        self.solver.update(&self.numbers, Change::Right);
        self.set_opening(margins.opening);
    }

    /// Asks for every corner to open by this much beyond what the flow rule needs, in the program's
    /// own units.
    pub(in super::super) fn set_opening(&mut self, opening: f64) {
        self.change_cost(1.0, |_| -opening);
    }

    /// Changes the friction law of every joint; one law a joint, in the scene's order.
    pub(in super::super) fn set_friction(&mut self, laws: &[FrictionLaw]) {
        for (j, law) in laws.iter().enumerate() {
            let slope = law.slope / self.shear_unit(j);
            let intercept = law.intercept / (self.joint_unit(j) * self.shear_unit(j));
            let numbers = &mut self.numbers;
            numbers.slopes[j] = slope;
            for at in self.friction_at[j] {
                numbers.matrix.nzval[at] = -slope;
            }
            let first = numbers.rows_of_blocks + 4 * j;
            numbers.right[first + 2..first + 4].fill(intercept);
        }
        self.solver.update(&self.numbers, Change::Matrix);
        self.solver.update(&self.numbers, Change::Right);
    }

    /// Asks for forces at another λ (in the case's unit), of a program for forces at a given one.
    pub(in super::super) fn set_multiplier(&mut self, scene: &Scene, lambda: f64) {
        self.goal = Goal::Forces(lambda);
        let mut balanced = right_side(scene, &self.scale, lambda);
        if let Some(units) = &self.equilibration {
            units.scale_rows(&mut balanced);
        }
        self.numbers.right[..balanced.len()].copy_from_slice(&balanced);
        self.solver.update(&self.numbers, Change::Right);
    }

    /// Changes the cost of every force, which is to be smallest: two corner forces and the shear of
    /// each joint, in the program's own units.
    pub(in super::super) fn set_force_cost(&mut self, cost: &[[f64; 3]]) {
        let all = &mut self.numbers.cost;
        all.fill(0.0);
        all[..3 * cost.len()].copy_from_slice(cost.as_flattened());
        self.solver.update(&self.numbers, Change::Cost);
    }

    /// Changes the cost: `lambda` · λ* (or the slack) − Σ price · (n1 + n2) is to be largest, with
    /// one price a joint in `normal`.
    pub(in super::super) fn set_cost(&mut self, lambda: f64, normal: &[f64]) {
        let prices: Vec<f64> = (normal.iter().enumerate())
            .map(|(j, price)| price * self.joint_unit(j))
            .collect();
        self.change_cost(lambda, |j| prices[j]);
    }

    /// Lets the solver end with any forces in equilibrium once those of the optimum are known to cost more
    /// than this, until the cost changes.
    pub(in super::super) fn end_above(&mut self, cost: f64) {
        self.numbers.useless_above = cost;
    }

    /// As [`Program::set_cost`], with prices in the program's own units.
    fn change_cost(&mut self, lambda: f64, price: impl Fn(usize) -> f64) {
        let joints = self.friction_at.len();
        self.numbers.useless_above = f64::INFINITY;
        let cost = &mut self.numbers.cost;
        cost.fill(0.0);
        for j in 0..joints {
            cost[3 * j] = price(j);
            cost[3 * j + 1] = price(j);
        }
        if let Some(last) = cost.get_mut(3 * joints) {
            *last = -lambda;
        }
        self.solver.update(&self.numbers, Change::Cost);
    }
}
