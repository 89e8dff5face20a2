//! Of a wall that is pushed both ways: the side that governs, and what both sides say of the wall.

use serde::{Deserialize, Serialize};

use super::ends::{Side, ends, is_unanswered};
use crate::answer::{
    BoundFact, Evidence, Fact, Outcome, PushoverFact, SideFact, Status, magnitude,
};
use crate::judge::Recomputed;
use crate::mechanics::Crack;
use crate::scene::Push;

/// A method's judged answer for one side of the push; of a wall that is pushed both ways, the side that
/// does not govern.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct OtherSide {
    /// Direction of its push.
    pub push: Push,
    /// The judged answer.
    pub outcome: Box<Outcome>,
    /// Residuals that the judge computed.
    pub residuals: Vec<Recomputed>,
    /// The crack, where there is one.
    pub crack: Option<Crack>,
}

/// Multipliers nearer than this, relative to the larger, are those of sides alike.
const ALIKE: f64 = 1e-6;

/// The answer of the side that governs, then the other: a side without an answer, as it may be the
/// weaker; else the one at whose λ a collapse is known first.
///
/// # Panics
/// Where there is no answer.
pub(super) fn governing(mut answers: Vec<OtherSide>, unit: f64) -> (OtherSide, Option<OtherSide>) {
    let mut first = 0;
    for side in 1..answers.len() {
        if gives_way_before(&answers[side].outcome, &answers[first].outcome, unit) {
            first = side;
        }
    }
    (answers.swap_remove(first), answers.pop())
}

/// Whether a side gives way before another. Of sides that differ by rounding alone neither does: it
/// must not depend on the machine.
fn gives_way_before(a: &Outcome, b: &Outcome, unit: f64) -> bool {
    let ((a, x), (b, y)) = (rank(a), rank(b));
    a < b || a == b && x < y - ALIKE * magnitude(y, unit)
}

/// How early a side gives way: first by what there is to say of it, then by the multiplier.
fn rank(outcome: &Outcome) -> (u8, f64) {
    match (outcome.status, outcome.evidence.collapse_known()) {
        (Status::Falls, _) => (0, 0.0),
        (Status::Failed, _) => (1, 0.0),
        (Status::Stands, _) => (4, 0.0),
        (_, Some(lambda)) if outcome.bracket().is_some() => (3, lambda),
        _ => (2, 0.0),
    }
}

/// What the wall's range is worth: no more than either side's that it needs, and one number only where
/// its own ends are.
pub(super) fn status(governing: Side, other: Option<Side>, unit: f64) -> Status {
    let own = governing.1.status;
    let Some((_, other_outcome)) = other else {
        return own;
    };
    let Some(bracket) = ends(governing, other).bracket() else {
        return own;
    };
    let either = |status| own == status || other_outcome.status == status;
    match governing.1.evidence {
        // Both ends are proved, and so are the wall's where both sides are.
        Evidence::Bounds { .. } | Evidence::Bounded { .. } | Evidence::Enclosed { .. } => {
            match bracket.is_one_number(unit) {
                _ if either(Status::Undecided) => Status::Undecided,
                _ if either(Status::Estimate) => Status::Estimate,
                true => Status::Verified,
                false => Status::Bracketed,
            }
        }
        // What was found or seen on one side stays that, whatever is known of the other.
        Evidence::Nothing
        | Evidence::ClosedForm { .. }
        | Evidence::Number { .. }
        | Evidence::State { .. }
        | Evidence::States { .. }
        | Evidence::Observed(_)
        | Evidence::Falls { .. }
        | Evidence::Stands { .. } => own,
    }
}

/// The facts of the side that governs, beside another: what it proves is proved of the wall, or names
/// the side.
pub(super) fn facts(own: Side, other: Side) -> Vec<Fact> {
    let push_moves = Fact::from(BoundFact::PushMoves);
    let of_both = other.1.status == Status::Stands || other.1.facts.contains(&push_moves);
    let own_facts = own.1.facts.iter();
    let mut facts = Vec::new();
    for fact in own_facts.filter(|&fact| of_both || *fact != push_moves) {
        let Fact::Bound(BoundFact::Proved(proved)) = fact else {
            facts.push(fact.clone());
            continue;
        };
        match other.1.proved() {
            Some(others) => facts.push(BoundFact::Proved(proved.and(others)).into()),
            None if other.1.status == Status::Stands => facts.push(fact.clone()),
            None => facts.extend([SideFact::For(own.0).into(), fact.clone()]),
        }
    }
    facts
}

