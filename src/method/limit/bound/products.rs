//! All products of a slice, force conditions times rates, as a linear map of the lifted unknowns.

use nalgebra::{DMatrix, DVector};

use super::factor::Pattern;
use super::lift::Lift;
use super::motion::Motion;

/// The products of one slice's force conditions and a motion's rates.
pub(super) struct Products<'a> {
    pub(super) lift: &'a Lift,
    /// The force conditions in the free numbers of the forces.
    pub(super) conditions: DMatrix<f64>,
    pub(super) transposed: DMatrix<f64>,
    pub(super) motion: &'a Motion,
    /// Which of the motion's unknowns meet in the linear systems.
    pub(super) pattern: &'a Pattern,
    /// The rows of 1 and of λ, as columns.
    pub(super) one: DVector<f64>,
    pub(super) lambda: DVector<f64>,
    /// The live load's power as a column of the motion's unknowns.
    pub(super) power: DVector<f64>,
}

impl<'a> Products<'a> {
    /// Of a slice a ≤ λ ≤ b with all rates.
    pub(super) fn all(lift: &'a Lift, ends: [f64; 2]) -> Self {
        Self::new(lift, ends, (&lift.motion, &lift.pattern))
    }

    /// Of a slice a ≤ λ ≤ b with a motion's rates.
    pub(super) fn new(
        lift: &'a Lift,
        [from, to]: [f64; 2],
        (motion, pattern): (&'a Motion, &'a Pattern),
    ) -> Self {
        let conditions = lift.force_conditions(from, to);
        let mut power = DVector::zeros(motion.unknowns);
        for &(k, value) in motion.power() {
            power[k] = value;
        }
        Self {
            lift,
            transposed: conditions.transpose(),
            conditions,
            motion,
            pattern,
            one: lift.basis.row(0).transpose(),
            lambda: lift.basis.row(1).transpose(),
            power,
        }
    }

    /// The products, from the lifted unknowns.
    pub(super) fn of(&self, unknowns: &DMatrix<f64>) -> DMatrix<f64> {
        &self.conditions * self.motion.rates(unknowns)
    }

    /// The transpose of [`Products::of`].
    pub(super) fn transposed(&self, multipliers: &DMatrix<f64>) -> DMatrix<f64> {
        let of_rates = &self.transposed * multipliers;
        self.motion.of_rates(&of_rates)
    }

    /// Row of 1 times the power, of lifted unknowns.
    pub(super) fn work(&self, unknowns: &DMatrix<f64>) -> f64 {
        (self.one.transpose() * unknowns * &self.power)[(0, 0)]
    }
}
