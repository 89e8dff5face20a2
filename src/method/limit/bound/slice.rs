//! From the multipliers of an interior point to those of a certificate.

use nalgebra::DMatrix;

use super::interior_point::{Multipliers, Request};
use super::lift::Lift;
use super::motion::Motion;
use super::newton::Newton;
use crate::certificate::{Assumption, Slice, SliceProof, Zeros};

/// Rounds of taking away what multipliers leave of the identity.
const ROUNDS: usize = 3;

/// What is left after which another round is of no use.
const ENOUGH: f64 = 1e-14;

/// How freely the bound itself moves: where the multipliers on their way to zero are gone, it has to
/// become the optimum.
const OF_SIGMA: [f64; 2] = [1e-6, 1.0];

/// Multipliers smaller than this share of the largest do not move.
const SMALL: f64 = 1e-13;

/// The slice of a certificate with the highest bound that `prove` finds, of up to three: multipliers
/// cleaned so that they leave as little of the identity as double precision allows, each changed in
/// proportion to its size. Those on their way to zero are kept or made zero, the bound moves little or
/// freely: where some motion can be as fast as it likes, its multipliers must vanish, and what rounding
/// left of them is all that remains.
pub(super) fn best_proof(
    lift: &Lift,
    request: Request,
    assumed: &[Assumption],
    multipliers: &Multipliers,
    prove: impl Fn(&Slice) -> Option<SliceProof>,
) -> Option<(Slice, SliceProof)> {
    let zeros = &Zeros::of(lift.joints(), assumed);
    let conditions = lift.force_conditions(request.from, request.to);
    let transposed = conditions.transpose();
    let power = lift.power();
    let (one, lambda) = (lift.basis.row(0).transpose(), lift.basis.row(1).transpose());
    let left = |(values, sigma): &(DMatrix<f64>, f64)| {
        let left = lift.motion.of_rates(&(&transposed * values));
        (&lambda - &one * *sigma) * power.transpose() - left
    };
    let clean = |values: DMatrix<f64>, of_sigma: f64| {
        let mut now = (values, multipliers.sigma);
        let mut least = (left(&now).amax(), now.clone());
        for _ in 0..ROUNDS {
            if least.0 <= ENOUGH {
                break;
            }
            let largest = now.0.amax();
            // At the optimum multipliers span many decades, and small ones are to move less.
            let exponent = if request.exact { 2 } else { 1 };
            let weights = now.0.map_with_location(|force, rate, value: f64| {
                if zeros.is_zero(force, rate) {
                    largest.powi(exponent)
                } else if value < SMALL * largest {
                    0.0
                } else {
                    value.powi(exponent)
                }
            });
            let of_slice = [&conditions, &transposed];
            let newton = Newton::new(lift, of_slice, weights.clone(), of_sigma, 0.0);
            let before = least.0;
            for _ in 0..ROUNDS {
                let moved = newton.solve(&left(&now), 1e-10);
                let mut change = &conditions * lift.motion.rates(&moved);
                change.component_mul_assign(&weights);
                now.0 += change;
                now.1 += of_sigma * (one.transpose() * &moved * &power)[(0, 0)];
                clip(&mut now.0, zeros);
                let remaining = left(&now).amax();
                if remaining < least.0 {
                    least = (remaining, now.clone());
                }
            }
            if least.0 > 0.1 * before {
                break;
            }
            now = least.1.clone();
        }
        least.1
    };
    let kept = multipliers.values.clone();
    let dropped = kept.map_with_location(|force, rate, value| {
        let is_leaving = value < multipliers.products[(force, rate)];
        if is_leaving && !zeros.is_zero(force, rate) {
            0.0
        } else {
            value
        }
    });
    let ways = [
        (kept, OF_SIGMA[0]),
        (dropped.clone(), OF_SIGMA[0]),
        (dropped, OF_SIGMA[1]),
    ];
    let slice = |(values, of_sigma)| {
        let (mut values, sigma) = clean(values, of_sigma);
        values.apply(|value| *value = grain(*value));
        Slice {
            from: request.from,
            to: request.to,
            assumed: assumed.to_vec(),
            sigma,
            balance: balance(lift, [request.from, request.to], sigma, &values),
            multipliers: values.transpose().as_slice().to_vec(),
        }
    };
    let mut best: Option<(Slice, SliceProof)> = None;
    for way in ways {
        let slice = slice(way);
        let Some(proof) = prove(&slice) else {
            continue;
        };
        if best
            .as_ref()
            .is_none_or(|(_, best)| proof.least > best.least)
        {
            best = Some((slice, proof));
        }
        let lost = |proof: &SliceProof| multipliers.sigma.min(request.enough) - proof.least;
        if best
            .as_ref()
            .is_some_and(|(_, best)| lost(best) < LOST * (request.to - request.from))
        {
            break;
        }
    }
    best
}

/// Share of a slice's width that may be lost on the way from multipliers to a proof, where no other
/// way is tried.
const LOST: f64 = 1e-4;

/// Multipliers are whole multiples of this: what is finer is below what rounding leaves, and would only
/// fill files.
const GRAIN: f64 = 1.0 / (1u64 << 48) as f64;

/// The nearest multiple of [`GRAIN`].
pub(super) fn grain(value: f64) -> f64 {
    (value / GRAIN).round() * GRAIN
}

/// Makes negative multipliers zero, but for those of the zero products.
fn clip(values: &mut DMatrix<f64>, zeros: &Zeros) {
    for rate in 0..values.ncols() {
        for force in 0..values.nrows() {
            if !zeros.is_zero(force, rate) {
                values[(force, rate)] = values[(force, rate)].max(0.0);
            }
        }
    }
}

/// The multipliers ν of the equilibrium conditions.
pub(super) fn balance(
    lift: &Lift,
    [from, to]: [f64; 2],
    sigma: f64,
    values: &DMatrix<f64>,
) -> Vec<f64> {
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
        target[0] = one - from * above + to * below;
        target[1] = above - below;
    }
    let mut missing = -Motion::of_velocities(&lift.conditions).of_rates(&forces);
    for (k, &live) in lift.conditions.live.iter().enumerate() {
        missing[(1, k)] += live;
        missing[(0, k)] -= sigma * live;
    }
    let balance = lift.balance(&missing);
    balance.transpose().as_slice().to_vec()
}