/// How the two sides compare, the one that governs first.
pub(super) fn compared(own: Side, other: Side, unit: f64) -> Vec<SideFact> {
    let (push, outcome) = own;
    if outcome.status == Status::Falls {
        return Vec::new();
    }
    let answered = outcome.bracket();
    if answered.is_none() && outcome.reason() == other.1.reason() {
        return vec![SideFact::Either];
    }
    if is_unanswered(outcome) {
        let said = other.1.bracket().map(|bracket| SideFact::AtMost {
            push: other.0,
            lambda: bracket.upper,
            status: other.1.status,
        });
        return said
            .into_iter()
            .chain([SideFact::Unanswered(push)])
            .collect();
    }
    let (Some(one), Some(two)) = (answered, other.1.bracket()) else {
        return vec![SideFact::Only(push)];
    };
    let known = |of: &Outcome| of.evidence.collapse_known().unwrap_or(f64::NAN);
    let (least, next) = (known(outcome), known(other.1));
    let is_alike = |a: f64, b: f64| (a - b).abs() <= ALIKE * magnitude(b, unit);
    if is_alike(one.lower, two.lower) && is_alike(one.upper, two.upper) {
        return vec![SideFact::Alike];
    }
    let by = (next - least) / magnitude(next, unit);
    let first = match is_alike(least, next) {
        true => SideFact::SameLowest,
        // The other side may have states as low that were not met.
        false if one.upper < two.lower && is_range(outcome) => SideFact::LowerEnd(push),
        false if one.upper < two.lower => SideFact::Weaker { push, by },
        false => SideFact::Lowest { push, by },
    };
    let lower = ends(own, Some(other)).lower;
    let elsewhere = lower.map(|end| end.push).filter(|&side| side != push);
    [first]
        .into_iter()
        .chain(elsewhere.map(SideFact::LowerEnd))
        .collect()
}

