//! A primal-dual interior-point method for the lifted program of one slice (Mehrotra, SIAM J. Optim.
//! 2 (1992) 575-601).
//!
//! ```text
//! least  (λ − σ₀)·(f_L·u) + σ₀    with all products ≥ 0 or = 0 and (1)·(f_L·u) ≤ 1
//! ```
//!
//! The last condition stands for = 1: with it the program always has an optimum. Where no collapse
//! state is in the slice that is σ₀, which is chosen above the slice's end, so that the multipliers
//! are a Farkas proof; else it is the least λ of the lift. Any multipliers on the way give a bound. A slice
//! without an upper end has 1 for σ₀ and −σ₀ ((1 + 2 λ) f_L·u + f_D·u) + σ₀ to be least, with that bracket ≤ 1: a bound
//! above 0 excludes all states.

use nalgebra::DMatrix;

use super::face::Face;
use super::lifted::{Lifted, Request};
use super::start::Halfway;
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
/// returns its steps and a point that other slices can begin at, as this one may begin at one. `suffice` gets
/// multipliers that the iteration may end with, and whether they are to be those of the optimum; where they do not
/// suffice, it goes on, to leave less of the identity. A step whose linear system rounding spoils is taken again,
/// softer.
pub(super) fn solve(
    face: &Face,
    request: Request,
    start: Option<&Halfway>,
    suffice: &mut dyn FnMut(&Multipliers, bool) -> bool,
) -> (usize, Option<Halfway>) {
    let own = &face.lift.parameters;
    let mut program = Lifted::new(face, request);
    let mut at = program.start(start);
    let mut halfway = None;
    let mut stalled = 0;
    let mut softer = 1.0;
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
                return (steps, halfway);
            }
            program.refine(&residual);
        }
        if residual.mean * program.count > own.halfway {
            halfway = Some(program.halfway(&at, residual.mean));
        }
        let merit = residual.sigma.min(request.enough) - own.of_left * residual.left;
        if best.as_ref().is_none_or(|(most, _)| merit > *most) {
            best = Some((merit, multipliers()));
        }
        let is_behind = (best.as_ref()).is_some_and(|(most, _)| *most < request.nothing());
        let is_late = is_behind && steps >= own.late;
        let is_stuck = stalled > own.stalled_steps || residual.mean < own.least_mean;
        if is_stuck || is_late || steps == request.steps {
            break;
        }
        steps += 1;
        let linearised = Linearised::new(&program, &at, &residual, softer);
        let Some((step, reach)) = linearised.corrected() else {
            softer *= own.softer;
            continue;
        };
        let [primal, dual] = reach.map(|length| ((1.0 - own.kept_back) * length).min(1.0));
        at.advance(&step, [primal, dual]);
        stalled = if primal.max(dual) < own.stalled_step {
            stalled + 1
        } else {
            0
        };
    }
    let (_, best) = best.expect("the start is finite");
    suffice(&best, program.request.exact);
    (steps, halfway)
}

#[cfg(test)]
mod tests {
    use super::super::parameters::Parameters;
    use super::super::solve_with;
    use crate::method::Settings;
    use crate::method::limit::walls::bonded;

    /// With next to no softness rounding spoils steps near the optimum. They are taken again, softer, so that the
    /// bound is as near and takes hardly more steps.
    #[test]
    fn a_step_that_rounding_spoils_is_taken_again_softer() {
        let scene = bonded(&["h1h", "11", "h1h"]);
        let solved = |parameters| {
            let outcome = solve_with(&scene, &Settings::default(), parameters, &());
            let bracket = outcome.bracket().expect("there is a bound and a state");
            (bracket.upper - bracket.lower, outcome.work.iterations)
        };
        let hardly = [1e-24; 3];
        let softened = Parameters {
            softness: hardly,
            hold: hardly,
            softest: 1e20,
            ..Parameters::TUNED
        };
        let (gap, steps) = solved(softened);
        let (_, tuned) = solved(Parameters::TUNED);
        assert!(gap < 1e-6 && steps < tuned + 20, "{gap:e} {steps} {tuned}");
        let unsolved = f64::INFINITY;
        let (gap, steps) = solved(Parameters {
            unsolved,
            ..softened
        });
        assert!(gap > 1e-5 && steps > tuned + 60, "{gap:e} {steps} {tuned}");
    }
}
