//! What an answer's own forces and mechanism prove of its claim.

use crate::answer::{
    Bracket, CeilingSlack, Claim, JudgedFact, Outcome, Residuals, Status, magnitude,
};
use crate::certificate::{Refusal, prove};
use crate::mechanics::{
    BlockResidual, CollapseResidual, Mechanism, StaticResidual, VERIFIED_RESIDUAL,
    associative_violation, falling_violation, kinematic_multiplier,
};
use crate::scene::Scene;

/// Recomputes the residual of an outcome and sets its status to what that proves of its claim.
///
/// A claim that is refuted over the whole scene has `failed`; one that only the own forces or
/// velocities of a block are too far from is `undecided`: double precision may not resolve more.
///
/// Returns the residual where forces or a mechanism were given; `None` means that there is nothing
/// to vouch for.
pub fn judge(scene: &Scene, outcome: &mut Outcome) -> Option<f64> {
    if matches!(outcome.status, Status::Falls | Status::Stands) {
        let residual = judge_certificate(scene, outcome);
        if outcome.status == Status::Falls && scene.left_out() > 0 {
            let count = scene.left_out();
            outcome
                .facts
                .push(JudgedFact::OpenHeadJoints { count }.into());
        }
        return residual;
    }
    let (Some(bracket), Some(forces), Some(mechanism)) =
        (outcome.bracket, &outcome.forces, &outcome.mechanism)
    else {
        let proof = match outcome.status {
            Status::Verified => true,
            Status::Bracketed => outcome.claim != Claim::Observed,
            _ => false,
        };
        if proof {
            refute(outcome, JudgedFact::NothingToProve);
        }
        return None;
    };
    if !outcome.states.is_empty() {
        return Some(judge_states(scene, outcome));
    }
    if outcome.claim == Claim::Bounded {
        return Some(judge_bounded(scene, outcome, bracket));
    }
    let statics = StaticResidual::of(scene, forces, bracket.lower);
    let of_forces = BlockResidual::of_forces(scene, forces, bracket.lower);
    let collapse = || CollapseResidual::of(scene, forces, mechanism);
    let of_collapse = || BlockResidual::of_collapse(scene, forces, mechanism);
    Some(match outcome.claim {
        Claim::Associative => {
            let ceiling = Some(ceiling(scene, mechanism));
            let blocks = of_forces.worse(BlockResidual::of_flow(scene, mechanism));
            let bounds = Bounds {
                statics,
                collapse: None,
                ceiling,
                blocks,
            };
            conclude_bounds(outcome, bracket, bounds, scene.multiplier_unit())
        }
        Claim::Enclosed => {
            let collapse = Some(collapse());
            let above = outcome.ceiling.as_ref();
            let flow = above.map(|mechanism| BlockResidual::of_flow(scene, mechanism));
            let ceiling = above.map(|mechanism| ceiling(scene, mechanism));
            let blocks = of_forces
                .worse(of_collapse())
                .worse(flow.unwrap_or_default());
            let bounds = Bounds {
                statics,
                collapse,
                ceiling,
                blocks,
            };
            conclude_bounds(outcome, bracket, bounds, scene.multiplier_unit())
        }
        Claim::CollapseState | Claim::Bounded | Claim::Observed => {
            let collapse = collapse();
            let blocks = of_forces.worse(of_collapse());
            conclude_state(outcome, statics, collapse, blocks)
        }
    })
}

/// The residual of the state at the upper end; refutes the answer where its certificate does not prove
/// the lower end. An estimate claims no certificate.
fn judge_bounded(scene: &Scene, outcome: &mut Outcome, bracket: Bracket) -> f64 {
    let (Some(forces), Some(mechanism)) = (&outcome.forces, &outcome.mechanism) else {
        return f64::INFINITY;
    };
    let statics = StaticResidual::of(scene, forces, bracket.upper);
    let collapse = CollapseResidual::of(scene, forces, mechanism);
    let blocks = BlockResidual::of_forces(scene, forces, bracket.upper)
        .worse(BlockResidual::of_collapse(scene, forces, mechanism));
    let residual = statics.largest().max(collapse.largest());
    // Written so that a NaN refutes.
    let holds = residual <= VERIFIED_RESIDUAL;
    if !holds {
        let residuals = Residuals::State { statics, collapse };
        refute(outcome, JudgedFact::Refuted(residuals));
    } else if outcome.status != Status::Estimate {
        if let Err(refusal) = certified(scene, outcome, bracket) {
            refute(outcome, JudgedFact::Uncertified(refusal));
        } else if !blocks.is_small() {
            unresolved(outcome, blocks);
        } else if bracket.is_one_number(scene.multiplier_unit()) {
            outcome.status = Status::Verified;
        } else {
            outcome.status = Status::Bracketed;
        }
    }
    residual
}

