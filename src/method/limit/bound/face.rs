//! The face of the lift that assumptions leave: forces and motions in which the assumed factors are zero.
//!
//! A product with a factor that is zero is no inequality any more. Left in the program as an equality it
//! is one of many that follow from each other, and what follows from them leaves the program without an
//! interior. So the forces and the motions of a branch are described by fewer unknowns, in which the
//! assumed factors are zero whatever the unknowns are. That is facial reduction (Borwein and Wolkowicz,
//! J. Austral. Math. Soc. A 30 (1981) 369-380) by what is known of the scene. The multipliers of the
//! products that are gone follow from the identity at the end.

use nalgebra::DMatrix;

use super::lift::Lift;
use super::motion::{Motion, Pivot};
use super::parameters::DEPENDENT;
use super::pattern::Pattern;
use crate::certificate::{Assumption, Zeros, left_side};

/// Forces and motions that meet assumptions.
pub(super) struct Face<'a> {
    pub(super) lift: &'a Lift,
    pub(super) zeros: Zeros,
    /// Orthonormal forces in equilibrium whose assumed conditions are zero, by column.
    pub(super) basis: DMatrix<f64>,
    /// The motions whose columns are the unknowns.
    pub(super) motion: Motion,
    /// Which of them meet in the linear systems.
    pub(super) pattern: Pattern,
    /// Whether slips are bounded along ways of three joints too.
    has_long_ways: bool,
    /// The zero rates that do not follow from others.
    pivots: Vec<Pivot>,
}

impl<'a> Face<'a> {
    /// That of these assumptions, with slip bounds along ways of three joints or without.
    pub(super) fn of(lift: &'a Lift, assumed: &[Assumption], has_long_ways: bool) -> Self {
        let conditions = &lift.conditions;
        let zeros = Zeros::of(lift.joints(), assumed);
        let plain = Motion::of_velocities(conditions);
        let (mut left, pivots) = plain.where_zero(conditions, |rate| zeros.rate(rate));
        if !has_long_ways {
            left.leave_out_long_ways(conditions);
        }
        let motion = left.numbered();
        Self {
            basis: forces_where_zero(lift, &zeros),
            lift,
            zeros,
            pattern: motion.pattern(),
            motion,
            has_long_ways,
            pivots,
        }
    }

    /// All forces, and one rate alone.
    pub(super) fn of_one_rate(lift: &'a Lift) -> Self {
        let motion = Motion::of_one_rate();
        Self {
            lift,
            zeros: Zeros::of(lift.joints(), &[]),
            basis: lift.basis.clone(),
            pattern: motion.pattern(),
            motion,
            has_long_ways: true,
            pivots: Vec::new(),
        }
    }

    /// Free numbers of the forces.
    pub(super) fn free(&self) -> usize {
        self.basis.ncols()
    }

    /// Whether a rate has no multipliers, as it is a slip bound that is not used.
    fn is_left_out(&self, rate: usize) -> bool {
        let conditions = &self.lift.conditions;
        let bound = rate.checked_sub(conditions.power() + 1);
        let bound = bound.and_then(|bound| conditions.slip_bounds.get(bound));
        !self.has_long_ways && bound.is_some_and(|bound| bound.is_long)
    }

    /// Whether the product of a force condition and a rate is zero, or left out.
    pub(super) fn is_zero(&self, force: usize, rate: usize) -> bool {
        self.zeros.is_zero(force, rate) || self.is_left_out(rate)
    }

    /// Products of numbers that a step of the interior point takes, roughly: those of the system's tiles
    /// and of its factor.
    pub(super) fn step_work(&self) -> f64 {
        let (free, conditions) = (self.free(), self.lift.conditions.force_rows());
        let rates = self.motion.rows.iter().filter(|row| !row.is_empty());
        let (free, products) = (free as f64, (rates.count() * conditions) as f64);
        free * free * (products + free * self.pattern.cost)
    }

    /// Unknowns that are all zero: one column an unknown of the motion.
    pub(super) fn zero(&self) -> DMatrix<f64> {
        DMatrix::zeros(self.free(), self.motion.unknowns)
    }

