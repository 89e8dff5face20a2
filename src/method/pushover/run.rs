//! One pushover of one scene: search, self-checks, outcome.

use super::checks::{failed, of_rest, of_settled, sees_joints};
use super::measure;
use super::model::Model;
use super::observing::observing;
use super::parameters::{Asked, Parameters};
use super::parts::weakest;
use super::physics::{BodyState, Physics};
use super::portion::{Portion, beyond_stagger};
use super::search::{Observation, RestState, SearchEnd, search};
use crate::answer::{
    Bracket, Checked, Fact, Observed, Outcome, PushoverFact, Recording, SelfCheck, Status, Work,
};
use crate::mechanics::{Mechanism, Motion, crack_slope_by_gap};
use crate::method::PushoverSettings;
use crate::scene::{Scene, Vector};
use nalgebra::Rotation2;

/// Natural frequency of the contacts times the substep beyond which walls jitter, with a margin
/// for rounding.
const MOST_STIFF: f64 = 0.2501;

/// One pushover of a portion of a scene.
pub struct Trial<'a> {
    /// The scene.
    pub scene: &'a Scene,
    /// What of it is pushed.
    pub portion: &'a Portion,
    /// What is asked of all pushovers of the scene.
    pub asked: Asked<'a>,
    /// Where another pushover saw the collapse: a hint of where to look.
    pub expected: Option<Bracket>,
}

impl<'a> Trial<'a> {
    /// Of a scene of which nobody has seen the collapse.
    pub fn new(scene: &'a Scene, portion: &'a Portion, asked: Asked<'a>) -> Self {
        Self {
            scene,
            portion,
            asked,
            expected: None,
        }
    }

    /// The outcome with parameters changed. A scene that neither rests nor falls rattles, because its
    /// friction is not solved to the end: it is pushed again with more sweeps.
    pub fn run(&self, change: &impl Fn(Parameters) -> Parameters) -> Outcome {
        let (mut more, mut spent) = (0, 0);
        loop {
            let mut outcome = self.set_free(&|own| {
                let own = change(own);
                let stabilization = own.stabilization + more;
                Parameters {
                    stabilization,
                    ..own
                }
            });
            spent += outcome.work.block_steps;
            more += 1;
            if more > self.asked.tuned.more_sweeps || !is_unclear(&outcome) {
                outcome.work.block_steps = spent;
                return outcome;
            }
        }
    }

    /// The outcome with parameters changed. A part that was held fixed and might have moved is set
    /// free, and the pushover repeated.
    fn set_free(&self, change: &impl Fn(Parameters) -> Parameters) -> Outcome {
        let Some(portion) = beyond_stagger(self.scene, self.portion, &self.asked.tuned) else {
            return run(self, self.portion, change).0;
        };
        let (outcome, moved) = run(self, &portion, change);
        if !moved {
            return outcome;
        }
        let spent = outcome.work.block_steps;
        let mut outcome = run(self, self.portion, change).0;
        outcome.work.block_steps += spent;
        outcome
    }
}

/// One pushover of a single level, whose error nothing measures, with its parameters changed: for comparisons,
/// and where a user asks for substeps of a certain length.
pub fn solve_with(
    scene: &Scene,
    settings: &PushoverSettings,
    change: impl Fn(Parameters) -> Parameters,
) -> Outcome {
    weakest(scene, |portion| {
        Trial::new(scene, portion, Asked::new(settings)).run(&change)
    })
}

/// Whether the scene neither rested nor fell in time, under its weight alone or under a push.
pub fn is_unclear(outcome: &Outcome) -> bool {
    use PushoverFact::{NotSettled, Unclear};
    let unclear = |fact: &Fact| matches!(fact, Fact::Pushover(Unclear { .. } | NotSettled { .. }));
    outcome.facts.iter().any(unclear)
}

