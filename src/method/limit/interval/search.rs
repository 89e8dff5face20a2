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

use crate::answer::{JointForce, Work, dead_power};
use crate::method::limit::program::{Ending, Friction, Program, Solution};
use crate::scene::{JointClass, Scene};

/// Largest gap of a collapse state. The judge allows 1e-8; a state must keep away from that.
pub(super) const CLOSED: f64 = 2e-9;

/// Shares by which the λ of the gap's own program is changed to look for the lowest and highest λ
/// among the states of one mechanism, from bold to careful. Up to a size that depends on the scene
/// this leaves the gap closed (an exact penalty), which the gap itself tells.
const TILTS: [f64; 4] = [1e-2, 1e-3, 1e-4, 1e-5];

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

/// Why a start gave no state.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Failure {
    /// The gap stayed open.
    Open,
    /// A program with frozen capacities has no force state.
    Infeasible,
    /// A program is unbounded.
    Unbounded,
    /// The solver gave up on a program.
    Unsolved,
    /// The state found for a part of the scene is none of the whole scene.
    PartOnly,
}

impl Failure {
    pub(super) const ALL: [Failure; 5] = [
        Failure::Open,
        Failure::Infeasible,
        Failure::Unbounded,
        Failure::Unsolved,
        Failure::PartOnly,
    ];

    pub(super) fn in_words(self) -> &'static str {
        match self {
            Failure::Open => "gap stayed open",
            Failure::Infeasible => "program infeasible",
            Failure::Unbounded => "program unbounded",
            Failure::Unsolved => "program unsolved",
            Failure::PartOnly => "no state of the whole scene",
        }
    }
}

/// Programs of one start until it is given up.
const PATIENCE: usize = 60;

/// Infeasible frozen programs of one start until it goes back to a Coulomb state's own forces.
const REFUSALS: usize = 4;

fn halfway(a: &[f64], b: &[f64]) -> Vec<f64> {
    a.iter().zip(b).map(|(a, b)| (a + b) / 2.0).collect()
}

