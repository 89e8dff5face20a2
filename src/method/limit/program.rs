//! The one linear program of the limit analysis, assembled once and solved for many numbers.
//!
//! Variables: two corner forces n1, n2 and one shear t a joint, then λ*. Rows: three equilibrium
//! equations a block, A q + λ* f_L = −f_D, then four inequalities a joint,
//!
//! ```text
//! n1 ≥ 0,  n2 ≥ 0,  ±t ≤ slope · (n1 + n2) + intercept
//! ```
//!
//! with slope μ and intercept 0 for Coulomb's law. Every method of this folder differs only in
//! slope, intercept and cost, so an iteration changes numbers and never the pattern.

use clarabel::algebra::CscMatrix;

use super::columns::{Entries, joint_columns, multiplier_column, right_side, slack_column};
use super::ending::{Ending, Solution};
use super::equilibration::{Equilibration, UnitPower};
use super::numbers::Numbers;
use super::scale::Scale;
use super::solver::Solver;
use crate::answer::{SolverEnding, Work};
use crate::mechanics::JointForce;
use crate::method::settings::{Engine, LP_TOLERANCE};
use crate::scene::Scene;

mod changes;

/// Friction law of one joint: |t| ≤ slope · (n1 + n2) + intercept, the intercept in units of the
/// scene's total weight.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct FrictionLaw {
    /// Slope; the coefficient of friction for Coulomb's law, negative for a contractant one.
    pub(super) slope: f64,
    /// Shear that the joint carries without compression.
    pub(super) intercept: f64,
}

/// What a program asks for beyond admissibility, in dimensionless form.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Margins {
    /// Least normal force at a corner and least distance of the shear from its limit.
    pub(super) force: f64,
    /// Least opening beyond the flow rule. It bounds self-equilibrated forces, so a scene that can
    /// lock has no optimum with it.
    pub(super) opening: f64,
}

impl Margins {
    /// Distance of forces from their limits, so that what the solver leaves stays inside them.
    pub(super) const OF_FORCES: Self = Self {
        force: 1e-11,
        opening: 0.0,
    };
}

/// The program of one scene.
pub struct Program {
    solver: Solver,
    numbers: Numbers,
    /// Where a joint's four friction coefficients stand in the matrix: rows ±t, columns n1 and n2.
    friction_at: Vec<[usize; 4]>,
    scale: Scale,
    /// Units of blocks and joints inside the program, where it needs them.
    equilibration: Option<Equilibration>,
    goal: Goal,
}

/// What a program looks for. All but `Forces` have a variable of their own behind the forces.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Goal {
    /// The largest λ.
    Multiplier,
    Forces(f64),
    /// Forces at this λ as far inside all their limits as possible, up to [`MAX_SLACK`].
    Slack(f64),
}

impl Goal {
    /// The λ that is given, where it is not the variable.
    fn fixed(self) -> Option<f64> {
        match self {
            Goal::Multiplier => None,
            Goal::Forces(lambda) | Goal::Slack(lambda) => Some(lambda),
        }
    }
}

/// Cap on the slack, in mean block weights; without it scenes that lock are unbounded.
const MAX_SLACK: f64 = 0.01;

impl Program {
    /// Assembles the associative program of a scene: Coulomb's law in every joint, λ to be largest.
    pub fn new(scene: &Scene) -> Self {
        Self::to_tolerance(scene, LP_TOLERANCE)
    }

    /// The same to another tolerance than the default.
    pub fn to_tolerance(scene: &Scene, tolerance: f64) -> Self {
        Self::with_units(scene, tolerance, UnitPower::CubeRoot)
    }

    /// The same, with these units of unequal blocks.
    pub(super) fn with_units(scene: &Scene, tolerance: f64, power: UnitPower) -> Self {
        Self::assemble(scene, Scale::of(scene), Goal::Multiplier, tolerance, power)
    }

    /// Assembles the program that only asks for forces at a given λ, in given units.
    pub(super) fn at_multiplier(scene: &Scene, lambda: f64, scale: Scale) -> Self {
        let goal = Goal::Forces(lambda);
        Self::assemble(scene, scale, goal, LP_TOLERANCE, UnitPower::CubeRoot)
    }

    /// Assembles the program for the forces at a given λ with the largest slack m: every corner
    /// force and every distance of a shear from its limit is at least m. Negative slack shows how
    /// far the scene is from standing, and its mechanism moves without more push: this program has
    /// an optimum on either side, where the one of [`Program::at_multiplier`] has none.
    pub(super) fn with_slack(scene: &Scene, lambda: f64, power: UnitPower) -> Self {
        let scale = Scale::of(scene);
        Self::assemble(scene, scale, Goal::Slack(lambda), LP_TOLERANCE, power)
    }

