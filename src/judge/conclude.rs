//! From the answers about one scene to their conclusion.

use super::claims::{Answered, Answers, Claims, Role};
use super::conclusion::{ALIKE, Basis, Conclusion, Difference, Doubt, Explanation, Floor, Seen};
use super::heard::{UNSTATED_ERROR, lower_states};
use super::outside::{excluding, is_impossible};
use crate::answer::{Bracket, Fact, LimitFact, Outcome, Status};
use crate::scene::Scene;

/// The conclusion from the answers about one scene: of a multiplier that is proved; else that it
/// falls or stands; else of a multiplier without a proof.
pub(crate) fn conclude(scene: &Scene, answers: &Answers) -> Conclusion {
    let claims = Claims::of(scene, answers);
    if let Some((basis, answer)) = proved(&claims) {
        return of_answer(&claims, basis, &answer);
    }
    let falls = with_status(&claims, Status::Falls);
    let stands = with_status(&claims, Status::Stands).filter(without_dilatancy);
    for (basis, status, methods) in [
        (Basis::Falls, Status::Falls, names(falls)),
        (Basis::Stands, Status::Stands, names(stands)),
    ] {
        if !methods.is_empty() {
            return without_multiplier(&claims, basis, status, methods);
        }
    }
    if let Some((basis, answer)) = unproved(&claims) {
        return of_answer(&claims, basis, &answer);
    }
    // A search that ended without a state, and what else looked for one and has no answer.
    let none_found = Fact::from(LimitFact::NoneFoundWithoutBound);
    if answers
        .iter()
        .any(|(_, outcome)| outcome.facts.contains(&none_found))
    {
        let searched = with_status(&claims, Status::Undecided);
        return Conclusion {
            difference: without_bound(&claims),
            ..without_multiplier(
                &claims,
                Basis::NoneFound,
                Status::Undecided,
                names(searched),
            )
        };
    }
    let asked = answers.iter().copied();
    let asked = asked.filter(|(_, outcome)| outcome.status != Status::NotApplicable);
    without_multiplier(&claims, Basis::Nothing, Status::Undecided, names(asked))
}

fn names<'a>(answers: impl Iterator<Item = (&'a str, &'a Outcome)>) -> Vec<String> {
    answers.map(|(name, _)| name.to_owned()).collect()
}

fn with_status<'a>(
    claims: &Claims<'a>,
    status: Status,
) -> impl Iterator<Item = (&'a str, &'a Outcome)> {
    let answers = claims.answers.iter().copied();
    answers.filter(move |(_, outcome)| outcome.status == status)
}

/// Whether `stands` is about friction without dilatancy.
fn without_dilatancy((_, stands): &(&str, &Outcome)) -> bool {
    !stands.evidence.stands_by_friction()
}

fn without_multiplier(
    claims: &Claims,
    basis: Basis,
    status: Status,
    methods: Vec<String>,
) -> Conclusion {
    Conclusion {
        head_joints: claims.head_joints,
        push: claims.push,
        other: None,
        multiplier_unit: claims.unit(),
        basis,
        methods,
        status,
        bracket: None,
        highest_state: None,
        is_rest_undecided: false,
        seen: None,
        floor: floor(claims),
        difference: None,
        doubts: Vec::new(),
        reaction: claims.reaction.clone(),
    }
}

/// The largest proved lower bound.
fn floor(claims: &Claims) -> Option<Floor> {
    let floors = claims.answered.iter().filter_map(|answer| {
        let proved = answer.outcome.proved();
        Some(Floor {
            by: answer.name.to_owned(),
            lower: answer.floor?,
            cap: proved.and_then(|proved| proved.cap),
            push: None,
        })
    });
    // One at 0 says nothing.
    let floors = floors.filter(|floor| claims.dimensionless(floor.lower) > 0.0);
    floors.max_by(|a, b| a.lower.total_cmp(&b.lower))
}

fn of_answer(claims: &Claims, basis: Basis, answer: &Answered) -> Conclusion {
    let methods = vec![answer.name.to_owned()];
    let doubts = against_any(claims);
    if basis != Basis::LowestState {
        let status = answer.outcome.status;
        return Conclusion {
            bracket: Some(answer.bracket),
            doubts,
            ..without_multiplier(claims, basis, status, methods)
        };
    }
    let highest_state = highest_state(claims, answer);
    Conclusion {
        bracket: Some(Bracket::point(answer.bracket.lower)),
        highest_state,
        is_rest_undecided: answer.outcome.status == Status::Undecided,
        seen: highest_state.and_then(|_| seen(claims)),
        difference: difference(claims, answer),
        doubts: [against_state(claims, answer), doubts].concat(),
        ..without_multiplier(claims, basis, Status::Verified, methods)
    }
}

/// The best multiplier that is proved: a state before a bound.
fn proved<'a>(claims: &Claims<'a>) -> Option<(Basis, Answered<'a>)> {
    let least = claims.verified_states().map(|answer| answer.bracket.lower);
    let least = least.fold(f64::INFINITY, f64::min);
    // Of those that differ by rounding alone, whose business it is: it must not depend on the machine.
    let as_low = |answer: &&Answered| {
        claims.excess(answer.bracket.lower, least) <= claims.proof_slack(least)
    };
    let as_low = claims.verified_states().filter(as_low);
    let lowest = as_low.min_by_key(|answer| match answer.role {
        Role::States => 0,
        Role::Enclosure => 1,
        _ => 2,
    });
    let bounds = claims.of_role(Role::Bounds).into_iter();
    let bound = bounds.min_by(|a, b| a.bracket.upper.total_cmp(&b.bracket.upper));
    let lowest = lowest.map(|answer| (Basis::LowestState, *answer));
    lowest.or(bound.map(|answer| (Basis::UpperBound, answer)))
}

