//! What an answer's own forces and mechanism prove of its claim.

use crate::answer::{
    Bracket, CeilingSlack, Claim, CollapseResidual, JudgedFact, Mechanism, Outcome, Residuals,
    StaticResidual, Status, VERIFIED_RESIDUAL, associative_violation, falling_violation,
    kinematic_multiplier,
};
use crate::scene::Scene;

/// Recomputes the residual of an outcome and sets its status to what that proves of its claim.
///
/// Returns the residual where forces or a mechanism were given; `None` means that there is nothing
/// to vouch for.
pub fn judge(scene: &Scene, outcome: &mut Outcome) -> Option<f64> {
    if matches!(outcome.status, Status::Falls | Status::Stands) {
        return judge_certificate(scene, outcome);
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
    let statics = StaticResidual::of(scene, forces, bracket.lower);
    let collapse = || CollapseResidual::of(scene, forces, mechanism);
    Some(match outcome.claim {
        Claim::Associative => {
            let ceiling = ceiling(scene, mechanism);
            conclude_bounds(outcome, bracket, statics, None, Some(ceiling))
        }
        Claim::Enclosed => {
            let collapse = collapse();
            let above = outcome.ceiling.as_ref();
            let ceiling = above.map(|mechanism| ceiling(scene, mechanism));
            conclude_bounds(outcome, bracket, statics, Some(collapse), ceiling)
        }
        Claim::CollapseState | Claim::Observed => {
            let collapse = collapse();
            conclude_state(outcome, statics, collapse)
        }
    })
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
fn slack(ceiling: &CeilingSlack, bracket: Bracket) -> f64 {
    let own = ceiling.multiplier;
    // Written so that a NaN refutes.
    let bounds = bracket.upper >= own && bracket.lower <= own + 1e-9 * own.abs().max(1e-3);
    if bounds {
        ceiling.flow_rule
    } else {
        f64::INFINITY
    }
}

/// Both ends proved: `verified` where they are one number, else `bracketed`, or `undecided` where
/// the method says that its bracket is no answer. An estimate is never downgraded.
fn conclude_bounds(
    outcome: &mut Outcome,
    bracket: Bracket,
    statics: StaticResidual,
    collapse: Option<CollapseResidual>,
    ceiling: Option<CeilingSlack>,
) -> f64 {
    let of_forces = statics.largest();
    let below = collapse.map_or(of_forces, |collapse| of_forces.max(collapse.largest()));
    let residual = below.max(ceiling.map_or(f64::INFINITY, |ceiling| slack(&ceiling, bracket)));
    let residuals = Residuals::Bounds {
        statics,
        collapse,
        ceiling,
    };
    if residual <= VERIFIED_RESIDUAL {
        outcome.status = match outcome.status {
            Status::Undecided => Status::Undecided,
            _ if bracket.is_one_number() => Status::Verified,
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
) -> f64 {
    let residual = statics.largest().max(collapse.largest());
    let residuals = Residuals::State { statics, collapse };
    let at_one = outcome
        .bracket
        .is_some_and(|bracket| bracket.lower == bracket.upper);
    if residual <= VERIFIED_RESIDUAL && at_one {
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
/// friction where the claim is not one of associative friction): refutes the status where that fails, lowers it to `undecided` where nothing is given.
fn judge_certificate(scene: &Scene, outcome: &mut Outcome) -> Option<f64> {
    let residual = match (
        outcome.status,
        &outcome.mechanism,
        &outcome.forces,
        &outcome.ray,
    ) {
        (Status::Falls, Some(mechanism), _, _) => falling_violation(scene, mechanism),
        (Status::Stands, _, Some(forces), Some(ray)) => {
            let at_rest = StaticResidual::of(scene, forces, 0.0).largest();
            // Without dilatancy a joint may slip where the ray needs its friction, so that only a
            // ray without friction proves that nothing collapses.
            let ray = if outcome.claim == Claim::Associative {
                StaticResidual::of_ray(scene, ray)
            } else {
                let smooth = scene.clone().with_friction(|_, _| 0.0);
                StaticResidual::of_ray(&smooth, ray)
            };
            at_rest.max(ray.largest())
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
    }
    Some(residual)
}

/// The largest residual of the states that an interval rests on; refutes it where one fails or
/// where the ends of the bracket are not among them.
fn judge_states(scene: &Scene, outcome: &mut Outcome) -> f64 {
    let mut largest: f64 = 0.0;
    let mut lambdas = Vec::new();
    for state in &outcome.states {
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
    }
    largest
}

fn refute(outcome: &mut Outcome, why: JudgedFact) {
    outcome.status = Status::Failed;
    outcome.bracket = None;
    outcome.crack = None;
    outcome.facts.push(why.into());
}
