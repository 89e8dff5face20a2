//! All products of a slice, force conditions times rates, as a linear map of the lifted unknowns.

use nalgebra::{DMatrix, DVector};

use super::face::Face;
use super::parameters::Parameters;
use crate::certificate::left_side;

/// The products of one slice's force conditions and a face's rates.
pub(super) struct Products<'a> {
    pub(super) face: &'a Face<'a>,
    /// The force conditions in the free numbers of the forces.
    pub(super) conditions: DMatrix<f64>,
    pub(super) transposed: DMatrix<f64>,
    /// The identity's left side is (aim − σ · scale) times the power: of λ and 1, or without an upper end of 0 and
    /// 1 + 2 λ, as columns ([`left_side`]).
    pub(super) aim: DVector<f64>,
    pub(super) scale: DVector<f64>,
    /// What σ is multiplied with beside it, without an upper end: 1, times the power of the dead load.
    dead: Option<[DVector<f64>; 2]>,
    /// The live load's power as a column of the motion's unknowns.
    pub(super) power: DVector<f64>,
}

impl<'a> Products<'a> {
    /// Of a slice a ≤ λ ≤ b, where b may be infinite.
    pub(super) fn new(face: &'a Face, ends: [f64; 2]) -> Self {
        let conditions = face.lift.force_conditions(&face.basis, ends);
        let mut power = DVector::zeros(face.motion.unknowns);
        for &(k, value) in face.motion.power() {
            power[k] = value;
        }
        // Linear in σ.
        let [(aim, _), (with_sigma, of_dead)] = [0.0, 1.0].map(|sigma| left_side(ends[1], sigma));
        let scale = [aim[0] - with_sigma[0], aim[1] - with_sigma[1]];
        let [one, lambda] = [0, 1].map(|row| face.basis.row(row).transpose());
        let of_forces = |[of_one, of_lambda]: [f64; 2]| &one * of_one + &lambda * of_lambda;
        let dead = || face.motion.dead_power(&face.lift.conditions);
        Self {
            transposed: conditions.transpose(),
            conditions,
            aim: of_forces(aim),
            scale: of_forces(scale),
            dead: (of_dead != 0.0).then(|| [&one * -of_dead, dead()]),
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

    /// What σ is multiplied with in the identity, of lifted unknowns.
    pub(super) fn work(&self, unknowns: &DMatrix<f64>) -> f64 {
        let live = (self.scale.transpose() * unknowns * &self.power)[(0, 0)];
        let dead = self.dead.as_ref();
        live + dead.map_or(0.0, |[one, dead]| {
            (one.transpose() * unknowns * dead)[(0, 0)]
        })
    }

    /// The coefficients of the same.
    pub(super) fn scale_row(&self) -> DMatrix<f64> {
        let live = &self.scale * self.power.transpose();
        match &self.dead {
            Some([one, dead]) => live + one * dead.transpose(),
            None => live,
        }
    }

    /// The identity's left side.
    pub(super) fn left_side(&self, aim: &DVector<f64>, sigma: f64) -> DMatrix<f64> {
        let live = (aim - &self.scale * sigma) * self.power.transpose();
        match &self.dead {
            Some([one, dead]) => live - one * dead.transpose() * sigma,
            None => live,
        }
    }
}