    /// All multipliers of the identity, from those of the products on the face. What these leave of it in
    /// all forces and motions is a sum of assumed force conditions, each times some rates, and of assumed
    /// rates, each times some force conditions.
    pub(super) fn complete(&self, values: &mut DMatrix<f64>, sigma: f64, ends: [f64; 2]) {
        let basis = &self.lift.basis;
        let conditions = self.lift.force_conditions(basis, ends);
        let motion = Motion::of_velocities(&self.lift.conditions);
        for (rate, mut column) in values.column_iter_mut().enumerate() {
            let is_left_out = self.zeros.rate(rate) || self.is_left_out(rate);
            for (force, value) in column.iter_mut().enumerate() {
                if is_left_out || self.zeros.force(force) {
                    *value = 0.0;
                }
            }
        }
        let mut left = -motion.of_rates(&conditions.tr_mul(values));
        let ([of_one, of_lambda], of_dead) = left_side(ends[1], sigma);
        let aim = (basis.row(0) * of_one + basis.row(1) * of_lambda).transpose();
        for &(k, value) in motion.power() {
            left.column_mut(k).axpy(value, &aim, 1.0);
        }
        let one = basis.row(0).transpose();
        for (k, &value) in self.lift.conditions.dead.iter().enumerate() {
            left.column_mut(k).axpy(of_dead * value, &one, 1.0);
        }
        self.complete_forces(values, (&conditions, &motion), &mut left);
        if !self.pivots.is_empty() {
            self.complete_rates(values, (&conditions, &motion), &left);
        }
    }

    /// Adds the multipliers of assumed force conditions, and takes their part from what is left.
    fn complete_forces(
        &self,
        values: &mut DMatrix<f64>,
        (conditions, motion): (&DMatrix<f64>, &Motion),
        left: &mut DMatrix<f64>,
    ) {
        let forces = zero_forces(self.lift, &self.zeros);
        if forces.is_empty() {
            return;
        }
        let zero = conditions.select_rows(&forces);
        let of_forces = inverse(zero.clone()).tr_mul(left);
        *left -= zero.tr_mul(&of_forces);
        // Each in the rates of the joints, which tell a motion.
        let all = DMatrix::identity(motion.unknowns, motion.unknowns);
        let rates = motion
            .rates(&all)
            .columns(0, 4 * self.lift.joints())
            .into_owned();
        let of_rates = of_forces * inverse(rates).transpose();
        for (&force, row) in forces.iter().zip(of_rates.row_iter()) {
            let mut target = values.row_mut(force);
            let mut target = target.columns_mut(0, row.len());
            target += row;
        }
    }

    /// Adds the multipliers of assumed rates, which are all that is left.
    fn complete_rates(
        &self,
        values: &mut DMatrix<f64>,
        (conditions, motion): (&DMatrix<f64>, &Motion),
        left: &DMatrix<f64>,
    ) {
        let rates: Vec<usize> = self.pivots.iter().map(|pivot| pivot.rate).collect();
        let unknowns: Vec<usize> = self.pivots.iter().map(|pivot| pivot.unknown).collect();
        let all = DMatrix::identity(motion.unknowns, motion.unknowns);
        let all = motion.rates(&all).select_rows(&unknowns);
        let at_pivots = all.select_columns(&rates).lu();
        let of_rates = at_pivots.solve(&left.select_columns(&unknowns).transpose());
        let of_rates = of_rates.expect("each pivot is the unknown of its own rate");
        let of_conditions = (of_rates * inverse(conditions.clone())).transpose();
        for (&rate, column) in rates.iter().zip(of_conditions.column_iter()) {
            let mut target = values.column_mut(rate);
            target += column;
        }
    }
}

/// The assumed force conditions.
fn zero_forces(lift: &Lift, zeros: &Zeros) -> Vec<usize> {
    let forces = 0..4 * lift.joints();
    forces.filter(|&force| zeros.force(force)).collect()
}