/// The best multiplier without a proof: what was seen before numbers.
fn unproved<'a>(claims: &Claims<'a>) -> Option<(Basis, Answered<'a>)> {
    let of_role = |role| {
        let mut of_role = claims.of_role(role).into_iter();
        of_role.find(|answer| !is_impossible(claims, answer))
    };
    let roles = [
        (Basis::Observed, Role::Observed),
        (Basis::Estimate, Role::Converged),
        (Basis::Estimate, Role::Number),
        (Basis::Estimate, Role::Loose),
        (Basis::Estimate, Role::ClosedForm),
    ];
    let mut found = roles
        .into_iter()
        .filter_map(|(basis, role)| Some((basis, of_role(role)?)));
    found.next()
}

/// The highest verified state, where it is another than the lowest.
fn highest_state(claims: &Claims, lowest: &Answered) -> Option<f64> {
    let highest = claims.verified_states().map(|answer| match answer.role {
        Role::Enclosure => answer.bracket.lower,
        _ => answer.bracket.upper,
    });
    let highest = highest.fold(f64::NEG_INFINITY, f64::max);
    (claims.excess(highest, lowest.bracket.lower) > ALIKE).then_some(highest)
}

/// What a simulation saw.
fn seen(claims: &Claims) -> Option<Seen> {
    let observed = claims.of_role(Role::Observed);
    observed.first().map(|answer| Seen {
        by: answer.name.to_owned(),
        bracket: answer.bracket,
    })
}

/// What associative friction says beside the lowest state.
fn difference(claims: &Claims, lowest: &Answered) -> Option<Difference> {
    let bounds = claims.of_role(Role::Bounds);
    if let Some(bound) = bounds.first() {
        let upper = bound.bracket.upper;
        return Some(Difference {
            method: bound.name.to_owned(),
            associative: Some(upper),
            relative: Some(claims.excess(upper, lowest.bracket.lower)),
            explanation: match highest_state(claims, lowest) {
                Some(highest) if claims.excess(upper, highest) <= ALIKE => {
                    Explanation::SeveralStates
                }
                _ => Explanation::Dilatancy,
            },
        });
    }
    without_bound(claims)
}

/// That with associative friction nothing collapses, where somebody proves it.
fn without_bound(claims: &Claims) -> Option<Difference> {
    let mut stands = with_status(claims, Status::Stands);
    let stands = stands.find(|answer| !without_dilatancy(answer));
    stands.map(|(name, _)| Difference {
        method: name.to_owned(),
        associative: None,
        relative: None,
        explanation: Explanation::Dilatancy,
    })
}

/// What speaks against a lowest state.
fn against_state(claims: &Claims, lowest: &Answered) -> Vec<Doubt> {
    let lower = lower_states(claims, lowest).into_iter().map(Doubt::Lower);
    let bounds = claims.of_role(Role::Bounds).into_iter().filter(|bound| {
        let below = -claims.excess(bound.bracket.upper, lowest.bracket.lower);
        below > claims.proof_slack(lowest.bracket.lower)
    });
    let bounds = bounds.map(|bound| Doubt::Bound {
        by: bound.name.to_owned(),
        lambda: bound.bracket.upper,
    });
    let stands = with_status(claims, Status::Stands).filter(without_dilatancy);
    let stands = stands.map(|(by, _)| Doubt::Stands { by: by.to_owned() });
    lower.chain(bounds).chain(stands).collect()
}

/// What speaks against any answer with a multiplier.
fn against_any(claims: &Claims) -> Vec<Doubt> {
    let impossible = claims.answered.iter();
    let impossible = impossible.filter(|answer| is_impossible(claims, answer));
    let impossible = impossible.map(|answer| Doubt::Impossible {
        by: answer.name.to_owned(),
        lambda: answer.bracket.lower,
    });
    let outside = claims.of_role(Role::Number).into_iter();
    let excluded = outside.filter_map(|answer| {
        let (floor, least) = excluding(claims, &answer)?;
        Some(Doubt::Excluded {
            by: answer.name.to_owned(),
            lambda: answer.bracket.upper,
            floor: floor.name.to_owned(),
            least,
        })
    });
    let falls = with_status(claims, Status::Falls);
    let falls = falls.map(|(by, _)| Doubt::Falls { by: by.to_owned() });
    above(claims)
        .into_iter()
        .chain(impossible)
        .chain(excluded)
        .chain(falls)
        .collect()
}

/// What lies above λ_A by more than its stated error.
fn above(claims: &Claims) -> Vec<Doubt> {
    let Some(bound) = claims.of_role(Role::Bounds).first().copied() else {
        return Vec::new();
    };
    let others = claims.answered.iter().filter_map(|answer| {
        let unstated = match answer.role {
            Role::Converged | Role::Number => Some(UNSTATED_ERROR),
            Role::Observed => None,
            _ => return None,
        };
        let error = answer.outcome.evidence.stated_error().or(unstated)?;
        let lambda = answer.bracket.lower;
        let most = bound.bracket.upper;
        claims.is_above(lambda, error, most).then(|| Doubt::Above {
            by: answer.name.to_owned(),
            lambda,
            above: claims.excess(lambda, most),
        })
    });
    others.collect()
}
