//! The table behind the picture: case × method × setting, each timed until its median is stable.

use std::io;

use super::ladder::{Rung, ladder};
use super::reference;
use crate::answer::{Bracket, Status};
use crate::case::{Case, Reference};
use crate::method::Method;
use crate::number::nine_digits;
use crate::scene::HeadJoints;
use crate::study::sweep::{self, Point, Row, Subject};

/// One point of the chart.
#[derive(Clone, Debug, PartialEq)]
pub struct Entry {
    /// Name of the case, with `@open` where head joints are open.
    pub case: String,
    /// Name of the method.
    pub method: String,
    /// What is not as by default.
    pub setting: String,
    /// What the answer is worth.
    pub status: Status,
    /// The answer, where there is one.
    pub bracket: Option<Bracket>,
    /// Median of the CPU time, seconds.
    pub seconds: f64,
    /// Number of runs that the median is of.
    pub runs: usize,
    /// What the scene's answers are measured against.
    pub reference: Option<Reference>,
    /// Why this status, in words.
    pub reason: String,
}

impl Entry {
    /// Error of an answer: the farther end of the bracket from the reference, relative to it. `None`
    /// where there is no answer: `undecided`, `failed` and the like.
    pub fn error(&self) -> Option<f64> {
        let answered = matches!(
            self.status,
            Status::Verified | Status::Bracketed | Status::Estimate
        );
        let bracket = self.bracket.filter(|_| answered)?;
        Some(bracket.error(self.reference.as_ref()?.value))
    }

    /// Distance of the nearer end, relative to the reference; 0 where it lies in the bracket.
    pub fn nearest(&self) -> Option<f64> {
        let (bracket, known) = (self.bracket?, self.reference.as_ref()?.value);
        let outside = (bracket.lower - known).max(known - bracket.upper).max(0.0);
        Some(outside / known.abs().max(1e-3))
    }

    /// Method and setting for people.
    pub fn name(&self) -> String {
        match self.setting.as_str() {
            "default" => self.method.clone(),
            setting => format!("{} {setting}", self.method),
        }
    }
}

/// CPU time that the runs of one entry fill together, seconds, and how many they are at most.
const FILL: f64 = 0.4;
const MOST_RUNS: usize = 9;

/// Runs every rung on every scene of the cases that has a reference, through the sweep's runner:
/// once, then quick ones again until their median is stable.
///
/// # Errors
/// Never without a journal; the sweep's runner says so for one.
pub fn run(
    cases: &[Case],
    head_joints: Option<HeadJoints>,
    externals: &[&'static dyn Method],
    finished: impl Fn(&Point, &Row) + Sync,
) -> io::Result<Vec<Entry>> {
    let mut first = Vec::new();
    for case in cases {
        for &of_case in &case.head_joints {
            if head_joints.is_some_and(|only| only != of_case) || reference(case, of_case).is_none()
            {
                continue;
            }
            let blocks = case.scene(of_case).blocks().len();
            for rung in ladder(blocks, externals) {
                first.push(Planned {
                    case,
                    head_joints: of_case,
                    blocks,
                    rung,
                });
            }
        }
    }
    let points: Vec<Point> = first.iter().map(|planned| planned.point(0)).collect();
    let rows = sweep::run(&points, None, &finished)?;
    let mut again = Vec::new();
    for (planned, row) in first.iter().zip(&rows) {
        let runs = (FILL / row.seconds.max(1e-9)).min(MOST_RUNS as f64) as usize;
        again.extend((1..runs).map(|repeat| planned.point(repeat)));
    }
    let repeated = sweep::run(&again, None, &finished)?;
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
    a.case == b.case && a.method == b.method && a.parameter("setting") == b.parameter("setting")
}

/// An entry before it has run.
struct Planned<'a> {
    case: &'a Case,
    head_joints: HeadJoints,
    blocks: usize,
    rung: Rung<'static>,
}

impl<'a> Planned<'a> {
    fn point(&self, repeat: usize) -> Point<'a> {
        let (case, head_joints) = (self.case, self.head_joints);
        let subject = Subject {
            case: match head_joints {
                HeadJoints::Contact => case.name.clone(),
                HeadJoints::Open => format!("{}@open", case.name),
            },
            parameters: vec![
                ("setting".to_owned(), self.rung.label.clone()),
                ("repeat".to_owned(), repeat.to_string()),
            ],
            blocks: self.blocks,
            sides: Box::new(move || case.sides(head_joints)),
            determined_by: Vec::new(),
        };
        Point::new(subject, self.rung.method, self.rung.settings)
    }

    fn entry(&self, row: Row, seconds: &mut [f64]) -> Entry {
        seconds.sort_by(f64::total_cmp);
        let ends = row.lower.zip(row.upper);
        Entry {
            setting: self.rung.label.clone(),
            bracket: ends.map(|(lower, upper)| Bracket { lower, upper }),
            seconds: seconds[seconds.len() / 2],
            runs: seconds.len(),
            reference: reference(self.case, self.head_joints).cloned(),
            case: row.case,
            method: row.method,
            status: row.status,
            reason: row.reason,
        }
    }
}

/// The table as CSV: numbers with nine digits, empty where there is no answer.
///
/// # Errors
/// Those of the CSV writer; none is expected in memory.
pub fn csv(entries: &[Entry]) -> Result<String, csv::Error> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    writer.write_record([
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
    ])?;
    for entry in entries {
        let text = |value: Option<f64>| value.map_or(String::new(), nine_digits);
        let known = entry.reference.as_ref();
        writer.write_record([
            entry.case.as_str(),
            &entry.method,
            &entry.setting,
            entry.status.name(),
            &text(entry.bracket.map(|b| b.lower)),
            &text(entry.bracket.map(|b| b.upper)),
            &text(entry.error()),
            &text(entry.bracket.map(|b| b.relative_width())),
            &nine_digits(entry.seconds),
            &entry.runs.to_string(),
            &text(known.map(|r| r.value)),
            known.map_or("", |r| r.kind.name()),
            known.map_or("", |r| r.method.as_str()),
            known.map_or("", |r| r.source.as_str()),
            &entry.reason,
        ])?;
    }
    let bytes = writer
        .into_inner()
        .map_err(|e| csv::Error::from(e.into_error()))?;
    Ok(String::from_utf8_lossy(&bytes).into_owned())
}
