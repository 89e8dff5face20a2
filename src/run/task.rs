//! One task: a method on a scene, solved, judged, and answered as a row. The only place with a clock
//! and the only place where a panic is caught.

use std::any::Any;
use std::borrow::Cow;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::time::Duration;

use cpu_time::ThreadTime;

use super::row::{Row, scene_name};
use super::sides::{OtherSide, governing};
use crate::answer::{Outcome, Status, Work};
use crate::fingerprint::Fingerprint;
use crate::judge::judge;
use crate::method::{Method, Settings, Watch, borrowed, expected_cost};
use crate::scene::{HeadJoints, JointClass, Scene};

/// Fingerprint of the sources that this program was compiled from.
const SOURCES: &str = env!("TRILITH_SOURCES");

/// Builds the scenes of a task, one a direction of the push, when its turn comes.
pub type Sides<'a> = Box<dyn Fn() -> Cow<'a, [Scene]> + Send + Sync + 'a>;

/// What a method is asked about.
pub struct Subject<'a> {
    /// Name of the case.
    pub case: String,
    /// What its head joints carry.
    pub head_joints: HeadJoints,
    /// What varies in a study, by name, in the order of the columns.
    pub parameters: Vec<(String, String)>,
    /// Number of blocks: long tasks are begun first. It decides nothing else.
    pub blocks: usize,
    /// The scenes. One a direction of the push.
    pub sides: Sides<'a>,
    /// Texts that determine these scenes: that of a case, or of the scenes themselves.
    pub determined_by: Vec<String>,
}

impl<'a> Subject<'a> {
    /// Scenes that are there already, one a direction of the push.
    ///
    /// # Panics
    /// Where there is none.
    pub fn of_scenes(case: &str, sides: &'a [Scene]) -> Self {
        Self {
            case: case.to_owned(),
            head_joints: sides[0].head_joints(),
            parameters: Vec::new(),
            blocks: sides[0].blocks().len(),
            sides: Box::new(move || Cow::Borrowed(sides)),
            determined_by: sides.iter().map(fingerprint).collect(),
        }
    }
}

/// What tells a scene from every other.
pub(crate) fn fingerprint(scene: &Scene) -> String {
    let mut of_scene = Fingerprint::new();
    // Every number of it, to the last bit.
    of_scene.add(format!("{scene:?}").as_bytes());
    of_scene.hex()
}

/// One method with its settings on one subject.
pub struct Task<'a> {
    subject: Subject<'a>,
    method: &'a dyn Method,
    settings: Settings,
    id: String,
}

impl<'a> Task<'a> {
    /// A task. Its id is the fingerprint of everything in it, and of the program's sources.
    pub fn new(subject: Subject<'a>, method: &'a dyn Method, settings: Settings) -> Self {
        let mut id = Fingerprint::new();
        let mut add = |text: &str| id.add(text.as_bytes());
        add(SOURCES);
        add(&subject.case);
        add(subject.head_joints.name());
        for (name, value) in &subject.parameters {
            add(name);
            add(value);
        }
        add(method.name());
        // Every field with its name; what it looks like can only change with the sources.
        add(&format!("{settings:?}"));
        subject.determined_by.iter().for_each(|text| add(text));
        method.determined_by().iter().for_each(|text| add(text));
        Self {
            id: id.hex(),
            method,
            subject,
            settings,
        }
    }

    /// 32 hexadecimal digits, the same on every machine.
    pub fn id(&self) -> &str {
        &self.id
    }

