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
}

/// Solves one slice until its multipliers `suffice`, are as good as they get, or steps are used up, and
/// returns its steps. `suffice` gets multipliers that the iteration may end with, and whether they are to be
/// those of the optimum; where they do not suffice, it goes on, to leave less of the identity.
pub(super) fn solve(
    face: &Face,
    request: Request,
    suffice: &mut dyn FnMut(&Multipliers, bool) -> bool,
) -> usize {
    let own = &face.lift.parameters;
    let mut program = Lifted::new(face, request);
    let mut at = program.start();
    let mut stalled = 0;
    let mut best: Option<(f64, Multipliers)> = None;
    let mut steps = 0;
    loop {
        let residual = program.residual(&at);
        if !residual.is_finite() {
            break;
        }
        let multipliers = || Multipliers {
            values: at.multipliers.clone(),
            products: at.products.clone(),
            unknowns: at.unknowns.clone(),
            sigma: residual.sigma,
        };
        if program.is_done(&residual) {
            if suffice(&multipliers(), program.request.exact) {
                return steps;
            }
            program.refine(&residual);
        }
        let merit = residual.sigma.min(request.enough) - own.of_left * residual.left;
        if best.as_ref().is_none_or(|(most, _)| merit > *most) {
            best = Some((merit, multipliers()));
        }
        let is_behind = (best.as_ref()).is_some_and(|(most, _)| *most < request.from);
        let is_late = is_behind && steps >= own.late;
        let is_stuck = stalled > own.stalled_steps || residual.mean < own.least_mean;
        if is_stuck || is_late || steps == request.steps {
            break;
        }
        let (step, reach) = Linearised::new(&program, &at, &residual).corrected();
        let [primal, dual] = reach.map(|length| ((1.0 - own.kept_back) * length).min(1.0));
        at.advance(&step, [primal, dual]);
        steps += 1;
        stalled = if primal.max(dual) < own.stalled_step {
            stalled + 1
        } else {
            0
        };
    }
    let (_, best) = best.expect("the start is finite");
    suffice(&best, program.request.exact);
    steps
}
