//! No more model than the scene needs: rungs from cheap to dear, and an answer from the first that
//! proves one.
//!
//! 1. The closed form, where it holds. It rests on an assumed mechanism, so it is reported and
//!    never the answer.
//! 2. λ_A, which no collapse multiplier exceeds, on the part of the wall that the crack can reach
//!    where that is proved to suffice. A scene that falls, or that no push can collapse, is
//!    settled here.
//! 3. Collapse states without dilatancy, of one start. Where one lies further below λ_A than the
//!    tolerance, the multiplier is not unique, and no further state could change that.
//! 4. States of more starts, each followed down to the lowest it finds. One start alone may end
//!    close to λ_A and miss a branch far below it.
//! 5. The sequential method, which ends on other branches: an answer that vouches for itself has
//!    listened first. Where it lies so low that the multiplier would not be unique, the search goes
//!    on, and where that finds no state as low, the answer is `undecided`.
//! 6. The whole scene in place of the part, where the part proves nothing.
//!
//! The answer is the bracket [lowest verified state, λ_A] with both ends proved; where it is wider
//! than the tolerance, it is `undecided: not unique`, which is right: between its ends the
//! multiplier depends on what nobody knows of a real wall. A state below everything that the starts
//! found is not excluded: that takes a certificate of the method `bound`, which only small scenes have.

use super::limit::{self, Associative, Sequential};
use super::macro_block::MacroBlock;
use super::settings::LP_TOLERANCE;
use super::{Method, Settings};
use crate::answer::{
    AutoFact, Bracket, Evidence, Fact, Outcome, Status, Uniqueness, Work, magnitude,
};
use crate::mechanics::Ceiling;
use crate::scene::Scene;

/// The method that picks among the others.
pub struct Auto;

impl Method for Auto {
    fn name(&self) -> &str {
        "auto"
    }

    fn solve(&self, scene: &Scene, settings: &Settings) -> Outcome {
        let mut ladder = Ladder {
            scene,
            settings,
            listened: false,
            work: Work::default(),
        };
        let closed_form = MacroBlock.solve(scene, settings).bracket();
        let bound = ladder.run(&Associative);
        if bound.status == Status::Stands {
            let found = ladder.states(settings, f64::NEG_INFINITY);
            return ladder.without_bound(found);
        }
        let Some(Bracket { upper, .. }) = bound.bracket() else {
            return ladder.settled(bound);
        };
        let unit = scene.multiplier_unit();
        let stop_below = upper - settings.auto.tolerance * magnitude(upper, unit);
        let mut found = ladder.states(settings, stop_below);
        let Some(Bracket { mut lower, .. }) = found.bracket() else {
            return ladder.without_state(upper, found);
        };
        let starts = |found: &Outcome| found.search().map_or(0, |search| search.starts.len());
        let mut searched = starts(&found);
        let mut heard = ladder.heard_below(stop_below, lower);
        if heard.is_some() {
            let mut longer = *settings;
            // As many as the scene allows, or more than those where that was not enough.
            longer.interval.starts = match settings.interval.starts {
                0 => SEARCH_ON * searched,
                _ => 0,
            };
            let further = ladder.states(&longer, stop_below);
            searched += starts(&further);
            if let Some(bracket) = further.bracket().filter(|bracket| bracket.lower < lower) {
                (lower, found) = (bracket.lower, further);
            }
            heard = heard.filter(|_| lower >= stop_below);
        }
        let bracket = Bracket {
            lower,
            upper: upper.max(lower),
        };
        let width = bracket.relative_width(unit);
        let uniqueness = Uniqueness {
            unique: width <= settings.auto.tolerance,
            relative_width: width,
            closed_form,
            starts: searched,
            ended_early: lower < stop_below,
        };
        ladder.answer(bound, found, bracket, uniqueness, heard)
    }
}

/// Starts of the longer search, as a multiple of those of the first.
const SEARCH_ON: usize = 4;

/// Proofs need the programs as tight as they are by default.
fn proving(settings: &Settings) -> Settings {
    let mut settings = *settings;
    settings.programs.lp_tolerance = LP_TOLERANCE;
    settings
}

