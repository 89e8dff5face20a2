//! Branches: what slices assume of products that are zero in every collapse state.
//!
//! Where narrow slices gain nothing, the lift mixes states, some with pressure on a corner and some in
//! which it opens. Such a slice is divided: in one part that corner carries nothing, in the other it
//! does not open (or friction is not used up in one direction, or there is no slip in it). This is the
//! branching on complementary pairs of mixed-integer programming, without its large constants.

use std::collections::BTreeMap;
use std::sync::Arc;

use nalgebra::DMatrix;

use super::face::Face;
use super::interior_point::Multipliers;
use super::lift::Lift;
use super::lifted::Request;
use super::products::Products;
use super::start::Halfway;
use super::vanishing::Vanishing;
use crate::certificate::{Assumption, Conditions, Factor};
use crate::method::at_once::each;

/// A branch: what it assumes, and how far it is.
#[derive(Clone, Debug)]
pub(super) struct Leaf {
    pub(super) assumed: Vec<Assumption>,
    /// No state that meets the assumptions has its λ* below this.
    pub(super) lower: f64,
    /// Share of the distance to the lowest state that the next slice spans.
    pub(super) share: f64,
    /// Whether shorter slices gain nothing either, so that it is to be divided.
    pub(super) divides: bool,
    /// Whether its slices bound slips along ways of three joints too.
    pub(super) has_long_ways: bool,
    /// Products that its last lifted state violates, the worst first.
    pub(super) violated: Vec<usize>,
    /// Up to which λ its forces can vanish; `None` until it is asked for.
    pub(super) vanishing: Option<Vanishings>,
    /// Normal forces of the states of its last lift that had some, over the total weight.
    pub(super) normals: Vec<Vec<f64>>,
    /// Steps of its last slice.
    pub(super) steps: usize,
    /// Where the next slice begins: a point of the last one that gained something.
    pub(super) halfway: Option<Arc<Halfway>>,
}

/// Up to which λ the forces of a leaf can vanish, and further ones with them.
#[derive(Clone, Debug)]
pub(super) struct Vanishings {
    /// Those that are assumed.
    pub(super) own: Option<Vanishing>,
    /// With one more of four a joint.
    pub(super) with: Vec<Option<Vanishing>>,
}

impl Vanishings {
    /// Of the forces that are assumed to vanish.
    fn of(conditions: &Conditions, assumed: &[Assumption]) -> Self {
        let vanish = assumed
            .iter()
            .filter(|assumed| assumed.zero == Factor::Force);
        let forces: Vec<usize> = vanish.map(|assumed| assumed.pair).collect();
        let mut with: Vec<(usize, Option<Vanishing>)> = Vec::new();
        with.extend((0..4 * conditions.joints.len()).map(|pair| (pair, None)));
        each(&mut with, &|(pair, vanishing)| {
            if assumed.iter().all(|assumed| assumed.pair != *pair) {
                *vanishing = Vanishing::of(conditions, &[&forces[..], &[*pair]].concat());
            }
        });
        Self {
            own: Vanishing::of(conditions, &forces),
            with: with.into_iter().map(|(_, vanishing)| vanishing).collect(),
        }
    }
}

impl Leaf {
    /// Up to which λ its forces can vanish, and how many programs that took now.
    pub(super) fn vanishings(&mut self, conditions: &Conditions) -> (&Vanishings, usize) {
        let solved = match self.vanishing {
            Some(_) => 0,
            None => 1 + 4 * conditions.joints.len() - self.assumed.len(),
        };
        let assumed = &self.assumed;
        let vanishings =
            (self.vanishing).get_or_insert_with(|| Vanishings::of(conditions, assumed));
        (vanishings, solved)
    }

