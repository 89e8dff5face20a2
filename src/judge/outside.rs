//! What no answer may be, whatever the others say: asked of outside programs above all.

use super::check::Verdict;
use super::claims::{Answered, Claims, Role};
use crate::answer::{Fact, LimitFact, Outcome};
use crate::number::{number, short};

/// Largest multiplier that any friction and shape may give, without dimensions: far beyond what
/// friction of 1e6 can hold on a block a thousand times as wide as it is high.
const ABSURD: f64 = 1e9;

/// Whether the multiplier of an outside program can be one at all; of our own methods, only where it
/// cannot.
pub(super) fn plausible(claims: &Claims, answer: &Answered) -> Option<(String, Verdict)> {
    let (name, lambda) = (answer.name, answer.bracket.lower);
    let error = answer.outcome.evidence.stated_error().unwrap_or(0.0);
    let error = error.max(claims.proof_slack(0.0));
    if claims.excess(lambda, 0.0) < -error {
        let text = format!(
            "{name} gives {}, and no multiplier is negative",
            short(lambda, 5)
        );
        return Some((text, Verdict::Violated));
    }
    let upper = claims.dimensionless(answer.bracket.upper);
    if upper.is_nan() || upper > ABSURD {
        let text = format!("{name} gives {lambda:.1e}, which no friction can hold");
        return Some((text, Verdict::Violated));
    }
    let (by, least) = proved_least(claims)?;
    let is_below = claims.is_below(answer.bracket.upper, error, least);
    let is_below = is_below && answer.role != Role::ClosedForm;
    if !(is_below || answer.is_outside()) {
        return None;
    }
    let (word, least) = (if is_below { "is" } else { "is not" }, number(least, 5));
    let text = format!("{name} {word} below {least}, the least multiplier that {by} proves");
    Some((text, Verdict::of(!is_below)))
}

/// Whether nothing can have this multiplier.
pub(super) fn is_impossible(claims: &Claims, answer: &Answered) -> bool {
    plausible(claims, answer).is_some_and(|(_, verdict)| verdict == Verdict::Violated)
}

/// A proved lower bound of every collapse multiplier, and whose it is: λ without friction.
fn proved_least(claims: &Claims) -> Option<(String, f64)> {
    claims.answers.iter().find_map(|(name, outcome)| {
        let frictionless = outcome.facts.iter().find_map(|fact| match fact {
            Fact::Limit(LimitFact::FoundNoBounds { frictionless }) => *frictionless,
            _ => None,
        });
        Some(((*name).to_owned(), frictionless?))
    })
}

/// Where a method claims what its own forces and mechanism do not prove.
pub(super) fn claims_without_proof(name: &str, outcome: &Outcome) -> Option<(String, Verdict)> {
    let text = || format!("{name} claims what its own forces and mechanism do not prove");
    outcome.is_refuted().then(|| (text(), Verdict::Violated))
}
