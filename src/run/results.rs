//! Cases: every method of a plan on every scene, as rows with the checks about them.

use std::sync::Mutex;

use super::progress::Progress;
use super::row::Row;
use super::schedule::{InOrder, longest_first};
use super::task::{Subject, Task};
use crate::answer::Outcome;
use crate::case::Case;
use crate::judge::{Check, Conclusion, conclude, cross_check, open_never_raises, reference_checks};
use crate::method::{Method, Settings};
use crate::scene::{HeadJoints, Push, Scene};

/// Everything about one case.
#[derive(Clone, Debug)]
pub struct CaseResult {
    /// The case.
    pub case: Case,
    /// What was run for each head-joint setting: one scene a direction of the push.
    pub scenes: Vec<(HeadJoints, Vec<Scene>)>,
    /// One row a method and head-joint setting, methods in their own order, then contact before
    /// open.
    pub rows: Vec<Row>,
    /// The cross-check and the references.
    pub checks: Vec<Check>,
    /// What it all comes to, one a head-joint setting.
    pub conclusions: Vec<Conclusion>,
}

impl CaseResult {
    /// The scene that a row's answer is about.
    ///
    /// # Panics
    /// Where the row is of another result.
    pub fn scene(&self, row: &Row) -> &Scene {
        self.side(row.head_joints, row.push)
    }

    /// The scene of a head-joint setting and a direction of the push.
    ///
    /// # Panics
    /// Where it did not run.
    pub fn side(&self, head_joints: HeadJoints, push: Push) -> &Scene {
        let scenes = self.scenes.iter();
        let mut of_setting = scenes.filter(|(setting, _)| *setting == head_joints);
        let sides = of_setting.next().map(|(_, sides)| sides.as_slice());
        let mut sides = sides.unwrap_or_default().iter();
        let scene = sides.find(|scene| scene.push() == push);
        scene.expect("this side ran")
    }

    fn new(case: Case, scenes: Vec<(HeadJoints, Vec<Scene>)>, mut rows: Vec<Row>) -> Self {
        let checks = checks(&case, &scenes, &rows);
        rows.iter_mut().for_each(|row| row.compare(&case, &checks));
        let conclusions = conclusions(&scenes, &rows);
        Self {
            case,
            scenes,
            rows,
            checks,
            conclusions,
        }
    }
}

/// What to run.
#[derive(Clone)]
pub struct Plan<'a> {
    /// The methods, in the order of the rows.
    pub methods: Vec<&'a dyn Method>,
    /// Settings of the methods.
    pub settings: Settings,
    /// Head joints instead of the case's own.
    pub head_joints: Option<HeadJoints>,
}

impl Plan<'_> {
    /// The scenes of a case: one a direction of the push for each head-joint setting.
    fn scenes(&self, case: &Case) -> Vec<(HeadJoints, Vec<Scene>)> {
        let settings = match self.head_joints {
            Some(only) => vec![only],
            None => case.head_joints.clone(),
        };
        let sides = settings.into_iter().map(|head| (head, case.sides(head)));
        sides.collect()
    }
}

/// The results of cases while they run.
pub type Results = InOrder<CaseResult>;

/// Runs every method of the plan on every scene of every case, on all cores, and judges them.
pub fn run(cases: &[Case], plan: &Plan, progress: &dyn Progress) -> Vec<CaseResult> {
    let results = Results::default();
    run_into(&results, cases, plan, progress, &|_| {});
    results.take().0
}

/// As [`run`], putting each case's result where others can take it before the last is done: what is
/// complete outlives an interruption. `show` gets each result as soon as those before it are
/// shown. Without methods, every case is complete at once.
pub fn run_into(
    results: &Results,
    cases: &[Case],
    plan: &Plan,
    progress: &dyn Progress,
    show: &(dyn Fn(&CaseResult) + Sync),
) {
    let scenes: Vec<_> = cases.iter().map(|case| plan.scenes(case)).collect();
    let (mut tasks, mut places, mut open) = (Vec::new(), Vec::new(), Vec::new());
    for (index, (case, of_case)) in cases.iter().zip(&scenes).enumerate() {
        let first = tasks.len();
        for &method in &plan.methods {
            for (head_joints, sides) in of_case {
                let subject = Subject {
                    head_joints: *head_joints,
                    ..Subject::of_scenes(&case.name, sides)
                };
                places.push((index, tasks.len() - first));
                tasks.push(Task::new(subject, method, plan.settings));
            }
        }
        let rows: Vec<Option<Row>> = vec![None; tasks.len() - first];
        open.push(Mutex::new(rows));
    }
    let complete = |index: usize, rows: Vec<Row>| {
        let result = CaseResult::new(cases[index].clone(), scenes[index].clone(), rows);
        results.add(index, result, |result| show(result));
    };
    if plan.methods.is_empty() {
        (0..cases.len()).for_each(|index| complete(index, Vec::new()));
    }
    let seconds: Vec<f64> = tasks.iter().map(Task::expected_seconds).collect();
    progress.expected(seconds.iter().sum());
    longest_first(&seconds, |task| {
        let row = tasks[task].run();
        progress.done(&tasks[task], &row);
        let (index, place) = places[task];
        let rows = {
            let mut open = open[index].lock().expect("a task's panic is a row");
            open[place] = Some(row);
            let all_there = open.iter().all(Option::is_some);
            all_there.then(|| std::mem::take(&mut *open))
        };
        if let Some(rows) = rows {
            complete(index, rows.into_iter().flatten().collect());
        }
    });
}

/// The answers of a head-joint setting.
fn answers(rows: &[Row], head_joints: HeadJoints) -> Vec<(&str, &Outcome)> {
    let of_setting = rows.iter().filter(|row| row.head_joints == head_joints);
    of_setting
        .map(|row| (row.method.as_str(), &row.outcome))
        .collect()
}

fn checks(case: &Case, scenes: &[(HeadJoints, Vec<Scene>)], rows: &[Row]) -> Vec<Check> {
    let mut checks = Vec::new();
    for (head_joints, sides) in scenes {
        // What holds between methods holds for one and the same scene.
        for scene in sides {
            let of_side = rows
                .iter()
                .filter(|row| row.head_joints == *head_joints && row.push == scene.push());
            let of_side: Vec<_> = of_side
                .map(|row| (row.method.as_str(), &row.outcome))
                .collect();
            checks.extend(cross_check(scene, &of_side));
        }
        let unit = sides.first().map_or(1.0, Scene::multiplier_unit);
        let answers = answers(rows, *head_joints);
        checks.extend(reference_checks(case, *head_joints, &answers, unit));
    }
    let scene = |wanted| {
        let found = scenes
            .iter()
            .find(|(head_joints, _)| *head_joints == wanted);
        found.and_then(|(_, sides)| sides.first())
    };
    let both = scene(HeadJoints::Contact).zip(scene(HeadJoints::Open));
    if let Some((contact, open)) = both {
        checks.extend(open_never_raises(
            (contact, &answers(rows, HeadJoints::Contact)),
            (open, &answers(rows, HeadJoints::Open)),
        ));
    }
    checks
}

fn conclusions(scenes: &[(HeadJoints, Vec<Scene>)], rows: &[Row]) -> Vec<Conclusion> {
    let with_sides = scenes.iter().filter_map(|(head_joints, sides)| {
        let scene = sides.first()?;
        Some(conclude(scene, &answers(rows, *head_joints)))
    });
    with_sides.collect()
}
