//! A primal-dual interior-point method for the lifted program of one slice (Mehrotra, SIAM J. Optim.
//! 2 (1992) 575-601).
//!
//! ```text
//! least  (λ − σ₀)·(f_L·u) + σ₀    with all products ≥ 0 or = 0 and (1)·(f_L·u) ≤ 1
//! ```
//!
//! The last condition stands for = 1: with it the program always has an optimum. Where no collapse
//! state is in the slice that is σ₀, which is chosen above the slice's end, so that the multipliers
//! are a Farkas proof; else it is the least λ of the lift. Any multipliers on the way give a bound.

use nalgebra::DMatrix;

use super::lift::Lift;
use super::newton::Newton;
use crate::certificate::Zeros;

/// A slice of λ*, and when to stop. What is assumed in it is given beside it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Request {
    /// a.
    pub(super) from: f64,
    /// b.
    pub(super) to: f64,
    /// Bound at which the iteration may stop.
    pub(super) enough: f64,
    /// σ₀, above b.
    pub(super) most: f64,
    /// Steps at most.
    pub(super) steps: usize,
    /// Whether it goes on to the optimum: slower, and for slices whose multipliers leave too much of the
    /// identity otherwise.
    pub(super) exact: bool,
}

/// Multipliers of a slice.
pub(super) struct Multipliers {
    /// One row a force condition, one column a rate.
    pub(super) values: DMatrix<f64>,
    /// The products that they belong to: where they are larger, a multiplier is on its way to zero.
    pub(super) products: DMatrix<f64>,
    /// The lifted state.
    pub(super) unknowns: DMatrix<f64>,
    /// The bound on λ* that they give, but for what they leave of the identity.
    pub(super) sigma: f64,
    /// Steps done.
    pub(super) steps: usize,
}

/// What keeps the linear systems solvable in double precision, as shares of the mean product, and
/// their least and most: the change of a product for a change of its multiplier, and what holds the
/// unknowns (proximal terms for both: Friedlander and Orban, Math. Prog. Comp. 4 (2012) 71-107; tied to
/// the mean product as by Pougkakiotis and Gondzio, Comput. Optim. Appl. 78 (2021) 307-351). Without
/// them the iteration breaks down on paper-1 (33 blocks), on which they were chosen. They decide how fast
/// it is and whether it ends, never what its multipliers prove.
const SOFTNESS: [f64; 3] = [1e-4, 1e-9, 1e-5];
const HOLD: [f64; 3] = [1e-2, 1e-9, 1e-4];

/// Step as a share of the one that makes a number zero.
const SHORT: f64 = 0.995;

/// Steps shorter than this are tried again towards the centre, with this share of the mean product.
const SHORT_STEP: f64 = 0.15;
const CENTRE: f64 = 0.4;

/// The gap at which the bound is as good as the optimum.
const GAP: f64 = 1e-8;

/// Share of what a slice gains, and of what is left above it, that its bound may fall short of where it
/// has a lifted state.
const ROUGH: f64 = 0.02;

/// What multipliers and products may leave there.
const ROUGHLY_LEFT: f64 = 3e-6;

/// What multipliers may leave of the identity at the end of the iteration; a last step takes more.
const LEFT: f64 = 1e-8;

/// What a unit of what multipliers leave of the identity costs of their bound, to compare them.
const OF_LEFT: f64 = 1e4;

/// Iterates: products w with multipliers m, and of the scale condition.
struct Point {
    unknowns: DMatrix<f64>,
    products: DMatrix<f64>,
    multipliers: DMatrix<f64>,
    scale: [f64; 2],
}

struct Step {
    unknowns: DMatrix<f64>,
    products: DMatrix<f64>,
    multipliers: DMatrix<f64>,
    scale: [f64; 2],
}

/// Residuals of the conditions and of the identity.
struct Residual {
    products: DMatrix<f64>,
    scale: f64,
    identity: DMatrix<f64>,
}

