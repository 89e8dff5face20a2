//! Runs methods on scenes: the one runner of `run`, sweeps, charts and atlas. The only place with a
//! clock.

use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Mutex, OnceLock};

use cpu_time::ThreadTime;
use rayon::prelude::*;

use crate::answer::{Bracket, Outcome, Status};
use crate::case::Case;
use crate::judge::{Check, cross_check, judge, open_never_raises, reference_checks};
use crate::method::{Method, Settings};
use crate::scene::{HeadJoints, Push, Scene};

/// One method on one wall.
#[derive(Clone, Copy)]
pub struct Task<'a> {
    /// The scene; or one a direction, where the wall is pushed both ways and the weaker side counts.
    pub sides: &'a [Scene],
    /// The method.
    pub method: &'a dyn Method,
    /// Its settings.
    pub settings: Settings,
}

/// The judged answer of one task.
#[derive(Clone, Debug)]
pub struct Answer {
    /// The answer, its status set by the judge.
    pub outcome: Outcome,
    /// Which of the task's sides it is about.
    pub side: usize,
    /// Residual that the judge computed, where there was something to judge.
    pub residual: Option<f64>,
    /// CPU time of the method over all sides, seconds.
    pub seconds: f64,
}

/// Runs one task and judges it.
///
/// # Panics
/// Where the task has no scene.
pub fn solve(task: &Task) -> Answer {
    let answers = task.sides.iter().enumerate().map(|(side, scene)| {
        let clock = ThreadTime::now();
        let (mut outcome, apart) = task.method.solve_apart(scene, &task.settings);
        let seconds = apart.unwrap_or_else(|| clock.elapsed()).as_secs_f64();
        let residual = judge(scene, &mut outcome);
        Answer {
            outcome,
            side,
            residual,
            seconds,
        }
    });
    let answers: Vec<Answer> = answers.collect();
    weaker(task.sides, answers)
}

/// Runs tasks on all cores. `finished` is called after each; answers keep the order of the tasks.
pub fn solve_all(tasks: &[Task], finished: impl Fn(usize, &Answer) + Sync) -> Vec<Answer> {
    let solved = tasks.par_iter().enumerate().map(|(index, task)| {
        let answer = solve(task);
        finished(index, &answer);
        answer
    });
    solved.collect()
}

/// Does the pieces of work of these indices, each as soon as a core is free, in the order given:
/// where long ones come first, no core waits for another at the end.
pub fn in_turn(order: &[usize], work: impl Fn(usize) + Sync) {
    let next = AtomicUsize::new(0);
    let take_turns = || {
        while let Some(&index) = order.get(next.fetch_add(1, Ordering::Relaxed)) {
            work(index);
        }
    };
    rayon::scope(|scope| {
        for _ in 0..rayon::current_num_threads().min(order.len()) {
            scope.spawn(|_| take_turns());
        }
    });
}

/// Multipliers nearer than this, relative to the larger, are those of sides alike.
const ALIKE: f64 = 1e-6;

/// The answer of the side that gives way first. A side without an honest answer leaves the wall
/// without one, as it may be the weaker.
fn weaker(sides: &[Scene], mut answers: Vec<Answer>) -> Answer {
    let seconds = answers.iter().map(|answer| answer.seconds).sum();
    let works: Vec<_> = answers.iter().map(|answer| answer.outcome.work).collect();
    let rank = |answer: &Answer| match (answer.outcome.status, answer.outcome.bracket) {
        (Status::Failed, _) => (0, 0.0),
        (Status::Falls, _) => (1, 0.0),
        (Status::Stands, _) => (4, 0.0),
        (_, Some(bracket)) => (3, bracket.lower),
        (_, None) => (2, 0.0),
    };
    // Of sides that differ by rounding alone, the first: it must not depend on the machine.
    let margin = |lambda: f64| ALIKE * lambda.abs().max(1e-3);
    let weaker = |a: &Answer, b: &Answer| {
        let ((a, x), (b, y)) = (rank(a), rank(b));
        a < b || a == b && x < y - margin(y)
    };
    let mut first = 0;
    for side in 1..answers.len() {
        if weaker(&answers[side], &answers[first]) {
            first = side;
        }
    }
    let mut answer = answers.swap_remove(first);
    let alike = answers.iter().all(|other| !weaker(&answer, other));
    if let [_, _, ..] = sides {
        let side = match sides[answer.side].push() {
            Push::Right => "pushed right",
            Push::Left => "pushed left",
        };
        let reason = match (answer.outcome.bracket, answer.outcome.reason().as_str()) {
            (Some(_), reason) => {
                let which = match alike {
                    true => "alike when pushed right and left".to_owned(),
                    false => format!("weaker when {side}"),
                };
                let part = if reason.is_empty() { "" } else { "; " };
                format!("{which}{part}{reason}")
            }
            (None, reason) => format!("{side}: {reason}"),
        };
        answer.outcome.facts = vec![reason.into()];
        answer.outcome.work = works.into_iter().fold(Default::default(), |a, b| a + b);
    }
    Answer { seconds, ..answer }
}

