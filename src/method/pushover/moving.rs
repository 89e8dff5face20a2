//! The pushover of a support that moves: from a reaction a third of the way between the ends that friction
//! admits, for at either end the scene is about to move before anything changes.

use crate::answer::{Fact, Outcome, ReactionFact, Status, magnitude};
use crate::scene::Scene;

use super::observing::observing;

/// The answer of a scene with a support that moves, by the pushover of one that begins further in; `None`
/// where none moves.
pub(super) fn from_within(scene: &Scene, pushover: impl Fn(&Scene) -> Outcome) -> Option<Outcome> {
    let reaction = scene.reaction()?;
    let before = reaction.range / 3.0;
    let within = reaction.at(before);
    let outcome = pushover(&scene.clone().with_start(within, before, false));
    if outcome.status == Status::Falls {
        // It stands with another reaction, and may with this one.
        let reason = ReactionFact::NotAtRest(within);
        return Some(Outcome::without_number(Status::Undecided, reason));
    }
    let unit = scene.multiplier_unit();
    let facts = outcome.facts.iter().map(|fact| match fact {
        Fact::Pushover(fact) => fact.clone().with_lambda(&|lambda| before + lambda).into(),
        other => other.clone(),
    });
    let facts = facts.collect();
    let outcome = Outcome { facts, ..outcome };
    Some(observing(outcome, |observed| {
        let Some(bracket) = &mut observed.bracket else {
            return;
        };
        let own = magnitude(bracket.upper, unit);
        bracket.lower += before;
        bracket.upper += before;
        // The error stays what it is, beside a larger λ.
        let share = own / magnitude(bracket.upper, unit);
        observed.stated_error = observed.stated_error.map(|error| error * share);
    }))
}
