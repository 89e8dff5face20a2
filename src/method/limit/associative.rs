//! Limit analysis with associative friction: the largest multiplier that equilibrium and Coulomb's
//! law admit. It bounds every non-associative collapse multiplier from above (Radenkovic 1961).

use super::program::{Ending, Margins, Program, Solution};
use crate::judge;
use crate::mechanism::{VELOCITY_THRESHOLDS, crack_slope};
use crate::method::{Bracket, Method, Outcome, Status, Work};
use crate::scene::Scene;

/// `lower` is the multiplier of a force state, `upper` that of an admissible mechanism; the status
/// is `verified` where they meet to a relative width of 1e-6.
pub struct Associative;

/// Relative width up to which a bracket counts as one number.
pub const VERIFIED_WIDTH: f64 = 1e-6;

impl Method for Associative {
    fn name(&self) -> &'static str {
        "associative"
    }

    fn solve(&self, scene: &Scene) -> Outcome {
        let mut program = Program::new(scene);
        program.set_margins(EXACT);
        let mut ending = program.solve();
        if !matches!(ending, Ending::Solved(_)) {
            // A scene that can lock, or one without slack anywhere, may still have an optimum.
            program = Program::new(scene);
            ending = program.solve();
        }
        match ending {
            Ending::Solved(solution) => bracket(scene, &program, &solution),
            ending => without_optimum(&ending),
        }
    }
}

/// Ten times what Clarabel leaves at the program's tolerance.
const EXACT: Margins = Margins {
    force: 1e-11,
    opening: 1e-10,
};

/// The outcome of a program without an optimum, for any method that starts with this one.
pub fn without_optimum(ending: &Ending) -> Outcome {
    match ending {
        Ending::Infeasible => Outcome::without_number(
            Status::Falls,
            "the solver finds no equilibrium within friction at any multiplier",
        ),
        Ending::Unbounded => Outcome::without_number(
            Status::Stands,
            "the solver finds a force state that grows with the multiplier without limit",
        ),
        Ending::GaveUp(why) => {
            Outcome::without_number(Status::Undecided, format!("the solver gave up: {why}"))
        }
        Ending::Solved(_) => Outcome::without_number(Status::Failed, "solved, but not read"),
    }
}

/// Both sides of λ_A, from the forces and from the mechanism of one solution.
fn bracket(scene: &Scene, program: &Program, solution: &Solution) -> Outcome {
    let scale = program.scale();
    let work = Work {
        programs: 1,
        iterations: solution.iterations,
        ..Work::default()
    };
    let forces = scale.forces(&solution.forces);
    let mechanism = scale.mechanism(&solution.velocity);
    let bracket = Bracket {
        lower: solution.lambda,
        upper: judge::kinematic_multiplier(scene, &mechanism),
    };
    if bracket.upper < 0.0 {
        return Outcome {
            work,
            mechanism: Some(mechanism),
            ..Outcome::without_number(Status::Falls, "a mechanism moves without any push")
        };
    }
    let (status, reason) = if bracket.relative_width() <= VERIFIED_WIDTH {
        (Status::Verified, String::new())
    } else {
        let width = bracket.relative_width();
        let reason = format!("force state and mechanism are {width:.1e} apart");
        (Status::Bracketed, reason)
    };
    Outcome {
        bracket: Some(bracket),
        crack: crack_slope(scene, &mechanism, VELOCITY_THRESHOLDS),
        mechanism: Some(mechanism),
        forces: Some(forces),
        work,
        ..Outcome::without_number(status, reason)
    }
}
