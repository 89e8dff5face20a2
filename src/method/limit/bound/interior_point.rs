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

use super::face::Face;
use super::lifted::{Lifted, Request};
use super::step::Linearised;

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

/// Solves one slice.
pub(super) fn solve(face: &Face, request: Request) -> Multipliers {
    let own = &face.lift.parameters;
    let program = Lifted::new(face, request);
    let mut at = program.start();
    let mut stalled = 0;
    let mut best: Option<(f64, Multipliers)> = None;
    for steps in 0..=request.steps {
        let residual = program.residual(&at);
        if !residual.is_finite() {
            break;
        }
        let merit = residual.sigma.min(request.enough) - own.of_left * residual.left;
        if best.as_ref().is_none_or(|(most, _)| merit > *most) {
            let multipliers = Multipliers {
                values: at.multipliers.clone(),
                products: at.products.clone(),
                unknowns: at.unknowns.clone(),
                sigma: residual.sigma,
                steps,
            };
            best = Some((merit, multipliers));
        }
        let is_stuck = stalled > own.stalled_steps || residual.mean < own.least_mean;
        if program.is_done(&residual) || is_stuck || steps == request.steps {
            break;
        }
        let (step, reach) = Linearised::new(&program, &at, &residual).corrected();
        let [primal, dual] = reach.map(|length| ((1.0 - own.kept_back) * length).min(1.0));
        at.advance(&step, [primal, dual]);
        stalled = if primal.max(dual) < own.stalled_step {
            stalled + 1
        } else {
            0
        };
    }
    best.expect("the start is finite").1
}
