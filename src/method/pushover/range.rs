//! Several collapse states: a range over what nobody knows of a real wall.
//!
//! What a perpend carries before the push depends on how tightly it was closed, so with head joints
//! in contact the collapse load is not unique; nor is it where levels disagree. Direction, contact
//! stiffness and substep stand for that here.

use super::levels::{BUDGET, Levels, halved, rounded_up, softness};
use super::model::Model;
use super::parameters::{Parameters, SLIDE};
use super::portion::Portion;
use super::run::Trial;
use crate::answer::{
    Bracket, Fact, Outcome, PushoverFact, SelfCheck, Status, Variation, magnitude,
};
use crate::method::PushoverSettings;
use crate::scene::Scene;

/// Pushovers of a range over head joints in contact.
const PUSHOVERS: usize = 2 * (STIFFNESSES.len() + 1);

/// Blocks times substeps beyond which a range is not begun, or not ended, but on request.
const MOST_WORK: usize = 500_000_000;

/// Substeps of one pushover for every course: what a range is expected to cost. Measured on walls of
/// 6 to 48 courses, which need 800 to 3400.
const SUBSTEPS_A_COURSE: f64 = 2000.0;

/// Contact stiffnesses, as multiples of what the substep allows.
const STIFFNESSES: [f64; 3] = [1.0, 0.5, SOFTEST];

const SOFTEST: f64 = 0.25;

/// Error of the ends of a range of states, where no level states one, relative to λ.
const STATED: f64 = 2e-3;

/// Times that the substep may be halved before contacts are stiff enough.
const MOST_HALVINGS: u32 = 6;

/// A portion and its mirror image, whose pushovers are varied.
pub struct Varied<'a, P> {
    scene: &'a Scene,
    mirror: Scene,
    portion: &'a Portion,
    parameters: &'a P,
}

type Runs = Vec<(Variation, Outcome)>;

impl<'a, P: Fn(&Model) -> Parameters> Varied<'a, P> {
    /// `parameters` are those of the first level.
    ///
    /// # Errors
    /// The scene has no mirror image.
    pub fn new(
        scene: &'a Scene,
        portion: &'a Portion,
        parameters: &'a P,
    ) -> Result<Self, PushoverFact> {
        let mirror = scene.mirrored().map_err(|_| PushoverFact::NoMirror)?;
        Ok(Self {
            scene,
            mirror,
            portion,
            parameters,
        })
    }

    /// The lowest lower and the highest upper value over both directions, several stiffnesses and
    /// two substeps.
    pub fn over_head_joints(&self, settings: &PushoverSettings) -> Outcome {
        let blocks = self.portion.present(self.scene).count();
        let costs = PUSHOVERS as f64 * blocks as f64 * SUBSTEPS_A_COURSE * self.courses();
        if costs > MOST_WORK as f64 && !settings.long_ranges {
            let pushovers = PUSHOVERS;
            let fact = PushoverFact::RangeNotRun { pushovers, blocks };
            return Outcome::without_number(Status::Undecided, fact);
        }
        let (mut spent, mut halvings) = (0, 0);
        // The softest contacts say how short the substep has to be.
        let softest = loop {
            let run = self.run([SOFTEST, 1.0], false, halvings, None);
            match softness(&run.1) {
                Some(more) if halvings + more <= MOST_HALVINGS => {
                    spent += run.1.work.block_steps;
                    halvings += more;
                }
                _ => break run,
            }
        };
        let mut runs = vec![softest];
        // The stiffest and the softest first: they lie furthest apart.
        for stiffness in [1.0, SOFTEST, 0.5] {
            for mirrored in [false, true] {
                if stiffness == SOFTEST && !mirrored {
                    continue;
                }
                let steps = spent + steps(&runs);
                if steps > MOST_WORK && !settings.long_ranges {
                    return unfinished(runs, spent);
                }
                runs.push(self.run([stiffness, 1.0], mirrored, halvings, None));
            }
        }
        if let Some(coarse) = covered(&runs) {
            for mirrored in [false, true] {
                let like = |(variation, _): &&(Variation, Outcome)| {
                    variation.stiffness == 1.0 && variation.mirrored == mirrored
                };
                let expected = runs.iter().find(like).and_then(|(_, run)| run.bracket);
                runs.push(self.run([1.0, 4.0], mirrored, halvings + 1, expected));
            }
            let fact = PushoverFact::Range { softest: SOFTEST };
            return joined(runs, spent, |all| moved(coarse, all), vec![fact.into()]);
        }
        joined(runs, spent, |_| None, Vec::new())
    }

    /// Courses that fit into the height of the portion.
    fn courses(&self) -> f64 {
        Model::new(self.scene, self.portion).map_or(1.0, |model| model.courses)
    }

    /// The range of levels that disagree: over the same variations at the last of them, over the last
    /// two, and down to where a block leaves its place.
    pub fn over_states(&self, levels: Levels) -> Outcome {
        let Levels {
            seen,
            last,
            halvings,
            ..
        } = levels;
        let brackets: Vec<Bracket> = seen.iter().map(|level| level.bracket).collect();
        let last_two = &brackets[brackets.len().saturating_sub(2)..];
        let fact = PushoverFact::LevelsDisagree {
            brackets: brackets.clone(),
        };
        let spent = last.work.block_steps;
        if spent > BUDGET / 8 {
            return Outcome {
                work: last.work,
                ..Outcome::without_number(Status::Undecided, fact)
            };
        }
        let expected = brackets.last().copied();
        let slides = |own: Parameters| Parameters {
            slide: SLIDE,
            ..own
        };
        let drifts = |own: Parameters| Parameters {
            drift: f64::INFINITY,
            ..own
        };
        let mut runs = Vec::new();
        for mirrored in [false, true] {
            runs.push(self.varied([1.0; 2], mirrored, halvings, None, slides));
            for stiffness in STIFFNESSES {
                let like = [stiffness, 1.0];
                runs.push(self.varied(like, mirrored, halvings, expected, drifts));
            }
        }
        let error = last.stated_error.unwrap_or(STATED);
        let outcome = joined(runs, spent, |_| Some(error), vec![fact.into()]);
        let range = outcome.bracket.map(|range| {
            let all = last_two.iter();
            all.fold(range, |range, &level| hull(range, Some(level)))
        });
        Outcome {
            bracket: range,
            ..outcome
        }
    }

