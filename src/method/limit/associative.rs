//! Limit analysis with associative friction: the largest multiplier that equilibrium and Coulomb's
//! law admit. It bounds every non-associative collapse multiplier from above (Radenkovic 1961).

use super::program::{Ending, Margins, Program};
use super::reduction;
use super::standing::{own_weight, without_optimum};
use crate::answer::{
    Bracket, Claim, JointForce, Mechanism, Outcome, StaticResidual, Status, VELOCITY_THRESHOLDS,
    VERIFIED_RESIDUAL, Work, associative_violation, crack_slope, is_one_number,
    kinematic_multiplier,
};
use crate::method::settings::LP_TOLERANCE;
use crate::method::{Method, Settings};
use crate::scene::{HeadJoints, Scene};

/// `lower` is the multiplier of a force state, `upper` that of an admissible mechanism; the status
/// is `verified` where they meet to a relative width of 1e-6.
pub struct Associative;

impl Method for Associative {
    fn name(&self) -> &str {
        "associative"
    }

    fn solve(&self, scene: &Scene, settings: &Settings) -> Outcome {
        let mut work = Work::default();
        let standing = match own_weight(scene, &mut work) {
            Ok(forces) => forces,
            Err(outcome) => return *outcome,
        };
        // Dilatancy pushes head joints that are in contact far beyond the stagger line: on paper-3
        // even 920 of 1176 blocks give 3e-8 too much, and no smaller part saves time.
        let reduce = scene.head_joints() == HeadJoints::Open && settings.programs.reduction;
        for part in reduction::parts(scene).into_iter().filter(|_| reduce) {
            if let Ok(mut answer) = optimum(&part.scene, settings, &mut work)
                && let Some(forces) =
                    part.complete(scene, answer.bracket.lower, &answer.forces, &mut work)
            {
                answer.mechanism = part.lift(scene, &answer.mechanism);
                answer.forces = forces;
                work.modelled = part.scene.blocks().len();
                return outcome(scene, answer, settings, work);
            }
        }
        work.modelled = scene.blocks().len();
        match optimum(scene, settings, &mut work) {
            Ok(answer) => outcome(scene, answer, settings, work),
            Err(ending) => without_optimum(scene, &ending, standing, &mut work),
        }
    }
}

/// Forces and mechanism of λ_A, in the case's units.
struct Optimum {
    forces: Vec<JointForce>,
    mechanism: Mechanism,
    bracket: Bracket,
}

/// Solves the program with margins; with finer ones, or none, where those are too wide for a small λ
/// or prove nothing; without any where it has no optimum with them: a scene that can lock, or one
/// without slack anywhere, may still have one.
fn optimum(scene: &Scene, user: &Settings, work: &mut Work) -> Result<Optimum, Ending> {
    let Ok(found) = solved(scene, Some(EXACT), user, work) else {
        return solved(scene, None, user, work);
    };
    let is_exact =
        |found: &Optimum| is_one_number(&found.bracket) && (loose(user) || proves(scene, found));
    if is_exact(&found) {
        return Ok(found);
    }
    // Where a wall slides as a whole, many states share λ = μ, and the forces that the program with
    // margins ends with can be a little out of balance.
    let others = [Some(FINER), None].into_iter();
    let others = others.take(if loose(user) { 1 } else { 2 });
    let mut others = others.filter_map(|margins| solved(scene, margins, user, work).ok());
    Ok(others.find(is_exact).unwrap_or(found))
}

fn solved(
    scene: &Scene,
    margins: Option<Margins>,
    user: &Settings,
    work: &mut Work,
) -> Result<Optimum, Ending> {
    let mut program = Program::asked(scene, user);
    if let Some(margins) = margins {
        program.set_margins(margins);
    }
    match program.solve_counted(work) {
        Ending::Solved(solution) => {
            let mechanism = program.scale().mechanism(&solution.velocity);
            let upper = kinematic_multiplier(scene, &mechanism);
            let lower = match margins {
                Some(_) => solution.lambda,
                // Without margins the ends may cross by what the solver leaves.
                None => solution.lambda.min(upper),
            };
            Ok(Optimum {
                forces: program.scale().forces(&solution.forces),
                bracket: Bracket { lower, upper },
                mechanism,
            })
        }
        ending => Err(ending),
    }
}

/// Ten times what Clarabel leaves at the program's tolerance.
const EXACT: Margins = Margins {
    force: 1e-11,
    opening: 1e-10,
};

/// What it leaves on scenes small enough to need no more.
const FINER: Margins = Margins {
    force: 3e-13,
    opening: 3e-12,
};

/// The outcome of both sides of λ_A.
fn outcome(scene: &Scene, optimum: Optimum, user: &Settings, work: Work) -> Outcome {
    let mut bracket = optimum.bracket;
    let (status, reason) = if loose(user) && !proves(scene, &optimum) {
        if !(bracket.lower.is_finite() && bracket.upper.is_finite()) {
            let reason = "solved loosely on request: the mechanism has no multiplier";
            return Outcome {
                work,
                ..Outcome::without_number(Status::Undecided, reason)
            };
        }
        if bracket.lower > bracket.upper {
            (bracket.lower, bracket.upper) = (bracket.upper, bracket.lower);
        }
        (Status::Estimate, "solved loosely on request".to_owned())
    } else if is_one_number(&bracket) {
        (Status::Verified, String::new())
    } else {
        let width = bracket.relative_width();
        let reason = format!("force state and mechanism are {width:.1e} apart");
        (Status::Bracketed, reason)
    };
    Outcome {
        claim: Claim::Associative,
        bracket: Some(bracket),
        crack: crack_slope(scene, &optimum.mechanism, VELOCITY_THRESHOLDS),
        mechanism: Some(optimum.mechanism),
        forces: Some(optimum.forces),
        work,
        ..Outcome::without_number(status, reason)
    }
}

/// Whether a user asks for less than the margins need to be of use. At the default, ends that prove
/// nothing are a defect, which the judge is to refute; here they are an estimate.
fn loose(user: &Settings) -> bool {
    user.programs.lp_tolerance > LP_TOLERANCE
}

fn proves(scene: &Scene, optimum: &Optimum) -> bool {
    let Bracket { lower, upper } = optimum.bracket;
    let statics = StaticResidual::of(scene, &optimum.forces, lower).largest();
    let residual = statics.max(associative_violation(scene, &optimum.mechanism));
    let crossed = lower > upper + 1e-9 * upper.abs().max(1e-3);
    residual <= VERIFIED_RESIDUAL && upper.is_finite() && !crossed
}
