//! The table behind the picture: case × method × setting, each timed until its median is stable.

use std::borrow::Cow;
use std::collections::BTreeMap;
use std::io;

use super::ladder::{Step, ladder};
use super::reference::{ReferenceRange, reference};
use crate::answer::{Bracket, Status};
use crate::case::Case;
use crate::method::Method;
use crate::run::{
    Heading, Journal, Progress, Row, Subject, Task, Value, csv_of, fingerprint, run_rows,
};
use crate::scene::HeadJoints;

/// One point of the chart.
#[derive(Clone, Debug)]
pub struct Measurement {
    /// The answer; its time is the median of all runs.
    pub row: Row,
    /// Number of runs that the median is of.
    pub runs: usize,
    /// What the scene's answers are measured against.
    pub reference: Option<ReferenceRange>,
    /// Whether its setting is meant to be quick rather than right.
    pub loose: bool,
}

impl Measurement {
    /// The answer's bracket; `None` where there is no answer: `undecided`, `failed` and the like.
    fn answer(&self) -> Option<Bracket> {
        let answered = matches!(
            self.row.status(),
            Status::Verified | Status::Bracketed | Status::Estimate
        );
        self.row.bracket().filter(|_| answered)
    }

    /// Distances of an answer's ends from their own of the reference range, the nearer one first;
    /// `None` where there is no answer.
    pub fn distances(&self) -> Option<[f64; 2]> {
        let unit = self.row.multiplier_unit;
        let [lower, upper] = self.reference.as_ref()?.distances(self.answer()?, unit);
        Some([lower.min(upper), lower.max(upper)])
    }

    /// Error of an answer: the larger distance, so that neither a wide bracket nor a single number for
    /// a wide truth looks exact; `None` where there is no answer.
    pub fn error(&self) -> Option<f64> {
        self.distances().map(|[_, farther]| farther)
    }

    /// Relative width of what the method gives, an answer or not.
    fn width(&self) -> Option<f64> {
        let bracket = self.row.bracket()?;
        Some(bracket.relative_width(self.row.multiplier_unit))
    }

    /// Whether the answer's lower end is not above the lowest state that is known.
    pub fn is_safe(&self) -> bool {
        let unit = self.row.multiplier_unit;
        let known = self.reference.as_ref().zip(self.answer());
        known.is_some_and(|(known, answer)| known.is_safe(answer, unit))
    }

    /// Whether the answer vouches for itself, and its setting is not a loose one.
    pub fn vouches(&self) -> bool {
        !self.loose && matches!(self.row.status(), Status::Verified | Status::Bracketed)
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

/// Every step on every scene that has a reference, before and while they run.
pub struct Chart<'a> {
    planned: Vec<Planned<'a>>,
}

impl<'a> Chart<'a> {
    /// The scenes of the cases with the ladders of all methods.
    pub fn new(
        cases: &'a [Case],
        head_joints: Option<HeadJoints>,
        externals: &[&'static dyn Method],
    ) -> Self {
        let mut planned = Vec::new();
        for case in cases {
            let own = case.head_joints.iter();
            let own = own.filter(|own| head_joints.is_none_or(|only| only == **own));
            for &head_joints in own.filter(|own| reference(case, **own).is_some()) {
                let sides = case.sides(head_joints);
                let blocks = sides[0].blocks().len();
                let determined_by: Vec<String> = sides.iter().map(fingerprint).collect();
                planned.extend(ladder(blocks, externals).into_iter().map(|step| Planned {
                    case,
                    head_joints,
                    blocks,
                    determined_by: determined_by.clone(),
                    step,
                }));
            }
        }
        Self { planned }
    }

    /// Number of points of the chart.
    pub fn count(&self) -> usize {
        self.planned.len()
    }

    /// Runs every step on every scene that the journal does not know: once, then quick ones again
    /// until their median is stable. The rows come in any order.
    ///
    /// # Errors
    /// Where the journal cannot be written.
    pub fn run(&self, journal: Option<&Journal>, progress: &Progress) -> io::Result<Vec<Row>> {
        let tasks: Vec<Task> = self.planned.iter().map(|planned| planned.task(0)).collect();
        let mut rows = run_rows(&tasks, journal, progress)?;
        let mut again = Vec::new();
        for (planned, row) in self.planned.iter().zip(&rows) {
            let runs = (FILL / row.seconds.max(1e-9)).min(MOST_RUNS as f64) as usize;
            again.extend((1..runs).map(|repeat| planned.task(repeat)));
        }
        rows.extend(run_rows(&again, journal, progress)?);
        Ok(rows)
    }

    /// The points whose first run is among the rows, in their order.
    pub fn measurements(&self, rows: &[Row]) -> Vec<Measurement> {
        let known: BTreeMap<&str, &Row> = rows.iter().map(|row| (row.id.as_str(), row)).collect();
        let points = self.planned.iter().filter_map(|planned| {
            let run = |repeat| known.get(planned.task(repeat).id()).copied();
            let first = run(0)?;
            let seconds = (0..MOST_RUNS).filter_map(run).map(|row| row.seconds);
            let mut seconds: Vec<f64> = seconds.collect();
            seconds.sort_by(f64::total_cmp);
            Some(Measurement {
                runs: seconds.len(),
                reference: reference(planned.case, planned.head_joints),
                loose: planned.step.loose,
                row: Row {
                    seconds: seconds[seconds.len() / 2],
                    ..first.clone()
                },
            })
        });
        points.collect()
    }
}

struct Planned<'a> {
    case: &'a Case,
    head_joints: HeadJoints,
    blocks: usize,
    determined_by: Vec<String>,
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
            determined_by: self.determined_by.clone(),
        };
        Task::new(subject, self.step.method, self.step.settings)
    }
}

const COLUMNS: [Heading<Measurement>; 16] = [
    ("case", |m| m.row.value("case")),
    ("method", |m| m.row.value("method")),
    ("setting", |m| m.setting().into()),
    ("status", |m| m.row.value("status")),
    ("lower", |m| m.row.value("lower")),
    ("upper", |m| m.row.value("upper")),
    ("error", |m| m.error().into()),
    ("width", |m| m.width().into()),
    ("seconds", |m| m.row.value("seconds")),
    ("runs", |m| Value::Count(m.runs)),
    ("reference", |m| {
        known(m, |of| Value::Number(of.range.lower))
    }),
    ("reference_upper", |m| {
        known(m, |of| Value::Number(of.range.upper))
    }),
    ("reference_kind", |m| {
        known(m, |of| of.lowest.kind.name().into())
    }),
    ("reference_method", |m| {
        known(m, |of| of.lowest.method.as_str().into())
    }),
    ("reference_source", |m| {
        known(m, |of| of.lowest.source.as_str().into())
    }),
    ("reason", |m| m.row.value("reason")),
];

fn known(entry: &Measurement, value: fn(&ReferenceRange) -> Value) -> Value {
    entry.reference.as_ref().map_or(Value::Nothing, value)
}

/// The table as CSV: numbers with nine digits, empty where there is no answer.
pub fn csv(entries: &[Measurement]) -> String {
    csv_of(&COLUMNS, entries)
}
