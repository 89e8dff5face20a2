//! What must hold between the methods of one scene. It follows from what their answers claim, so
//! that a new method of a known kind, and an outside program, is compared without a line here.

use super::check::{Check, Verdict};
use super::claims::{Answered, Answers, Claims, Role};
use super::heard::{CONVERGED_ERROR, LowerState, UNSTATED_ERROR, lower_states};
use super::outside::{below_floor, claims_without_proof, excluding, plausible};
use crate::answer::{Bracket, Outcome, Status};
use crate::number::{number, percent, short};
use crate::scene::{HeadJoints, Scene};

/// Whose answer a check is about, what it says, and the result.
type Said<'a> = (&'a str, (String, Verdict));

/// Relations between the methods of one scene.
pub fn cross_check(scene: &Scene, answers: &Answers) -> Vec<Check> {
    let claims = Claims::of(scene, answers);
    let groups = [
        below_bounds(&claims),
        in_searched(&claims),
        beside_states(&claims),
        in_ranges(&claims),
        lower_than_lowest(&claims),
        each_by_itself(&claims),
    ];
    let checks = groups.into_iter().flatten();
    let checks = checks.map(|(method, (text, verdict))| Check {
        head_joints: claims.head_joints,
        method: method.to_owned(),
        text,
        verdict,
    });
    checks.collect()
}

/// Proved bounds against one another, and everything else against them.
fn below_bounds<'a>(claims: &Claims<'a>) -> Vec<Said<'a>> {
    let bounds = claims.of_role(Role::Bounds);
    let mut said = Vec::new();
    for (index, bound) in bounds.iter().enumerate() {
        for other in &bounds[index + 1..] {
            said.push((other.name, bounds_meet(claims, bound, other)));
        }
    }
    for (bound, state) in pairs(&bounds, &claims.of_role(Role::Converged)) {
        said.push((state.name, converged_below_bound(claims, bound, state)));
    }
    let states = [Role::States, Role::Enclosure].map(|role| claims.of_role(role));
    for (bound, states) in pairs(&bounds, &states.concat()) {
        said.push((states.name, states_below_bound(claims, bound, states)));
    }
    for (bound, value) in pairs(&bounds, &claims.of_role(Role::Number)) {
        said.push((value.name, number_below_bound(claims, bound, value)));
    }
    said
}

/// The answers of our own searches for collapse states.
fn searched<'a>(claims: &Claims<'a>) -> Vec<Answered<'a>> {
    let mut found = claims.of_role(Role::States);
    found.retain(|answer| !answer.is_outside());
    found
}

/// Single values against the ranges of collapse states that a search found.
fn in_searched<'a>(claims: &Claims<'a>) -> Vec<Said<'a>> {
    let single = [Role::Converged, Role::Number].map(|role| claims.of_role(role));
    let (single, searched) = (single.concat(), searched(claims));
    let compared = pairs(&single, &searched);
    compared
        .map(|(state, states)| (state.name, among_found(claims, state, states)))
        .collect()
}

/// Answers that deny states, all or those below a bound, against the states that are verified.
fn beside_states<'a>(claims: &Claims<'a>) -> Vec<Said<'a>> {
    let mut said = Vec::new();
    for &(name, outcome) in claims.answers {
        if outcome.status == Status::Stands {
            let beside = |state| (name, stands_beside_state(name, outcome, state));
            said.extend(claims.verified_states().map(beside));
        }
    }
    for floor in claims.answered.iter().filter(|a| a.floor.is_some()) {
        let above =
            (claims.verified_states()).filter_map(|state| above_floor(claims, floor, state));
        said.extend(above.map(|check| (floor.name, check)));
    }
    said
}

