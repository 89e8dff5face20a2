//! Of a wall that is pushed both ways, the side that gives way first.

use crate::answer::{Outcome, SideFact, Status, magnitude};
use crate::judge::Recomputed;
use crate::scene::Scene;

/// The judged answer of a method for one side of the push.
pub(super) struct Answer<'a> {
    /// The scene that it is about.
    pub scene: &'a Scene,
    /// The answer, its status set by the judge.
    pub outcome: Outcome,
    /// Residuals that the judge computed, where there was something to judge.
    pub residuals: Vec<Recomputed>,
    /// CPU time of the method, seconds.
    pub seconds: f64,
    /// The answer of the side that does not count, where the wall is pushed both ways.
    pub stronger: Option<Box<Answer<'a>>>,
}

/// Multipliers nearer than this, relative to the larger, are those of sides alike.
const ALIKE: f64 = 1e-6;

/// The answer of the side that gives way first. A side without an honest answer leaves the wall
/// without one, as it may be the weaker.
///
/// # Panics
/// Where there is no answer.
pub(super) fn weaker(mut answers: Vec<Answer>) -> Answer {
    if answers.len() == 1 {
        return answers.remove(0);
    }
    let seconds = answers.iter().map(|answer| answer.seconds).sum();
    let work = answers
        .iter()
        .map(|answer| answer.outcome.work)
        .fold(Default::default(), |a, b| a + b);
    let mut first = 0;
    for side in 1..answers.len() {
        if is_weaker(&answers[side], &answers[first]) {
            first = side;
        }
    }
    let mut answer = answers.swap_remove(first);
    let alike = answers.iter().all(|other| !is_weaker(&answer, other));
    let push = answer.scene.push();
    let side = match answer.outcome.bracket() {
        Some(_) if alike => SideFact::Alike,
        Some(_) => SideFact::Weaker(push),
        None => SideFact::Unanswered(push),
    };
    answer.outcome.facts.insert(0, side.into());
    answer.outcome.work = work;
    Answer {
        seconds,
        stronger: answers.pop().map(Box::new),
        ..answer
    }
}

/// Whether a side gives way before another. Of sides that differ by rounding alone neither does: it
/// must not depend on the machine.
fn is_weaker(a: &Answer, b: &Answer) -> bool {
    let margin = |lambda: f64| ALIKE * magnitude(lambda, b.scene.multiplier_unit());
    let ((a, x), (b, y)) = (rank(a), rank(b));
    a < b || a == b && x < y - margin(y)
}

/// How early a side gives way: first by the status, then by the multiplier.
fn rank(answer: &Answer) -> (u8, f64) {
    match (answer.outcome.status, answer.outcome.bracket()) {
        (Status::Failed, _) => (0, 0.0),
        (Status::Falls, _) => (1, 0.0),
        (Status::Stands, _) => (4, 0.0),
        (_, Some(bracket)) => (3, bracket.lower),
        (_, None) => (2, 0.0),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::answer::{Bracket, Evidence};
    use crate::scene::{HeadJoints, Push, Wall};

    fn side(push: Push) -> Scene {
        Wall::of_cubes(1, push).scene(HeadJoints::Open).unwrap()
    }

    fn at(lambda: f64) -> Outcome {
        let evidence = Evidence::Number {
            bracket: Bracket::point(lambda),
            stated_error: None,
            forces: None,
            mechanism: None,
            crack: None,
        };
        Outcome {
            evidence,
            ..Outcome::without_number(Status::Estimate, "told")
        }
    }

    /// The weaker of the answers to a push to the right and to the left: its push and outcome.
    fn of(outcomes: [Outcome; 2]) -> (Push, Outcome) {
        let scenes = [Push::Right, Push::Left].map(side);
        let answers = outcomes.into_iter().zip(&scenes);
        let answers = answers.map(|(outcome, scene)| Answer {
            scene,
            outcome,
            residuals: Vec::new(),
            seconds: 1.0,
            stronger: None,
        });
        let answer = weaker(answers.collect());
        assert_eq!(answer.seconds, 2.0);
        (answer.scene.push(), answer.outcome)
    }

    #[test]
    fn the_weaker_side_answers_and_is_named() {
        let (push, outcome) = of([at(0.5), at(0.4)]);
        assert_eq!(outcome.bracket(), Some(Bracket::point(0.4)));
        assert_eq!(push, Push::Left);
        assert_eq!(
            outcome.reason(),
            "the wall is weaker when pushed to the left; told"
        );
    }

    #[test]
    fn rounding_does_not_choose_a_side() {
        let (push, outcome) = of([at(0.5), at(0.5 - 1e-12)]);
        assert_eq!(push, Push::Right);
        assert_eq!(
            outcome.reason(),
            "the wall is as strong when pushed to the right as to the left; told"
        );
    }

    #[test]
    fn a_side_that_falls_is_the_weaker_and_one_that_stands_the_stronger() {
        let falls = Outcome::without_number(Status::Falls, "why");
        assert_eq!(of([at(0.5), falls]).0, Push::Left);
        let stands = Outcome::without_number(Status::Stands, "why");
        assert_eq!(of([stands, at(0.5)]).0, Push::Left);
    }

    #[test]
    fn a_side_without_an_answer_leaves_the_wall_without_one() {
        let (_, outcome) = of([at(0.5), Outcome::without_number(Status::Undecided, "why")]);
        assert_eq!(outcome.status, Status::Undecided);
        assert_eq!(
            outcome.reason(),
            "there is no answer when pushed to the left: why"
        );
    }
}