/// Whether an answer is what was met of several collapse states.
fn is_range(outcome: &Outcome) -> bool {
    outcome.facts.contains(&PushoverFact::Range.into())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::answer::{Bracket, CollapseState, Mechanism, sentence};
    use crate::run::ends::Ends;

    fn number(lower: f64, upper: f64) -> Outcome {
        let evidence = Evidence::Number {
            bracket: Bracket { lower, upper },
            stated_error: None,
            forces: None,
            mechanism: None,
        };
        Outcome::with(Status::Estimate, evidence).because("told")
    }

    fn bounded(lower: f64, upper: f64, status: Status) -> Outcome {
        let state = CollapseState {
            lambda: upper,
            forces: Vec::new(),
            mechanism: Mechanism::default(),
        };
        let evidence = Evidence::Bounded {
            lower: Some(lower),
            certificate: None,
            state,
        };
        Outcome::with(status, evidence)
    }

    /// The wall from the answers to a push to the right and to the left: the side that governs, what is
    /// said of it, its ends and status.
    fn of(outcomes: [Outcome; 2]) -> (Push, String, Ends, Status) {
        let answers = [Push::Right, Push::Left].into_iter().zip(outcomes);
        let answers = answers.map(|(push, outcome)| OtherSide {
            push,
            outcome: Box::new(outcome),
            residuals: Vec::new(),
            crack: None,
        });
        let unit = 1.0;
        let (own, other) = governing(answers.collect(), unit);
        let own = (own.push, &*own.outcome);
        let other = other.as_ref().map(|other| (other.push, &*other.outcome));
        let ends = ends(own, other);
        let other_side = other.unwrap();
        let said = compared(own, other_side, unit).into_iter().map(Fact::from);
        let said: Vec<Fact> = said.chain(facts(own, other_side)).collect();
        (own.0, sentence(&said), ends, status(own, other, unit))
    }

    fn lambdas(ends: Ends) -> [Option<(f64, Push)>; 2] {
        [ends.lower, ends.upper].map(|end| end.map(|end| (end.lambda, end.push)))
    }

    #[test]
    fn the_weaker_side_answers_and_is_named() {
        let (push, reason, ends, _) = of([number(0.5, 0.5), number(0.4, 0.4)]);
        assert_eq!(ends.bracket(), Some(Bracket::point(0.4)));
        assert_eq!(push, Push::Left);
        let expected = "the wall is weaker when pushed to the left, by 20.0 %; told";
        assert_eq!(reason, expected);
    }

    #[test]
    fn of_ranges_neither_side_is_called_weaker() {
        let range = |lambda| {
            let facts = vec![PushoverFact::Range.into()];
            Outcome {
                facts,
                ..number(lambda, lambda)
            }
        };
        let (push, reason, ..) = of([range(0.45), range(0.48)]);
        assert_eq!(push, Push::Right);
        assert!(
            reason.starts_with("the lower end is that of the push to the right; "),
            "{reason}"
        );
    }

    #[test]
    fn rounding_does_not_choose_a_side() {
        let (push, reason, ..) = of([number(0.5, 0.5), number(0.5 - 1e-12, 0.5 - 1e-12)]);
        assert_eq!(push, Push::Right);
        let expected = "the wall is as strong when pushed to the right as to the left; told";
        assert_eq!(reason, expected);
    }

    /// Left [0.3, 0.9] and right [0.4, 0.5]: the right governs, but only 0.3 is proved.
    #[test]
    fn each_end_names_its_side() {
        let right = bounded(0.4, 0.5, Status::Bracketed);
        let left = bounded(0.3, 0.9, Status::Bracketed);
        let (push, reason, ends, status) = of([right, left]);
        assert_eq!(push, Push::Right);
        let expected = [Some((0.3, Push::Left)), Some((0.5, Push::Right))];
        assert_eq!(lambdas(ends), expected);
        assert_eq!(status, Status::Bracketed);
        assert_eq!(
            reason,
            "the lowest collapse known is that of the push to the right, by 44.4 %, and the ranges of the \
             two sides overlap; the lower end is that of the push to the left"
        );
    }

    /// A proof at 0 on both sides makes them alike no more than the states above it do.
    #[test]
    fn sides_with_the_same_lower_end_are_not_alike() {
        let right = bounded(0.0, 0.53, Status::Bracketed);
        let left = bounded(0.0, 0.36, Status::Bracketed);
        let (push, _, ends, _) = of([right, left]);
        assert_eq!(push, Push::Left);
        assert_eq!(
            ends.bracket(),
            Some(Bracket {
                lower: 0.0,
                upper: 0.36
            })
        );
    }

    #[test]
    fn a_wall_is_one_number_where_its_own_ends_are() {
        let right = bounded(0.4, 0.4, Status::Verified);
        let (.., status) = of([right.clone(), bounded(0.5, 0.9, Status::Bracketed)]);
        assert_eq!(status, Status::Verified);
        let (.., status) = of([right, bounded(0.3, 0.9, Status::Bracketed)]);
        assert_eq!(status, Status::Bracketed);
        let right = bounded(0.4, 0.4, Status::Verified);
        let (.., status) = of([right, bounded(0.5, 0.9, Status::Estimate)]);
        assert_eq!(status, Status::Estimate);
    }

    #[test]
    fn a_side_that_falls_is_the_weaker_and_one_that_stands_the_stronger() {
        let falls = Outcome::without_number(Status::Falls, "why");
        let (push, _, ends, status) = of([number(0.5, 0.5), falls]);
        assert_eq!(
            (push, ends.bracket(), status),
            (Push::Left, None, Status::Falls)
        );
        let stands = Outcome::without_number(Status::Stands, "why");
        let (push, reason, ends, _) = of([stands.clone(), number(0.5, 0.5)]);
        assert_eq!(ends.bracket(), Some(Bracket::point(0.5)));
        assert_eq!(
            (push, &*reason),
            (Push::Left, "only the push to the left has a limit; told")
        );
        let (.., reason, ends, status) = of([stands.clone(), stands]);
        assert_eq!((ends.bracket(), status), (None, Status::Stands));
        assert_eq!(reason, "for a push to either side: why");
    }

    #[test]
    fn a_side_without_an_answer_leaves_the_wall_without_a_lower_end() {
        let unknown = Outcome::without_number(Status::Undecided, "why");
        let (_, reason, ends, status) = of([number(0.4, 0.5), unknown]);
        assert_eq!(status, Status::Undecided);
        assert_eq!(lambdas(ends), [None, Some((0.5, Push::Right))]);
        assert_eq!(
            reason,
            "pushed to the right, λ is at most 0.50000 (estimate); there is no answer when pushed to the \
             left: why"
        );
    }

    /// What is proved is never printed as more than that.
    #[test]
    fn bounds_are_rounded_outwards() {
        let (.., ends, _) = of([
            bounded(0.289_523_821_6, 0.3, Status::Bracketed),
            bounded(0.4, 0.4, Status::Verified),
        ]);
        let lower = ends.lower.unwrap();
        assert_eq!(
            (lower.outwards(6), lower.written()),
            ("0.289523".into(), 0.289_523_821)
        );
        assert_eq!(ends.upper.unwrap().outwards(5), "0.30000");
    }
}