/// The closed form's range against every answer, and what was seen against what is known.
fn in_ranges<'a>(claims: &Claims<'a>) -> Vec<Said<'a>> {
    let mut said = Vec::new();
    for range in claims.of_role(Role::ClosedForm) {
        for answer in claims.answered.iter().filter(|a| a.name != range.name) {
            said.push((range.name, range_contains(&range, answer)));
        }
    }
    for seen in claims.of_role(Role::Observed) {
        said.extend(seen_among_known(claims, &seen).map(|check| (seen.name, check)));
    }
    said
}

/// What lies below the lowest state of a search or of an enclosure.
fn lower_than_lowest<'a>(claims: &Claims<'a>) -> Vec<Said<'a>> {
    // One that is undecided claims no lowest state.
    let mut enclosed = claims.of_role(Role::Enclosure);
    enclosed.retain(|answer| answer.outcome.status != Status::Undecided);
    let mut said = Vec::new();
    for lowest in [searched(claims), enclosed].concat() {
        for lower in lower_states(claims, &lowest) {
            said.push((lowest.name, lower_state(&lowest, &lower)));
        }
    }
    said
}

/// What an answer shows to be wrong with itself.
fn each_by_itself<'a>(claims: &Claims<'a>) -> Vec<Said<'a>> {
    let answered = claims.answered.iter();
    let implausible = answered.flat_map(|answer| {
        let checks = [plausible(claims, answer), below_floor(claims, answer)];
        checks
            .into_iter()
            .flatten()
            .map(|check| (answer.name, check))
    });
    let unproved = claims.answers.iter();
    let unproved =
        unproved.filter_map(|&(name, outcome)| Some((name, claims_without_proof(name, outcome)?)));
    implausible.chain(unproved).collect()
}

/// Without dilatancy a scene that stands has no collapse state; with associative friction it may.
fn stands_beside_state(name: &str, stands: &Outcome, state: &Answered) -> (String, Verdict) {
    let (state, lambda) = (state.name, number(state.bracket.lower, 5));
    if stands.evidence.stands_by_friction() {
        let text = format!(
            "{name} says that it stands, and {state} finds a collapse at {lambda}: joints that wedge with \
             dilatancy slip without it"
        );
        (text, Verdict::Holds)
    } else {
        let text = format!(
            "{name} says that it stands, although {state} verifies a collapse state at {lambda}"
        );
        (text, Verdict::Violated)
    }
}

/// No verified state lies below a proved lower bound.
fn above_floor(claims: &Claims, floor: &Answered, state: &Answered) -> Option<(String, Verdict)> {
    let least = floor.floor.filter(|_| floor.name != state.name)?;
    let lambda = state.bracket.lower;
    let (by, name) = (floor.name, state.name);
    Some(
        if claims.is_below(lambda, claims.proof_slack(least), least) {
            let (lambda, least) = (number(lambda, 6), number(least, 6));
            let text = format!(
                "{by} proves that no state is below {least}, although {name} verifies one at {lambda}"
            );
            (text, Verdict::Violated)
        } else {
            (
                format!("no state of {name} is below the bound of {by}"),
                Verdict::Holds,
            )
        },
    )
}

fn pairs<'a, 'b>(
    ones: &'b [Answered<'a>],
    others: &'b [Answered<'a>],
) -> impl Iterator<Item = (&'b Answered<'a>, &'b Answered<'a>)> {
    let with_others = |one| others.iter().map(move |other| (one, other));
    ones.iter().flat_map(with_others)
}

/// λ_A is one number: proved bounds of it overlap.
fn bounds_meet(claims: &Claims, one: &Answered, other: &Answered) -> (String, Verdict) {
    let apart = |low: Bracket, high: Bracket| {
        claims.excess(high.lower, low.upper) > claims.proof_slack(low.upper)
    };
    let apart = apart(one.bracket, other.bracket) || apart(other.bracket, one.bracket);
    let word = if apart { "contradict" } else { "meet" };
    let text = format!("the bounds of {} {word} those of {}", other.name, one.name);
    (text, Verdict::of(!apart))
}

