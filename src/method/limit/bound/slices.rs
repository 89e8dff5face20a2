//! Which slices of λ are solved, one after the other, and what they prove together.

use std::sync::Arc;

use super::branches::{Gains, Leaf, Leaves, normals, violated};
use super::face::Face;
use super::interior_point::solve;
use super::lift::Lift;
use super::lifted::Request;
use super::parameters::OTHER_MACHINE;
use super::slice::best_proof;
use super::vanishing::Vanishing;
use crate::answer::{BoundFact, Budget};
use crate::certificate::{Assumption, Factor, Prover, SliceProof, scene_fingerprint, together};
use crate::certificate::{Certificate, LongestWay, Proved, Slice};
use crate::method::settings::BoundSettings;
use crate::scene::Scene;

/// What the slices are solved with.
pub(super) struct Search<'a> {
    pub(super) lift: &'a Lift,
    /// `None` where nothing can be proved, so that the bounds are what is computed.
    pub(super) prover: Option<&'a Prover>,
    pub(super) settings: &'a BoundSettings,
}

/// What a bound is to reach.
#[derive(Clone, Copy)]
pub(super) struct Goal {
    /// λ of the lowest known collapse state.
    pub(super) state: f64,
    /// How far below it the bound may stay.
    pub(super) tolerance: f64,
}

/// The slices so far.
#[derive(Default)]
pub(super) struct Slices {
    /// No collapse state has its λ* below this.
    pub(super) lower: f64,
    /// The branches that leave no state out.
    pub(super) leaves: Leaves,
    /// Normal forces of the states of the last lift before the first division.
    pub(super) undivided: Vec<Vec<f64>>,
    /// What divisions gained so far.
    pub(super) gains: Gains,
    /// Slices that raised a leaf.
    pub(super) slices: Vec<(Slice, SliceProof)>,
    /// Lifts solved, and their steps.
    pub(super) programs: usize,
    pub(super) steps: usize,
    /// Programs over the forces alone, which tell up to which λ they can vanish.
    pub(super) small_programs: usize,
    /// Whether slices go on to the optimum: on some scenes rounding leaves nothing of others.
    exact: bool,
    /// Products of numbers that these steps took, roughly.
    pub(super) work: f64,
    /// What ended it, where that is what the settings allow.
    pub(super) ended_by: Option<Budget>,
}

/// What the multipliers of a slice gave that have the highest bound.
struct Best {
    proof: Option<(Slice, SliceProof)>,
    /// Products that the lifted state violates, the worst first.
    violated: Vec<usize>,
    /// Normal forces of the states that it is made of.
    normals: Vec<Vec<f64>>,
    /// Whether they are those of the optimum.
    exact: bool,
}

impl Best {
    fn least(&self) -> Option<f64> {
        self.proof.as_ref().map(|(_, proof)| proof.least)
    }
}

