//! Levels: the same pushover with ever shorter substeps, which tell its error on this scene.
//!
//! Contacts are springs that stiffen with the square of the substep, so that what the springs cost λ
//! shrinks from level to level. One level can only assume that error; two measure it. Agreement is
//! necessary, not proof: a state that all levels miss is missed.

use super::agreement::{
    Enclosure, Level, Sizes, agreement, differ_in_deflection, of_one_fall, wandering,
};
use super::model::Model;
use super::observing::observing;
use super::parameters::{Asked, SLIDE};
use super::portion::Portion;
use super::run::{Trial, is_unclear};
use super::tuned::Tuned;
use crate::answer::{Bracket, Checked, Fact, Outcome, PushoverFact, SelfCheck, Status};
use crate::scene::Scene;

/// How the pushovers of one portion ended, from the longest substep to the shortest.
pub struct Levels {
    /// What was seen at every level.
    pub seen: Vec<Level>,
    /// The last outcome with a bracket; without one, why there is none.
    pub last: Outcome,
    /// Times that the substep of the last level was halved.
    pub halvings: u32,
    /// What the levels agree on.
    pub agreed: Option<Enclosure>,
    /// Where they do not, what the last two cover; not of a tall wall, whose levels follow a trend.
    pub wandering: Option<Enclosure>,
    /// Whether a further level would have cost too much.
    pub ran_out: bool,
    /// Whether the portion is so tall that it leans further than blocks may slide before it rests.
    pub sways: bool,
}

impl Levels {
    /// The last outcome, with what levels say instead of what it saw by itself; an estimate where no error is stated.
    pub fn with(self, found: Enclosure) -> Outcome {
        let error = Some(found.error).filter(|error| error.is_finite());
        let mut outcome = observing(self.last, |observed| {
            observed.bracket = Some(found.bracket);
            observed.stated_error = error;
        });
        if error.is_none() {
            outcome.status = Status::Estimate;
        }
        outcome
    }

    /// What the levels agree on, or else what the last two cover; without either no number.
    pub fn measured(self) -> Outcome {
        if let Some(found) = self.agreed.or(self.wandering) {
            return self.with(found);
        }
        let fact = match (&*self.seen, self.ran_out) {
            ([], _) => return self.last,
            (_, true) => PushoverFact::RangeUnfinished {
                so_far: self.brackets(),
            },
            _ => self.why_not(),
        };
        Outcome {
            facts: [vec![fact.into()], self.last.facts].concat(),
            work: self.last.work,
            ..Outcome::of(Status::Undecided)
        }
    }

    /// What was seen at every level.
    pub fn brackets(&self) -> Vec<Bracket> {
        self.seen.iter().map(|level| level.bracket).collect()
    }

    /// Why there is no number: what each of the levels saw.
    pub fn why_not(&self) -> PushoverFact {
        match *self.brackets() {
            [bracket] => PushoverFact::OneLevel { bracket },
            _ => PushoverFact::LevelsDisagree {
                brackets: self.brackets(),
            },
        }
    }

    /// Whether blocks had left the place where they were laid, at the last loads at rest; without any, whether the
    /// scene drifts, however short the substep.
    pub fn slides(&self) -> bool {
        let drifts = |check: &SelfCheck| check.what == Checked::Drift;
        let mut last_two = self.seen.iter().rev().take(2);
        last_two.any(|level| level.drift > SLIDE)
            || self.seen.is_empty() && failed_check(&self.last).is_some_and(drifts)
    }
}

