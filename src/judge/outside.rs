//! What no answer may be, whatever the others say: asked of outside programs above all.

use super::check::Verdict;
use super::claims::{Answered, Claims, Role};
use crate::answer::{Fact, LimitFact, Outcome};
use crate::number::{below, short};

/// Largest multiplier that any friction and shape may give, without dimensions: far beyond what
/// friction of 1e6 can hold on a block a thousand times as wide as it is high.
const ABSURD: f64 = 1e9;

/// Whether the multiplier of an outside program can be one at all; of our own methods, only where it
/// cannot.
pub(super) fn plausible(claims: &Claims, answer: &Answered) -> Option<(String, Verdict)> {
    let (name, lambda) = (answer.name, answer.bracket.lower);
    let error = answer.stated_error(0.0);
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
    let (word, least) = (if is_below { "is" } else { "is not" }, below(least, 5));
    let text = format!("{name} {word} below {least}, the least multiplier that {by} proves");
    Some((text, Verdict::of(!is_below)))
}

/// A number that lies wholly below a proved lower bound, also with the error that it states: of an
/// outside program it is a contradiction where the bound is of every collapse. What assumes its
/// mechanism is compared with nothing else.
pub(super) fn below_floor(claims: &Claims, answer: &Answered) -> Option<(String, Verdict)> {
    // A verified state below a bound is a check of its own.
    let is_compared = !matches!(answer.role, Role::ClosedForm | Role::Bounds | Role::Loose);
    if !is_compared || answer.has_state() {
        return None;
    }
    let (floor, least) = highest_floor(claims, answer)?;
    let (is_below, number) = (is_under(claims, answer, least), below(least, 5));
    let (name, by) = (answer.name, floor.name);
    if !is_below {
        return answer.is_outside().then(|| {
            let text = format!("{name} is not below {number}, the bound that {by} proves");
            (text, Verdict::Holds)
        });
    }
    let contradicts = floor.is_whole && answer.is_outside();
    let text = format!(
        "{name} is below {number}, and {by} proves that {}",
        match floor.is_whole {
            true => "no collapse is".to_owned(),
            false => "none is in which the push does work".to_owned() + &capped(floor),
        }
    );
    let verdict = match contradicts {
        true => Verdict::Violated,
        false => Verdict::Marked,
    };
    Some((text, verdict))
}

/// The cap of a bound, in words.
fn capped(floor: &Answered) -> String {
    let cap = floor.outcome.proved().and_then(|proved| proved.cap);
    cap.map_or_else(String::new, |cap| {
        format!(" for motions of up to {cap:.0e} times its own")
    })
}

/// The highest lower bound that another proves.
fn highest_floor<'c, 'a>(
    claims: &'c Claims<'a>,
    answer: &Answered,
) -> Option<(&'c Answered<'a>, f64)> {
    let others = claims
        .answered
        .iter()
        .filter(|other| other.name != answer.name);
    let floors = others.filter_map(|other| Some((other, other.floor?)));
    let floors = floors.filter(|(_, least)| claims.dimensionless(*least) > 0.0);
    floors.max_by(|a, b| a.1.total_cmp(&b.1))
}

fn is_under(claims: &Claims, answer: &Answered, least: f64) -> bool {
    let stated = answer.stated_error(0.0);
    let error = stated.max(claims.proof_slack(least));
    claims.is_below(answer.bracket.upper, error, least)
}

/// The lower bound that leaves no collapse where an answer lies, and whose it is.
pub(super) fn excluding<'c, 'a>(
    claims: &'c Claims<'a>,
    answer: &Answered,
) -> Option<(&'c Answered<'a>, f64)> {
    let floor = highest_floor(claims, answer);
    floor.filter(|(floor, least)| floor.is_whole && is_under(claims, answer, *least))
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