impl Search<'_> {
    /// Solves slices until the bound meets the lowest state or the budget is spent, always of the
    /// branch with the lowest bound. A slice begins where the last one ended: the whole distance to
    /// the state at first, then half of what is left; half as far after one that gained less than half of its
    /// width, twice as far after one without states. Where short ones gain nothing either, slips are bounded
    /// along longer ways too; where these gain nothing, the branch is divided. `told` gets the slices each time
    /// that the bound has grown.
    pub(super) fn run(&mut self, slices: &mut Slices, state: f64, told: &dyn Fn(&Slices)) {
        slices.ended_by = None;
        let tolerance = self.settings.bound_gap * state.max(1e-3);
        let goal = Goal { state, tolerance };
        while state - slices.lower > tolerance {
            let at = slices.leaves.lowest();
            let mut leaf = slices.leaves.0[at].clone();
            let result = if leaf.divides {
                self.divide(slices, &leaf, goal)
            } else {
                let advanced = self.advance(slices, &mut leaf, goal);
                advanced.map(|()| vec![leaf])
            };
            let mut parts = match result {
                Ok(parts) => parts.into_iter(),
                Err(budget) => {
                    slices.ended_by = Some(budget);
                    return;
                }
            };
            let Some(first) = parts.next() else {
                return;
            };
            slices.leaves.0[at] = first;
            slices.leaves.0.extend(parts);
            slices.raise(told);
        }
    }

    /// Solves a leaf's next slice.
    pub(super) fn advance(
        &self,
        slices: &mut Slices,
        leaf: &mut Leaf,
        goal: Goal,
    ) -> Result<(), Budget> {
        let own = &self.lift.parameters;
        let steps_left = self.steps_left(slices, &leaf.face(self.lift), 1)?;
        if self.exclude(slices, leaf, goal.state) {
            return Ok(());
        }
        let request = Request {
            steps: own.steps.min(steps_left),
            exact: slices.exact,
            ..self.request(leaf, goal)
        };
        let gain = self.solve(slices, leaf, request);
        leaf.adapt(self.lift, request, goal.state, gain);
        Ok(())
    }

    /// How many further steps the settings allow, or which of them allows fewer than these.
    pub(super) fn steps_left(
        &self,
        slices: &Slices,
        face: &Face,
        needed: usize,
    ) -> Result<usize, Budget> {
        let settings = self.settings;
        if slices.programs >= settings.lifts {
            return Err(Budget::Programs);
        }
        let by_steps = settings.lift_steps.saturating_sub(slices.steps);
        let step = face.step_work();
        let least = self.lift.parameters.least_steps as f64 * step;
        let by_work = (1e9 * settings.lift_work).max(least) - slices.work;
        let by_work = (by_work / step).max(0.0) as usize;
        if by_steps < needed {
            Err(Budget::Steps)
        } else if by_work < needed {
            Err(Budget::Work)
        } else {
            Ok(by_steps.min(by_work))
        }
    }

    /// The next slice of a leaf, without steps. The state itself is to be well inside a slice that
    /// reaches it.
    fn request(&self, leaf: &Leaf, goal: Goal) -> Request {
        let Goal { state, tolerance } = goal;
        let own = &self.lift.parameters;
        let (from, share) = (leaf.lower, leaf.share);
        let (to, enough) = if share == 1.0 {
            let to = state + own.behind * (state - from) + own.near_state[0] * tolerance;
            (to, state - own.near_state[1] * tolerance)
        } else {
            let to = from + share * (state - from);
            (to, to + own.beyond_enough * own.beyond[1])
        };
        Request {
            from,
            to,
            enough,
            most: to + own.beyond[0] * to + own.beyond[1],
            steps: 0,
            exact: false,
            left: own.left,
        }
    }

    /// Assumes what follows from equilibrium beyond a leaf's bound: rates are zero whose forces can
    /// vanish no more. Whether the leaf itself is done, as no forces are left.
    fn exclude(&self, found: &mut Slices, leaf: &mut Leaf, state: f64) -> bool {
        let from = leaf.lower;
        let to = state + self.lift.parameters.behind * (state - from);
        let conditions = &self.lift.conditions;
        let (vanishings, solved) = leaf.vanishings(conditions);
        let vanishings = vanishings.clone();
        found.small_programs += solved;
        let mut prove = |vanishing: &Option<Vanishing>, assumed: &[Assumption]| {
            let vanishing = vanishing
                .as_ref()
                .filter(|own| own.is_excluded(from, self.lift));
            let Some(slice) = vanishing.map(|own| own.slice(self.lift, [from, to], assumed)) else {
                return false;
            };
            let proof = self.proof(&slice);
            let proof = proof.filter(|proof| proof.least >= to && proof.deficit == 0.0);
            found.slices.extend(proof.map(|proof| (slice, proof)));
            proof.is_some()
        };
        let mut assumed = leaf.assumed.clone();
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

    /// Solves one slice of a leaf, and returns the share of its width by which it raises the leaf's bound.
    pub(super) fn solve(&self, found: &mut Slices, leaf: &mut Leaf, request: Request) -> f64 {
        let assumed = leaf.assumed.clone();
        let face = leaf.face(self.lift);
        let bearable = self.lift.parameters.lost_to_rounding;
        let mut best: Option<Best> = None;
        let start = leaf.halfway.as_deref();
        let (steps, halfway) = solve(&face, request, start, &mut |multipliers, exact| {
            let prove = |slice: &Slice| self.proof(slice);
            let proof = best_proof(&face, request, &assumed, (multipliers, exact), prove);
            let own = Best {
                violated: violated(&face, request, multipliers),
                normals: normals(&face, multipliers),
                proof,
                exact,
            };
            if best.as_ref().is_none_or(|best| own.least() > best.least()) {
                best = Some(own);
            }
            // What the multipliers promise and the proof does not keep is lost to rounding.
            let promised = multipliers.sigma.min(request.to);
            let least = best.as_ref().and_then(Best::least);
            least.is_some_and(|least| request.keeps(promised, least, bearable))
        });
        found.programs += 1;
        found.count(steps, &face);
        leaf.steps = steps;
        let best = best.expect("the iteration ends with multipliers");
        found.exact |= best.exact;
        leaf.violated = best.violated;
        let Some((slice, proof)) = best.proof else {
            return 0.0;
        };
        if proof.least <= request.to {
            leaf.normals = best.normals;
        }
        let gain = request.share(proof.least);
        if gain > 0.0 {
            leaf.lower = proof.least.min(request.to);
            leaf.halfway = halfway.map(Arc::new);
            found.slices.push((slice, proof));
        }
        gain
    }
}

impl Slices {
    /// Takes the bound that its leaves have by now.
    fn raise(&mut self, told: &dyn Fn(&Slices)) {
        let before = self.lower;
        self.lower = self.leaves.lower();
        if self.lower > before {
            told(self);
        }
    }

    fn count(&mut self, steps: usize, face: &Face) {
        self.steps += steps;
        self.work += steps as f64 * face.step_work();
    }

    /// What ended the proof before it met the lowest state.
    pub(super) fn ended(&self) -> Option<BoundFact> {
        let programs = self.programs;
        self.ended_by
            .map(|budget| BoundFact::OutOfBudget { budget, programs })
    }

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
        proved.lower = (proved.lower * scene.multiplier_unit()) * (1.0 - OTHER_MACHINE);
        let certificate = Certificate {
            scene: scene_fingerprint(prover.conditions()),
            lower: proved.lower,
            cap,
            opening,
            longest_way: LongestWay::ThreeJoints,
            slices: self.slices.iter().map(|(slice, _)| slice.clone()).collect(),
        };
        (certificate, proved)
    }
}
