//! Where the search for collapse states begins: kinds of normal forces, one after the other.
//!
//! No kind of start finds every state: on 57 walls of 15 to 152 blocks the lowest state was met by
//! one kind alone on several (measured). So the kinds take turns, and those that begin at the lowest
//! state known so far use what the others find. Every start is the same in every run.

use super::descent::{Approach, Branch, Descent};
use super::found::Found;
use super::numerics::Numerics;
use super::search::{Prices, Search, State};
use crate::answer::SearchFailure;
use crate::method::limit::ending::totals;
use crate::method::limit::noise::Noise;
use crate::scene::{HeadJoints, JointClass};

/// What the normal forces are that a start in turn begins with.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Kind {
    /// Those of the lowest state with open head joints, each scaled at random.
    OpenScaled,
    /// Those under the own weight, each reduced at random.
    OwnWeightReduced,
    /// Those under the own weight, half of them reduced to a twentieth.
    OwnWeightThinned,
    /// Of one order of magnitude in all joints, at random.
    Even,
    /// Those of a random force state at a random λ below λ_A.
    Statics,
    /// The same, each scaled at random.
    StaticsScaled,
    /// Those of a random force state at a random λ below the lowest state known.
    StaticsBelow,
    /// Those of the force state with the largest λ less random prices of the normal forces.
    Priced,
    /// Those of the lowest state known, each raised a little at random.
    LowestRaised,
    /// Those of the lowest state known, each scaled at random.
    LowestScaled,
    /// Those of the force state nearest to the lowest state's mechanism with its slips changed at
    /// random.
    LowestRepriced,
}

/// Kinds of starts that a search takes in turn once those chosen on purpose are used up.
const IN_TURN: [Kind; 13] = [
    // These first ones only where starts are dear.
    Kind::LowestRaised,
    Kind::LowestRaised,
    Kind::LowestRaised,
    Kind::OpenScaled,
    Kind::OwnWeightReduced,
    Kind::Even,
    Kind::Statics,
    Kind::Priced,
    Kind::OwnWeightThinned,
    Kind::StaticsBelow,
    Kind::LowestScaled,
    Kind::LowestRepriced,
    Kind::StaticsScaled,
];

/// The starts of one search.
pub(super) struct Starts {
    /// N of every joint, dimensionless, for starts chosen on purpose, the next one last. They go on
    /// quickly.
    chosen: Vec<Vec<f64>>,
    /// N under the own weight.
    at_rest: Vec<f64>,
    /// N of the lowest state with open head joints, or under the own weight where there is none.
    open: Vec<f64>,
    /// Whether one start takes so large a part of the budget that small steps from the lowest state
    /// known come first: on walls of hundreds of blocks.
    pub(super) dear: bool,
    /// Place in [`IN_TURN`].
    turn: usize,
    /// Number of the random sequence.
    sequence: usize,
}

impl Starts {
    /// The starts of a scene with an associative state.
    ///
    /// With head joints in contact, the first two are the lowest state of the same scene with open
    /// head joints (nothing on head joints: the state before pushing) and the associative state,
    /// which lies in the middle of the optimal face. With open head joints the associative state
    /// comes first and is followed by the forces of a few programs with frozen capacities.
    pub(super) fn of(search: &mut Search, associative: Vec<f64>, at_rest: Vec<f64>) -> Self {
        let mut chosen = Vec::new();
        let open = (search.scene.head_joints() == HeadJoints::Contact)
            .then(|| open_state(search))
            .flatten();
        if let Some(normal) = &open {
            chosen.push(normal.clone());
        }
        chosen.push(associative.clone());
        if open.is_none() {
            chosen.extend(frozen_state(search, associative));
        }
        chosen.reverse();
        Self {
            chosen,
            open: open.unwrap_or_else(|| at_rest.clone()),
            at_rest,
            dear: false,
            turn: 0,
            sequence: 0,
        }
    }

    /// The starts of a scene without an associative state, from the forces that hold it under its
    /// own weight.
    pub(super) fn without_associative(search: &mut Search, at_rest: Vec<f64>) -> Self {
        search.coulomb_normal = Some(at_rest.clone());
        Self {
            chosen: vec![at_rest.clone()],
            open: at_rest.clone(),
            at_rest,
            dear: false,
            turn: 0,
            sequence: 0,
        }
    }

    /// Takes normal forces of neighbours after so many of the starts chosen on purpose, so that they
    /// are followed however few starts are asked for.
    pub(super) fn add_neighbours(&mut self, after: usize, neighbours: Vec<Vec<f64>>) {
        let at = self.chosen.len().saturating_sub(after);
        self.chosen.splice(at..at, neighbours.into_iter().rev());
    }

    /// Goes on to the next kind, unless the last start lowered λ: then its kind is taken again.
    pub(super) fn go_on(&mut self, lowered: bool) {
        if self.sequence > 0 && !lowered {
            self.turn += 1;
        }
    }

    /// Follows the next start. Those of a kind that this scene does not have are passed over.
    pub(super) fn follow_next(
        &mut self,
        search: &mut Search,
        found: &Found,
    ) -> Result<Branch, SearchFailure> {
        let known = found.lambdas();
        let (normal, approach, noise) = match self.chosen.pop() {
            Some(normal) => (normal, Approach::Quick, Noise::new(0)),
            None => self.in_turn(search, found)?,
        };
        let mut descent = Descent {
            search,
            approach,
            noise,
            known: &known,
        };
        descent.follow(normal)
    }