/// Whether the certificate proves the lower end.
fn certified(scene: &Scene, outcome: &Outcome, bracket: Bracket) -> Result<(), Refusal> {
    let certificate = outcome.certificate.as_ref().ok_or(Refusal::Missing)?;
    let proved = prove(scene, certificate)?.lower;
    if bracket.lower <= proved {
        Ok(())
    } else {
        Err(Refusal::Less {
            claimed: bracket.lower,
            proved,
        })
    }
}

/// What was computed of bounds.
struct Bounds {
    statics: StaticResidual,
    /// Where the lower bound is a collapse state.
    collapse: Option<CollapseResidual>,
    ceiling: Option<CeilingSlack>,
    /// Of all of these, the largest violation of one block's own conditions.
    blocks: BlockResidual,
}

fn ceiling(scene: &Scene, mechanism: &Mechanism) -> CeilingSlack {
    CeilingSlack {
        flow_rule: associative_violation(scene, mechanism),
        multiplier: kinematic_multiplier(scene, mechanism),
    }
}

/// How far a mechanism is from proving that no λ above `bracket.upper` is admissible by associative
/// friction: its violation of the flow rule, infinite where its own multiplier is above that or
/// below `bracket.lower`.
fn slack(ceiling: &CeilingSlack, bracket: Bracket, unit: f64) -> f64 {
    let own = ceiling.multiplier;
    // Written so that a NaN refutes.
    let bounds = bracket.upper >= own && bracket.lower <= own + 1e-9 * magnitude(own, unit);
    if bounds {
        ceiling.flow_rule
    } else {
        f64::INFINITY
    }
}

/// Both ends proved: `verified` where they are one number, else `bracketed`, or `undecided` where
/// the method says that its bracket is no answer. An estimate is never downgraded.
fn conclude_bounds(outcome: &mut Outcome, bracket: Bracket, bounds: Bounds, unit: f64) -> f64 {
    let Bounds {
        statics,
        collapse,
        ceiling,
        blocks,
    } = bounds;
    let of_forces = statics.largest();
    let below = collapse.map_or(of_forces, |collapse| of_forces.max(collapse.largest()));
    let above = ceiling.map_or(f64::INFINITY, |ceiling| slack(&ceiling, bracket, unit));
    let residual = below.max(above);
    let residuals = Residuals::Bounds {
        statics,
        collapse,
        ceiling,
    };
    if residual <= VERIFIED_RESIDUAL && !blocks.is_small() {
        unresolved(outcome, blocks);
    } else if residual <= VERIFIED_RESIDUAL {
        outcome.status = match outcome.status {
            Status::Undecided => Status::Undecided,
            _ if bracket.is_one_number(unit) => Status::Verified,
            _ => Status::Bracketed,
        };
    } else if outcome.status == Status::Estimate {
        outcome.facts.push(JudgedFact::NoProof(residuals).into());
    } else {
        refute(outcome, JudgedFact::Refuted(residuals));
    }
    residual
}

fn conclude_state(
    outcome: &mut Outcome,
    statics: StaticResidual,
    collapse: CollapseResidual,
    blocks: BlockResidual,
) -> f64 {
    let residual = statics.largest().max(collapse.largest());
    let residuals = Residuals::State { statics, collapse };
    let at_one = outcome
        .bracket
        .is_some_and(|bracket| bracket.lower == bracket.upper);
    if residual <= VERIFIED_RESIDUAL && at_one && !blocks.is_small() {
        unresolved(outcome, blocks);
    } else if residual <= VERIFIED_RESIDUAL && at_one {
        outcome.status = Status::Verified;
        outcome.facts.push(JudgedFact::CollapseState.into());
    } else if outcome.status == Status::Verified {
        refute(outcome, JudgedFact::Refuted(residuals));
    } else {
        outcome.facts.push(JudgedFact::NoProof(residuals).into());
    }
    residual
}

