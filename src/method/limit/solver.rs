//! What solves the programs: the interior point that knows their structure, or Clarabel.
//!
//! The structured one counts only where its answer satisfies the conditions of an optimum; where it
//! gives up, as on every program without an optimum, Clarabel solves the program from scratch.

use clarabel::algebra::CscMatrix;
use clarabel::solver::{
    DefaultSettings, DefaultSolver, IPSolver, SolverStatus,
    SupportedConeT::{NonnegativeConeT, ZeroConeT},
};

use super::numbers::{Numbers, Solved};
use super::structured::InteriorPoint;
use crate::answer::SolverEnding;
use crate::method::settings::{Engine, LP_TOLERANCE};

/// A solver of one scene's programs, one after the other.
pub(super) enum Solver {
    Structured(Box<InteriorPoint>),
    Clarabel(Box<DefaultSolver<f64>>),
}

impl Solver {
    /// The solver that is asked for, or Clarabel for programs that the structured one does not know.
    pub(super) fn new(engine: Engine, numbers: &Numbers) -> Self {
        match engine {
            Engine::Structured if !numbers.has_slack => {
                Solver::Structured(Box::new(InteriorPoint::new(numbers)))
            }
            Engine::Structured | Engine::Clarabel => {
                let settings = settings(numbers.tolerance, numbers.has_own_units);
                Solver::Clarabel(Box::new(clarabel(numbers, settings)))
            }
        }
    }

    /// Takes changes of the numbers: of the matrix, the right sides or the costs.
    pub(super) fn update(&mut self, numbers: &Numbers, change: Change) {
        let Solver::Clarabel(solver) = self else {
            return;
        };
        let updated = match change {
            Change::Matrix => solver.update_A(&numbers.matrix.nzval),
            Change::Right => solver.update_b(&numbers.right),
            Change::Cost => solver.update_q(&numbers.cost),
        };
        updated.expect("presolve is off, so updates are allowed");
    }

    /// Asks Clarabel to refine its linear systems less, where it is the one that was asked for.
    pub(super) fn refine_less(&mut self, numbers: &Numbers) {
        if let Solver::Clarabel(solver) = self {
            let rough = DefaultSettings {
                iterative_refinement_reltol: ROUGH_REFINEMENT,
                iterative_refinement_abstol: ROUGH_REFINEMENT,
                ..settings(numbers.tolerance, false)
            };
            let updated = solver.update_settings(rough);
            updated.expect("refinement may change at any time");
        }
    }

    /// Solves the program as it stands.
    pub(super) fn solve(&mut self, numbers: &Numbers) -> Solved {
        let solver = match self {
            Solver::Clarabel(solver) => return solved(solver, numbers),
            Solver::Structured(solver) => solver,
        };
        solver.solve(numbers).unwrap_or_else(|iterations| {
            let settings = settings(numbers.tolerance, numbers.has_own_units);
            let mut clarabel = clarabel(numbers, settings);
            let solved = solved(&mut clarabel, numbers);
            Solved {
                iterations: iterations + solved.iterations,
                ..solved
            }
        })
    }

    /// Which solver this is.
    pub(super) fn engine(&self) -> Engine {
        match self {
            Solver::Structured(_) => Engine::Structured,
            Solver::Clarabel(_) => Engine::Clarabel,
        }
    }
}

/// What has changed of a program's numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Change {
    Matrix,
    Right,
    Cost,
}

fn clarabel(numbers: &Numbers, settings: DefaultSettings<f64>) -> DefaultSolver<f64> {
    let (matrix, equations) = (&numbers.matrix, numbers.rows_of_blocks);
    let solver = linear(&numbers.cost, matrix, &numbers.right, equations, settings);
    solver.expect("dimensions agree by construction")
}

/// Clarabel for a program whose first so many rows are equations, the others inequalities.
fn linear(
    cost: &[f64],
    matrix: &CscMatrix<f64>,
    right: &[f64],
    equations: usize,
    settings: DefaultSettings<f64>,
) -> Option<DefaultSolver<f64>> {
    let quadratic = CscMatrix::zeros((cost.len(), cost.len()));
    let cones = [
        ZeroConeT(equations),
        NonnegativeConeT(right.len() - equations),
    ];
    DefaultSolver::new(&quadratic, cost, matrix, right, &cones, settings).ok()
}

