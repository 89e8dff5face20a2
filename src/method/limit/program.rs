//! The one linear program of the limit analysis, assembled once and solved by Clarabel.
//!
//! Variables: two corner forces n1, n2 and one shear t a joint, then λ. Rows: three equilibrium
//! equations a block, A q + λ f_L = −f_D, then four inequalities a joint,
//!
//! ```text
//! n1 ≥ 0,  n2 ≥ 0,  ±t ≤ slope · (n1 + n2) + intercept
//! ```
//!
//! with slope μ and intercept 0 for Coulomb's law. Every method of this folder differs only in
//! slope, intercept and cost, so an iteration changes numbers and never the pattern.

use clarabel::algebra::CscMatrix;
use clarabel::solver::{
    DefaultSettings, DefaultSolver, IPSolver, SolverStatus,
    SupportedConeT::{NonnegativeConeT, ZeroConeT},
};

use super::columns::{Entries, equilibrium_column};
use super::scale::Scale;
use crate::answer::{JointForce, SolverEnding, Work};
use crate::method::settings::LP_TOLERANCE;
use crate::scene::Scene;

/// Friction law of one joint: |t| ≤ slope · (n1 + n2) + intercept, the intercept in units of the
/// scene's total weight.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FrictionLaw {
    /// Slope; the coefficient of friction for Coulomb's law, negative for a contractant one.
    pub slope: f64,
    /// Shear that the joint carries without compression.
    pub intercept: f64,
}

/// What a program asks for beyond admissibility, in dimensionless form.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Margins {
    /// Least normal force at a corner and least distance of the shear from its limit.
    pub force: f64,
    /// Least opening beyond the flow rule. It bounds self-equilibrated forces, so a scene that can
    /// lock has no optimum with it.
    pub opening: f64,
}

/// How a program ended.
#[derive(Clone, Debug)]
pub enum Ending {
    /// The solver reports an optimum. That is its word, not a proof.
    Solved(Solution),
    /// No force state satisfies the rows, for any λ; velocities as in [`Solution`] by which the
    /// solver shows that. Its word again.
    Infeasible(Vec<f64>),
    /// λ can grow without limit.
    Unbounded,
    /// The solver gave up; its own word for why.
    GaveUp(String),
}

impl Ending {
    /// The ending without its numbers.
    pub fn kind(&self) -> SolverEnding {
        match self {
            Ending::Solved(_) => SolverEnding::Optimum,
            Ending::Infeasible(_) => SolverEnding::Infeasible,
            Ending::Unbounded => SolverEnding::Unbounded,
            Ending::GaveUp(why) => SolverEnding::GaveUp(why.clone()),
        }
    }
}

/// A force state and the mechanism dual to it, in dimensionless form: total weight 1, wall height
/// 1, and a mechanism on which the live load for λ = 1 does unit work.
#[derive(Clone, Debug)]
pub struct Solution {
    /// Multiplier of the force state.
    pub lambda: f64,
    /// Corner forces and shear of every joint.
    pub forces: Vec<JointForce>,
    /// Velocities (fx, fy about the centroid, rotation times height), three a block.
    pub velocity: Vec<f64>,
    /// Interior-point iterations.
    pub iterations: usize,
}

/// The program of one scene.
pub struct Program {
    solver: DefaultSolver<f64>,
    values: Vec<f64>,
    right: Vec<f64>,
    /// Where a joint's four friction coefficients stand in `values`: rows ±t, columns n1 and n2.
    friction_at: Vec<[usize; 4]>,
    rows_of_blocks: usize,
    scale: Scale,
    goal: Goal,
}

/// What a program looks for. All but `Forces` have a variable of their own behind the forces.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Goal {
    /// The largest λ.
    Multiplier,
    /// Any forces at this λ.
    Forces(f64),
    /// Forces at this λ as far inside all their limits as possible, up to [`MAX_SLACK`].
    Slack(f64),
}

/// Cap on the slack, in mean block weights; without it scenes that lock are unbounded.
const MAX_SLACK: f64 = 0.01;

impl Program {
    /// Assembles the associative program of a scene: Coulomb's law in every joint, λ to be largest.
    pub fn new(scene: &Scene) -> Self {
        Self::assemble(scene, Scale::of(scene), Goal::Multiplier)
    }