/// The inverse of a matrix on what it maps to. By its singular values alone, it was off by 1e-11 on paper-2
/// with open head joints; a step of Newton's method squares that (Ben-Israel and Cohen, SIAM J. Numer. Anal.
/// 3 (1966) 410-419).
fn inverse(matrix: DMatrix<f64>) -> DMatrix<f64> {
    let inverse = matrix.clone().pseudo_inverse(DEPENDENT);
    let inverse = inverse.expect("the least share is not negative");
    2.0 * &inverse - &inverse * (matrix * &inverse)
}

/// Orthonormal forces in equilibrium whose assumed conditions are zero.
fn forces_where_zero(lift: &Lift, zeros: &Zeros) -> DMatrix<f64> {
    let forces = zero_forces(lift, zeros);
    if forces.is_empty() {
        return lift.basis.clone();
    }
    let conditions = lift.force_conditions(&lift.basis, [0.0, 1.0]);
    let zero = conditions.select_rows(&forces);
    // What is across to the zero conditions.
    let gram = zero.tr_mul(&zero).symmetric_eigen();
    let kept: Vec<usize> = (0..gram.eigenvalues.len())
        .filter(|&k| gram.eigenvalues[k] < DEPENDENT)
        .collect();
    &lift.basis * gram.eigenvectors.select_columns(&kept)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::certificate::{Conditions, Factor, LongestWay};
    use crate::method::limit::bound::parameters::Parameters;
    use crate::method::limit::walls::{LOWEST_OF_SMALL_WALL as LOWEST, small_wall};
    use crate::scene::HeadJoints;

    /// What is left of an identity whose multipliers are those of products on the face is made of the
    /// assumed factors alone, to rounding, whatever is assumed.
    #[test]
    fn assumed_factors_take_what_a_face_leaves() {
        let scene = small_wall(HeadJoints::Contact);
        let conditions = Conditions::of(&scene).with_slip_bounds(&scene, LongestWay::ThreeJoints);
        let lift = Lift::new(conditions, Parameters::TUNED).unwrap();
        let assume = |pair: usize, zero: Factor| Assumption { pair, zero };
        let rates = [0, 2, 3, 9].map(|pair| assume(pair, Factor::Rate));
        let forces = [5, 10].map(|pair| assume(pair, Factor::Force));
        let joint = [16, 17, 18, 19].map(|pair| assume(pair, Factor::Rate));
        for assumed in [
            &[][..],
            &rates,
            &forces,
            &[&rates[..], &forces, &joint].concat(),
        ] {
            let face = Face::of(&lift, assumed, false);
            let ends = [0.9 * LOWEST, 1.1 * LOWEST];
            let conditions = lift.force_conditions(&face.basis, ends);
            assert!(
                forces
                    .iter()
                    .filter(|own| assumed.contains(own))
                    .all(|own| { conditions.row(own.pair).amax() < 1e-12 })
            );
            // Any multipliers, then those near them that leave nothing of the identity on the face.
            let shape = (conditions.nrows(), face.motion.rows.len());
            let any = |force: usize, rate: usize| ((force * rate) as f64).sin();
            let mut values = DMatrix::from_fn(shape.0, shape.1, any);
            let on_face = |values: &DMatrix<f64>| {
                let mut left = -face.motion.of_rates(&conditions.tr_mul(values));
                let aim = (face.basis.row(1) - face.basis.row(0)).transpose();
                for &(k, value) in face.motion.power() {
                    left.column_mut(k).axpy(value, &aim, 1.0);
                }
                left
            };
            let all = DMatrix::identity(face.motion.unknowns, face.motion.unknowns);
            let rates = face.motion.rates(&all);
            let missing = on_face(&values);
            values += inverse(conditions.clone()).tr_mul(&missing) * inverse(rates).transpose();
            assert!(on_face(&values).amax() < 1e-10);
            face.complete(&mut values, 1.0, ends);
            let plain = Motion::of_velocities(&lift.conditions);
            let every = lift.force_conditions(&lift.basis, ends);
            let mut left = -plain.of_rates(&every.tr_mul(&values));
            let aim = (lift.basis.row(1) - lift.basis.row(0)).transpose();
            for &(k, value) in plain.power() {
                left.column_mut(k).axpy(value, &aim, 1.0);
            }
            assert!(left.amax() < 1e-9, "{}", left.amax());
        }
    }
}