/// λ ≤ λ_A, but for what the iteration states about itself.
fn converged_below_bound(claims: &Claims, bound: &Answered, state: &Answered) -> (String, Verdict) {
    let (lambda, most) = (state.bracket.upper, bound.bracket.upper);
    let excess = claims.excess(lambda, most);
    let stated = state.stated_error(UNSTATED_ERROR);
    let (state, bound) = (state.name, bound.name);
    if excess <= 1e-6 {
        (format!("{state} is not above {bound}"), Verdict::Holds)
    } else if claims.is_above(lambda, stated, most) {
        let text = format!("{state} is {} above {bound}", percent(excess));
        (text, Verdict::Violated)
    } else if excess <= UNSTATED_ERROR {
        let text = format!(
            "{state} is above {bound} by no more than 0.01 %, which comes from the shear c0 that it gives \
             every joint"
        );
        (text, Verdict::Marked)
    } else {
        let text = format!(
            "{state} is {} above {bound}, which comes from the shear c0 that it lets \
             joints carry beyond Coulomb's law",
            percent(excess)
        );
        (text, Verdict::Marked)
    }
}

/// No collapse state is above λ_A.
fn states_below_bound(claims: &Claims, bound: &Answered, states: &Answered) -> (String, Verdict) {
    // The upper end of an enclosure is a bound itself.
    let highest = match states.role {
        Role::Enclosure => states.bracket.lower,
        _ => states.bracket.upper,
    };
    let excess = claims.excess(highest, bound.bracket.upper);
    let holds = excess <= claims.proof_slack(bound.bracket.upper);
    let text = format!("{} is not above {}", states.name, bound.name);
    (text, Verdict::of(holds))
}

/// A number without a proof is no multiplier if it is above λ_A by more than its stated error.
fn number_below_bound(claims: &Claims, bound: &Answered, value: &Answered) -> (String, Verdict) {
    let most = bound.bracket.upper;
    let stated = value.stated_error(UNSTATED_ERROR);
    let (name, bound) = (value.name, bound.name);
    let Bracket { lower, upper } = value.bracket;
    let [low, high] = [lower, upper].map(|lambda| claims.excess(lambda, most));
    let states = claims.verified_states();
    let states = states.map(|state| state.bracket.lower).reduce(f64::min);
    let low_of_all = states.filter(|&least| claims.is_below(upper, stated, least));
    if let (Some(least), true) = (low_of_all, high <= 1e-6) {
        let text = format!(
            "{name} is not above {bound}, and {} below the lowest verified state",
            percent(-claims.excess(upper, least))
        );
        (text, Verdict::Marked)
    } else if high <= 1e-6 {
        (format!("{name} is not above {bound}"), Verdict::Holds)
    } else if claims.is_above(lower, stated, most) {
        let text = format!(
            "{name} is {} above {bound}, which no collapse multiplier is",
            percent(low)
        );
        (text, Verdict::Violated)
    } else {
        let text = format!(
            "{name} reaches {} above {bound}, which no collapse multiplier is",
            percent(high)
        );
        (text, Verdict::Marked)
    }
}

/// Outside lies no contradiction: the interval is what was found. The ends of a number's bracket may
/// be anything, so that it only has to meet the range.
fn among_found(claims: &Claims, state: &Answered, states: &Answered) -> (String, Verdict) {
    let (s, i) = (state.bracket, states.bracket);
    let error = state.stated_error(UNSTATED_ERROR);
    let below = match state.role {
        Role::Number => claims.is_below(s.upper, error, i.lower),
        _ => claims.is_below(s.lower, CONVERGED_ERROR, i.lower),
    };
    let inside = !below && !claims.is_above(s.lower, error, i.upper);
    let (word, verdict) = if inside {
        ("lies within", Verdict::Holds)
    } else {
        ("lies outside", Verdict::Marked)
    };
    let text = format!(
        "{} {word} the range of collapse states that {} found",
        state.name, states.name
    );
    (text, verdict)
}

