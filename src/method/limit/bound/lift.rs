//! The lifted program of one slice, in the forces that are in equilibrium.
//!
//! Unknown is Y = s·kᵀ. Forces s = N z in equilibrium have few free numbers z, and a motion has three
//! velocities u a block and a forward slip g⁺ a joint; so Y = N (Z, G⁺) with one column a motion.

use nalgebra::DMatrix;

use super::parameters::{INDEPENDENT, Parameters};
use crate::certificate::Conditions;

/// What does not depend on the slice: forces in equilibrium, and the conditions.
pub(super) struct Lift {
    pub(super) conditions: Conditions,
    /// Orthonormal forces in equilibrium, by column; rows 1, λ, then three a joint.
    pub(super) basis: DMatrix<f64>,
    /// Orthonormal combinations of the equilibrium conditions, by column, and what they are made of.
    across: DMatrix<f64>,
    triangle: DMatrix<f64>,
    /// What it is solved with.
    pub(super) parameters: Parameters,
}

impl Lift {
    /// Of a scene's conditions. `None` where the equilibrium conditions are not independent: a block hangs
    /// on nothing.
    pub(super) fn new(conditions: Conditions, parameters: Parameters) -> Option<Self> {
        let (rows, forces) = (conditions.velocities(), conditions.forces());
        let mut transposed = DMatrix::zeros(forces, rows);
        for row in 0..rows {
            transposed[(0, row)] = conditions.dead[row];
            transposed[(1, row)] = conditions.live[row];
        }
        for (j, joint) in conditions.joints.iter().enumerate() {
            for (kind, entries) in joint.rates.iter().enumerate() {
                for &(row, value) in entries {
                    transposed[(2 + 3 * j + kind, row)] += value;
                }
            }
        }
        if forces <= rows {
            return None;
        }
        let decomposed = transposed.qr();
        let mut whole = DMatrix::identity(forces, forces);
        decomposed.q_tr_mul(&mut whole);
        let triangle = decomposed.unpack_r();
        let least = triangle
            .diagonal()
            .iter()
            .fold(f64::INFINITY, |a, b| a.min(b.abs()));
        if least < INDEPENDENT {
            return None;
        }
        Some(Self {
            basis: whole.rows(rows, forces - rows).transpose(),
            across: whole.rows(0, rows).transpose(),
            triangle,
            conditions,
            parameters,
        })
    }

    pub(super) fn joints(&self) -> usize {
        self.conditions.joints.len()
    }

    /// Whether a slip is bounded along a way of three joints.
    pub(super) fn has_long_ways(&self) -> bool {
        self.conditions
            .slip_bounds
            .iter()
            .any(|bound| bound.is_long)
    }

    /// The force conditions of a slice a ≤ λ ≤ b in the free numbers of a basis of forces: four a joint,
    /// 1, λ − a, b − λ, of which the last is zero where b is infinite.
    pub(super) fn force_conditions(
        &self,
        basis: &DMatrix<f64>,
        [from, to]: [f64; 2],
    ) -> DMatrix<f64> {
        let mut rows = DMatrix::zeros(self.conditions.force_rows(), basis.ncols());
        for (j, joint) in self.conditions.joints.iter().enumerate() {
            let [one, other, shear] = [0, 1, 2].map(|k| basis.row(2 + 3 * j + k));
            let limit = (one + other) * joint.friction;
            rows.set_row(4 * j, &one);
            rows.set_row(4 * j + 1, &other);
            rows.set_row(4 * j + 2, &(&limit + shear));
            rows.set_row(4 * j + 3, &(&limit - shear));
        }
        let (one, lambda) = (basis.row(0), basis.row(1));
        let last = 4 * self.joints();
        rows.set_row(last, &one);
        rows.set_row(last + 1, &(lambda - one * from));
        if to.is_finite() {
            rows.set_row(last + 2, &(one * to - lambda));
        }
        rows
    }

    /// The multipliers ν of the equilibrium conditions that leave least of these columns, of all
    /// forces (1, λ, three a joint) by motion.
    pub(super) fn balance(&self, columns: &DMatrix<f64>) -> DMatrix<f64> {
        let mut balance = self.across.transpose() * columns;
        self.triangle.solve_upper_triangular_mut(&mut balance);
        balance
    }
}
