//! Limit analysis with associative friction: the largest multiplier that equilibrium and Coulomb's
//! law admit. It bounds every non-associative collapse multiplier from above (Radenkovic 1961).

use super::program::{Ending, Margins, Program};
use super::reduction;
use crate::judge;
use crate::mechanism::{Mechanism, VELOCITY_THRESHOLDS, crack_slope};
use crate::method::{Bracket, JointForce, Method, Outcome, Settings, Status, Work};
use crate::scene::{HeadJoints, Scene};

/// `lower` is the multiplier of a force state, `upper` that of an admissible mechanism; the status
/// is `verified` where they meet to a relative width of 1e-6.
pub struct Associative;

/// Relative width up to which a bracket counts as one number.
pub const VERIFIED_WIDTH: f64 = 1e-6;

impl Method for Associative {
    fn name(&self) -> &'static str {
        "associative"
    }

    fn solve(&self, scene: &Scene, _settings: &Settings) -> Outcome {
        let mut work = Work::default();
        // Dilatancy pushes head joints that are in contact far beyond the stagger line: on paper-3
        // even 920 of 1176 blocks give 3e-8 too much, and no smaller part saves time.
        let open = scene.head_joints == HeadJoints::Open;
        for part in reduction::parts(scene).into_iter().filter(|_| open) {
            if let Ok(mut answer) = optimum(&part.scene, &mut work)
                && let Some(forces) = part.complete(scene, answer.lambda, &answer.forces, &mut work)
            {
                answer.mechanism = part.lift(scene, &answer.mechanism);
                work.modelled = part.scene.blocks.len();
                return bracket(scene, Optimum { forces, ..answer }, work);
            }
        }
        work.modelled = scene.blocks.len();
        match optimum(scene, &mut work) {
            Ok(answer) => bracket(scene, answer, work),
            Err(ending) => Outcome {
                work,
                ..without_optimum(&ending)
            },
        }
    }
}

/// Forces and mechanism of λ_A, in the case's units.
struct Optimum {
    lambda: f64,
    forces: Vec<JointForce>,
    mechanism: Mechanism,
}

/// Solves the program with margins, or without where it has no optimum with them: a scene that can
/// lock, or one without slack anywhere, may still have one.
fn optimum(scene: &Scene, work: &mut Work) -> Result<Optimum, Ending> {
    let mut program = Program::new(scene);
    program.set_margins(EXACT);
    work.programs += 1;
    let mut ending = program.solve();
    if !matches!(ending, Ending::Solved(_)) {
        program = Program::new(scene);
        work.programs += 1;
        ending = program.solve();
    }
    let Ending::Solved(solution) = ending else {
        return Err(ending);
    };
    work.iterations += solution.iterations;
    Ok(Optimum {
        lambda: solution.lambda,
        forces: program.scale().forces(&solution.forces),
        mechanism: program.scale().mechanism(&solution.velocity),
    })
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
fn bracket(scene: &Scene, optimum: Optimum, work: Work) -> Outcome {
    let Optimum {
        lambda,
        forces,
        mechanism,
    } = optimum;
    let bracket = Bracket {
        lower: lambda,
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
