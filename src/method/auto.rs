//! No more model than the scene needs: rungs from cheap to dear, and an answer from the first that
//! proves one.
//!
//! 1. The closed form, where it holds. It rests on an assumed mechanism, so it is told and never
//!    the answer.
//! 2. λ_A, which no collapse multiplier exceeds, on the part of the wall that the crack can reach
//!    where that is proved to be enough. A scene that falls, or that no push can collapse, is
//!    settled here.
//! 3. Collapse states without dilatancy, of one start. Where one lies further below λ_A than the
//!    tolerance, the multiplier is not unique, and no further state could change that.
//! 4. States of more starts, each followed down to the lowest it finds. One start alone may end
//!    close to λ_A and miss a branch far below it.
//! 5. The whole scene in place of the part, where the part proves nothing.
//!
//! The answer is the bracket [lowest verified state, λ_A] with both ends proved; where it is wider
//! than the tolerance, it is `undecided: not unique`, which is right: between its ends the
//! multiplier depends on what nobody knows of a real wall. No rigorous lower bound on collapse is
//! known, so that a state below everything that the starts found can never be excluded.

use super::limit::{self, Associative};
use super::macro_block::MacroBlock;
use super::settings::LP_TOLERANCE;
use super::{Method, Settings};
use crate::answer::{Bracket, Claim, Outcome, Status, Work};
use crate::number::short;
use crate::scene::Scene;

/// The method that picks among the others.
pub struct Auto;

impl Method for Auto {
    fn name(&self) -> &str {
        "auto"
    }

    fn solve(&self, scene: &Scene, settings: &Settings) -> Outcome {
        let mut climb = Climb {
            scene,
            settings,
            work: Work::default(),
        };
        let closed_form = closed_form(scene, settings);
        let bound = climb.run(&Associative);
        let Some(Bracket { upper, .. }) = bound.bracket else {
            return climb.settled(bound);
        };
        let starts = settings.interval.starts.max(2);
        let enough = upper - settings.auto.tolerance * upper.abs().max(1e-3);
        let found = climb.states(starts, enough);
        let Some(Bracket { lower, .. }) = found.bracket else {
            return climb.without_state(upper, &found);
        };
        let why = match lower < enough {
            true => "a state as low ends the search".to_owned(),
            false => format!("one start may miss a lower state, {starts} found none"),
        };
        let tried = format!("{closed_form}; {why}");
        climb.answer(&bound, found, &tried)
    }
}

/// What the closed form says, in words.
fn closed_form(scene: &Scene, settings: &Settings) -> String {
    let outcome = MacroBlock.solve(scene, settings);
    match outcome.bracket {
        Some(range) => format!(
            "macro-block says {} to {}, an estimate",
            short(range.lower, 4),
            short(range.upper, 4)
        ),
        None => "macro-block does not apply".to_owned(),
    }
}

/// Proofs need the programs as tight as they are by default.
fn proving(settings: &Settings) -> Settings {
    let mut settings = *settings;
    settings.programs.lp_tolerance = LP_TOLERANCE;
    settings
}

/// The way up on one scene.
struct Climb<'a> {
    scene: &'a Scene,
    settings: &'a Settings,
    work: Work,
}

impl Climb<'_> {
    /// Runs a method and counts its work.
    fn run(&mut self, method: &dyn Method) -> Outcome {
        let outcome = method.solve(self.scene, &proving(self.settings));
        self.count(outcome.work);
        outcome
    }

    /// The interval, stopped at the first state below `enough`.
    fn states(&mut self, starts: usize, enough: f64) -> Outcome {
        let mut settings = proving(self.settings);
        settings.interval.starts = starts;
        let outcome = limit::lowest(self.scene, &settings, enough);
        self.count(outcome.work);
        outcome
    }

    fn count(&mut self, work: Work) {
        let modelled = self.work.modelled.max(work.modelled);
        self.work = Work {
            modelled,
            ..self.work + work
        };
    }

    /// The answer of a scene without a multiplier, which the program for λ_A has settled or not.
    fn settled(&self, bound: Outcome) -> Outcome {
        let reason = match bound.reason().as_str() {
            "" => "by the program of the associative multiplier".to_owned(),
            reason => format!("by the program of the associative multiplier: {reason}"),
        };
        Outcome {
            work: self.work,
            facts: vec![reason.into()],
            ..bound
        }
    }

    /// [lowest state of `found`, λ_A], with who was asked in `tried`.
    fn answer(&mut self, bound: &Outcome, found: Outcome, tried: &str) -> Outcome {
        let lower = found.bracket.map_or(0.0, |bracket| bracket.lower);
        let upper = bound
            .bracket
            .map_or(lower, |bracket| bracket.upper)
            .max(lower);
        let bracket = Bracket { lower, upper };
        let width = bracket.relative_width();
        let apart = format!(
            "lowest state found and associative multiplier are {} % apart",
            short(100.0 * width, 2)
        );
        let unique = width <= self.settings.auto.tolerance;
        let mut reason = match unique {
            true => format!("{apart} ({tried})"),
            false => format!("not unique: {apart} ({tried})"),
        };
        reason.push_str(&self.saved());
        Outcome {
            claim: Claim::Enclosed,
            bracket: Some(bracket),
            crack: found.crack,
            mechanism: found.mechanism,
            forces: found.forces,
            ceiling: bound.mechanism.clone(),
            work: self.work,
            ..Outcome::without_number(
                match unique {
                    true => Status::Bracketed,
                    false => Status::Undecided,
                },
                reason,
            )
        }
    }

    fn without_state(&self, upper: f64, found: &Outcome) -> Outcome {
        let upper = short(upper, 5);
        let why = &found.reason();
        let reason = format!("no collapse state is proved below λ_A = {upper}: {why}");
        Outcome {
            work: self.work,
            ..Outcome::without_number(Status::Undecided, reason)
        }
    }

    /// What was not needed, in words.
    fn saved(&self) -> String {
        let blocks = self.scene.blocks().len();
        let part = match self.work.modelled {
            modelled if (1..blocks).contains(&modelled) => {
                format!("{} of {blocks} blocks, ", blocks - modelled)
            }
            _ => String::new(),
        };
        format!("; saved: {part}sequential and pushover")
    }
}
