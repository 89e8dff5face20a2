//! The judge: recomputes every residual from forces and mechanism, outside the methods, and says
//! what holds between methods and against published values.

mod check;
mod cross_check;
mod references;

pub use check::{Check, Verdict};
pub use cross_check::{Answers, cross_check, open_never_raises};
pub use references::{Comparison, comparisons, computed, reference_checks};

use crate::answer::{
    Bracket, Claim, CollapseResidual, Mechanism, Outcome, StaticResidual, Status,
    VERIFIED_RESIDUAL, associative_violation, falling_violation, is_one_number,
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
            refute(outcome, "claims a proof without forces and mechanism");
        }
        return None;
    };
    if !outcome.states.is_empty() {
        return Some(judge_states(scene, outcome));
    }
    let statics = StaticResidual::of(scene, forces, bracket.lower);
    match outcome.claim {
        Claim::Associative => {
            let (slack, text) = ceiling(scene, mechanism, bracket);
            let residual = statics.largest().max(slack);
            conclude_bounds(outcome, residual, &format!("{statics}, {text}"));
            Some(residual)
        }
        Claim::Enclosed => {
            let collapse = CollapseResidual::of(scene, forces, mechanism);
            let above = outcome.ceiling.as_ref();
            let (slack, text) = above.map_or((f64::INFINITY, "no bound".into()), |mechanism| {
                ceiling(scene, mechanism, bracket)
            });
            let residual = statics.largest().max(collapse.largest()).max(slack);
            conclude_bounds(outcome, residual, &format!("{statics}, {collapse}, {text}"));
            Some(residual)
        }
        Claim::CollapseState | Claim::Observed => {
            let collapse = CollapseResidual::of(scene, forces, mechanism);
            let residual = statics.largest().max(collapse.largest());
            conclude_state(outcome, residual, &statics, &collapse);
            Some(residual)
        }
    }
}

/// How far a mechanism is from proving that no λ above `bracket.upper` is admissible by associative
/// friction: its violation of the flow rule, infinite where its own multiplier is above that or
/// below `bracket.lower`; and that in words.
fn ceiling(scene: &Scene, mechanism: &Mechanism, bracket: Bracket) -> (f64, String) {
    let slack = associative_violation(scene, mechanism);
    let upper = kinematic_multiplier(scene, mechanism);
    let text = format!("flow rule violated by {slack:.1e}, mechanism's own multiplier {upper:.6}");
    // Written so that a NaN refutes.
    let bounds = bracket.upper >= upper && bracket.lower <= upper + 1e-9 * upper.abs().max(1e-3);
    (if bounds { slack } else { f64::INFINITY }, text)
}

/// Both ends proved: `verified` where they are one number, else `bracketed`, or `undecided` where
/// the method says that its bracket is no answer. What claims nothing loses nothing.
fn conclude_bounds(outcome: &mut Outcome, residual: f64, text: &str) {
    let bracket = outcome.bracket;
    if residual <= VERIFIED_RESIDUAL {
        if outcome.status != Status::Undecided {
            outcome.status = match bracket.is_some_and(|bracket| is_one_number(&bracket)) {
                true => Status::Verified,
                false => Status::Bracketed,
            };
        }
    } else if outcome.status == Status::Estimate {
        outcome.facts.push(format!("no proof: {text}").into());
    } else {
        refute(outcome, &format!("refuted by the judge: {text}"));
    }
}

fn conclude_state(
    outcome: &mut Outcome,
    residual: f64,
    statics: &StaticResidual,
    collapse: &CollapseResidual,
) {
    let at_one = outcome
        .bracket
        .is_some_and(|bracket| bracket.lower == bracket.upper);
    if residual <= VERIFIED_RESIDUAL && at_one {
        outcome.status = Status::Verified;
        outcome.facts.push("a true collapse state".into());
    } else if outcome.status == Status::Verified {
        let text = format!("refuted by the judge: {statics}, {collapse}");
        refute(outcome, &text);
    } else {
        let text = format!("no proof: {}", worst(statics, collapse));
        outcome.facts.push(text.into());
    }
}

/// The residual of what proves `falls` (a mechanism) or `stands` (forces at λ = 0 and a ray): refutes
/// the status where that fails, lowers it to `undecided` where nothing is given.
fn judge_certificate(scene: &Scene, outcome: &mut Outcome) -> Option<f64> {
    let residual = match (
        outcome.status,
        &outcome.mechanism,
        &outcome.forces,
        &outcome.ray,
    ) {
        (Status::Falls, Some(mechanism), _, _) => falling_violation(scene, mechanism),
        (Status::Stands, _, Some(forces), Some(ray)) => StaticResidual::of(scene, forces, 0.0)
            .largest()
            .max(StaticResidual::of_ray(scene, ray).largest()),
        (Status::Falls, None, _, _) if outcome.claim == Claim::Observed => return None,
        (status, _, _, _) => {
            outcome.status = Status::Undecided;
            let text = format!("claims that it {} without a proof", status.name());
            outcome.facts.push(text.into());
            return None;
        }
    };
    // Written so that a NaN refutes.
    let holds = residual <= VERIFIED_RESIDUAL;
    if !holds {
        refute(
            outcome,
            &format!("refuted by the judge: residual {residual:.1e}"),
        );
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
        refute(
            outcome,
            &format!("refuted by the judge: residual {largest:.1e}"),
        );
    }
    largest
}

fn worst(statics: &StaticResidual, collapse: &CollapseResidual) -> &'static str {
    let named = [
        (statics.equilibrium, "equilibrium is violated"),
        (statics.tension, "a joint is in tension"),
        (statics.friction, "friction exceeds μN"),
        (collapse.penetration, "blocks interpenetrate"),
        (collapse.open_contact, "an opening joint carries a force"),
        (
            collapse.idle_friction,
            "a slipping joint carries less than μN",
        ),
        (collapse.gap, "small violations add up to a gap"),
    ];
    let worst = named.iter().max_by(|a, b| a.0.total_cmp(&b.0));
    worst.expect("the list is not empty").1
}

fn refute(outcome: &mut Outcome, reason: &str) {
    outcome.status = Status::Failed;
    outcome.bracket = None;
    outcome.crack = None;
    outcome.facts.push(reason.into());
}
