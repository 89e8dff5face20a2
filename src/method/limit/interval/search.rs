//! The linear programs of the search for collapse states, and the gap that they close.
//!
//! For a statically admissible state (q, λ) and a zero-dilatancy mechanism u with f_L·u = 1 the gap
//!
//! ```text
//! gap = Σ μ N |slip| − f_D·u − λ  =  Σ n · opening + Σ (μ N |slip| + t · slip)  ≥ 0
//! ```
//!
//! is the whole violation of complementarity in units of λ, and (q, λ, u) is a collapse state where
//! it vanishes. It holds no mode that could be guessed wrong: every opening counts with its size.

use super::numerics::{Numerics, Refinement};
use super::parameters::Tuned;
use crate::answer::{SearchFailure, Work};
use crate::mechanics::{JointForce, dead_power};
use crate::method::limit::ending::{Ending, Solution, totals};
use crate::method::limit::noise::Noise;
use crate::method::limit::program::{FrictionLaw, Program};
use crate::method::settings::LP_TOLERANCE;
use crate::scene::Scene;

/// A collapse state in dimensionless form.
#[derive(Clone, Debug)]
pub(super) struct State {
    pub(super) lambda: f64,
    pub(super) forces: Vec<JointForce>,
    pub(super) velocity: Vec<f64>,
    /// Price μ|slip| of the normal force of every joint, which is all that the states of one
    /// mechanism share.
    pub(super) prices: Prices,
}

impl State {
    pub(super) fn new(solution: Solution, velocity: Vec<f64>, prices: Prices) -> Self {
        Self {
            lambda: solution.lambda,
            forces: solution.forces,
            velocity,
            prices,
        }
    }
}

/// A mechanism as the gap sees it.
#[derive(Clone, Debug)]
pub(super) struct Prices {
    pub(super) friction: Vec<f64>,
    dead_power: f64,
}

impl Prices {
    /// Prices that belong to no mechanism.
    pub(super) fn without_mechanism(friction: Vec<f64>) -> Self {
        Self {
            friction,
            dead_power: 0.0,
        }
    }

    pub(super) fn gap(&self, solution: &Solution) -> f64 {
        let normal = totals(&solution.forces);
        let dissipated = normal.iter().zip(&self.friction).map(|(n, p)| n * p);
        dissipated.sum::<f64>() - self.dead_power - solution.lambda
    }

    /// Whether these are the prices of the same mechanism, so that program (b) would give the same.
    pub(super) fn are_those_of(&self, other: &Prices, within: f64) -> bool {
        let alike = |(a, b): (&f64, &f64)| (a - b).abs() <= within;
        alike((&self.dead_power, &other.dead_power))
            && self.friction.iter().zip(&other.friction).all(alike)
    }
}

/// The programs of one scene.
pub(super) struct Search<'a> {
    pub(super) scene: &'a Scene,
    /// How its programs are written and solved.
    pub(super) numerics: Numerics,
    pub(super) tuned: Tuned,
    program: Program,
    /// The program for forces at a given λ, once it is needed.
    statics: Option<Program>,
    /// Whether a random cost of either sign has shown that forces at a given λ have no limit.
    unlimited: bool,
    coulomb: Vec<FrictionLaw>,
    /// No price on any joint's normal force.
    no_prices: Vec<f64>,
    /// λ_A, once it is known to have a limit.
    pub(super) associative: Option<f64>,
    /// N of the last Coulomb state: capacities frozen there hold at least that state.
    pub(super) coulomb_normal: Option<Vec<f64>>,
    /// How many of the largest changes of λ's cost have left gaps open that a smaller one closed.
    pub(super) too_large: usize,
    pub(super) work: Work,
}

impl<'a> Search<'a> {
    pub(super) fn new(scene: &'a Scene, numerics: Numerics, tuned: Tuned) -> Self {
        let coulomb = scene.joints().iter().map(|joint| FrictionLaw {
            slope: joint.friction,
            intercept: 0.0,
        });
        let program = Program::with_units(scene, LP_TOLERANCE, numerics.power);
        let mut program = program.tested_by(numerics.engine);
        if numerics.refinement == Refinement::Rough {
            program.refine_less();
        }
        Self {
            scene,
            numerics,
            tuned,
            program,
            statics: None,
            unlimited: false,
            coulomb: coulomb.collect(),
            no_prices: vec![0.0; scene.joints().len()],
            associative: None,
            coulomb_normal: None,
            too_large: 0,
            work: Work::default(),
        }
    }