/// The methods run so far on one scene, from cheap to dear, with their work.
struct Ladder<'a> {
    scene: &'a Scene,
    settings: &'a Settings,
    /// Whether the sequential method has run.
    listened: bool,
    work: Work,
}

impl Ladder<'_> {
    /// Runs a method and counts its work.
    fn run(&mut self, method: &dyn Method) -> Outcome {
        let outcome = method.solve(self.scene, &proving(self.settings));
        self.count(outcome.work);
        outcome
    }

    /// The interval, stopped at the first state below `stop_below`.
    fn states(&mut self, settings: &Settings, stop_below: f64) -> Outcome {
        let outcome = limit::lowest(self.scene, &proving(settings), stop_below);
        self.count(outcome.work);
        outcome
    }

    /// What the sequential method says, where that is so low that the multiplier would not be unique,
    /// although the `lowest` state is not.
    fn heard_below(&mut self, stop_below: f64, lowest: f64) -> Option<AutoFact> {
        if lowest < stop_below {
            return None;
        }
        self.listened = true;
        let other = self.run(&Sequential);
        let lambda = other.bracket()?.upper;
        let below = (lowest - lambda) / magnitude(lowest, self.scene.multiplier_unit());
        (lambda < stop_below).then_some(AutoFact::LowerHeard { lambda, below })
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
        Outcome {
            work: self.work,
            facts: introduced(AutoFact::SettledByAssociative, bound.facts),
            ..bound
        }
    }

    /// The answer where nothing collapses by associative friction, which settles nothing without
    /// dilatancy: `found` stands by a proof of its own, or the multiplier is not unique.
    fn without_bound(&self, found: Outcome) -> Outcome {
        if found.status == Status::Stands {
            let work = self.work;
            return Outcome { work, ..found };
        }
        let lowest = found.bracket().map(|bracket| bracket.lower);
        let lowest = lowest.map(|lambda| AutoFact::CollapsesWithoutBound { lambda });
        Outcome {
            work: self.work,
            facts: match lowest {
                Some(fact) => vec![fact.into()],
                None => found.facts,
            },
            ..Outcome::of(Status::Undecided)
        }
    }

    fn without_state(&self, associative: f64, found: Outcome) -> Outcome {
        Outcome {
            work: self.work,
            facts: introduced(AutoFact::NoState { associative }, found.facts),
            ..Outcome::of(Status::Undecided)
        }
    }

    /// [lowest state of `found`, λ_A], and whether that is an answer.
    fn answer(
        &mut self,
        bound: Outcome,
        found: Outcome,
        bracket: Bracket,
        uniqueness: Uniqueness,
        heard: Option<AutoFact>,
    ) -> Outcome {
        let is_answer = uniqueness.unique && heard.is_none();
        let facts = heard.into_iter();
        let facts = facts.chain([AutoFact::Uniqueness(uniqueness), self.saved()]);
        Outcome {
            evidence: enclosed(bound.evidence, found.evidence, bracket.upper),
            work: self.work,
            facts: facts.map(Fact::from).collect(),
            ..Outcome::of(if is_answer {
                Status::Bracketed
            } else {
                Status::Undecided
            })
        }
    }

    /// What was not needed.
    fn saved(&self) -> AutoFact {
        let of_blocks = self.scene.blocks().len();
        let is_part = (1..of_blocks).contains(&self.work.modelled);
        AutoFact::Saved {
            sequential: !self.listened,
            blocks: if is_part {
                of_blocks - self.work.modelled
            } else {
                0
            },
            of_blocks,
        }
    }
}

/// The lowest state, and the mechanism of λ_A as the proof that none is above `upper`.
fn enclosed(bound: Evidence, found: Evidence, upper: f64) -> Evidence {
    match (bound, found) {
        (Evidence::Bounds { above, .. }, Evidence::States { mut states }) if !states.is_empty() => {
            Evidence::Enclosed {
                state: states.swap_remove(0),
                ceiling: Ceiling {
                    lambda: upper,
                    ..above
                },
            }
        }
        _ => Evidence::Nothing,
    }
}

/// Facts of another method behind what introduces them.
fn introduced(by: AutoFact, facts: Vec<Fact>) -> Vec<Fact> {
    [vec![by.into()], facts].concat()
}