    /// The same to another tolerance than the default.
    pub fn to_tolerance(scene: &Scene, tolerance: f64) -> Self {
        Self::assemble_to(scene, Scale::of(scene), Goal::Multiplier, tolerance)
    }

    /// Assembles the program that only asks for forces at a given λ, in given units.
    pub fn at_multiplier(scene: &Scene, lambda: f64, scale: Scale) -> Self {
        Self::assemble(scene, scale, Goal::Forces(lambda))
    }

    /// Assembles the program for the forces at a given λ with the largest slack m: every corner
    /// force and every distance of a shear from its limit is at least m. Negative slack shows how
    /// far the scene is from standing, and its mechanism moves without more push: this program has
    /// an optimum on either side, where the one of [`Program::at_multiplier`] has none.
    pub fn with_slack(scene: &Scene, lambda: f64) -> Self {
        Self::assemble(scene, Scale::of(scene), Goal::Slack(lambda))
    }

    fn assemble(scene: &Scene, scale: Scale, goal: Goal) -> Self {
        Self::assemble_to(scene, scale, goal, LP_TOLERANCE)
    }

    fn assemble_to(scene: &Scene, scale: Scale, goal: Goal, tolerance: f64) -> Self {
        let rows_of_blocks = 3 * scene.blocks().len();
        let joints = scene.joints().len();
        let has_slack = matches!(goal, Goal::Slack(_));
        let fixed = match goal {
            Goal::Multiplier => None,
            Goal::Forces(lambda) | Goal::Slack(lambda) => Some(lambda),
        };
        let inequalities = 4 * joints + usize::from(has_slack);
        let rows = rows_of_blocks + inequalities;
        let columns = 3 * joints + usize::from(!matches!(goal, Goal::Forces(_)));
        let mut entries = Entries::default();
        let mut friction_at = Vec::with_capacity(joints);
        for (j, joint) in scene.joints().iter().enumerate() {
            let first = rows_of_blocks + 4 * j;
            let mut at = [0; 4];
            for corner in 0..2 {
                equilibrium_column(scene, &scale, j, corner, &mut entries);
                entries.push(first + corner, -1.0);
                at[corner] = entries.push(first + 2, -joint.friction);
                at[2 + corner] = entries.push(first + 3, -joint.friction);
                entries.close_column();
            }
            equilibrium_column(scene, &scale, j, 2, &mut entries);
            entries.push(first + 2, 1.0);
            entries.push(first + 3, -1.0);
            entries.close_column();
            friction_at.push(at);
        }
        let mut right = vec![0.0; rows];
        for (i, block) in scene.blocks().iter().enumerate() {
            let units = [scale.force, scale.force, scale.force * scale.length];
            let (dead, live) = (block.dead(), block.live());
            for k in 0..3 {
                right[3 * i + k] = -(dead[k] + fixed.unwrap_or(0.0) * live[k]) / units[k];
                if live[k] != 0.0 && fixed.is_none() {
                    entries.push(3 * i + k, live[k] / units[k]);
                }
            }
        }
        if has_slack {
            for row in rows_of_blocks..rows {
                entries.push(row, 1.0);
            }
            right[rows - 1] = MAX_SLACK / scene.blocks().len() as f64;
        }
        if columns > 3 * joints {
            entries.close_column();
        }
        let matrix = CscMatrix::new(rows, columns, entries.starts, entries.rows, entries.values);
        let mut cost = vec![0.0; columns];
        if let Some(last) = cost.get_mut(3 * joints) {
            *last = -1.0;
        }
        let cones = [ZeroConeT(rows_of_blocks), NonnegativeConeT(inequalities)];
        let solver = DefaultSolver::new(
            &CscMatrix::zeros((columns, columns)),
            &cost,
            &matrix,
            &right,
            &cones,
            settings(tolerance),
        )
        .expect("dimensions agree by construction");
        Self {
            values: matrix.nzval,
            right,
            solver,
            friction_at,
            rows_of_blocks,
            scale,
            goal,
        }
    }

    /// Units of this program.
    pub fn scale(&self) -> Scale {
        self.scale
    }

