//! Limit analysis with associative friction: the largest multiplier that equilibrium and Coulomb's
//! law admit. It bounds every non-associative collapse multiplier from above (Radenkovic 1961).

use super::ending::Ending;
use super::equilibration::{UnitPower, needs_own_units, unit_powers};
use super::own_weight::{own_weight, without_optimum};
use super::program::{Margins, Program};
use super::reduction;
use crate::answer::{
    Bracket, Evidence, LimitFact, Outcome, Status, VERIFIED_WIDTH, Work, magnitude,
};
use crate::mechanics::{
    BlockResidual, Ceiling, ForceState, JointForce, Mechanism, StaticResidual, VERIFIED_RESIDUAL,
    associative_violation, kinematic_multiplier,
};
use crate::method::settings::{Engine, LP_TOLERANCE};
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
        associative(scene, settings, &mut work).after(work)
    }
}

fn associative(scene: &Scene, settings: &Settings, work: &mut Work) -> Outcome {
    let at_rest = match own_weight(scene, work) {
        Ok(forces) => forces,
        Err(outcome) => return *outcome,
    };
    // Dilatancy pushes head joints that are in contact far beyond the stagger line: on paper-3
    // even 920 of 1176 blocks give 3e-8 too much, and no smaller part saves time.
    let reduce = scene.head_joints() == HeadJoints::Open && settings.programs.reduction;
    for part in reduction::parts(scene).into_iter().filter(|_| reduce) {
        if let Ok(mut answer) = optimum(&part.scene, settings, work)
            && let Some(forces) = part.complete(scene, answer.bracket.lower, &answer.forces, work)
        {
            answer.mechanism = part.extend(scene, &answer.mechanism);
            answer.forces = forces;
            answer.begin_at_zero(&at_rest);
            // What completes a part is as little proved by the solver's word as an optimum is.
            if loose(settings) || proves(scene, &answer) {
                work.modelled = part.scene.blocks().len();
                return outcome(scene, answer, settings);
            }
        }
    }
    work.modelled = scene.blocks().len();
    match optimum(scene, settings, work) {
        Ok(mut answer) => {
            answer.begin_at_zero(&at_rest);
            outcome(scene, answer, settings)
        }
        Err(ending) => without_optimum(scene, &ending, at_rest, work),
    }
}

/// Forces and mechanism of λ_A, in the case's units.
struct Optimum {
    forces: Vec<JointForce>,
    mechanism: Mechanism,
    bracket: Bracket,
    engine: Engine,
}

impl Optimum {
    /// Puts ends that rounding leaves below 0 at 0, where a push begins and the forces at rest are.
    fn begin_at_zero(&mut self, at_rest: &[JointForce]) {
        let Bracket { lower, upper } = &mut self.bracket;
        if *lower < 0.0 {
            *lower = 0.0;
            self.forces = at_rest.to_vec();
        }
        *upper = upper.max(0.0);
    }
}

/// The optimum, with the units of unequal blocks that there are until one proves it.
fn optimum(scene: &Scene, user: &Settings, work: &mut Work) -> Result<Optimum, Ending> {
    let mut best = None;
    for power in unit_powers(scene) {
        let found = with_units(scene, *power, user, work);
        match &found {
            Ok(optimum) if is_exact(scene, optimum, user) => return found,
            Err(Ending::Unbounded) => return found,
            Ok(optimum) if proves(scene, optimum) => best = Some(found),
            _ => best = best.or(Some(found)),
        }
    }
    best.expect("there is one way at least")
}

fn is_exact(scene: &Scene, found: &Optimum, user: &Settings) -> bool {
    let one = found.bracket.is_one_number(scene.multiplier_unit());
    one && (loose(user) || proves(scene, found))
}

/// The optimum by the engine that is asked for; by Clarabel where what another one leaves is more than
/// a proof takes.
fn with_units(
    scene: &Scene,
    power: UnitPower,
    user: &Settings,
    work: &mut Work,
) -> Result<Optimum, Ending> {
    let found = by_engine(scene, power, user.programs.engine, user, work);
    match found {
        Ok(found) if found.engine != Engine::Clarabel && !is_exact(scene, &found, user) => {
            work.fallbacks += 1;
            by_engine(scene, power, Engine::Clarabel, user, work)
        }
        found => found,
    }
}

/// Solves the program with margins; with finer ones, or none, where those are too wide for a small λ
/// or prove nothing; without any where it has no optimum with them: a scene that can lock, or one
/// without slack anywhere, may still have one.
fn by_engine(
    scene: &Scene,
    power: UnitPower,
    engine: Engine,
    user: &Settings,
    work: &mut Work,
) -> Result<Optimum, Ending> {
    let mut solved = |margins| {
        let tolerance = user.programs.lp_tolerance;
        let program = Program::with_units(scene, tolerance, power)
            .with_width(0.5 * VERIFIED_WIDTH)
            .tested_by(engine);
        solved(scene, program, margins, work)
    };
    let Ok(found) = solved(Some(WIDE_MARGINS)) else {
        return solved(None);
    };
    let is_exact = |found: &Optimum| is_exact(scene, found, user);
    if is_exact(&found) {
        return Ok(found);
    }
    // Where a wall slides as a whole, many states share λ = μ, and the forces that the program with
    // margins ends with can be a little out of balance.
    let others = [Some(NARROW_MARGINS), None].into_iter();
    let others = others.take(if loose(user) { 1 } else { 2 });
    let others = others.chain(sticky_margins(scene).map(Some));
    let mut others = others.filter_map(|margins| solved(margins).ok());
    Ok(others.find(is_exact).unwrap_or(found))
}