/// Solves one slice.
pub(super) fn solve(lift: &Lift, request: Request, zeros: &Zeros) -> Multipliers {
    let conditions = lift.force_conditions(request.from, request.to);
    let transposed = conditions.transpose();
    let (rows, rates) = (conditions.nrows(), lift.conditions.rate_rows());
    let is_free = |at: usize| zeros.is_zero(at % rows, at / rows);
    let free: Vec<bool> = (0..rows * rates).map(is_free).collect();
    let count = (free.iter().filter(|free| !**free).count() + 1) as f64;
    let start = DMatrix::from_fn(rows, rates, |i, j| {
        f64::from(u8::from(!zeros.is_zero(i, j)))
    });
    let power = lift.power();
    let lambda = lift.basis.row(1).transpose() - lift.basis.row(0).transpose() * request.most;
    let cost = &lambda * power.transpose();
    let one = lift.basis.row(0).transpose();
    let scale_row = &one * power.transpose();
    let mut at = Point {
        unknowns: lift.zero(),
        products: start.clone(),
        multipliers: start,
        scale: [1.0, 1.0],
    };
    let mut stalled = 0;
    let mut best: Option<(f64, Multipliers)> = None;
    for steps in 0..=request.steps {
        let identity = lift.motion.of_rates(&(&transposed * &at.multipliers));
        let identity = &cost - identity + &scale_row * at.scale[1];
        let work = (one.transpose() * &at.unknowns * &power)[(0, 0)];
        let residual = Residual {
            products: &conditions * lift.motion.rates(&at.unknowns) - &at.products,
            scale: 1.0 - work - at.scale[0],
            identity,
        };
        let mean = (at.products.dot(&at.multipliers) + at.scale[0] * at.scale[1]) / count;
        let sigma = request.most - at.scale[1];
        let above = cost.dot(&at.unknowns) + request.most;
        let left = residual.identity.amax();
        let violated = residual.products.amax();
        if !(sigma.is_finite() && left.is_finite()) {
            break;
        }
        let merit = sigma.min(request.enough) - OF_LEFT * left;
        if best.as_ref().is_none_or(|(most, _)| merit > *most) {
            let multipliers = Multipliers {
                values: at.multipliers.clone(),
                products: at.products.clone(),
                unknowns: at.unknowns.clone(),
                sigma,
                steps,
            };
            best = Some((merit, multipliers));
        }
        let excludes = sigma > request.enough && left < LEFT;
        // A lifted state well inside the slice: where exactly the bound ends is of no use.
        let inside = above - sigma < ROUGH * (above - request.from).min(request.enough - above);
        let optimal = above - sigma < GAP && left < LEFT && violated < LEFT;
        let rough = !request.exact && inside && left < ROUGHLY_LEFT && violated < ROUGHLY_LEFT;
        if excludes || optimal || rough || stalled > 8 || mean < 1e-13 || steps == request.steps {
            break;
        }
        let of_mean = |[share, least, most]: [f64; 3]| (share * mean).clamp(least, most);
        let (softness, held) = (of_mean(SOFTNESS), of_mean(HOLD));
        let softened = at.products.zip_map(&at.multipliers, |product, multiplier| {
            1.0 / (product + softness * multiplier)
        });
        let mut weights = at.multipliers.component_mul(&softened);
        for (weight, free) in weights.iter_mut().zip(&free) {
            if *free {
                *weight = 1.0 / softness;
            }
        }
        let newton = Newton::new(
            lift,
            [&conditions, &transposed],
            weights.clone(),
            at.scale[1] / at.scale[0],
            held,
        );
        let step = |wanted: &DMatrix<f64>, scale: f64| {
            // What multipliers become where products do not move.
            let mut target = wanted.component_mul(&softened);
            target -= weights.component_mul(&residual.products);
            for ((target, free), missing) in target.iter_mut().zip(&free).zip(&residual.products) {
                if *free {
                    *target = -missing / softness;
                }
            }
            let of_scale = scale / at.scale[0] - at.scale[1] / at.scale[0] * residual.scale;
            let mut right = lift.motion.of_rates(&(&transposed * &target));
            right -= &residual.identity;
            right -= &scale_row * of_scale;
            let unknowns = newton.solve(&right, 1e-11);
            let moved = &conditions * lift.motion.rates(&unknowns);
            let multipliers = target - weights.component_mul(&moved);
            let mut products = moved + &residual.products + &multipliers * softness;
            for (product, free) in products.iter_mut().zip(&free) {
                if *free {
                    *product = 0.0;
                }
            }
            let work = (one.transpose() * &unknowns * &power)[(0, 0)];
            let first = residual.scale - work;
            let second = of_scale + at.scale[1] / at.scale[0] * work;
            Step {
                unknowns,
                products,
                multipliers,
                scale: [first, second],
            }
        };
        let product = at.products.component_mul(&at.multipliers);
        let scaled = at.scale[0] * at.scale[1];
        let predicted = step(&-&product, -scaled);
        let lengths = lengths(&at, &predicted, &free);
        let mut after = (at.scale[0] + lengths[0] * predicted.scale[0])
            * (at.scale[1] + lengths[1] * predicted.scale[1]);
        for (k, free) in free.iter().enumerate() {
            if !free {
                after += (at.products[k] + lengths[0] * predicted.products[k])
                    * (at.multipliers[k] + lengths[1] * predicted.multipliers[k]);
            }
        }
        let centre = (after / count / mean).powi(3) * mean;
        let mut wanted = -&product - predicted.products.component_mul(&predicted.multipliers);
        for (wanted, free) in wanted.iter_mut().zip(&free) {
            *wanted = if *free { 0.0 } else { *wanted + centre };
        }
        let mut corrected = step(
            &wanted,
            centre - scaled - predicted.scale[0] * predicted.scale[1],
        );
        let mut reach = self::lengths(&at, &corrected, &free);
        if reach[0].min(reach[1]) < SHORT_STEP {
            // A correction that leads nowhere: back towards the centre.
            let mut wanted = -&product;
            for (wanted, free) in wanted.iter_mut().zip(&free) {
                *wanted = if *free { 0.0 } else { *wanted + CENTRE * mean };
            }
            let centred = step(&wanted, CENTRE * mean - scaled);
            let other = self::lengths(&at, &centred, &free);
            if other[0].min(other[1]) > reach[0].min(reach[1]) {
                (corrected, reach) = (centred, other);
            }
        }
        let [primal, dual] = reach.map(|l| (SHORT * l).min(1.0));
        at.unknowns += corrected.unknowns * primal;
        at.products += corrected.products * primal;
        at.multipliers += corrected.multipliers * dual;
        at.scale[0] += primal * corrected.scale[0];
        at.scale[1] += dual * corrected.scale[1];
        stalled = if primal.max(dual) < 0.05 {
            stalled + 1
        } else {
            0
        };
    }
    best.expect("the start is finite").1
}

/// Longest steps that keep products and multipliers from becoming negative.
fn lengths(at: &Point, step: &Step, free: &[bool]) -> [f64; 2] {
    let longest = |values: &DMatrix<f64>, by: &DMatrix<f64>, scale: f64, by_scale: f64| {
        let of_scale = if by_scale < 0.0 {
            scale / -by_scale
        } else {
            1e30
        };
        let pairs = values.iter().zip(by).zip(free);
        let lengths = pairs.filter(|((_, by), free)| !**free && **by < 0.0);
        lengths
            .map(|((value, by), _)| value / -by)
            .fold(of_scale, f64::min)
            .min(1.0 / SHORT)
    };
    [
        longest(&at.products, &step.products, at.scale[0], step.scale[0]),
        longest(
            &at.multipliers,
            &step.multipliers,
            at.scale[1],
            step.scale[1],
        ),
    ]
}
