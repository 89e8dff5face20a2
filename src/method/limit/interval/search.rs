//! Two linear programs that alternate on the complementarity gap of non-associative friction.
//!
//! For a statically admissible state (q, λ) and a zero-dilatancy mechanism u with f_L·u = 1 the gap
//!
//! ```text
//! gap = Σ μ N |slip| − f_D·u − λ  =  Σ n · opening + Σ (μ N |slip| + t · slip)  ≥ 0
//! ```
//!
//! is the whole violation of complementarity in units of λ, and (q, λ, u) is a collapse state where
//! it vanishes. It holds no mode that could be guessed wrong: every opening counts with its size.

use super::noise::Noise;
use crate::answer::{JointForce, SearchFailure, Work, dead_power};
use crate::method::limit::ending::{Ending, Solution};
use crate::method::limit::program::{FrictionLaw, Program};
use crate::scene::{JointClass, Scene};

/// Largest gap of a collapse state. The judge allows 1e-8; a state must keep away from that.
pub(super) const CLOSED: f64 = 2e-9;

/// Shares by which the cost of λ in program (b) is changed to look for the lowest and highest λ
/// among the states of one mechanism, from large to small. Up to a size that depends on the scene
/// this leaves the gap closed (an exact penalty), which the gap itself shows.
const COST_CHANGES: [f64; 4] = [1e-2, 1e-3, 1e-4, 1e-5];

/// A verified collapse state in dimensionless form.
#[derive(Clone, Debug)]
pub(super) struct State {
    pub(super) lambda: f64,
    pub(super) forces: Vec<JointForce>,
    pub(super) velocity: Vec<f64>,
    /// Price μ|slip| of the normal force of every joint, which is all that the states of one
    /// mechanism share.
    prices: Prices,
}

impl State {
    fn new(solution: Solution, velocity: Vec<f64>, prices: Prices) -> Self {
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
struct Prices {
    friction: Vec<f64>,
    dead_power: f64,
}

impl Prices {
    fn gap(&self, solution: &Solution) -> f64 {
        let dissipated = totals(&solution.forces);
        let dissipated: f64 = dissipated
            .iter()
            .zip(&self.friction)
            .map(|(n, p)| n * p)
            .sum();
        dissipated - self.dead_power - solution.lambda
    }
}

/// How a search goes on from capacities that leave a gap.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Approach {
    /// To the Coulomb state's normal forces where that halves the gap: few programs.
    Quick,
    /// Half the way to the forces of the frozen program, always: more programs, and other states.
    Blending,
}

/// Programs of one start until it is given up.
const MAX_PROGRAMS: usize = 60;

/// Infeasible frozen programs of one start until it goes back to a Coulomb state's own forces.
const MAX_INFEASIBLE: usize = 4;

fn halfway(a: &[f64], b: &[f64]) -> Vec<f64> {
    a.iter().zip(b).map(|(a, b)| (a + b) / 2.0).collect()
}

/// The search on one scene.
pub(super) struct Search<'a> {
    scene: &'a Scene,
    program: Program,
    coulomb: Vec<FrictionLaw>,
    /// No price on any joint's normal force.
    no_prices: Vec<f64>,
    /// N of the last Coulomb state: capacities frozen there hold at least that state.
    coulomb_normal: Option<Vec<f64>>,
    pub(super) work: Work,
}

/// N of every joint, negative rounding cut off.
pub(super) fn totals(forces: &[JointForce]) -> Vec<f64> {
    forces
        .iter()
        .map(|f| (f.normal[0] + f.normal[1]).max(0.0))
        .collect()
}

impl<'a> Search<'a> {
    pub(super) fn new(scene: &'a Scene) -> Self {
        let coulomb = scene.joints().iter().map(|joint| FrictionLaw {
            slope: joint.friction,
            intercept: 0.0,
        });
        Self {
            scene,
            program: Program::new(scene),
            coulomb: coulomb.collect(),
            no_prices: vec![0.0; scene.joints().len()],
            coulomb_normal: None,
            work: Work::default(),
        }
    }

    pub(super) fn program(&self) -> &Program {
        &self.program
    }

    /// Normal forces of the associative state; the ending where there is none.
    pub(super) fn associative(&mut self) -> Result<Vec<f64>, Ending> {
        self.program.set_friction(&self.coulomb);
        self.program.set_cost(1.0, &self.no_prices);
        match self.program.solve_counted(&mut self.work) {
            Ending::Solved(solution) => {
                let normal = totals(&solution.forces);
                self.coulomb_normal = Some(normal.clone());
                Ok(normal)
            }
            ending => Err(ending),
        }
    }

