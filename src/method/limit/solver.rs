//! How Clarabel is to solve the programs.

use clarabel::solver::DefaultSettings;

/// Settings for programs to this tolerance; `tight` where blocks or joints have units of their own.
pub(super) fn settings(tolerance: f64, tight: bool) -> DefaultSettings<f64> {
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

/// Infeasibility that the solver is to reach where blocks have units of their own.
const LAST_DIGIT: f64 = 1e-15;

/// The same with less refinement of the linear systems.
pub(super) fn rough(settings: DefaultSettings<f64>) -> DefaultSettings<f64> {
    DefaultSettings {
        iterative_refinement_reltol: ROUGH_REFINEMENT,
        iterative_refinement_abstol: ROUGH_REFINEMENT,
        ..settings
    }
}

/// Residual of the linear systems that is refined no further.
const ROUGH_REFINEMENT: f64 = 1e-8;