    /// Asks for a little more than admissible: every force inequality to hold with [`Margins::force`]
    /// to spare, every corner to open by [`Margins::opening`] beyond what the flow rule needs.
    ///
    /// The solver's own violations of 1e-12 then stay inside the margins, so forces and mechanism
    /// are admissible exactly and their multipliers are bounds, from the one solve. The price is a
    /// bracket of 1e-9 (33 blocks) to 6e-9 (1176 blocks) instead of 1e-12, at the same number of
    /// iterations (measured); margins ten times larger cost ten times the width and save nothing.
    pub fn set_margins(&mut self, margins: Margins) {
        for right in &mut self.right[self.rows_of_blocks..] {
            *right -= margins.force;
        }
        let updated = self.solver.update_b(&self.right);
        updated.expect("presolve is off, so updates are allowed");
        self.set_cost(1.0, &vec![-margins.opening; self.friction_at.len()]);
    }

    /// Changes the friction law of every joint; one law a joint, in the scene's order.
    pub fn set_friction(&mut self, laws: &[FrictionLaw]) {
        for (j, law) in laws.iter().enumerate() {
            for at in self.friction_at[j] {
                self.values[at] = -law.slope;
            }
            let first = self.rows_of_blocks + 4 * j;
            self.right[first + 2] = law.intercept;
            self.right[first + 3] = law.intercept;
        }
        let updated = self.solver.update_A(&self.values);
        updated.expect("presolve is off, so updates are allowed");
        let updated = self.solver.update_b(&self.right);
        updated.expect("presolve is off, so updates are allowed");
    }

    /// Changes the cost: `lambda` · λ (or the slack) − Σ price · (n1 + n2) is to be largest, with
    /// one price a joint in `normal`.
    pub fn set_cost(&mut self, lambda: f64, normal: &[f64]) {
        let mut cost = vec![0.0; self.solver.solution.x.len()];
        for (j, price) in normal.iter().enumerate() {
            cost[3 * j] = *price;
            cost[3 * j + 1] = *price;
        }
        if let Some(last) = cost.get_mut(3 * normal.len()) {
            *last = -lambda;
        }
        let updated = self.solver.update_q(&cost);
        updated.expect("presolve is off, so updates are allowed");
    }

    /// Solves the program as it stands and counts it.
    pub fn solve_counted(&mut self, work: &mut Work) -> Ending {
        let ending = self.solve();
        work.programs += 1;
        work.iterations += self.solver.solution.iterations as usize;
        ending
    }

    /// Solves the program as it stands.
    pub fn solve(&mut self) -> Ending {
        self.solver.solve();
        let solution = &self.solver.solution;
        match solution.status {
            SolverStatus::Solved | SolverStatus::AlmostSolved => Ending::Solved(self.read()),
            SolverStatus::PrimalInfeasible | SolverStatus::AlmostPrimalInfeasible => {
                Ending::Infeasible(solution.z[..self.rows_of_blocks].to_vec())
            }
            SolverStatus::DualInfeasible | SolverStatus::AlmostDualInfeasible => Ending::Unbounded,
            status @ (SolverStatus::Unsolved
            | SolverStatus::MaxIterations
            | SolverStatus::MaxTime
            | SolverStatus::NumericalError
            | SolverStatus::InsufficientProgress
            | SolverStatus::CallbackTerminated) => Ending::GaveUp(format!("{status:?}")),
        }
    }

    fn read(&self) -> Solution {
        let solution = &self.solver.solution;
        let (corners, lambda) = solution.x.split_at(3 * self.friction_at.len());
        let forces = corners.chunks_exact(3).map(|q| JointForce {
            normal: [q[0], q[1]],
            shear: q[2],
        });
        Solution {
            lambda: match self.goal {
                Goal::Multiplier => lambda[0],
                Goal::Forces(lambda) | Goal::Slack(lambda) => lambda,
            },
            forces: forces.collect(),
            velocity: solution.z[..self.rows_of_blocks].to_vec(),
            iterations: solution.iterations as usize,
        }
    }
}

fn settings(tolerance: f64) -> DefaultSettings<f64> {
    DefaultSettings {
        verbose: false,
        max_threads: 1,
        direct_solve_method: "qdldl".to_owned(),
        // Presolve would drop rows and forbid data updates.
        presolve_enable: false,
        tol_gap_abs: tolerance,
        tol_gap_rel: tolerance,
        tol_feas: tolerance,
        ..DefaultSettings::default()
    }
}