/// The closed form's range is a claim of the paper, not a law.
fn range_contains(range: &Answered, answer: &Answered) -> (String, Verdict) {
    let Bracket { lower, upper } = range.bracket;
    let (name, value) = (answer.name, answer.bracket);
    let width = 100.0 * (upper - lower) / upper;
    let (word, verdict) = if value.lower >= lower && value.upper <= upper {
        ("contains", Verdict::Holds)
    } else {
        ("does not contain", Verdict::Marked)
    };
    let text = format!(
        "the range of {} ({width:.0} % wide) {word} {name}",
        range.name
    );
    (text, verdict)
}

/// What was seen meets [lowest known, λ_A], widened by its stated error. Above is a contradiction;
/// below, a lower state may exist than those known.
fn seen_among_known(claims: &Claims, seen: &Answered) -> Option<(String, Verdict)> {
    let (pushover, error) = (seen.bracket, seen.outcome.evidence.stated_error()?);
    let bounds = claims.of_role(Role::Bounds);
    let roles = [Role::Bounds, Role::Converged, Role::States];
    let known = claims.answered.iter();
    let known = known.filter(|answer| roles.contains(&answer.role));
    let lowest = known.map(|answer| answer.bracket.lower);
    let lowest = lowest.fold(f64::INFINITY, f64::min);
    let bound = bounds.first()?;
    let (low, high) = (lowest * (1.0 - error), bound.bracket.upper * (1.0 + error));
    let below = -claims.excess(pushover.upper, lowest) > error;
    let above = claims.excess(pushover.lower, bound.bracket.upper) > error;
    let text = format!(
        "{} {} the range {} to {}, from the lowest multiplier known to {}, widened by {} %{}",
        seen.name,
        if below || above {
            "lies outside"
        } else {
            "meets"
        },
        number(low, 4),
        number(high, 4),
        bound.name,
        short(100.0 * error, 2),
        if below && excluding(claims, seen).is_none() {
            ": a lower state may exist"
        } else {
            ""
        }
    );
    let verdict = match (below, above) {
        (_, true) => Verdict::Violated,
        (true, false) => Verdict::Marked,
        (false, false) => Verdict::Holds,
    };
    Some((text, verdict))
}

/// The lowest state that was found is not the lowest that somebody speaks of.
fn lower_state(lowest: &Answered, lower: &LowerState) -> (String, Verdict) {
    let what = if lower.is_verified {
        "a lower state exists"
    } else {
        "a lower state may exist"
    };
    let text = format!(
        "{what}: {} gives {}, which is {} below the lowest state that {} verifies",
        lower.by,
        number(lower.lambda, lower.decimals),
        percent(lower.below),
        lowest.name
    );
    (text, Verdict::Marked)
}

/// Open head joints never raise λ_A, as they only take forces away: `contact` and `open` are the
/// scenes and answers with either, on sides of the push that may differ.
pub fn open_never_raises(
    (contact_scene, contact): (&Scene, &Answers),
    (open_scene, open): (&Scene, &Answers),
) -> Vec<Check> {
    let (contact, open) = (
        Claims::of(contact_scene, contact),
        Claims::of(open_scene, open),
    );
    let of_contact = contact.of_role(Role::Bounds);
    let open = open.of_role(Role::Bounds);
    let compared = open.iter().filter_map(|open| {
        let contact_bound = of_contact.iter().find(|bound| bound.name == open.name)?;
        let most = contact_bound.bracket.upper;
        let excess = contact.excess(open.bracket.lower, most);
        Some(Check {
            head_joints: HeadJoints::Open,
            method: open.name.to_owned(),
            text: format!("open head joints do not raise the {} multiplier", open.name),
            verdict: Verdict::of(excess <= contact.proof_slack(most)),
        })
    });
    compared.collect()
}
