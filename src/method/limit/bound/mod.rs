//! A proved lower bound of non-associative collapse by a lifted linear program.
//!
//! The least multiplier of friction without dilatancy is the optimum of a linear program with
//! complementarity constraints. Radenkovic's second theorem gives 0 as its lower bound, and
//! mixed-integer programming with large constants ends at eight blocks. The lift gives a useful one:
//! with s = (1, λ, q) for the forces and k = (u, g⁺) for the motion (g⁺ ≥ 0 and g⁻ = g⁺ − slip ≥ 0
//! are the forward and the backward part of each slip), let Y stand for the product s kᵀ. Every
//! collapse state in which the push does work, f_L·u = 1, gives a Y with
//!
//! ```text
//! every column of Y in equilibrium
//! (n1, n2, μN + t, μN − t, 1, λ − a, b − λ) × (opening 1, opening 2, g⁺, g⁻, f_L·u) ≥ 0, all pairs
//! n · opening = 0 at one corner, (μN + t) g⁺ = 0 and (μN − t) g⁻ = 0 in one joint
//! (row of 1) · f_L = 1
//! ```
//!
//! so the least (row of λ)·f_L is a lower bound of λ over all collapse states with a ≤ λ ≤ b. What
//! the program forgets is that Y has rank one: it is a first-level reformulation-linearisation
//! (Sherali and Adams, SIAM J. Discrete Math. 3 (1990) 411-430) of a program with complementarity
//! constraints (Luo, Pang and Ralph, Mathematical Programs with Equilibrium Constraints, 1996).
//! Bounds of each slip by the rates of the joints around it are further rates (`certificate/slips.rs`;
//! our own, as is the lift's use here). All of 60 random walls of 6 to 15 blocks are enclosed to 1e-4
//! with them; without them ten of the 60 were 0.5 to 9 % apart. With open head joints a bond has no such bounds
//! along short ways: longer ones take openings-4 from 0.2249 to 0.2636, where 0.2637 is the lowest state. They
//! make a step two to three times as dear, so that they are used where slices gain nothing without.
//!
//! No product needs a large constant, and velocities may be as large as they like: all conditions on
//! the motion are homogeneous but f_L·u = 1.
//!
//! Narrow slices [a, b] are tighter, because the products with λ − a and b − λ pin λ. A slice either
//! has no state, or a bound inside it; slices side by side raise the bound from 0 to the lowest
//! verified state. Where narrow ones gain nothing, a slice is divided by a product that must be zero:
//! one part assumes that its force is zero, the other its rate. Where equilibrium does not let a force
//! vanish any more, from some λ on, the first part is empty, which a small linear program shows, and
//! the other one goes on with fewer rates. Forces and motions are described by the unknowns that are
//! left (`face.rs`). Any number of slices and branches is a valid answer.
//!
//! What is claimed: no collapse state in which the push does work has 0 ≤ λ < lower. States in which
//! it does none (a stone that drops while the push only holds on) are none of these, and nothing is
//! said of λ < 0. Where no state is known, `standing.rs` asks whether there can be any.
//!
//! What proves it is not the interior point that found the multipliers but the identity that they
//! satisfy; see [`crate::certificate::Certificate`] and the rounding argument there.

mod bordered;
mod branches;
mod cleaner;
mod dense;
mod division;
mod face;
mod factor;
mod interior_point;
mod lift;
mod lifted;
mod motion;
mod newton;
mod ordering;
mod parameters;
mod pattern;
mod point;
mod products;
mod proving;
mod slice;
mod slices;
pub(super) mod standing;
mod start;
mod step;
#[cfg(test)]
mod tuned;
mod vanishing;

use std::sync::Arc;
use std::time::Duration;

use super::interval::{Interval, lowest};
use crate::answer::{BoundFact, Evidence, Fact, LimitFact, Outcome, Status, Work, magnitude};
use crate::certificate::Certificate;
use crate::mechanics::CollapseState;
use crate::method::settings::LP_TOLERANCE;
use crate::method::{Method, Settings, Watch};
use crate::scene::Scene;
use parameters::Parameters;
use proving::{Opened, lift_of, opening};
use slices::{Search, Slices};

/// `lower` is proved by a certificate; `upper` is the lowest verified state.
pub struct Bound;

impl Method for Bound {
    fn name(&self) -> &str {
        "bound"
    }

    fn solve(&self, scene: &Scene, settings: &Settings) -> Outcome {
        solve_with(scene, settings, Parameters::TUNED, &())
    }