fn solved(solver: &mut DefaultSolver<f64>, numbers: &Numbers) -> Solved {
    solver.solve();
    let solution = &solver.solution;
    let ending = match solution.status {
        SolverStatus::Solved | SolverStatus::AlmostSolved => SolverEnding::Optimum,
        SolverStatus::PrimalInfeasible | SolverStatus::AlmostPrimalInfeasible => {
            SolverEnding::Infeasible
        }
        SolverStatus::DualInfeasible | SolverStatus::AlmostDualInfeasible => {
            SolverEnding::Unbounded
        }
        status @ (SolverStatus::Unsolved
        | SolverStatus::MaxIterations
        | SolverStatus::MaxTime
        | SolverStatus::NumericalError
        | SolverStatus::InsufficientProgress
        | SolverStatus::CallbackTerminated) => SolverEnding::GaveUp(format!("{status:?}")),
    };
    Solved {
        ending,
        variables: solution.x.clone(),
        velocities: solution.z[..numbers.rows_of_blocks].to_vec(),
        iterations: solution.iterations as usize,
        engine: Engine::Clarabel,
    }
}

/// Multipliers of the rows of a program (the first so many are equations, the others inequalities)
/// with this cost: at its optimum, or those that show that it has no solution. `None` where it is
/// unbounded or the solver gave up.
pub(super) fn multipliers(
    cost: &[f64],
    matrix: &CscMatrix<f64>,
    right: &[f64],
    equations: usize,
) -> Option<Vec<f64>> {
    let settings = settings(LP_TOLERANCE, false);
    let mut solver = linear(cost, matrix, right, equations, settings)?;
    solver.solve();
    match solver.solution.status {
        SolverStatus::Solved | SolverStatus::PrimalInfeasible => Some(solver.solution.z.clone()),
        _ => None,
    }
}

/// Settings of Clarabel for programs to this tolerance; `tight` where blocks or joints have units of
/// their own.
fn settings(tolerance: f64, tight: bool) -> DefaultSettings<f64> {
    let settings = DefaultSettings {
        verbose: false,
        max_threads: 1,
        direct_solve_method: "qdldl".to_owned(),
        // Presolve would drop rows and forbid data updates.
        presolve_enable: false,
        tol_gap_abs: tolerance,
        tol_gap_rel: tolerance,
        tol_feas: tolerance,
        ..DefaultSettings::default()
    };
    if !tight {
        return settings;
    }
    // What is left of a light block's velocities comes back divided by its force unit, so that
    // these programs are solved to the last digit.
    DefaultSettings {
        tol_feas: LAST_DIGIT,
        iterative_refinement_abstol: 0.0,
        iterative_refinement_reltol: 0.0,
        ..settings
    }
}

/// Infeasibility that Clarabel is to reach where blocks have units of their own.
const LAST_DIGIT: f64 = 1e-15;

/// Residual of the linear systems that is refined no further.
const ROUGH_REFINEMENT: f64 = 1e-8;

#[cfg(test)]
mod tests {
    use crate::answer::Work;
    use crate::method::limit::ending::Ending;
    use crate::method::limit::program::Program;
    use crate::method::limit::scale::Scale;
    use crate::method::limit::walls::wall;
    use crate::scene::Push;

    #[test]
    fn a_program_without_forces_is_left_to_clarabel_and_counted() {
        let scene = wall(4, Push::Right);
        let mut work = Work::default();
        let mut program = Program::at_multiplier(&scene, 0.5, Scale::of(&scene));
        let standing = program.solve_counted(&mut work);
        assert!(matches!(standing, Ending::Solved(_)));
        assert_eq!(work.fallbacks, 0);
        program.set_multiplier(&scene, 2.0);
        let falling = program.solve_counted(&mut work);
        assert!(matches!(falling, Ending::Infeasible(_)));
        assert_eq!((work.programs, work.fallbacks), (2, 1));
        // What came before leaves no trace.
        program.set_multiplier(&scene, 0.5);
        let again = program.solve_counted(&mut work);
        let forces = |ending| match ending {
            Ending::Solved(solution) => solution.forces,
            ending => panic!("{ending:?}"),
        };
        assert_eq!(forces(standing), forces(again));
    }
}
