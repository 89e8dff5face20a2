//! The table behind the picture: case × method × setting, each timed until its median is stable.

use std::borrow::Cow;
use std::io;

use super::ladder::{Step, ladder};
use super::reference;
use crate::answer::{Status, magnitude};
use crate::case::{Case, Reference};
use crate::method::Method;
use crate::run::{self, Progress, Row, Subject, Task, Value, values};
use crate::scene::HeadJoints;
use crate::study::sweep;

/// One point of the chart.
#[derive(Clone, Debug)]
pub struct Measurement {
    /// The answer; its time is the median of all runs.
    pub row: Row,
    /// Number of runs that the median is of.
    pub runs: usize,
    /// What the scene's answers are measured against.
    pub reference: Option<Reference>,
}

impl Measurement {
    /// Error of an answer: the farther end of the bracket from the reference, relative to it. `None`
    /// where there is no answer: `undecided`, `failed` and the like.
    pub fn error(&self) -> Option<f64> {
        let answered = matches!(
            self.row.status(),
            Status::Verified | Status::Bracketed | Status::Estimate
        );
        let bracket = self.row.bracket().filter(|_| answered)?;
        Some(bracket.error(self.reference.as_ref()?.value, self.row.multiplier_unit))
    }

    /// Distance of the nearer end, relative to the reference; 0 where it lies in the bracket.
    pub fn nearest(&self) -> Option<f64> {
        let (bracket, known) = (self.row.bracket()?, self.reference.as_ref()?.value);
        let outside = (bracket.lower - known).max(known - bracket.upper).max(0.0);
        Some(outside / magnitude(known, self.row.multiplier_unit))
    }

    /// What is not as by default.
    pub fn setting(&self) -> &str {
        self.row.parameter(SETTING).unwrap_or_default()
    }

    /// Method and setting for people.
    pub fn name(&self) -> String {
        match self.setting() {
            "default" => self.row.method.clone(),
            setting => format!("{} {setting}", self.row.method),
        }
    }
}

/// Names of the parameters of a task: what is not as by default, and which run of several it is.
const SETTING: &str = "setting";
const REPEAT: &str = "repeat";

/// CPU time that the runs of one entry fill together, seconds, and how many they are at most.
const FILL: f64 = 0.4;
const MOST_RUNS: usize = 9;

/// Runs every step on every scene of the cases that has a reference, through the sweep's runner:
/// once, then quick ones again until their median is stable.
///
/// # Errors
/// Never without a journal; the sweep's runner says so for one.
pub fn run(
    cases: &[Case],
    head_joints: Option<HeadJoints>,
    externals: &[&'static dyn Method],
    progress: &dyn Progress,
) -> io::Result<Vec<Measurement>> {
    let mut first = Vec::new();
    for case in cases {
        for &of_case in &case.head_joints {
            if head_joints.is_some_and(|only| only != of_case) || reference(case, of_case).is_none()
            {
                continue;
            }
            let blocks = case.scene(of_case).blocks().len();
            for step in ladder(blocks, externals) {
                first.push(Planned {
                    case,
                    head_joints: of_case,
                    blocks,
                    step,
                });
            }
        }
    }
    let tasks: Vec<Task> = first.iter().map(|planned| planned.task(0)).collect();
    let rows = sweep::run(&tasks, None, progress)?;
    let mut again = Vec::new();
    for (planned, row) in first.iter().zip(&rows) {
        let runs = (FILL / row.seconds.max(1e-9)).min(MOST_RUNS as f64) as usize;
        again.extend((1..runs).map(|repeat| planned.task(repeat)));
    }
    let repeated = sweep::run(&again, None, progress)?;
    let mut repeated = repeated.into_iter().peekable();
    let mut entries = Vec::new();
    for (planned, row) in first.iter().zip(rows) {
        let mut seconds = vec![row.seconds];
        while let Some(next) = repeated.next_if(|next| same(next, &row)) {
            seconds.push(next.seconds);
        }
        entries.push(planned.entry(row, &mut seconds));
    }
    Ok(entries)
}

/// Whether two rows are runs of one entry.
fn same(a: &Row, b: &Row) -> bool {
    a.scene_name() == b.scene_name()
        && a.method == b.method
        && a.parameter(SETTING) == b.parameter(SETTING)
}

/// An entry before it has run.
struct Planned<'a> {
    case: &'a Case,
    head_joints: HeadJoints,
    blocks: usize,
    step: Step<'static>,
}

impl<'a> Planned<'a> {
    fn task(&self, repeat: usize) -> Task<'a> {
        let (case, head_joints) = (self.case, self.head_joints);
        let subject = Subject {
            case: case.name.clone(),
            head_joints,
            parameters: vec![
                (SETTING.to_owned(), self.step.label.clone()),
                (REPEAT.to_owned(), repeat.to_string()),
            ],
            blocks: self.blocks,
            sides: Box::new(move || Cow::Owned(case.sides(head_joints))),
            determined_by: Vec::new(),
        };
        Task::new(subject, self.step.method, self.step.settings)
    }

    fn entry(&self, row: Row, seconds: &mut [f64]) -> Measurement {
        seconds.sort_by(f64::total_cmp);
        Measurement {
            runs: seconds.len(),
            reference: reference(self.case, self.head_joints).cloned(),
            row: Row {
                seconds: seconds[seconds.len() / 2],
                ..row
            },
        }
    }
}

/// The table as CSV: numbers with nine digits, empty where there is no answer.
///
/// # Errors
/// Those of the CSV writer; none is expected in memory.
pub fn csv(entries: &[Measurement]) -> Result<String, csv::Error> {
    let headings = [
        "case",
        "method",
        "setting",
        "status",
        "lower",
        "upper",
        "error",
        "width",
        "seconds",
        "runs",
        "reference",
        "reference_kind",
        "reference_method",
        "reference_source",
        "reason",
    ];
    run::csv(headings, entries.iter().map(line))
}

fn line(entry: &Measurement) -> Vec<Value> {
    let known = entry.reference.as_ref();
    let width = entry
        .row
        .bracket()
        .map(|bracket| bracket.relative_width(entry.row.multiplier_unit));
    let of_reference: [Value; 4] = [
        known.map(|r| r.value).into(),
        known.map(|r| r.kind.name().to_owned()).into(),
        known.map(|r| r.method.clone()).into(),
        known.map(|r| r.source.clone()).into(),
    ];
    let row = |names| values(&entry.row, names);
    [
        row(&["case", "method"]),
        vec![entry.setting().into()],
        row(&["status", "lower", "upper"]),
        vec![entry.error().into(), width.into()],
        row(&["seconds"]),
        vec![Value::Count(entry.runs)],
        of_reference.to_vec(),
        row(&["reason"]),
    ]
    .concat()
}