/// One search, and whether what is held fixed might have moved.
fn run(
    trial: &Trial,
    portion: &Portion,
    change: &impl Fn(Parameters) -> Parameters,
) -> (Outcome, bool) {
    let scene = trial.scene;
    let undecided = |fact: PushoverFact| Outcome::without_number(Status::Undecided, fact);
    let model = match Model::new(scene, portion, &trial.asked.tuned) {
        Ok(model) => model,
        Err(fact) => return (undecided(fact), false),
    };
    let parameters = change(Parameters::new(&model, &trial.asked));
    if parameters.contact_frequency * parameters.substep > MOST_STIFF {
        return (undecided(PushoverFact::TooStiff), false);
    }
    let mut physics = Physics::new(&model, &parameters);
    let laid = physics.states();
    physics.step();
    let sees = sees_joints(&model, &physics.contacts());
    if !sees.passed() {
        return (undecided(PushoverFact::Checked(sees)), false);
    }
    let slip = |from: &[BodyState], to: &[BodyState]| {
        let rates = mechanism(&model, from, to).joint_rates(scene);
        let slips = rates.iter().map(|rate| rate.slip.abs() / model.length);
        slips.fold(0.0, f64::max)
    };
    let mut checks = vec![sees];
    let refused = |settled: &RestState| {
        checks.extend(of_settled(&model, &parameters, &laid, settled));
        failed(&parameters, &checks)
    };
    let mut moved = portion.holds_any();
    let expected = trial.expected.map(|at| model.in_grid(at));
    let mut outcome = match search(&mut physics, &model, &parameters, expected, refused, slip) {
        SearchEnd::Bracketed(seen) => {
            let states = [&seen.settled.states[..], &seen.collapsed];
            moved &= strip_moved(&model, parameters.still, states);
            checks.extend(of_rest(&model, &parameters, &seen));
            match failed(&parameters, &checks) {
                Some(fact) => undecided(fact),
                None => collapsed(&model, &parameters, &seen),
            }
        }
        SearchEnd::Undecided(fact) => {
            // With more blocks free, it would settle further.
            let settles = |check: &SelfCheck| check.what == Checked::Settlement;
            moved &= !matches!(&fact, PushoverFact::SelfCheckFailed(check) if settles(check));
            undecided(fact)
        }
        SearchEnd::Falls(fact) => Outcome::without_number(Status::Falls, fact),
    };
    outcome = observing(outcome, |observed| observed.checks = checks);
    outcome.work = Work {
        block_steps: physics.steps * parameters.substeps * model.blocks.len(),
        ..Work::default()
    };
    (outcome, moved)
}

/// Whether any block beside those held fixed moved between two states.
fn strip_moved(model: &Model, still: f64, [from, to]: [&[BodyState]; 2]) -> bool {
    let limit = still * measure::displacement(model, from, to);
    let mut blocks = model.blocks.iter().zip(from.iter().zip(to));
    blocks.any(|(block, (from, to))| {
        model.portion.is_in_strip(block.index)
            && block.smallness * measure::moved(block, from, to) > limit
    })
}

/// The outcome of a bracket.
fn collapsed(model: &Model, parameters: &Parameters, seen: &Observation) -> Outcome {
    let moved = |frame: &Vec<BodyState>| mechanism(model, &seen.settled.states, frame);
    let mechanism = mechanism(model, &seen.onset, &seen.collapsed);
    let observed = Observed {
        bracket: Some(Bracket {
            lower: model.lambda(seen.loads[0]),
            upper: model.lambda(seen.loads[1]),
        }),
        stated_error: Some(parameters.stated_error),
        crack: crack_slope_by_gap(model.scene, &mechanism),
        mechanism: Some(mechanism),
        recording: seen.fall.as_ref().map(|fall| Recording {
            frames: fall.frames.iter().map(moved).collect(),
            interval: fall.interval * model.length.sqrt(),
        }),
        ..Observed::default()
    };
    let jumps = seen.jump > parameters.stated_error;
    let fact = jumps.then(|| PushoverFact::Jumps { part: seen.jump }.into());
    Outcome {
        facts: fact.into_iter().collect(),
        ..Outcome::with(Status::Bracketed, observed)
    }
}

/// Displacements from one state to another, in the scene's length unit.
fn mechanism(model: &Model, from: &[BodyState], to: &[BodyState]) -> Mechanism {
    let mut motions = vec![Motion::default(); model.scene.blocks().len()];
    for ((a, b), block) in from.iter().zip(to).zip(&model.blocks) {
        let mut moved = Vector::new(b.position[0] - a.position[0], b.position[1] - a.position[1]);
        if block.is_pinned {
            let arm =
                |state: &BodyState| Rotation2::new(state.rotation) * Vector::from(block.centroid);
            moved += arm(b) - arm(a);
        }
        motions[block.index] = Motion {
            velocity: moved * model.length,
            rotation: b.rotation - a.rotation,
        };
    }
    Mechanism { motions }
}