    fn in_turn(
        &mut self,
        search: &mut Search,
        found: &Found,
    ) -> Result<(Vec<f64>, Approach, Noise), SearchFailure> {
        loop {
            let kinds = if self.dear {
                &IN_TURN[..]
            } else {
                &IN_TURN[3..]
            };
            let kind = kinds[self.turn % kinds.len()];
            self.sequence += 1;
            let mut noise = Noise::new(self.sequence);
            let Some(normal) = self.normal(kind, search, found.lowest_anywhere(), &mut noise)
            else {
                self.turn += 1;
                continue;
            };
            let approach = match kind {
                Kind::LowestRaised => Approach::Nearby,
                _ => Approach::Blending,
            };
            return Ok((normal?, approach, noise));
        }
    }

    /// Normal forces of one kind; `None` where the scene, or what is found so far, has none.
    fn normal(
        &self,
        kind: Kind,
        search: &mut Search,
        lowest: Option<&State>,
        noise: &mut Noise,
    ) -> Option<Result<Vec<f64>, SearchFailure>> {
        let tuned = search.tuned;
        let scaled = |normal: &[f64], noise: &mut Noise| {
            let scaled = normal.iter().map(|n| n * tuned.scaled.pick(noise));
            scaled.collect::<Vec<f64>>()
        };
        let highest = search.associative.or(lowest.map(|state| state.lambda));
        Some(Ok(match kind {
            Kind::OpenScaled => scaled(&self.open, noise),
            Kind::OwnWeightReduced => self.at_rest.iter().map(|n| n * noise.uniform()).collect(),
            Kind::OwnWeightThinned => {
                let thinned = |n: &f64| match noise.uniform() < tuned.thinned {
                    true => tuned.thinned_to * n,
                    false => *n,
                };
                self.at_rest.iter().map(thinned).collect()
            }
            Kind::Even => {
                let joints = 0..self.at_rest.len();
                let even = joints.map(|j| search.unit(j) * tuned.even.pick(noise));
                even.collect()
            }
            Kind::Statics => {
                let lambda = highest? * tuned.statics.pick(noise);
                return Some(search.random_statics(lambda, noise));
            }
            Kind::StaticsScaled => {
                let lambda = highest? * tuned.statics_scaled.pick(noise);
                let statics = search.random_statics(lambda, noise);
                return Some(statics.map(|normal| scaled(&normal, noise)));
            }
            Kind::StaticsBelow => {
                let lambda = lowest?.lambda * tuned.statics_below.pick(noise);
                return Some(search.random_statics(lambda, noise));
            }
            Kind::Priced => {
                let size = tuned.priced.pick(noise);
                let friction = self.at_rest.iter().map(|_| size * noise.uniform());
                let prices = Prices::without_mechanism(friction.collect());
                let nearest = search.nearest(&prices, 1.0);
                return Some(nearest.map(|solution| totals(&solution.forces)));
            }
            Kind::LowestRaised => {
                let raise = tuned.raised.pick(noise);
                let heads_alone = noise.uniform() < tuned.heads_alone;
                let joints = search.scene.joints().iter().enumerate();
                let normal = joints.zip(totals(&lowest?.forces)).map(|((j, joint), n)| {
                    let is_raised = !heads_alone || joint.class == JointClass::Head;
                    let share = if is_raised { noise.uniform() } else { 0.0 };
                    n + raise * share * search.unit(j)
                });
                normal.collect()
            }
            Kind::LowestScaled => scaled(&totals(&lowest?.forces), noise),
            Kind::LowestRepriced => {
                let mut prices = lowest?.prices.clone();
                for price in &mut prices.friction {
                    *price *= tuned.repriced * noise.uniform();
                }
                let weight = 1.0 - tuned.repriced_weight * noise.uniform();
                let nearest = search.nearest(&prices, weight);
                return Some(nearest.map(|solution| totals(&solution.forces)));
            }
        }))
    }
}

/// Normal forces after a few programs with frozen capacities, each from the last one's forces: the
/// way of the sequential method, which ends on other branches than the gap does.
fn frozen_state(search: &mut Search, mut normal: Vec<f64>) -> Option<Vec<f64>> {
    for _ in 0..search.tuned.frozen {
        normal = totals(&search.frozen(&normal).ok()?.forces);
    }
    Some(normal)
}

/// Normal forces of a low state of the same scene with open head joints, zero on those; `None` where
/// the scene has no head joints or no such state is found.
fn open_state(search: &mut Search) -> Option<Vec<f64>> {
    let scene = search.scene;
    let is_head = |class| class == JointClass::Head;
    if !scene.joints().iter().any(|joint| is_head(joint.class)) {
        return None;
    }
    let open = scene.clone().with_head_joints(HeadJoints::Open);
    let mut inner = Search::new(&open, Numerics::first(search.numerics.engine), search.tuned);
    let state = inner.associative().ok().and_then(|associative| {
        let mut descent = Descent {
            search: &mut inner,
            approach: Approach::Quick,
            noise: Noise::new(0),
            known: &[],
        };
        let normal = totals(&associative.forces);
        Some(descent.follow(normal).ok()?.lowest)
    });
    search.work = search.work + inner.work;
    let mut beds = totals(&state?.forces).into_iter();
    let all = scene.joints().iter().map(|joint| match joint.class {
        JointClass::Head => Some(0.0),
        JointClass::Base | JointClass::Bed | JointClass::Guide => beds.next(),
    });
    all.collect()
}
