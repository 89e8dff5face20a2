//! Which slices of λ are solved, one after the other, and what they prove together.

use nalgebra::DMatrix;

use super::branches::{Leaf, Leaves, most_violated};
use super::interior_point::{Multipliers, Request, solve};
use super::lift::Lift;
use super::slice::best_proof;
use super::vanishing::Vanishing;
use crate::certificate::{
    Assumption, Factor, Prover, SliceProof, Zeros, scene_fingerprint, together,
};
use crate::certificate::{Certificate, Proved, Slice};
use crate::method::settings::BoundSettings;
use crate::scene::Scene;

/// How far above its end the bound of a slice without states may grow, relative to that and at least:
/// the farther, the earlier the proof is done.
const BEYOND: [f64; 2] = [0.01, 0.01];

/// How far a slice that reaches the state ends behind it, over its width.
const BEHIND: f64 = 0.1;

/// Interior-point steps of one slice at most.
const STEPS: usize = 250;

/// Least share of the distance to the lowest state that a slice spans.
const LEAST_SHARE: f64 = 0.2;

/// Least share of its width that a slice gains, where a shorter one is worth while.
const LEAST_GAIN: f64 = 0.15;

/// Share of a slice's width that rounding may cost before the slice is solved to its optimum.
const LOST: f64 = 0.2;

/// States of a lift that are given to the search for collapse states.
const STATES: usize = 8;

/// What the slices are solved with.
pub(super) struct Search<'a> {
    pub(super) lift: &'a Lift,
    /// `None` where nothing can be proved, so that the bounds are what is computed.
    pub(super) prover: Option<&'a Prover>,
    pub(super) settings: &'a BoundSettings,
}

/// The slices so far.
pub(super) struct Slices {
    /// No collapse state has its λ* below this.
    pub(super) lower: f64,
    /// The branches that leave no state out.
    pub(super) leaves: Leaves,
    /// Slices that raised a leaf.
    slices: Vec<(Slice, SliceProof)>,
    /// Lifts solved, and their steps.
    pub(super) programs: usize,
    pub(super) steps: usize,
    /// Programs over the forces alone, which tell up to which λ they can vanish.
    pub(super) small_programs: usize,
    /// Whether slices go on to the optimum: on some scenes rounding leaves nothing of others.
    exact: bool,
    /// Whether the budget ended it.
    pub(super) out_of_budget: bool,
    /// Normal forces of the states of the last lift that had some, over the total weight.
    pub(super) normals: Vec<Vec<f64>>,
}

/// What one slice showed.
struct Seen {
    /// Share of its width by which it raises the bound.
    gain: f64,
    /// The product that the lifted state violates most, as a product of means.
    violated: Option<usize>,
}

impl Default for Slices {
    fn default() -> Self {
        Self {
            lower: 0.0,
            leaves: Leaves::default(),
            slices: Vec::new(),
            programs: 0,
            steps: 0,
            small_programs: 0,
            exact: false,
            out_of_budget: false,
            normals: Vec::new(),
        }
    }
}