    fn solve_watched(
        &self,
        scene: &Scene,
        settings: &Settings,
        watch: &dyn Watch,
    ) -> (Outcome, Option<Duration>) {
        (solve_with(scene, settings, Parameters::TUNED, watch), None)
    }
}

/// The answer with these tuned numbers.
fn solve_with(
    scene: &Scene,
    settings: &Settings,
    parameters: Parameters,
    watch: &dyn Watch,
) -> Outcome {
    let mut proving = *settings;
    proving.programs.lp_tolerance = LP_TOLERANCE;
    let found = lowest(scene, &proving, f64::NEG_INFINITY);
    let Some(state) = found.evidence.states().first().cloned() else {
        return standing::without_state(scene, &proving, found);
    };
    let mut work = found.work;
    if state.lambda == 0.0 {
        let bounded = Some((0.0, None));
        return answer(state, bounded, work, vec![LimitFact::AtRest.into()]);
    }
    let lift = match lift_of(scene, settings, parameters) {
        Ok(lift) => lift,
        Err(why) => return answer(state, None, work, vec![why.into()]),
    };
    let opened = opening(scene, &mut work).and_then(|opening| Opened::of(scene, &lift, opening));
    let mut search = Search {
        lift: &lift,
        prover: opened.as_ref().map(|own| &own.prover),
        settings: &settings.bound,
    };
    let mut state = state;
    let unit = scene.multiplier_unit();
    let mut slices = Slices::default();
    for _ in 0..lift.parameters.restarts {
        let told = |slices: &Slices| {
            if let Some(own) = &opened {
                watch.proved(&|| own.so_far(scene, &settings.bound, slices, state.lambda));
            }
        };
        search.run(&mut slices, state.lambda / unit, &told);
        let gap = state.lambda - slices.lower * unit;
        if gap <= settings.bound.bound_gap * magnitude(state.lambda, unit) {
            break;
        }
        let (lower, searched) = lowest_of_lift(scene, &proving, &slices);
        work = Work {
            modelled: work.modelled,
            ..work + searched
        };
        match lower.filter(|lower| lower.lambda < state.lambda - lift.parameters.lower_state * unit)
        {
            Some(lower) => state = lower,
            None => break,
        }
    }
    work.programs += slices.programs + slices.small_programs;
    work.iterations += slices.steps;
    let (certificate, mut facts) = match &opened {
        Some(own) => own.claim(scene, &settings.bound, &slices, (&found, state.lambda)),
        None => (None, vec![Fact::from(BoundFact::Uncertified)]),
    };
    let lower = certificate
        .as_ref()
        .map_or(slices.lower * unit, |own| own.lower);
    // One at 0 says nothing.
    let certificate = certificate.filter(|own| own.lower > 0.0);
    facts.extend(slices.ended().map(Fact::from));
    let bounded = Some((lower, certificate.map(Arc::new)));
    answer(state, bounded, work, facts)
}

/// The lowest state that the states of lifts lead to, which other starts may miss, and the work: those of the
/// branch that limits the bound, and those before the first division.
fn lowest_of_lift(
    scene: &Scene,
    proving: &Settings,
    slices: &Slices,
) -> (Option<CollapseState>, Work) {
    let mut few = *proving;
    few.interval.starts = 1;
    // There is a state: it need not be asked whether there can be any.
    few.bound.lifts = 0;
    let mut normals = slices.leaves.0[slices.leaves.lowest()].normals.clone();
    for undivided in &slices.undivided {
        if !normals.contains(undivided) {
            normals.push(undivided.clone());
        }
    }
    let found = Interval.solve_from(scene, &few, &normals);
    (found.evidence.states().first().cloned(), found.work)
}

/// The answer with a lowest state: without a lower end nothing is claimed.
fn answer(
    state: CollapseState,
    bounded: Option<(f64, Option<Arc<Certificate>>)>,
    work: Work,
    facts: Vec<Fact>,
) -> Outcome {
    let uncertified = Fact::from(BoundFact::Uncertified);
    let status = match bounded {
        None => Status::Undecided,
        Some(_) if facts.contains(&uncertified) => Status::Estimate,
        Some(_) => Status::Bracketed,
    };
    let (lower, certificate) = bounded.unzip();
    Outcome {
        evidence: Evidence::Bounded {
            // What rounding of the state leaves is not the bound's.
            lower: lower.map(|lower| lower.min(state.lambda)),
            certificate: certificate.flatten(),
            state,
        },
        work,
        facts,
        ..Outcome::of(status)
    }
}