    /// Its forces and motions.
    pub(super) fn face<'a>(&self, lift: &'a Lift) -> Face<'a> {
        Face::of(lift, &self.assumed, self.has_long_ways)
    }

    /// How it goes on after a slice that gained this share of its width.
    pub(super) fn adapt(&mut self, lift: &Lift, slice: Request, state: f64, gain: f64) {
        let own = &lift.parameters;
        if self.lower >= slice.to.min(state) {
            self.share *= 2.0;
        } else if gain < own.half_gain {
            self.share *= 0.5;
        }
        self.share = self.share.min(own.next_share);
        // A slice that reaches the state may fail where one that ends before it does not.
        let is_tried = gain > 0.0 || slice.to <= state;
        let is_stuck = is_tried && (self.share < own.least_share || gain < own.least_gain);
        if is_stuck && !self.has_long_ways && lift.has_long_ways() {
            self.has_long_ways = true;
            self.share = own.next_share;
        } else {
            self.divides = is_stuck;
        }
    }

    /// Its parts: in one the force of a product is zero, in the other its rate.
    pub(super) fn parts(&self, pair: usize) -> [Self; 2] {
        [Factor::Force, Factor::Rate].map(|zero| {
            let mut assumed = self.assumed.clone();
            assumed.push(Assumption { pair, zero });
            Self {
                assumed,
                lower: self.lower,
                share: 1.0,
                divides: false,
                has_long_ways: self.has_long_ways,
                violated: Vec::new(),
                normals: self.normals.clone(),
                steps: self.steps,
                halfway: self.halfway.clone(),
                // What assumes no more forces has the same.
                vanishing: self.vanishing.clone().filter(|_| zero == Factor::Rate),
            }
        })
    }
}

/// All branches together; they leave no state out.
pub(super) struct Leaves(pub(super) Vec<Leaf>);

impl Default for Leaves {
    fn default() -> Self {
        Self(vec![Leaf {
            assumed: Vec::new(),
            lower: 0.0,
            share: 1.0,
            divides: false,
            has_long_ways: false,
            violated: Vec::new(),
            vanishing: None,
            normals: Vec::new(),
            steps: 0,
            halfway: None,
        }])
    }
}

impl Leaves {
    /// The place of the leaf with the lowest bound, the first of equals.
    pub(super) fn lowest(&self) -> usize {
        let leaves = 0..self.0.len();
        let lowest = leaves.min_by(|&a, &b| self.0[a].lower.total_cmp(&self.0[b].lower));
        lowest.expect("there is always one")
    }

    /// No state has its λ* below this.
    pub(super) fn lower(&self) -> f64 {
        self.0[self.lowest()].lower
    }
}

/// What divisions by each product have gained: their sum and number.
#[derive(Default)]
pub(super) struct Gains(BTreeMap<usize, (f64, usize)>);

impl Gains {
    /// Notes what a division by a product gained.
    pub(super) fn add(&mut self, pair: usize, gain: f64) {
        let own = self.0.entry(pair).or_default();
        *own = (own.0 + gain, own.1 + 1);
    }

    /// What a division by a product can be expected to gain: the mean of those by it, or else of all.
    fn expected(&self, pair: usize) -> f64 {
        let all = (self.0.values()).fold((0.0, 0), |all, own| (all.0 + own.0, all.1 + own.1));
        let (sum, times) = self.0.get(&pair).copied().unwrap_or(all);
        sum / times.max(1) as f64
    }

    /// Products in the order in which divisions by them are tried; of equals, as they are given.
    pub(super) fn in_order(&self, violated: &[usize]) -> Vec<usize> {
        let mut order = violated.to_vec();
        order.sort_by(|&a, &b| self.expected(b).total_cmp(&self.expected(a)));
        order
    }
}

/// The products of joints that are zero in every state and of which the lifted state has both factors,
/// those first of which it has most in the mean.
pub(super) fn violated(face: &Face, request: Request, multipliers: &Multipliers) -> Vec<usize> {
    let zeros = &face.zeros;
    let products = Products::new(face, [request.from, request.to]);
    let products = products.of(&multipliers.unknowns);
    let power = face.lift.conditions.power();
    // The condition 1 stands behind those of the joints.
    let one = power;
    let both = |pair: usize| products[(pair, power)] * products[(one, pair)];
    let pairs = (0..one).filter(|&pair| !zeros.is_zero(pair, power) && !zeros.is_zero(one, pair));
    let mut violated: Vec<usize> = pairs.filter(|&pair| both(pair) > 0.0).collect();
    violated.sort_by(|&a, &b| both(b).total_cmp(&both(a)));
    violated
}

/// Normal forces of the states that the lift is made of: the columns of the power and of the rates
/// that weigh most.
pub(super) fn normals(face: &Face, multipliers: &Multipliers) -> Vec<Vec<f64>> {
    let lift = face.lift;
    let rates = face.motion.rates(&multipliers.unknowns);
    let weights = face.basis.row(0) * &rates;
    let power = lift.conditions.power();
    let mut order: Vec<usize> = (0..power).collect();
    order.sort_by(|&a, &b| weights[b].total_cmp(&weights[a]));
    let own = &lift.parameters;
    let chosen = [power].into_iter().chain(order).take(own.states);
    let least = own.state_weight * weights[power].abs();
    let usable = chosen.filter(|&rate| weights[rate] > least);
    let normal = |rate: usize| {
        let forces: DMatrix<f64> = &face.basis * rates.columns(rate, 1) / weights[rate];
        let joints = (0..lift.joints()).map(|j| (forces[2 + 3 * j] + forces[3 + 3 * j]).max(0.0));
        joints.collect()
    };
    usable.map(normal).collect()
}