    /// What the method is asked about.
    pub fn subject(&self) -> &Subject<'a> {
        &self.subject
    }

    /// The method.
    pub fn method(&self) -> &dyn Method {
        self.method
    }

    /// Name of the scene in tables and files.
    pub fn scene_name(&self) -> String {
        scene_name(&self.subject.case, self.subject.head_joints)
    }

    /// What the task is, for people: case, method and parameters.
    pub fn describe(&self) -> String {
        let mut text = format!("{} {}", self.scene_name(), self.method.name());
        for (name, value) in &self.subject.parameters {
            text.push_str(&format!(" {name}={value}"));
        }
        text
    }

    /// CPU seconds that the task may take, roughly: the time left is told by it.
    pub fn expected_seconds(&self) -> f64 {
        expected_cost(self.method.name()).seconds(self.subject.blocks, self.subject.head_joints)
    }

    /// Of these, those that no second core can take off: where they are many, the task is begun early.
    pub fn seconds_alone(&self) -> f64 {
        expected_cost(self.method.name())
            .seconds_alone(self.subject.blocks, self.subject.head_joints)
    }

    /// Runs and judges the method on every side of the push; the side that governs answers.
    /// A method that panics has failed. `watch` is told of bounds that grow.
    ///
    /// # Panics
    /// Where the subject has no scene.
    pub fn run(&self, watch: &dyn Watch) -> Row {
        let scenes = (self.subject.sides)();
        let answers = scenes.iter().map(|scene| self.answer(scene, watch));
        let answers: Vec<_> = answers.collect();
        let seconds = answers.iter().map(|(_, seconds)| seconds).sum();
        let work = answers.iter().map(|(side, _)| side.outcome.work);
        let work = work.fold(Work::default(), |sum, work| sum + work);
        let answers = answers.into_iter().map(|(side, _)| side).collect();
        let (own, other) = governing(answers, scenes[0].multiplier_unit());
        let of_push = scenes.iter().find(|scene| scene.push() == own.push);
        let scene = of_push.expect("it has answered");
        Row {
            id: self.id.clone(),
            case: self.subject.case.clone(),
            head_joints: self.subject.head_joints,
            push: scene.push(),
            method: self.method.name().to_owned(),
            parameters: self.subject.parameters.clone(),
            friction: friction(scene),
            blocks: scene.blocks().len(),
            joints: scene.joints().len(),
            multiplier_unit: scene.multiplier_unit(),
            reaction: scene.reaction().cloned(),
            outcome: Outcome {
                work,
                ..*own.outcome
            },
            other,
            residuals: own.residuals,
            crack: own.crack,
            seconds,
            references: Vec::new(),
            demand: None,
            verdict: None,
        }
    }

    /// The judged answer for one side, and its CPU seconds.
    fn answer(&self, scene: &Scene, watch: &dyn Watch) -> (OtherSide, f64) {
        let (clock, before) = (ThreadTime::now(), borrowed());
        let elapsed = || {
            let seconds = clock.elapsed().as_secs_f64() + borrowed() - before;
            Duration::from_secs_f64(seconds.max(0.0))
        };
        let solved = catch_unwind(AssertUnwindSafe(|| {
            let (mut outcome, spent) = self.method.solve_watched(scene, &self.settings, watch);
            let spent = spent.unwrap_or_else(elapsed);
            let residuals = judge(scene, &mut outcome).residuals;
            (outcome, residuals, spent)
        }));
        let (outcome, residuals, spent) = solved.unwrap_or_else(|panic| {
            let failed = Outcome::without_number(Status::Failed, panicked(&*panic));
            (failed, Vec::new(), elapsed())
        });
        let side = OtherSide {
            push: scene.push(),
            crack: outcome.evidence.crack(scene),
            outcome: Box::new(outcome),
            residuals,
        };
        (side, spent.as_secs_f64())
    }
}

/// A method's judged answer on scenes of no case: one scene, or one a direction of the push, of which
/// the one that governs answers.
///
/// # Panics
/// Where there is no scene.
pub fn answer(sides: &[Scene], method: &dyn Method, settings: Settings) -> Row {
    Task::new(Subject::of_scenes("", sides), method, settings).run(&())
}

/// Least and largest coefficient of friction of the joints.
fn friction(scene: &Scene) -> Option<[f64; 2]> {
    let joints = scene.joints().iter();
    let joints = joints.filter(|joint| joint.class != JointClass::Guide);
    let of_joints = joints.map(|joint| joint.friction);
    let widened = |range: [f64; 2], mu: f64| [range[0].min(mu), range[1].max(mu)];
    let first = of_joints.clone().next()?;
    Some(of_joints.fold([first; 2], widened))
}

/// What a panic said, in words.
fn panicked(panic: &(dyn Any + Send)) -> String {
    let text = panic.downcast_ref::<String>().map(String::as_str);
    let text = text.or_else(|| panic.downcast_ref::<&str>().copied());
    let words: Vec<&str> = text
        .unwrap_or("without a word")
        .split_whitespace()
        .collect();
    format!("the method panicked: {}", words.join(" "))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::method::METHODS;

    fn id(case: &str, parameter: &str, method: usize, starts: &str, text: &str) -> String {
        let subject = Subject {
            case: case.into(),
            head_joints: HeadJoints::Contact,
            parameters: vec![("friction".into(), parameter.into())],
            blocks: 1,
            sides: Box::new(|| Cow::Owned(Vec::new())),
            determined_by: vec![text.into()],
        };
        let mut settings = Settings::default();
        settings.set("starts", starts).unwrap();
        Task::new(subject, METHODS[method].method, settings)
            .id()
            .into()
    }

    #[test]
    fn the_id_tells_whatever_determines_the_answer() {
        let mut ids = vec![
            id("a", "0.5", 0, "2", "x"),
            id("b", "0.5", 0, "2", "x"),
            id("a", "0.6", 0, "2", "x"),
            id("a", "0.5", 1, "2", "x"),
            id("a", "0.5", 0, "3", "x"),
            id("a", "0.5", 0, "2", "y"),
        ];
        assert_eq!(ids[0], id("a", "0.5", 0, "2", "x"));
        ids.sort();
        ids.dedup();
        assert_eq!(ids.len(), 6);
    }
}