    pub(super) fn program(&self) -> &Program {
        &self.program
    }

    /// Force unit of small changes of a joint: the weight of a block in the mean, or the joint's own
    /// unit where blocks are unequal.
    pub(super) fn unit(&self, joint: usize) -> f64 {
        let mean_weight = 1.0 / self.scene.blocks().len() as f64;
        let own = self.program.own_unit(joint);
        own.map_or(mean_weight, |own| own.min(mean_weight))
    }

    /// The associative state; the ending where there is none.
    pub(super) fn associative(&mut self) -> Result<Solution, Ending> {
        self.program.set_friction(&self.coulomb);
        self.program.set_cost(1.0, &self.no_prices);
        match self.program.solve_counted(&mut self.work) {
            Ending::Solved(solution) => {
                self.associative = Some(solution.lambda);
                self.coulomb_normal = Some(totals(&solution.forces));
                Ok(solution)
            }
            ending => Err(ending),
        }
    }

    fn solve(&mut self) -> Result<Solution, SearchFailure> {
        solved(self.program.solve_counted(&mut self.work))
    }

    /// (a) The largest λ with shear capacities frozen at μ `normal`; its mechanism has no
    /// dilatancy and closes the gap best for these normal forces.
    pub(super) fn frozen(&mut self, normal: &[f64]) -> Result<Solution, SearchFailure> {
        let laws: Vec<FrictionLaw> = (self.coulomb.iter().zip(normal))
            .map(|(law, n)| FrictionLaw {
                slope: 0.0,
                intercept: law.slope * n,
            })
            .collect();
        self.program.set_friction(&laws);
        self.program.set_cost(1.0, &self.no_prices);
        self.solve()
    }

    /// (b) The Coulomb state with the smallest gap to a mechanism, λ counted `weight` times: below
    /// 1 it prefers a low λ among equals, above 1 a high one.
    pub(super) fn nearest(
        &mut self,
        prices: &Prices,
        weight: f64,
    ) -> Result<Solution, SearchFailure> {
        self.nearest_within(prices, weight, f64::INFINITY)
    }

    /// The same, or forces on the way to it once gap + (1 − `weight`) λ of the nearest one is known to be
    /// larger than `most`.
    pub(super) fn nearest_within(
        &mut self,
        prices: &Prices,
        weight: f64,
        most: f64,
    ) -> Result<Solution, SearchFailure> {
        self.program.set_friction(&self.coulomb);
        self.program.set_cost(weight, &prices.friction);
        self.program.end_above(most + prices.dead_power);
        self.solve()
    }

    pub(super) fn prices(&self, velocity: &[f64]) -> Prices {
        let mechanism = self.program.scale().mechanism(velocity);
        let rates = mechanism.joint_rates(self.scene);
        let joints = self.scene.joints().iter().zip(&rates);
        Prices {
            friction: joints
                .map(|(j, rate)| j.friction * rate.slip.abs())
                .collect(),
            dead_power: dead_power(self.scene, &mechanism) / self.scene.total_weight(),
        }
    }

    /// (c) The state with the lowest (`sign` −1) or highest (+1) λ among those of one mechanism, by this
    /// change of the cost; `None` where that does not leave the gap closed.
    fn extreme(
        &mut self,
        velocity: &[f64],
        prices: &Prices,
        sign: f64,
        change: f64,
    ) -> Option<State> {
        let found = self.nearest(prices, 1.0 + sign * change).ok()?;
        let closed = prices.gap(&found).abs() <= self.tuned.closed;
        closed.then(|| State::new(found, velocity.to_vec(), prices.clone()))
    }