/// The search on one scene.
pub(super) struct Search<'a> {
    scene: &'a Scene,
    program: Program,
    coulomb: Vec<Friction>,
    free: Vec<f64>,
    /// N of the last Coulomb state: capacities frozen there hold at least that state.
    safe: Option<Vec<f64>>,
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
        let coulomb = scene.joints().iter().map(|joint| Friction {
            slope: joint.friction,
            intercept: 0.0,
        });
        Self {
            scene,
            program: Program::new(scene),
            coulomb: coulomb.collect(),
            free: vec![0.0; scene.joints().len()],
            safe: None,
            work: Work::default(),
        }
    }

    pub(super) fn program(&self) -> &Program {
        &self.program
    }

    /// Normal forces of the associative state; the ending where there is none.
    pub(super) fn associative(&mut self) -> Result<Vec<f64>, Ending> {
        self.program.set_friction(&self.coulomb);
        self.program.set_cost(1.0, &self.free);
        match self.program.solve_counted(&mut self.work) {
            Ending::Solved(solution) => {
                let normal = totals(&solution.forces);
                self.safe = Some(normal.clone());
                Ok(normal)
            }
            ending => Err(ending),
        }
    }

    fn solve(&mut self) -> Result<Solution, Failure> {
        match self.program.solve_counted(&mut self.work) {
            Ending::Solved(solution) => Ok(solution),
            Ending::Infeasible(_) => Err(Failure::Infeasible),
            Ending::Unbounded => Err(Failure::Unbounded),
            Ending::GaveUp(_) => Err(Failure::Unsolved),
        }
    }

    /// (a) The largest λ with shear capacities frozen at μ `normal`; its mechanism has no
    /// dilatancy and closes the gap best for these normal forces.
    pub(super) fn frozen(&mut self, normal: &[f64]) -> Result<Solution, Failure> {
        let laws: Vec<Friction> = (self.coulomb.iter().zip(normal))
            .map(|(law, n)| Friction {
                slope: 0.0,
                intercept: law.slope * n,
            })
            .collect();
        self.program.set_friction(&laws);
        self.program.set_cost(1.0, &self.free);
        self.solve()
    }

    /// (b) The Coulomb state with the smallest gap to a mechanism, λ counted `weight` times: below
    /// 1 it prefers a low λ among equals, above 1 a high one.
    fn nearest(&mut self, prices: &Prices, weight: f64) -> Result<Solution, Failure> {
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

    /// From normal forces to a collapse state: (a) and (b) in turn until the gap is closed.
    pub(super) fn close(&mut self, mut normal: Vec<f64>) -> Result<State, Failure> {
        let mut last_gap = f64::INFINITY;
        let end = self.work.programs + PATIENCE;
        let mut refused = 0;
        while self.work.programs < end {
            let above = match self.frozen(&normal) {
                // Inclined joints may need more shear than these capacities give.
                Err(Failure::Infeasible) if refused < REFUSALS => {
                    refused += 1;
                    normal = self.nearer_to_safe(&normal, refused)?;
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
            self.safe = Some(coulomb.clone());
            if gap < 0.5 * last_gap {
                normal = coulomb;
            } else {
                normal = halfway(&normal, &totals(&above.forces));
            }
            last_gap = gap;
        }
        Err(Failure::Open)
    }

    /// Half the way to normal forces that carry a Coulomb state, the whole way at last.
    fn nearer_to_safe(&mut self, normal: &[f64], refused: usize) -> Result<Vec<f64>, Failure> {
        let safe = match self.safe.clone() {
            Some(safe) => safe,
            None => self.associative().map_err(|_| Failure::Unsolved)?,
        };
        Ok(match refused {
            REFUSALS => safe,
            _ => halfway(normal, &safe),
        })
    }

    /// (c) The state with the lowest (`sign` −1) or highest (+1) λ among those of one mechanism,
    /// at the boldest tilt that leaves the gap closed; `None` where none does.
    fn extreme(&mut self, velocity: &[f64], prices: &Prices, sign: f64) -> Option<State> {
        TILTS.into_iter().find_map(|tilt| {
            let found = self.nearest(prices, 1.0 + sign * tilt).ok()?;
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
    /// capacities raised a little pick another corner of the mechanisms' face. The solver by itself
    /// lands in its middle, where most joints move and the fewest states remain.
    pub(super) fn neighbour(&mut self, state: &State, step: usize) -> Option<State> {
        let rise = RISES[step % RISES.len()];
        let unit = 1.0 / self.scene.blocks().len() as f64;
        let mut noise = Noise::new(step);
        let raised: Vec<f64> = (self.scene.joints().iter().zip(totals(&state.forces)))
            .map(|(joint, n)| {
                let share = match rise {
                    Rise::HeadJoints(share) if joint.class == JointClass::Head => share,
                    Rise::HeadJoints(_) => 0.0,
                    Rise::Random(share) => share * noise.uniform(),
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
enum Rise {
    HeadJoints(f64),
    Random(f64),
}

/// The rises of a descent, in turn. Head joints alone suffice on walls of up to 55 blocks; on 1176
/// blocks the larger, random ones find the way down (measured).
const RISES: [Rise; 3] = [
    Rise::HeadJoints(1e-3),
    Rise::Random(1e-2),
    Rise::Random(1e-1),
];

/// A fixed sequence of numbers in [0, 1) (xorshift, Marsaglia 2003).
pub(super) struct Noise(u64);

impl Noise {
    /// The sequence of that number; every one is the same in every run.
    pub(super) fn new(sequence: usize) -> Self {
        // Any odd constant would do.
        Self((sequence as u64 + 1).wrapping_mul(0x9E37_79B9_7F4A_7C15))
    }

    pub(super) fn uniform(&mut self) -> f64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 11) as f64 / (1u64 << 53) as f64
    }
}
