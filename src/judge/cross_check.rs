//! What must hold between the methods of one scene. It follows from what their answers claim, so
//! that a new method of a known kind is compared without a line here.

use super::check::{Check, Verdict};
use crate::answer::{Bracket, Claim, Outcome, Status};
use crate::method::{Kind, kind};
use crate::number::{number, short};
use crate::scene::HeadJoints;

/// Convergence tolerance of the sequential method: what it may exceed λ_A by through c0.
const COHESION_BIAS: f64 = 1e-4;

/// Outcomes of one scene by method name.
pub type Answers<'a> = [(&'a str, &'a Outcome)];

/// A method that gave a bracket.
struct Answered<'a> {
    name: &'a str,
    bracket: Bracket,
    outcome: &'a Outcome,
}

/// The answers of a kind that have a bracket.
fn of_kind<'a>(answers: &'a Answers, wanted: Kind) -> Vec<Answered<'a>> {
    let of_kind = answers.iter().filter(|(name, _)| kind(name) == wanted);
    let answered = of_kind.filter_map(|&(name, outcome)| {
        Some(Answered {
            name,
            bracket: outcome.bracket?,
            outcome,
        })
    });
    answered.collect()
}

/// Relations between the methods of one scene.
pub fn cross_check(head_joints: HeadJoints, answers: &Answers) -> Vec<Check> {
    let bounds = of_kind(answers, Kind::AssociativeBounds);
    let converged = of_kind(answers, Kind::CollapseState);
    let found = of_kind(answers, Kind::CollapseStates);
    let mut checks = Vec::new();
    let mut add = |method: &str, (text, verdict): (String, Verdict)| {
        checks.push(Check {
            head_joints,
            method: method.to_owned(),
            text,
            verdict,
        });
    };
    for (bound, state) in pairs(&bounds, &converged) {
        add(state.name, converged_below_bound(bound, state));
    }
    for (bound, states) in pairs(&bounds, &found) {
        let (a, i) = (bound.bracket, states.bracket);
        let holds = i.upper <= a.upper + 1e-6 * a.upper.max(1e-3);
        let text = format!("{} is not above {}", states.name, bound.name);
        add(states.name, (text, Verdict::of(holds)));
    }
    for (state, states) in pairs(&converged, &found) {
        add(state.name, converged_among_found(state, states));
    }
    for (stands, outcome) in answers {
        if outcome.status == Status::Stands {
            for state in verified_states(answers) {
                add(stands, stands_beside_state(stands, outcome, &state));
            }
        }
    }
    for range in of_kind(answers, Kind::ClosedForm) {
        for (name, outcome) in answers.iter().filter(|(name, _)| *name != range.name) {
            if let Some(value) = outcome.bracket {
                add(range.name, range_contains(&range, name, value));
            }
        }
    }
    for seen in of_kind(answers, Kind::Observed) {
        if let Some(check) = seen_among_known(&seen, answers) {
            add(seen.name, check);
        }
    }
    checks
}

/// The answers that the judge has verified as collapse states.
fn verified_states<'a>(answers: &'a Answers) -> Vec<Answered<'a>> {
    let verified = answers.iter().filter(|(_, outcome)| {
        outcome.status == Status::Verified && outcome.claim == Claim::CollapseState
    });
    let verified = verified.filter_map(|&(name, outcome)| {
        Some(Answered {
            name,
            bracket: outcome.bracket?,
            outcome,
        })
    });
    verified.collect()
}

/// Without dilatancy a scene that stands has no collapse state; with associative friction it may.
fn stands_beside_state(name: &str, stands: &Outcome, state: &Answered) -> (String, Verdict) {
    let (state, lambda) = (state.name, number(state.bracket.lower, 5));
    if stands.claim == Claim::Associative {
        let text = format!(
            "{name} stands, {state} collapses at {lambda}: joints that would wedge with dilatancy \
             slip without it"
        );
        (text, Verdict::Holds)
    } else {
        let text = format!("{name} stands, although {state} verifies a collapse state at {lambda}");
        (text, Verdict::Violated)
    }
}

fn pairs<'a>(
    ones: &'a [Answered<'a>],
    others: &'a [Answered<'a>],
) -> impl Iterator<Item = (&'a Answered<'a>, &'a Answered<'a>)> {
    let with_others = |one| others.iter().map(move |other| (one, other));
    ones.iter().flat_map(with_others)
}

