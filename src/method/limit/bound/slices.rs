//! Which slices of λ are solved, one after the other, and what they prove together.

use nalgebra::DMatrix;

use super::factor::Pattern;
use super::interior_point::{Multipliers, Request, solve};
use super::lift::Lift;
use super::slice::slices;
use crate::answer::certificate::{Prover, SliceProof, scene_fingerprint};
use crate::answer::{Certificate, Proved, Slice};
use crate::method::settings::BoundSettings;
use crate::scene::Scene;

/// How far above its end the bound of a slice without states may grow, relative to that and at least:
/// the farther, the earlier the proof is done.
const BEYOND: [f64; 2] = [0.01, 0.01];

/// How far a slice that reaches the state ends behind it, over its width.
const BEHIND: f64 = 0.1;

/// Interior-point steps of one slice at most.
const STEPS: usize = 80;

/// Least share of the distance to the lowest state that a slice spans.
const LEAST_SHARE: f64 = 1.0 / 256.0;

/// States of a lift that are given to the search for collapse states.
const STATES: usize = 8;

/// What the slices are solved with.
pub(super) struct Search<'a> {
    pub(super) lift: &'a Lift,
    pub(super) pattern: &'a Pattern,
    /// `None` where nothing can be proved, so that the bounds are what is computed.
    pub(super) prover: Option<&'a Prover>,
    pub(super) settings: &'a BoundSettings,
}

/// The slices so far.
#[derive(Default)]
pub(super) struct Slices {
    /// No collapse state has its λ* below this.
    pub(super) lower: f64,
    /// Those that raised it.
    slices: Vec<(Slice, SliceProof)>,
    /// Lifts solved, and their steps.
    pub(super) programs: usize,
    pub(super) steps: usize,
    /// Whether the budget ended it.
    pub(super) out_of_budget: bool,
    /// Normal forces of the states of the last lift that had some, over the total weight.
    pub(super) normals: Vec<Vec<f64>>,
}

impl Search<'_> {
    /// Solves slices until the bound meets the lowest state, no slice raises it any more, or the
    /// budget is spent. A slice begins where the last one ended: the whole distance to the state at
    /// first, half as far after one that gained less than half of its width, twice as far after one
    /// without states.
    pub(super) fn run(&mut self, slices: &mut Slices, state: f64) {
        let mut share = 1.0;
        slices.out_of_budget = false;
        while state - slices.lower > self.settings.bound_gap * state.max(1e-3) {
            let steps_left = self.settings.lift_steps.saturating_sub(slices.steps);
            if slices.programs >= self.settings.lifts || steps_left == 0 {
                slices.out_of_budget = true;
                return;
            }
            let from = slices.lower;
            // The state itself is to be well inside a slice that reaches it: where it lies at the end,
            // the lift has hardly an interior, and its multipliers do not settle.
            let tolerance = self.settings.bound_gap * state.max(1e-3);
            let (to, enough) = if share == 1.0 {
                let to = state + BEHIND * (state - from) + 0.01 * tolerance;
                (to, state - 0.005 * tolerance)
            } else {
                let to = from + share * (state - from);
                (to, to + 0.25 * BEYOND[1])
            };
            let request = Request {
                from,
                to,
                enough,
                most: to + BEYOND[0] * to + BEYOND[1],
                steps: STEPS.min(steps_left),
            };
            let gain = self.solve(slices, request);
            if slices.lower >= to.min(state) {
                share = f64::min(1.0, 2.0 * share);
            } else if gain < 0.5 {
                share *= 0.5;
            }
            if share < LEAST_SHARE {
                return;
            }
        }
    }

    /// Solves one slice; the share of its width by which it raises the bound.
    fn solve(&self, found: &mut Slices, request: Request) -> f64 {
        let multipliers = solve(self.lift, self.pattern, request);
        found.programs += 1;
        found.steps += multipliers.steps;
        let candidates = slices(self.lift, self.pattern, request, &multipliers);
        let proved = candidates.into_iter().filter_map(|slice| {
            let proof = match self.prover {
                Some(prover) => prover.slice(&slice, self.settings.lift_cap, 0).ok()?,
                None => SliceProof {
                    least: slice.sigma,
                    deficit: 0.0,
                    rounding: 0.0,
                },
            };
            Some((slice, proof))
        });
        let best = proved.max_by(|a, b| a.1.least.total_cmp(&b.1.least));
        let Some((slice, proof)) = best else {
            return 0.0;
        };
        if proof.least <= request.to {
            found.normals = normals(self.lift, &multipliers);
        }
        let reached = proof.least.min(request.to);
        let gain = (reached - request.from) / (request.to - request.from);
        if gain > 0.0 {
            found.lower = reached;
            found.slices.push((slice, proof));
        }
        gain
    }
}

impl Slices {
    /// The certificate and what it proves.
    pub(super) fn certificate(
        &self,
        scene: &Scene,
        prover: &Prover,
        cap: f64,
        opening: Vec<f64>,
    ) -> (Certificate, Proved) {
        let mut proved = Proved::default();
        for (index, (slice, proof)) in self.slices.iter().enumerate() {
            proved = proved
                .and(slice, *proof, cap, index)
                .expect("each slice begins where the one before ends");
        }
        // Another machine may round the scene's geometry otherwise.
        proved.lower = (proved.lower * scene.multiplier_unit()) * (1.0 - 1e-9);
        let certificate = Certificate {
            scene: scene_fingerprint(prover.conditions()),
            lower: proved.lower,
            cap,
            opening,
            slices: self.slices.iter().map(|(slice, _)| slice.clone()).collect(),
        };
        (certificate, proved)
    }
}

/// Normal forces of the states that the lift is made of: the columns of the power and of the rates
/// that weigh most.
fn normals(lift: &Lift, multipliers: &Multipliers) -> Vec<Vec<f64>> {
    let rates = lift.rates(&multipliers.unknowns);
    let weights = lift.basis.row(0) * &rates;
    let power = rates.ncols() - 1;
    let mut order: Vec<usize> = (0..power).collect();
    order.sort_by(|&a, &b| weights[b].total_cmp(&weights[a]));
    let chosen = [power].into_iter().chain(order).take(STATES);
    let usable = chosen.filter(|&rate| weights[rate] > 1e-6 * weights[power].abs());
    let normal = |rate: usize| {
        let forces: DMatrix<f64> = &lift.basis * rates.columns(rate, 1) / weights[rate];
        let joints = (0..lift.joints()).map(|j| (forces[2 + 3 * j] + forces[3 + 3 * j]).max(0.0));
        joints.collect()
    };
    usable.map(normal).collect()
}