    fn solve(&mut self) -> Result<Solution, SearchFailure> {
        match self.program.solve_counted(&mut self.work) {
            Ending::Solved(solution) => Ok(solution),
            Ending::Infeasible(_) => Err(SearchFailure::Infeasible),
            Ending::Unbounded => Err(SearchFailure::Unbounded),
            Ending::GaveUp(_) => Err(SearchFailure::Unsolved),
        }
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
    fn nearest(&mut self, prices: &Prices, weight: f64) -> Result<Solution, SearchFailure> {
        self.program.set_friction(&self.coulomb);
        self.program.set_cost(weight, &prices.friction);
        self.solve()
    }

    fn prices(&self, velocity: &[f64]) -> Prices {
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

    /// Takes these normal forces, which carry a Coulomb state, where there is no associative one.
    pub(super) fn carry(&mut self, normal: Vec<f64>) {
        self.coulomb_normal = Some(normal);
    }

    /// From normal forces to a collapse state: (a) and (b) in turn until the gap is closed.
    pub(super) fn close(
        &mut self,
        mut normal: Vec<f64>,
        approach: Approach,
    ) -> Result<State, SearchFailure> {
        let mut last_gap = f64::INFINITY;
        let end = self.work.programs + MAX_PROGRAMS;
        let mut infeasible = 0;
        while self.work.programs < end {
            let above = match self.frozen(&normal) {
                // Inclined joints may need more shear than these capacities give.
                Err(SearchFailure::Infeasible) if infeasible < MAX_INFEASIBLE => {
                    infeasible += 1;
                    normal = self.nearer_to_coulomb(&normal, infeasible)?;
                    continue;
                }
                frozen => frozen?,
            };
            let prices = self.prices(&above.velocity);
            let below = self.nearest(&prices, 1.0)?;
            let gap = prices.gap(&below);
            if gap.abs() <= CLOSED {
                return Ok(State::new(below, above.velocity, prices));
            }
            // (b) alone stalls on walls with openings; blending alone is slow.
            let coulomb = totals(&below.forces);
            self.coulomb_normal = Some(coulomb.clone());
            if approach == Approach::Quick && gap < 0.5 * last_gap {
                normal = coulomb;
            } else {
                normal = halfway(&normal, &totals(&above.forces));
            }
            last_gap = gap;
        }
        Err(SearchFailure::GapOpen)
    }

    /// Half the way to normal forces that carry a Coulomb state, the whole way at last.
    fn nearer_to_coulomb(
        &mut self,
        normal: &[f64],
        infeasible: usize,
    ) -> Result<Vec<f64>, SearchFailure> {
        let coulomb = match self.coulomb_normal.clone() {
            Some(coulomb) => coulomb,
            None => self.associative().map_err(|_| SearchFailure::Unsolved)?,
        };
        Ok(if infeasible == MAX_INFEASIBLE {
            coulomb
        } else {
            halfway(normal, &coulomb)
        })
    }

    /// (c) The state with the lowest (`sign` −1) or highest (+1) λ among those of one mechanism,
    /// by the largest change of the cost that leaves the gap closed; `None` where none does.
    fn extreme(&mut self, velocity: &[f64], prices: &Prices, sign: f64) -> Option<State> {
        COST_CHANGES.into_iter().find_map(|change| {
            let found = self.nearest(prices, 1.0 + sign * change).ok()?;
            let closed = prices.gap(&found).abs() <= CLOSED;
            closed.then(|| State::new(found, velocity.to_vec(), prices.clone()))
        })
    }

    /// The lowest (`sign` −1) or highest (+1) state of a state's own mechanism.
    pub(super) fn extreme_of(&mut self, state: &State, sign: f64) -> State {
        let found = self.extreme(&state.velocity, &state.prices, sign);
        let better = found.filter(|other| sign * (other.lambda - state.lambda) > 0.0);
        better.unwrap_or_else(|| state.clone())
    }

    /// The lowest state of another mechanism that much the same normal forces allow: frozen
    /// capacities raised a little pick another corner of the face of optimal mechanisms. The solver
    /// by itself lands in the middle of that face, where most joints move and the fewest states
    /// remain.
    pub(super) fn neighbour(&mut self, state: &State, step: usize) -> Option<State> {
        let raise = RAISES[step % RAISES.len()];
        let unit = 1.0 / self.scene.blocks().len() as f64;
        let mut noise = Noise::new(step);
        let raised: Vec<f64> = (self.scene.joints().iter().zip(totals(&state.forces)))
            .map(|(joint, n)| {
                let share = match raise {
                    NormalRaise::HeadJoints(share) if joint.class == JointClass::Head => share,
                    NormalRaise::HeadJoints(_) => 0.0,
                    NormalRaise::Random(share) => share * noise.uniform(),
                };
                n + share * unit
            })
            .collect();
        let above = self.frozen(&raised).ok()?;
        let prices = self.prices(&above.velocity);
        self.extreme(&above.velocity, &prices, -1.0)
    }
}

/// How normal forces are raised, in mean block weights.
#[derive(Clone, Copy)]
enum NormalRaise {
    HeadJoints(f64),
    Random(f64),
}

/// What the steps of a descent raise, in turn. Head joints alone suffice on walls of up to 55
/// blocks; on 1176 blocks the larger, random raises find lower states (measured).
const RAISES: [NormalRaise; 3] = [
    NormalRaise::HeadJoints(1e-3),
    NormalRaise::Random(1e-2),
    NormalRaise::Random(1e-1),
];