    fn assemble(scene: &Scene, scale: Scale, goal: Goal, tolerance: f64, power: UnitPower) -> Self {
        let rows_of_blocks = 3 * scene.blocks().len();
        let joints = scene.joints().len();
        let inequalities = 4 * joints + usize::from(matches!(goal, Goal::Slack(_)));
        let rows = rows_of_blocks + inequalities;
        let columns = 3 * joints + usize::from(!matches!(goal, Goal::Forces(_)));
        let mut entries = Entries::for_joints(joints);
        let friction_at = joint_columns(scene, &scale, &mut entries);
        let mut right = right_side(scene, &scale, goal.fixed().unwrap_or(0.0));
        right.resize(rows, 0.0);
        match goal {
            Goal::Multiplier => multiplier_column(scene, &scale, &mut entries),
            Goal::Forces(_) => {}
            Goal::Slack(_) => {
                slack_column(rows_of_blocks..rows, &mut entries);
                right[rows - 1] = MAX_SLACK / scene.blocks().len() as f64;
            }
        }
        let equilibration = Equilibration::of(scene, &scale, power);
        if let Some(units) = &equilibration {
            units.scale(&mut entries, &mut right[..rows_of_blocks], &friction_at);
        }
        let matrix = CscMatrix::new(rows, columns, entries.starts, entries.rows, entries.values);
        let mut cost = vec![0.0; columns];
        if let Some(last) = cost.get_mut(3 * joints) {
            *last = -1.0;
        }
        let slopes = friction_at.iter().map(|at| -matrix.nzval[at[0]]);
        let numbers = Numbers {
            slopes: slopes.collect(),
            matrix,
            right,
            cost,
            rows_of_blocks,
            tolerance,
            width: 0.0,
            useless_above: f64::INFINITY,
            has_own_units: equilibration.is_some(),
            has_slack: matches!(goal, Goal::Slack(_)),
        };
        Self {
            solver: Solver::new(numbers.engine(), &numbers),
            numbers,
            friction_at,
            scale,
            equilibration,
            goal,
        }
    }

    /// The same program, solved by the engine that is asked for from the beginning.
    pub(super) fn by(mut self, engine: Engine) -> Self {
        if engine != Engine::Structured {
            self.solver = Solver::new(engine, &self.numbers);
        }
        self
    }

    /// The same for a caller that tests what the answers prove: the structured engine solves programs in
    /// units of blocks and joints too (on 348 blocks eight times as fast as Clarabel), but leaves more of
    /// the velocities of light blocks.
    pub(super) fn tested_by(mut self, engine: Engine) -> Self {
        if engine != self.engine() {
            self.solver = Solver::new(engine, &self.numbers);
        }
        self
    }

    /// The same program for a caller that tests what the answer proves, so that λ* of this relative
    /// width is enough where rounding leaves no better one: on walls of 20,000 blocks.
    pub(super) fn with_width(mut self, width: f64) -> Self {
        self.numbers.width = width;
        self
    }

    /// Asks for less of Clarabel's linear systems, for a search that solves many programs and proves
    /// what it keeps: a quarter less time for the same states (measured on walls of 20 to 40 blocks).
    /// Programs with units of their own stay as they are.
    pub(super) fn refine_less(&mut self) {
        if self.equilibration.is_none() {
            self.solver.refine_less(&self.numbers);
        }
    }

    /// Which engine solves it first.
    pub(super) fn engine(&self) -> Engine {
        self.solver.engine()
    }

    /// Units of this program.
    pub(super) fn scale(&self) -> Scale {
        self.scale
    }

    /// Solves the program as it stands and counts it.
    pub(super) fn solve_counted(&mut self, work: &mut Work) -> Ending {
        let solved = self.solver.solve(&self.numbers);
        work.programs += 1;
        work.iterations += solved.iterations;
        work.fallbacks += usize::from(self.solver.engine() != solved.engine);
        match solved.ending {
            SolverEnding::Optimum => {
                let (forces, lambda) = self.forces(&solved.variables);
                Ending::Solved(Solution {
                    lambda,
                    forces,
                    velocity: self.velocity(solved.velocities),
                    engine: solved.engine,
                })
            }
            SolverEnding::Infeasible => Ending::Infeasible(self.velocity(solved.velocities)),
            SolverEnding::Unbounded => Ending::Unbounded,
            SolverEnding::GaveUp(why) => Ending::GaveUp(why),
        }
    }

    /// Solves the program as it stands.
    pub fn solve(&mut self) -> Ending {
        self.solve_counted(&mut Work::default())
    }

    /// Force unit of a joint in the program, in that of the scale.
    fn joint_unit(&self, joint: usize) -> f64 {
        self.own_unit(joint).unwrap_or(1.0)
    }

    /// The same, where joints have units of their own.
    pub(super) fn own_unit(&self, joint: usize) -> Option<f64> {
        let units = self.equilibration.as_ref()?;
        Some(units.joints[joint])
    }

    /// Unit of a joint's shear, in that of the joint.
    fn shear_unit(&self, joint: usize) -> f64 {
        self.equilibration
            .as_ref()
            .map_or(1.0, |units| units.shears[joint])
    }

    fn velocity(&self, mut rates: Vec<f64>) -> Vec<f64> {
        if let Some(units) = &self.equilibration {
            units.scale_rows(&mut rates);
        }
        rates
    }

    /// Forces of the joints and λ*.
    fn forces(&self, variables: &[f64]) -> (Vec<JointForce>, f64) {
        let (corners, last) = variables.split_at(3 * self.friction_at.len());
        let forces = corners.chunks_exact(3).enumerate().map(|(j, q)| {
            let unit = self.joint_unit(j);
            JointForce {
                normal: [q[0] * unit, q[1] * unit],
                shear: q[2] * unit * self.shear_unit(j),
            }
        });
        let lambda = match self.goal.fixed() {
            None => last[0],
            Some(lambda) => lambda / self.scale.multiplier,
        };
        (forces.collect(), lambda)
    }
}
