//! All products of a slice, force conditions times rates, as a linear map of the lifted unknowns.

use nalgebra::{DMatrix, DVector};

use super::face::Face;
use super::parameters::Parameters;

/// The products of one slice's force conditions and a face's rates.
pub(super) struct Products<'a> {
    pub(super) face: &'a Face<'a>,
    /// The force conditions in the free numbers of the forces.
    pub(super) conditions: DMatrix<f64>,
    pub(super) transposed: DMatrix<f64>,
    /// The rows of 1 and of λ, as columns.
    pub(super) one: DVector<f64>,
    pub(super) lambda: DVector<f64>,
    /// The live load's power as a column of the motion's unknowns.
    pub(super) power: DVector<f64>,
}

impl<'a> Products<'a> {
    /// Of a slice a ≤ λ ≤ b.
    pub(super) fn new(face: &'a Face, ends: [f64; 2]) -> Self {
        let conditions = face.lift.force_conditions(&face.basis, ends);
        let mut power = DVector::zeros(face.motion.unknowns);
        for &(k, value) in face.motion.power() {
            power[k] = value;
        }
        Self {
            transposed: conditions.transpose(),
            conditions,
            one: face.basis.row(0).transpose(),
            lambda: face.basis.row(1).transpose(),
            power,
            face,
        }
    }

    pub(super) fn parameters(&self) -> &'a Parameters {
        &self.face.lift.parameters
    }

    /// The products, from the lifted unknowns.
    pub(super) fn of(&self, unknowns: &DMatrix<f64>) -> DMatrix<f64> {
        &self.conditions * self.face.motion.rates(unknowns)
    }

    /// The transpose of [`Products::of`].
    pub(super) fn transposed(&self, multipliers: &DMatrix<f64>) -> DMatrix<f64> {
        let of_rates = &self.transposed * multipliers;
        self.face.motion.of_rates(&of_rates)
    }

    /// Row of 1 times the power, of lifted unknowns.
    pub(super) fn work(&self, unknowns: &DMatrix<f64>) -> f64 {
        (self.one.transpose() * unknowns * &self.power)[(0, 0)]
    }
}