/// The judged answer of one method for one scene of a case.
#[derive(Clone, Debug)]
pub struct Row {
    /// Head joints of the scene.
    pub head_joints: HeadJoints,
    /// Name of the method.
    pub method: String,
    /// Which of the scene's sides the answer is about.
    pub side: usize,
    /// The answer, its status set by the judge.
    pub outcome: Outcome,
    /// Residual that the judge computed, where there was something to judge.
    pub residual: Option<f64>,
    /// CPU time of the method, seconds.
    pub seconds: f64,
}

impl Row {
    fn new(head_joints: HeadJoints, method: &str, answer: &Answer) -> Self {
        Self {
            head_joints,
            method: method.to_owned(),
            side: answer.side,
            outcome: answer.outcome.clone(),
            residual: answer.residual,
            seconds: answer.seconds,
        }
    }
}

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
}

impl CaseResult {
    /// The scene that a row's answer is about.
    ///
    /// # Panics
    /// Where the row is of another result.
    pub fn scene(&self, row: &Row) -> &Scene {
        let mut scenes = self.scenes.iter();
        let found = scenes.find(|(head_joints, _)| *head_joints == row.head_joints);
        &found.expect("the row is of this result").1[row.side]
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
    /// Number of method runs for these cases.
    pub fn runs(&self, cases: &[Case]) -> usize {
        let scenes: usize = cases.iter().map(|case| self.scenes(case).len()).sum();
        scenes * self.methods.len()
    }

    fn scenes(&self, case: &Case) -> Vec<HeadJoints> {
        self.head_joints
            .map_or_else(|| case.head_joints.clone(), |only| vec![only])
    }
}

/// Runs every method of the plan on every scene of every case, on all cores, and judges them.
/// `finished` is called with case and method after each run; results keep the order of the cases.
pub fn run(cases: &[Case], plan: &Plan, finished: impl Fn(&str, &str) + Sync) -> Vec<CaseResult> {
    let results: Vec<OnceLock<CaseResult>> = cases.iter().map(|_| OnceLock::new()).collect();
    run_each(cases, plan, finished, |index, result| {
        let first = results[index].set(result);
        first.expect("a case is complete once");
    });
    let complete = results.into_iter().filter_map(OnceLock::into_inner);
    complete.collect()
}

/// As [`run`], handing over each case's result, with the index of the case, as soon as its last
/// method has finished: what is complete outlives an interruption. Without methods, every case is
/// complete at once.
pub fn run_each(
    cases: &[Case],
    plan: &Plan,
    finished: impl Fn(&str, &str) + Sync,
    complete: impl Fn(usize, CaseResult) + Sync,
) {
    let scenes: Vec<Vec<(HeadJoints, Vec<Scene>)>> = cases
        .iter()
        .map(|case| {
            let settings = plan.scenes(case).into_iter();
            settings.map(|head| (head, case.sides(head))).collect()
        })
        .collect();
    let (mut of_task, mut tasks) = (Vec::new(), Vec::new());
    let mut rows: Vec<Mutex<Vec<Option<Row>>>> = Vec::new();
    for (index, of_case) in scenes.iter().enumerate() {
        let first = tasks.len();
        for &method in &plan.methods {
            for (head_joints, sides) in of_case {
                of_task.push((index, tasks.len() - first, *head_joints));
                tasks.push(Task {
                    sides,
                    method,
                    settings: plan.settings,
                });
            }
        }
        rows.push(Mutex::new(vec![None; tasks.len() - first]));
    }
    let hand_over = |index: usize, rows: Vec<Row>| {
        let (case, scenes) = (cases[index].clone(), scenes[index].clone());
        let checks = check(&case, &scenes, &rows);
        complete(
            index,
            CaseResult {
                case,
                scenes,
                rows,
                checks,
            },
        );
    };
    if plan.methods.is_empty() {
        (0..cases.len()).for_each(|index| hand_over(index, Vec::new()));
    }
    solve_all(&tasks, |task, answer| {
        let (index, place, head_joints) = of_task[task];
        let method = tasks[task].method.name();
        finished(&cases[index].name, method);
        let mut of_case = rows[index].lock().expect("no other thread panicked");
        of_case[place] = Some(Row::new(head_joints, method, answer));
        if of_case.iter().all(Option::is_some) {
            let of_case = std::mem::take(&mut *of_case);
            hand_over(index, of_case.into_iter().flatten().collect());
        }
    });
}

fn check(case: &Case, scenes: &[(HeadJoints, Vec<Scene>)], rows: &[Row]) -> Vec<Check> {
    let mut checks = Vec::new();
    for (head_joints, sides) in scenes {
        let answers = |side: Option<usize>| -> Vec<(&str, &Outcome)> {
            let of_scene = rows.iter().filter(|row| row.head_joints == *head_joints);
            let of_side = of_scene.filter(|row| side.is_none_or(|side| row.side == side));
            of_side
                .map(|row| (row.method.as_str(), &row.outcome))
                .collect()
        };
        // What holds between methods holds for one and the same scene.
        for side in 0..sides.len() {
            checks.extend(cross_check(*head_joints, &answers(Some(side))));
        }
        checks.extend(reference_checks(case, *head_joints, &answers(None)));
    }
    let associative = |head_joints| -> Option<Bracket> {
        let mut found = rows.iter().filter(|row| row.method == "associative");
        found
            .find(|row| row.head_joints == head_joints)?
            .outcome
            .bracket
    };
    let (contact, open) = (
        associative(HeadJoints::Contact),
        associative(HeadJoints::Open),
    );
    checks.extend(open_never_raises(contact, open));
    checks
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::{Piece, Wall};

    /// Answers what the direction of the push says.
    struct Told([fn() -> Outcome; 2]);

    impl Method for Told {
        fn name(&self) -> &str {
            "told"
        }

        fn solve(&self, scene: &Scene, _settings: &Settings) -> Outcome {
            self.0[usize::from(scene.push() == Push::Left)]()
        }
    }

    fn sides() -> [Scene; 2] {
        [Push::Right, Push::Left].map(|push| {
            let wall = Wall {
                unit_length: 1.0,
                unit_height: 1.0,
                thickness: 1.0,
                unit_weight: 1.0,
                courses: vec![vec![Piece::Unit]],
                friction: 0.5.into(),
                overburden: 0.0,
                push,
            };
            wall.scene(HeadJoints::Open).unwrap()
        })
    }

    fn at(lambda: f64) -> Outcome {
        Outcome {
            bracket: Some(Bracket::point(lambda)),
            ..Outcome::without_number(Status::Estimate, "told")
        }
    }

    fn answer(told: [fn() -> Outcome; 2]) -> Answer {
        solve(&Task {
            sides: &sides(),
            method: &Told(told),
            settings: Settings::default(),
        })
    }

    #[test]
    fn the_weaker_side_answers_and_is_named() {
        let answer = answer([|| at(0.5), || at(0.4)]);
        assert_eq!(answer.outcome.bracket, Some(Bracket::point(0.4)));
        assert_eq!(answer.side, 1);
        assert_eq!(answer.outcome.reason(), "weaker when pushed left; told");
    }

    #[test]
    fn rounding_does_not_choose_a_side() {
        let answer = answer([|| at(0.5), || at(0.5 - 1e-12)]);
        assert_eq!(answer.side, 0);
        assert_eq!(
            answer.outcome.reason(),
            "alike when pushed right and left; told"
        );
    }

    #[test]
    fn a_side_that_falls_is_the_weaker_and_one_that_stands_the_stronger() {
        let of = |outcomes: [Outcome; 2]| {
            let answers = outcomes.into_iter().enumerate();
            let answers = answers.map(|(side, outcome)| Answer {
                outcome,
                side,
                residual: None,
                seconds: 0.0,
            });
            weaker(&sides(), answers.collect())
        };
        let falls = Outcome::without_number(Status::Falls, "why");
        assert_eq!(of([at(0.5), falls]).side, 1);
        let stands = Outcome::without_number(Status::Stands, "why");
        assert_eq!(of([stands, at(0.5)]).side, 1);
    }

    #[test]
    fn a_side_without_an_answer_leaves_the_wall_without_one() {
        let answer = answer([
            || at(0.5),
            || Outcome::without_number(Status::Undecided, "why"),
        ]);
        assert_eq!(answer.outcome.status, Status::Undecided);
        assert_eq!(answer.outcome.reason(), "pushed left: why");
    }
}