#[cfg(test)]
mod tests {
    use super::super::parameters::Parameters;
    use super::super::proving::opening;
    use super::super::slices::{Search, Slices};
    use super::*;
    use crate::answer::Work;
    use crate::certificate::{Certificate, LongestWay, Refusal, prove};
    use crate::certificate::{Conditions, Prover};
    use crate::method::Settings;
    use crate::method::limit::walls::{LOWEST_OF_SMALL_WALL as LOWEST, small_wall};
    use crate::scene::{HeadJoints, Scene};

    /// The certificate of slices that are divided by these products from the start.
    fn divided(scene: &Scene, pairs: &[usize]) -> (Certificate, f64) {
        let conditions = Conditions::of(scene).with_slip_bounds(scene, LongestWay::ThreeJoints);
        let opening = opening(scene, &mut Work::default()).unwrap();
        let prover = Prover::new(scene, conditions.clone(), &opening).unwrap();
        let lift = Lift::new(conditions, Parameters::TUNED).unwrap();
        let settings = Settings::default().bound;
        let mut slices = Slices::default();
        for (leaf, &pair) in pairs.iter().enumerate() {
            let [part, other] = slices.leaves.0[leaf].parts(pair);
            slices.leaves.0[leaf] = part;
            slices.leaves.0.push(other);
        }
        let mut search = Search {
            lift: &lift,
            prover: Some(&prover),
            settings: &settings,
        };
        search.run(&mut slices, LOWEST, &|_| {});
        let lower = slices.lower;
        (
            slices
                .certificate(scene, &prover, settings.lift_cap, opening)
                .0,
            lower,
        )
    }

    /// Whatever they are divided by, branches prove the same together, and a certificate says so.
    #[test]
    fn branches_prove_what_one_slice_does() {
        let scene = small_wall(HeadJoints::Contact);
        for pairs in [&[][..], &[0], &[9], &[2, 15], &[4, 5, 31]] {
            let (certificate, lower) = divided(&scene, pairs);
            assert!((lower - LOWEST).abs() < 3e-5, "{pairs:?}: {lower}");
            let proved = prove(&scene, &certificate).unwrap();
            assert!(
                proved.lower > LOWEST * (1.0 - 1e-4),
                "{pairs:?}: {proved:?}"
            );
            assert_eq!(proved.slices, certificate.slices.len());
        }
    }

    /// A branch that is gone, or turned into the other one, proves no more than what is left: of a corner that may
    /// open, and of a joint that may slip.
    #[test]
    fn a_changed_branch_proves_nothing() {
        for pair in [9, 10] {
            assert_nothing_without_branch(pair);
        }
    }

    fn assert_nothing_without_branch(pair: usize) {
        let scene = small_wall(HeadJoints::Contact);
        let (certificate, _) = divided(&scene, &[pair]);
        let refused = |change: &dyn Fn(&mut Certificate)| {
            let mut changed = certificate.clone();
            change(&mut changed);
            prove(&scene, &changed).expect_err("it is changed")
        };
        let is_of = |zero: Factor| {
            let mut slices = certificate.slices.iter();
            slices.position(|slice| {
                slice
                    .assumed
                    .first()
                    .is_some_and(|first| first.zero == zero)
            })
        };
        let [force, rate] = [Factor::Force, Factor::Rate].map(|zero| is_of(zero).unwrap());
        let gone = refused(&|c| {
            c.slices.remove(force);
        });
        assert!(matches!(gone, Refusal::Less { .. }), "{gone:?}");
        for (slice, other) in [(force, Factor::Rate), (rate, Factor::Force)] {
            refused(&|c| c.slices[slice].assumed[0].zero = other);
            refused(&|c| c.slices[slice].assumed[0].pair += 1);
            // Without its assumption it would speak of all states.
            refused(&|c| c.slices[slice].assumed.clear());
            let twice = |c: &mut Certificate| {
                let first = c.slices[slice].assumed[0];
                c.slices[slice].assumed.push(first);
            };
            assert_eq!(refused(&twice), Refusal::Size);
            let far = refused(&|c| c.slices[slice].assumed[0].pair = usize::MAX);
            assert_eq!(far, Refusal::Size);
        }
    }
}