    /// One pushover with a stiffness, which in another level's measure is `times` as much.
    fn run(
        &self,
        [stiffness, times]: [f64; 2],
        mirrored: bool,
        halvings: u32,
        expected: Option<Bracket>,
    ) -> (Variation, Outcome) {
        self.varied([stiffness, times], mirrored, halvings, expected, |own| own)
    }

    /// The same with further parameters changed.
    fn varied(
        &self,
        [stiffness, times]: [f64; 2],
        mirrored: bool,
        halvings: u32,
        expected: Option<Bracket>,
        change: impl Fn(Parameters) -> Parameters,
    ) -> (Variation, Outcome) {
        let trial = Trial {
            scene: if mirrored { &self.mirror } else { self.scene },
            portion: self.portion,
            expected,
        };
        let outcome = trial.run(&|model: &Model| {
            let own = halved((self.parameters)(model), halvings);
            change(Parameters {
                // Stiffness goes with the square of the frequency.
                contact_frequency: own.contact_frequency * stiffness.sqrt(),
                ..own
            })
        });
        let variation = Variation {
            stiffness: stiffness * times,
            mirrored,
        };
        (variation, outcome)
    }
}

/// Blocks times substeps of all runs.
fn steps(runs: &Runs) -> usize {
    runs.iter().map(|(_, run)| run.work.block_steps).sum()
}

/// A range that ended before all of its pushovers were run: no number, but how far it got.
fn unfinished(runs: Runs, spent: usize) -> Outcome {
    let run = runs.len();
    let brackets: Vec<Bracket> = runs.iter().filter_map(|(_, run)| run.bracket).collect();
    let so_far = brackets.first().map(|&first| {
        let all = brackets.iter();
        all.fold(first, |all, &one| hull(all, Some(one)))
    });
    let fact = PushoverFact::RangeUnfinished {
        run,
        pushovers: PUSHOVERS,
        so_far,
    };
    let mut outcome = Outcome::without_number(Status::Undecided, fact);
    outcome.work.block_steps = spent + steps(&runs);
    outcome
}

fn hull(range: Bracket, other: Option<Bracket>) -> Bracket {
    let other = other.unwrap_or(range);
    Bracket {
        lower: range.lower.min(other.lower),
        upper: range.upper.max(other.upper),
    }
}

/// What all brackets cover; `None` where a run has none.
fn covered(runs: &Runs) -> Option<Bracket> {
    let brackets: Option<Vec<Bracket>> = runs.iter().map(|(_, run)| run.bracket).collect();
    let brackets = brackets?;
    let first = *brackets.first()?;
    Some(
        brackets
            .iter()
            .fold(first, |all, &one| hull(all, Some(one))),
    )
}

/// How far the shorter substep moved the ends of a range, or the width of its widest bracket: the
/// error that is stated.
fn moved(coarse: Bracket, runs: &Runs) -> Option<f64> {
    let all = covered(runs)?;
    let widths = runs.iter().filter_map(|(_, run)| run.bracket);
    let width = widths.map(|b| b.upper - b.lower).fold(0.0, f64::max);
    let ends = (coarse.lower - all.lower).max(all.upper - coarse.upper);
    Some(rounded_up(ends.max(width) / magnitude(all.upper, 1.0)))
}

/// One outcome of all; without a number where one of them has none.
fn joined(
    runs: Runs,
    spent: usize,
    error: impl Fn(&Runs) -> Option<f64>,
    facts: Vec<Fact>,
) -> Outcome {
    let block_steps = spent + steps(&runs);
    let checks = runs.iter().flat_map(|(variation, run)| {
        run.checks.iter().map(|check| SelfCheck {
            variation: Some(*variation),
            ..check.clone()
        })
    });
    let checks: Vec<SelfCheck> = checks.collect();
    let mut outcome = match covered(&runs) {
        Some(range) => Outcome {
            bracket: Some(range),
            stated_error: error(&runs),
            crack: runs[0].1.crack.filter(|_| same_crack(&runs)),
            facts,
            ..Outcome::of(Status::Bracketed)
        },
        None => Outcome {
            facts: [why_none(&runs), facts].concat(),
            ..Outcome::of(status_without(&runs))
        },
    };
    outcome.checks = checks;
    outcome.work.block_steps = block_steps;
    outcome
}

/// A scene that falls however it is varied falls.
fn status_without(runs: &Runs) -> Status {
    match runs.iter().all(|(_, run)| run.status == Status::Falls) {
        true => Status::Falls,
        false => Status::Undecided,
    }
}

fn same_crack(runs: &Runs) -> bool {
    runs.windows(2)
        .all(|pair| pair[0].1.crack == pair[1].1.crack)
}

fn why_none(runs: &Runs) -> Vec<Fact> {
    if status_without(runs) == Status::Falls {
        return runs[0].1.facts.clone();
    }
    let mut facts = Vec::new();
    for (variation, run) in runs.iter().filter(|(_, run)| run.bracket.is_none()) {
        facts.push(PushoverFact::Without(*variation).into());
        facts.extend(run.facts.clone());
    }
    facts
}