/// The residual of what proves `falls` (a mechanism) or `stands` (forces at λ = 0 and a ray, without
/// friction where the claim is not one of associative friction): refutes the status where that
/// fails, lowers it to `undecided` where nothing is given.
fn judge_certificate(scene: &Scene, outcome: &mut Outcome) -> Option<f64> {
    let (residual, blocks) = match (
        outcome.status,
        &outcome.mechanism,
        &outcome.forces,
        &outcome.ray,
    ) {
        (Status::Falls, Some(mechanism), _, _) => (
            falling_violation(scene, mechanism),
            BlockResidual::of_flow(scene, mechanism),
        ),
        (Status::Stands, _, Some(forces), Some(ray)) => {
            let at_rest = StaticResidual::of(scene, forces, 0.0).largest();
            // Without dilatancy a joint may slip where the ray needs its friction, so that only a
            // ray without friction proves that nothing collapses.
            let smooth = scene.clone().with_friction(|_, _| 0.0);
            let pushed = if outcome.claim == Claim::Associative {
                scene
            } else {
                &smooth
            };
            let of_ray = StaticResidual::of_ray(pushed, ray).largest();
            let blocks = BlockResidual::of_forces(scene, forces, 0.0);
            let blocks = blocks.worse(BlockResidual::of_ray(pushed, ray));
            (at_rest.max(of_ray), blocks)
        }
        (Status::Falls, None, _, _) if outcome.claim == Claim::Observed => return None,
        (status, _, _, _) => {
            outcome.status = Status::Undecided;
            outcome.facts.push(JudgedFact::NoCertificate(status).into());
            return None;
        }
    };
    // Written so that a NaN refutes.
    let holds = residual <= VERIFIED_RESIDUAL;
    if !holds {
        refute(outcome, JudgedFact::Refuted(Residuals::Largest(residual)));
    } else if !blocks.is_small() {
        unresolved(outcome, blocks);
    }
    Some(residual)
}

/// The largest residual of the states that an interval rests on; refutes it where one fails or
/// where the ends of the bracket are not among them.
fn judge_states(scene: &Scene, outcome: &mut Outcome) -> f64 {
    let mut largest: f64 = 0.0;
    let mut blocks = BlockResidual::default();
    let mut lambdas = Vec::new();
    for state in &outcome.states {
        blocks = blocks.worse(BlockResidual::of_state(scene, state));
        let statics = StaticResidual::of(scene, &state.forces, state.lambda);
        let collapse = CollapseResidual::of(scene, &state.forces, &state.mechanism);
        largest = largest.max(statics.largest()).max(collapse.largest());
        lambdas.push(state.lambda);
    }
    let proved = outcome
        .bracket
        .is_some_and(|b| lambdas.contains(&b.lower) && lambdas.contains(&b.upper));
    if !(proved && largest <= VERIFIED_RESIDUAL) {
        refute(outcome, JudgedFact::Refuted(Residuals::Largest(largest)));
    } else if !blocks.is_small() {
        unresolved(outcome, blocks);
    }
    largest
}

/// Takes the answer away where the residuals hold over the whole scene and not at one of its blocks.
/// An estimate stays one.
fn unresolved(outcome: &mut Outcome, blocks: BlockResidual) {
    if outcome.status == Status::Estimate {
        let residuals = Residuals::Block(blocks);
        outcome.facts.push(JudgedFact::NoProof(residuals).into());
        return;
    }
    outcome.status = Status::Undecided;
    outcome.bracket = None;
    outcome.crack = None;
    let blocks_fact = JudgedFact::Unresolved(blocks);
    outcome.facts.push(blocks_fact.into());
}

fn refute(outcome: &mut Outcome, why: JudgedFact) {
    outcome.status = Status::Failed;
    outcome.bracket = None;
    outcome.crack = None;
    outcome.facts.push(why.into());
}