    /// The lowest state of a mechanism by the largest of these changes of the cost that leaves the gap
    /// closed; `None` where none does. Where that is not the first one tried on this scene, the next one
    /// after that comes first from now on.
    pub(super) fn lowest_of(
        &mut self,
        velocity: &[f64],
        prices: &Prices,
        changes: &[f64],
    ) -> Option<State> {
        let mut lowest = |&change| Some((change, self.extreme(velocity, prices, -1.0, change)?));
        let (change, state) = changes.iter().find_map(&mut lowest)?;
        let all = &self.tuned.cost_changes;
        if change < all[self.too_large] {
            self.too_large = (self.too_large + 1).min(self.tuned.too_large.min(all.len() - 1));
        }
        Some(state)
    }

    /// The highest state of a state's own mechanism, by the largest change of the cost that leaves the gap
    /// closed.
    pub(super) fn highest_of(&mut self, state: &State) -> State {
        let changes = self.tuned.cost_changes;
        let mut highest = |&change| self.extreme(&state.velocity, &state.prices, 1.0, change);
        let found = changes.iter().find_map(&mut highest);
        let higher = found.filter(|other| other.lambda > state.lambda);
        higher.unwrap_or_else(|| state.clone())
    }

    /// The lowest state of a mechanism from which a push begins: where its states reach below 0 the one
    /// at 0, between its lowest and its highest, as the states of one mechanism are convex. `None` where
    /// all of them lie below 0: then it is none of a push.
    pub(super) fn lowest_pushed(&mut self, lowest: State) -> Option<State> {
        // What the solver leaves of a state at 0 is one.
        if lowest.lambda.abs() <= self.tuned.closed {
            return Some(State {
                lambda: 0.0,
                ..lowest
            });
        }
        if lowest.lambda > 0.0 {
            return Some(lowest);
        }
        let highest = self.highest_of(&lowest);
        if highest.lambda < 0.0 {
            return None;
        }
        let share = -lowest.lambda / (highest.lambda - lowest.lambda);
        let between = |low: f64, high: f64| low + share * (high - low);
        let forces = lowest.forces.iter().zip(&highest.forces);
        let forces = forces.map(|(low, high)| JointForce {
            normal: [0, 1].map(|end| between(low.normal[end], high.normal[end])),
            shear: between(low.shear, high.shear),
        });
        Some(State {
            lambda: 0.0,
            forces: forces.collect(),
            ..lowest
        })
    }

    /// Normal forces of a Coulomb state at a given λ*, at random: those that a random cost of every
    /// force picks, a corner of all such states. Where forces have no limit, costs of one sign.
    pub(super) fn random_statics(
        &mut self,
        lambda: f64,
        noise: &mut Noise,
    ) -> Result<Vec<f64>, SearchFailure> {
        let scale = self.program.scale();
        let scene = self.scene;
        let lambda = lambda * scale.multiplier;
        let engine = self.numerics.engine;
        let program = self
            .statics
            .get_or_insert_with(|| Program::at_multiplier(scene, lambda, scale).tested_by(engine));
        program.set_multiplier(scene, lambda);
        let cost = scene.joints().iter();
        let cost: Vec<[f64; 3]> = cost
            .map(|_| [0; 3].map(|_| noise.between(-1.0, 1.0)))
            .collect();
        if !self.unlimited {
            program.set_force_cost(&cost);
            match program.solve_counted(&mut self.work) {
                Ending::Unbounded => self.unlimited = true,
                ending => return Ok(totals(&solved(ending)?.forces)),
            }
        }
        let bounded = cost.iter().map(|[n1, n2, _]| [n1.abs(), n2.abs(), 0.0]);
        program.set_force_cost(&bounded.collect::<Vec<_>>());
        let ending = program.solve_counted(&mut self.work);
        Ok(totals(&solved(ending)?.forces))
    }
}

fn solved(ending: Ending) -> Result<Solution, SearchFailure> {
    match ending {
        Ending::Solved(solution) => Ok(solution),
        Ending::Infeasible(_) => Err(SearchFailure::Infeasible),
        Ending::Unbounded => Err(SearchFailure::Unbounded),
        Ending::GaveUp(_) => Err(SearchFailure::Unsolved),
    }
}
