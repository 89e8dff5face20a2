//! From the multipliers of an interior point to those of a certificate.

use nalgebra::DMatrix;

use super::cleaner::Cleaner;
use super::face::Face;
use super::interior_point::Multipliers;
use super::lift::Lift;
use super::lifted::Request;
use super::motion::Motion;
use super::parameters::GRAIN;
use super::products::Products;
use crate::certificate::{Assumption, Slice, SliceProof, left_side};

/// The slice of a certificate with the highest bound that `prove` finds, of up to three: multipliers
/// cleaned so that they leave as little of the identity as double precision allows, each changed in
/// proportion to its size. Those on their way to zero are kept or made zero, the bound moves little or
/// freely: where some motion can be as fast as it likes, its multipliers must vanish, and what rounding
/// left of them is all that remains.
pub(super) fn best_proof(
    face: &Face,
    request: Request,
    assumed: &[Assumption],
    (multipliers, exact): (&Multipliers, bool),
    prove: impl Fn(&Slice) -> Option<SliceProof>,
) -> Option<(Slice, SliceProof)> {
    let lift = face.lift;
    let ends = [request.from, request.to];
    let products = Products::new(face, ends);
    let cleaner = Cleaner {
        products: &products,
        aim: products.aim.clone(),
        is_zero: &|force, rate| face.is_zero(force, rate),
        exponent: if exact { 2 } else { 1 },
    };
    let kept = &multipliers.values;
    let dropped = kept.map_with_location(|force, rate, value| {
        let is_leaving = value < multipliers.products[(force, rate)];
        if is_leaving && !face.is_zero(force, rate) {
            0.0
        } else {
            value
        }
    });
    let [little, freely] = lift.parameters.of_sigma;
    let mut best: Option<(Slice, SliceProof)> = None;
    for (values, of_sigma) in [(kept, little), (&dropped, little), (&dropped, freely)] {
        let (mut values, sigma) = cleaner.clean(values.clone(), multipliers.sigma, of_sigma);
        face.complete(&mut values, sigma, ends);
        let slice = certified(lift, ends, assumed, sigma, values);
        if let Some(proof) = prove(&slice)
            && best.as_ref().is_none_or(|best| proof.least > best.1.least)
        {
            best = Some((slice, proof));
        }
        let promised = match request.to.is_finite() {
            true => multipliers.sigma.min(request.enough),
            false => multipliers.sigma,
        };
        let kept = |best: &(Slice, SliceProof)| {
            request.keeps(promised, best.1.least, lift.parameters.lost)
        };
        if best.as_ref().is_some_and(kept) {
            break;
        }
    }
    best
}

/// The slice of a certificate with these multipliers, in whole grains.
pub(super) fn certified(
    lift: &Lift,
    ends: [f64; 2],
    assumed: &[Assumption],
    sigma: f64,
    mut values: DMatrix<f64>,
) -> Slice {
    values.apply(|value| *value = (*value / GRAIN).round() * GRAIN);
    Slice {
        from: ends[0],
        to: ends[1],
        assumed: assumed.to_vec(),
        sigma,
        balance: balance(lift, ends, sigma, &values),
        multipliers: values.transpose().as_slice().to_vec(),
    }
}

/// The multipliers ν of the equilibrium conditions.
fn balance(lift: &Lift, [from, to]: [f64; 2], sigma: f64, values: &DMatrix<f64>) -> Vec<f64> {
    let joints = &lift.conditions.joints;
    let mut forces = DMatrix::zeros(lift.conditions.forces(), values.ncols());
    for (rate, column) in values.column_iter().enumerate() {
        let mut target = forces.column_mut(rate);
        for (j, joint) in joints.iter().enumerate() {
            let limits = joint.friction * (column[4 * j + 2] + column[4 * j + 3]);
            target[2 + 3 * j] = column[4 * j] + limits;
            target[3 + 3 * j] = column[4 * j + 1] + limits;
            target[4 + 3 * j] = column[4 * j + 2] - column[4 * j + 3];
        }
        let [one, above, below] = [0, 1, 2].map(|k| column[4 * joints.len() + k]);
        target[0] = one - from * above;
        target[1] = above;
        if to.is_finite() {
            target[0] += to * below;
            target[1] -= below;
        }
    }
    let mut missing = -Motion::of_velocities(&lift.conditions).of_rates(&forces);
    let ([of_one, of_lambda], of_dead) = left_side(to, sigma);
    for (k, &live) in lift.conditions.live.iter().enumerate() {
        missing[(0, k)] += of_one * live;
        missing[(1, k)] += of_lambda * live;
        missing[(0, k)] += of_dead * lift.conditions.dead[k];
    }
    let balance = lift.balance(&missing);
    balance.transpose().as_slice().to_vec()
}