/// λ ≤ λ_A (1 + 1e-4), what is above λ_A marked as the bias of c0.
fn converged_below_bound(bound: &Answered, state: &Answered) -> (String, Verdict) {
    let excess = (state.bracket.upper - bound.bracket.upper) / bound.bracket.upper.max(1e-3);
    let (state, bound) = (state.name, bound.name);
    if excess <= 1e-6 {
        (format!("{state} is not above {bound}"), Verdict::Holds)
    } else if excess <= COHESION_BIAS {
        let text = format!("{state} is above {bound} by no more than 0.01 %: bias of c0");
        (text, Verdict::Marked)
    } else {
        let text = format!("{state} is {:.3} % above {bound}", 100.0 * excess);
        (text, Verdict::Violated)
    }
}

/// Outside lies no contradiction: the interval is what was found.
fn converged_among_found(state: &Answered, states: &Answered) -> (String, Verdict) {
    let (s, i) = (state.bracket, states.bracket);
    let slack = COHESION_BIAS * i.upper.max(1e-3);
    let inside = s.lower >= i.lower - slack && s.upper <= i.upper + slack;
    let (word, verdict) = if inside {
        ("lies in", Verdict::Holds)
    } else {
        ("lies outside", Verdict::Marked)
    };
    let text = format!("{} {word} the verified {} found", state.name, states.name);
    (text, verdict)
}

/// The closed form's range is a claim of the paper, not a law.
fn range_contains(range: &Answered, name: &str, value: Bracket) -> (String, Verdict) {
    let Bracket { lower, upper } = range.bracket;
    let width = 100.0 * (upper - lower) / upper;
    let (word, verdict) = if value.lower >= lower && value.upper <= upper {
        ("contains", Verdict::Holds)
    } else {
        ("does not contain", Verdict::Marked)
    };
    let text = format!("{} range ({width:.0} % wide) {word} {name}", range.name);
    (text, verdict)
}

/// What was seen meets [lowest known, λ_A], widened by its stated error.
fn seen_among_known(seen: &Answered, answers: &Answers) -> Option<(String, Verdict)> {
    let (pushover, error) = (seen.bracket, seen.outcome.stated_error?);
    let bounds = of_kind(answers, Kind::AssociativeBounds);
    let known = [Kind::CollapseState, Kind::CollapseStates];
    let states = known.into_iter().flat_map(|kind| of_kind(answers, kind));
    let lowest = (bounds.iter().map(|bound| bound.bracket.lower))
        .chain(states.map(|state| state.bracket.lower))
        .fold(f64::INFINITY, f64::min);
    let bound = bounds.first()?;
    let (low, high) = (lowest * (1.0 - error), bound.bracket.upper * (1.0 + error));
    let meets = pushover.upper >= low && pushover.lower <= high;
    let text = format!(
        "{} {} [{low:.4}, {high:.4}], lowest known to {} widened by {} %",
        seen.name,
        if meets { "meets" } else { "misses" },
        bound.name,
        short(100.0 * error, 2)
    );
    Some((text, Verdict::of(meets)))
}

/// Open head joints never raise λ_A, as they only take forces away: `contact` and `open` are the
/// answers with either, on sides of the push that may differ.
pub fn open_never_raises(contact: &Answers, open: &Answers) -> Vec<Check> {
    let open = of_kind(open, Kind::AssociativeBounds);
    let compared = open.iter().filter_map(|open| {
        let contact = of_kind(contact, Kind::AssociativeBounds);
        let contact = contact.iter().find(|contact| contact.name == open.name)?;
        let holds = open.bracket.lower <= contact.bracket.upper * (1.0 + 1e-6);
        Some(Check {
            head_joints: HeadJoints::Open,
            method: open.name.to_owned(),
            text: format!("open head joints do not raise the {} multiplier", open.name),
            verdict: Verdict::of(holds),
        })
    });
    compared.collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Without dilatancy `stands` beside a state that the judge verified is a contradiction; with
    /// associative friction it is explained.
    #[test]
    fn stands_beside_a_verified_state() {
        let state = Outcome {
            bracket: Some(Bracket::point(0.4)),
            ..Outcome::of(Status::Verified)
        };
        for (claim, expected) in [
            (Claim::CollapseState, Verdict::Violated),
            (Claim::Associative, Verdict::Holds),
        ] {
            let stands = Outcome {
                claim,
                ..Outcome::of(Status::Stands)
            };
            let answers = [("one", &stands), ("other", &state)];
            let checks = cross_check(HeadJoints::Contact, &answers);
            let verdicts: Vec<Verdict> = checks.iter().map(|check| check.verdict).collect();
            assert_eq!(verdicts, [expected], "{checks:?}");
            assert!(checks[0].text.contains("0.4"), "{}", checks[0].text);
        }
        let bound = Outcome {
            claim: Claim::Associative,
            ..state.clone()
        };
        let stands = Outcome::of(Status::Stands);
        let answers = [("one", &stands), ("bound", &bound)];
        assert!(cross_check(HeadJoints::Contact, &answers).is_empty());
    }
}
