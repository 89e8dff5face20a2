//! Scenes of several connected parts: the part that collapses first decides.

use super::observing::observing;
use super::portion::Portion;
use crate::answer::{Bracket, Fact, Outcome, PushoverFact, Status};
use crate::scene::Scene;

/// The outcome of all parts of a scene, from the `answer` of each. A part that falls lets the scene
/// fall; one without an answer leaves it without, unless it is seen to stand at a higher load than
/// another part.
pub fn weakest(scene: &Scene, answer: impl Fn(&Portion) -> Outcome) -> Outcome {
    let parts = Portion::parts(scene);
    let [_, _, ..] = parts[..] else {
        return answer(&Portion::default());
    };
    let mut answers: Vec<(&Portion, Outcome)> = Vec::new();
    let mut block_steps = 0;
    for part in &parts {
        let mut outcome = answer(part);
        block_steps += std::mem::take(&mut outcome.work.block_steps);
        let falls = outcome.status == Status::Falls;
        answers.push((part, outcome));
        if falls {
            answers.drain(..answers.len() - 1);
            break;
        }
    }
    let of_part = |(_, of): &(_, Outcome)| of.evidence.checks().to_vec();
    let checks = answers.iter().flat_map(of_part).collect();
    let mut outcome = decisive(scene, answers);
    outcome.work.block_steps = block_steps;
    observing(outcome, |observed| observed.checks = checks)
}

/// The answer of the part that decides.
fn decisive(scene: &Scene, mut answers: Vec<(&Portion, Outcome)>) -> Outcome {
    let upper = |outcome: &Outcome| outcome.bracket().map_or(f64::INFINITY, |of| of.upper);
    let least = answers.iter().map(|(_, of)| upper(of));
    let least = least.fold(f64::INFINITY, f64::min);
    let unanswered = |(part, outcome): &(&Portion, Outcome)| {
        let pushed = part.is_pushed(scene);
        outcome.bracket().is_none() && stands_at(outcome).is_none_or(|at| pushed && at < least)
    };
    let first = answers.iter().position(unanswered);
    let weakest = || answers.iter().position(|(_, of)| upper(of) == least);
    let decides = first.or_else(weakest).unwrap_or(0);
    let (_, outcome) = answers.swap_remove(decides);
    match outcome.bracket() {
        Some(bracket) => beside(outcome, bracket, &answers),
        None => outcome,
    }
}

/// The largest multiplier at which an outcome without a bracket saw the part stand.
fn stands_at(outcome: &Outcome) -> Option<f64> {
    outcome.facts.iter().find_map(|fact| match fact {
        Fact::Pushover(PushoverFact::StillStands { lambda }) => Some(*lambda),
        _ => None,
    })
}

/// The weakest part's outcome beside those of parts that collapse almost as early: an estimate beside one.
fn beside(mut outcome: Outcome, bracket: Bracket, others: &[(&Portion, Outcome)]) -> Outcome {
    let near = others.iter().filter_map(|(_, of)| {
        let bracket_of = of.bracket()?;
        let error = of.evidence.stated_error();
        let least = bracket_of.lower * (1.0 - error.unwrap_or(0.0));
        (least <= bracket.upper).then_some((bracket_of.lower, error, &of.facts))
    });
    let (mut lower, mut most) = (bracket.lower, outcome.evidence.stated_error());
    for (other, error, facts) in near {
        lower = lower.min(other);
        most = most.zip(error).map(|(most, error)| most.max(error));
        if error.is_none() {
            outcome.status = Status::Estimate;
            outcome.facts.extend_from_slice(facts);
        }
    }
    observing(outcome, |observed| {
        observed.bracket = Some(Bracket { lower, ..bracket });
        observed.stated_error = most;
    })
}