/// Pushes a portion with shorter and shorter substeps until the brackets agree.
pub fn by_levels(scene: &Scene, portion: &Portion, asked: Asked) -> Levels {
    let tuned = &asked.tuned;
    let budget = match asked.settings.long_ranges {
        true => usize::MAX,
        false => tuned.budget,
    };
    let sizes = sizes(scene, portion, tuned);
    let mut levels = Levels {
        seen: Vec::new(),
        last: Outcome::of(Status::Undecided),
        halvings: 0,
        agreed: None,
        wandering: None,
        ran_out: false,
        sways: sizes.sways,
    };
    let swaying = tuned.levels_of_swaying.min(tuned.levels);
    let least = if sizes.sways { swaying } else { 2 };
    let (mut spent, mut halvings) = (0, 0);
    let (mut softest, mut fallen, mut doubts) = (f64::INFINITY, false, 0);
    loop {
        let trial = Trial {
            expected: levels.seen.last().map(|level| level.bracket),
            ..Trial::new(scene, portion, asked)
        };
        let outcome = trial.run(&|own| own.halved(halvings));
        let cost = outcome.work.block_steps;
        spent += cost;
        match (outcome.bracket(), outcome.evidence.stated_error()) {
            (Some(bracket), Some(target)) => {
                levels.seen.push(level(&outcome, bracket));
                levels.last = outcome;
                let halved_once = halvings == levels.halvings + 1;
                let two_suffice = halved_once && differ_in_deflection(&levels.seen, tuned);
                levels.halvings = halvings;
                let tiny = tuned.close * target * sizes.extent;
                let alike = of_one_fall(&levels.seen, sizes, tiny);
                let too_few = alike.len() + tuned.levels < least + levels.seen.len();
                let all = too_few || levels.seen.len() >= tuned.levels;
                levels.ran_out = !all && spent.saturating_add(cost) > budget;
                let ends = all || levels.ran_out;
                let agreed = agreement(alike, sizes, target, ends, tuned);
                levels.agreed = agreed.filter(|_| two_suffice || alike.len() >= least);
                let covered = wandering(&levels.seen, sizes, target, tuned);
                levels.wandering = covered.filter(|_| !sizes.sways);
                if ends || levels.agreed.is_some() {
                    break;
                }
                halvings += 1;
            }
            _ => {
                let fell = outcome.status == Status::Falls && !std::mem::replace(&mut fallen, true);
                let soft = softness(&outcome, tuned.halvings);
                let soft = soft.filter(|_| shortens(&mut softest, &outcome, tuned.shrinking));
                // Soft contacts let a scene down: shorter substeps have to see the fall too.
                // So does what rests too slowly to tell: stiffer contacts drift less.
                doubts += usize::from(is_unclear(&outcome));
                let unclear = is_unclear(&outcome) && doubts <= tuned.doubts;
                let more = if fell || unclear { Some(1) } else { soft };
                match levels.seen.is_empty() {
                    true => levels.last = outcome,
                    false => levels.last.facts = outcome.facts,
                }
                halvings += more.unwrap_or(0);
                if more.is_none() || halvings > tuned.halvings {
                    // What levels without an end cover is no answer where the next one has none.
                    levels.wandering = None;
                    break;
                }
            }
        }
    }
    let last_two = levels.seen.iter().rev().take(2);
    let jump = last_two.map(|level| level.jump).fold(0.0, f64::max);
    state_jump(&mut levels.last.facts, jump);
    levels.last.work.block_steps = spent;
    levels
}

/// What differences between levels of a portion are measured by.
fn sizes(scene: &Scene, portion: &Portion, tuned: &Tuned) -> Sizes {
    let model = Model::new(scene, portion, tuned);
    Sizes {
        unit: portion.multiplier_unit(scene),
        sways: (model.as_ref()).is_ok_and(|model| model.courses >= tuned.swaying),
        extent: model.map_or(1.0, |model| model.extent),
    }
}

/// Times that the substep has to be halved for contacts that are stiff enough, where a self-check
/// says that they are not: deflections fall with the square of the substep.
fn softness(outcome: &Outcome, most: u32) -> Option<u32> {
    let failed = failed_check(outcome)?;
    let soft = matches!(failed.what, Checked::Settlement | Checked::Drift);
    let times = (failed.value / failed.limit).sqrt().log2().ceil();
    (soft && times.is_finite()).then(|| (times as u32).clamp(1, most))
}

/// The self-check that took a number away.
fn failed_check(outcome: &Outcome) -> Option<&SelfCheck> {
    outcome.facts.iter().find_map(|fact| match fact {
        Fact::Pushover(PushoverFact::SelfCheckFailed(check)) => Some(check),
        _ => None,
    })
}

/// Whether shorter substeps bring a figure down, `before` being the last one: a drift that they do
/// not shorten is the scene's own.
fn shortens(before: &mut f64, outcome: &Outcome, shrinking: f64) -> bool {
    let figure = failed_check(outcome).map_or(f64::INFINITY, |check| check.value);
    let shorter = figure <= shrinking * *before;
    *before = figure;
    shorter
}

/// Says how large the larger jump of two runs is, instead of what one of them saw.
pub fn state_jump(facts: &mut Vec<Fact>, part: f64) {
    facts.retain(|fact| !matches!(fact, Fact::Pushover(PushoverFact::Jumps { .. })));
    facts.extend((part > 0.0).then(|| Fact::from(PushoverFact::Jumps { part })));
}

/// Part of the work of the push that goes into motion where a scene falls in a jump; 0 where it does not.
pub fn jump_of(facts: &[Fact]) -> f64 {
    let part = |fact: &Fact| match fact {
        Fact::Pushover(PushoverFact::Jumps { part }) => *part,
        _ => 0.0,
    };
    facts.iter().map(part).fold(0.0, f64::max)
}

/// What a level saw beside its bracket: how far the scene moved is the figure of the check on drift.
fn level(outcome: &Outcome, bracket: Bracket) -> Level {
    let mut checks = outcome.evidence.checks().iter();
    let drift = checks.find(|check| check.what == Checked::Drift);
    Level {
        bracket,
        drift: drift.map_or(f64::INFINITY, |check| check.value),
        jump: jump_of(&outcome.facts),
    }
}