impl Search<'_> {
    /// Solves slices until the bound meets the lowest state or the budget is spent, always of the
    /// branch with the lowest bound. A slice begins where the last one ended: the whole distance to
    /// the state at first, half as far after one that gained less than half of its width, twice as far
    /// after one without states. Where short ones gain nothing either, the branch is divided.
    pub(super) fn run(&mut self, slices: &mut Slices, state: f64) {
        slices.out_of_budget = false;
        let tolerance = self.settings.bound_gap * state.max(1e-3);
        while state - slices.lower > tolerance {
            let steps_left = self.settings.lift_steps.saturating_sub(slices.steps);
            if slices.programs >= self.settings.lifts || steps_left == 0 {
                slices.out_of_budget = true;
                return;
            }
            let at = slices.leaves.lowest();
            if self.exclude(slices, at, state) {
                slices.lower = slices.leaves.lower();
                continue;
            }
            let Leaf {
                lower: from, share, ..
            } = slices.leaves[at];
            // The state itself is to be well inside a slice that reaches it: where it lies at the end,
            // the lift has hardly an interior, and its multipliers do not settle.
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
                exact: slices.exact,
            };
            let seen = self.solve(slices, at, request);
            let leaf = &mut slices.leaves[at];
            if leaf.lower >= to.min(state) {
                leaf.share = f64::min(1.0, 2.0 * share);
            } else if seen.gain < 0.5 {
                leaf.share *= 0.5;
            }
            if leaf.share < LEAST_SHARE || seen.gain < LEAST_GAIN {
                let Some(pair) = seen.violated else {
                    return;
                };
                slices.leaves.divide(at, pair);
            }
            slices.lower = slices.leaves.lower();
        }
    }

    /// Assumes what follows from equilibrium beyond a leaf's bound: rates are zero whose forces can
    /// vanish no more. Whether the leaf itself is done, as no forces are left.
    fn exclude(&self, found: &mut Slices, at: usize, state: f64) -> bool {
        let from = found.leaves[at].lower;
        let to = state + BEHIND * (state - from);
        let conditions = &self.lift.conditions;
        let (vanishings, solved) = found.leaves[at].vanishings(conditions);
        let vanishings = vanishings.clone();
        found.small_programs += solved;
        let mut prove = |vanishing: &Option<Vanishing>, assumed: &[Assumption]| {
            let vanishing = vanishing.as_ref().filter(|own| own.is_excluded(from));
            let Some(slice) = vanishing.map(|own| own.slice(self.lift, [from, to], assumed)) else {
                return false;
            };
            let proof = self.proof(&slice);
            let proof = proof.filter(|proof| proof.least >= to && proof.deficit == 0.0);
            found.slices.extend(proof.map(|proof| (slice, proof)));
            proof.is_some()
        };
        let mut assumed = found.leaves[at].assumed.clone();
        let is_done = prove(&vanishings.own, &assumed);
        let known: Vec<usize> = assumed.iter().map(|assumed| assumed.pair).collect();
        for (pair, vanishing) in vanishings.with.iter().enumerate() {
            if is_done || known.contains(&pair) {
                continue;
            }
            let zero = Factor::Force;
            assumed.push(Assumption { pair, zero });
            if prove(vanishing, &assumed) {
                let last = assumed.last_mut().expect("it was put there");
                last.zero = Factor::Rate;
            } else {
                assumed.pop();
            }
        }
        let leaf = &mut found.leaves[at];
        if is_done {
            leaf.lower = to;
        }
        leaf.assumed = assumed;
        is_done
    }

    /// What a slice proves.
    fn proof(&self, slice: &Slice) -> Option<SliceProof> {
        match self.prover {
            Some(prover) => prover.slice(slice, self.settings.lift_cap, 0).ok(),
            None => Some(SliceProof {
                least: slice.sigma,
                deficit: 0.0,
                rounding: 0.0,
            }),
        }
    }

    /// Solves one slice of a leaf.
    fn solve(&self, found: &mut Slices, leaf: usize, request: Request) -> Seen {
        let assumed = found.leaves[leaf].assumed.clone();
        let zeros = Zeros::of(self.lift.joints(), &assumed);
        let prove = |slice: &Slice| self.proof(slice);
        let mut multipliers = solve(self.lift, request, &zeros);
        found.programs += 1;
        found.steps += multipliers.steps;
        let mut best = best_proof(self.lift, request, &assumed, &multipliers, prove);
        let least = |best: &Option<(Slice, SliceProof)>| {
            best.as_ref()
                .map_or(f64::NEG_INFINITY, |(_, proof)| proof.least)
        };
        // What the multipliers promise and the proof does not keep is lost to rounding.
        let promised = multipliers.sigma.min(request.to);
        if !request.exact && promised - least(&best) > LOST * (request.to - request.from) {
            let exact = Request {
                exact: true,
                ..request
            };
            let again = solve(self.lift, exact, &zeros);
            found.programs += 1;
            found.steps += again.steps;
            let other = best_proof(self.lift, exact, &assumed, &again, prove);
            if least(&other) > least(&best) {
                found.exact = true;
                (best, multipliers) = (other, again);
            }
        }
        let violated = most_violated(self.lift, request, &zeros, &multipliers);
        let Some((slice, proof)) = best else {
            return Seen {
                gain: 0.0,
                violated,
            };
        };
        if proof.least <= request.to {
            found.normals = normals(self.lift, &multipliers);
        }
        let reached = proof.least.min(request.to);
        let gain = (reached - request.from) / (request.to - request.from);
        if gain > 0.0 {
            found.leaves[leaf].lower = reached;
            found.slices.push((slice, proof));
        }
        Seen { gain, violated }
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
        let parts = self.slices.iter().map(|(slice, proof)| (slice, *proof));
        let parts: Vec<_> = parts.collect();
        let mut proved = together(&parts, cap).expect("each slice begins where others end");
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
    let rates = lift.motion.rates(&multipliers.unknowns);
    let weights = lift.basis.row(0) * &rates;
    let power = lift.conditions.power();
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