fn solved(
    scene: &Scene,
    mut program: Program,
    margins: Option<Margins>,
    work: &mut Work,
) -> Result<Optimum, Ending> {
    if let Some(margins) = margins {
        program.set_margins(margins);
    }
    match program.solve_counted(work) {
        Ending::Solved(solution) => {
            let mechanism = program.scale().mechanism(&solution.velocity);
            let upper = kinematic_multiplier(scene, &mechanism);
            let lambda = solution.lambda * program.scale().multiplier;
            let lower = match margins {
                Some(_) => lambda,
                // Without margins the ends may cross by what the solver leaves.
                None => lambda.min(upper),
            };
            Ok(Optimum {
                forces: program.scale().forces(&solution.forces),
                bracket: Bracket { lower, upper },
                mechanism,
                engine: solution.engine,
            })
        }
        ending => Err(ending),
    }
}

/// Ten times what Clarabel leaves at the program's tolerance.
const WIDE_MARGINS: Margins = Margins {
    force: 1e-11,
    opening: 1e-10,
};

/// What it leaves on scenes small enough to need no more.
const NARROW_MARGINS: Margins = Margins {
    force: 3e-13,
    opening: 3e-12,
};

/// What the solver leaves of a slip, which comes back multiplied by the friction as an opening that
/// is missing.
const SLIP_LEFT: f64 = 1e-13;

/// Margins that cover what is left of slips, for scenes whose friction needs wider ones than
/// [`WIDE_MARGINS`].
fn sticky_margins(scene: &Scene) -> Option<Margins> {
    let friction = scene.joints().iter().map(|joint| joint.friction);
    let opening = SLIP_LEFT * friction.fold(0.0, f64::max);
    let margins = Margins {
        opening,
        ..WIDE_MARGINS
    };
    (opening > WIDE_MARGINS.opening).then_some(margins)
}

/// The outcome of both sides of λ_A.
fn outcome(scene: &Scene, optimum: Optimum, user: &Settings) -> Outcome {
    let bracket = optimum.bracket;
    let unit = scene.multiplier_unit();
    if !loose(user) && needs_own_units(scene) && !proves(scene, &optimum) {
        // Elsewhere ends that prove nothing are a defect, for the judge to refute.
        return Outcome::without_number(Status::Undecided, unproved(scene, &optimum));
    }
    let (status, fact) = if loose(user) && !proves(scene, &optimum) {
        if !(bracket.lower.is_finite() && bracket.upper.is_finite()) {
            let fact = LimitFact::LooseWithoutMultiplier;
            return Outcome::without_number(Status::Undecided, fact);
        }
        (Status::Estimate, Some(LimitFact::Loose))
    } else if bracket.is_one_number(unit) {
        (Status::Verified, None)
    } else {
        let relative_width = bracket.relative_width(unit);
        (Status::Bracketed, Some(LimitFact::Apart { relative_width }))
    };
    Outcome {
        evidence: Evidence::Bounds {
            below: ForceState {
                lambda: bracket.lower,
                forces: optimum.forces,
            },
            above: Ceiling {
                lambda: bracket.upper,
                mechanism: optimum.mechanism,
            },
        },
        facts: fact.into_iter().map(LimitFact::into).collect(),
        ..Outcome::of(status)
    }
}

/// Whether a user asks for less than the margins need to be of use. At the default, ends that prove
/// nothing are a defect, which the judge is to refute; here they are an estimate.
fn loose(user: &Settings) -> bool {
    user.programs.lp_tolerance > LP_TOLERANCE
}

fn proves(scene: &Scene, optimum: &Optimum) -> bool {
    let Bracket { lower, upper } = optimum.bracket;
    let residual = residual(scene, optimum);
    let blocks = of_blocks(scene, optimum);
    let crossed = lower > upper + 1e-9 * magnitude(upper, scene.multiplier_unit());
    residual <= VERIFIED_RESIDUAL && blocks.is_small() && upper.is_finite() && !crossed
}

/// Largest violation of the forces and of the mechanism, over the whole scene.
fn residual(scene: &Scene, optimum: &Optimum) -> f64 {
    let statics = StaticResidual::of(scene, &optimum.forces, optimum.bracket.lower).largest();
    statics.max(associative_violation(scene, &optimum.mechanism))
}

/// The same over what acts on single blocks.
fn of_blocks(scene: &Scene, optimum: &Optimum) -> BlockResidual {
    let of_forces = BlockResidual::of_forces(scene, &optimum.forces, optimum.bracket.lower);
    of_forces.worse(BlockResidual::of_flow(scene, &optimum.mechanism))
}

/// Why both ends prove nothing.
fn unproved(scene: &Scene, optimum: &Optimum) -> LimitFact {
    let blocks = of_blocks(scene, optimum);
    if blocks.is_small() {
        let residual = residual(scene, optimum);
        LimitFact::Unproved { residual }
    } else {
        LimitFact::Unresolved(blocks)
    }
}
