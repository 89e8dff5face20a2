//! `trilith run`.

use std::path::PathBuf;

use clap::{Args, ValueEnum};
use std::path::Path;

use trilith::answer::Status;
use trilith::case;
use trilith::files::write_whole;
use trilith::judge::Verdict;
use trilith::record::{RecordChange, compare as compare_record, record};
use trilith::report;
use trilith::run::CaseResult;

use super::plan::PlanArguments;
use super::solve::solve;
use super::stop::{REFUTED, Stop, print};

#[derive(Args)]
pub(super) struct RunArguments {
    /// Case files, folders of them, or names of built-in cases; none: the paper's three walls.
    #[arg(value_name = "CASE")]
    cases: Vec<String>,
    #[command(flatten)]
    plan: PlanArguments,
    /// Also write results.csv, results.json and one record a case into this folder.
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
    /// How results are printed.
    #[arg(long, default_value = "table")]
    format: Format,
    /// Also put the scene, forces, velocities, rays and ceilings of every answer into the JSON, in the
    /// formats of outside programs.
    #[arg(long)]
    states: bool,
    /// Compare records with the .snap files in this folder; write .snap.new and exit 1 on change.
    #[arg(long, value_name = "DIR")]
    record: Option<PathBuf>,
}

#[derive(Clone, Copy, ValueEnum)]
pub(super) enum Format {
    Table,
    Csv,
    Json,
}

pub(super) fn run(arguments: &RunArguments) -> Result<u8, Stop> {
    if arguments.states && arguments.out.is_none() && !matches!(arguments.format, Format::Json) {
        let text = "error: --states goes into JSON, and none is written\nhelp: add `--format json`, \
                    or `--out DIR`";
        return Err(Stop::bad_input(text));
    }
    let (cases, plan) = arguments.plan.read(&arguments.cases, case::paper)?;
    let format = arguments.format;
    print(&format.heading()?)?;
    let show = |result: &CaseResult| print(&format.case(result)?);
    let results = solve(&cases, &plan, show, |complete| {
        hand_out(arguments, complete)?;
        Ok(handed_out(arguments.out.as_deref()))
    })?;
    hand_out(arguments, &results)?;
    let changed = match &arguments.record {
        Some(folder) => compare(folder, &results)?,
        None => false,
    };
    Ok(if changed || refuted(&results) {
        REFUTED
    } else {
        0
    })
}

/// Each case is printed as soon as those before it are; a JSON document only as a whole.
impl Format {
    /// What comes before the first case.
    fn heading(self) -> Result<String, Stop> {
        match self {
            Format::Table | Format::Json => Ok(String::new()),
            Format::Csv => csv(&[]),
        }
    }

    fn case(self, result: &CaseResult) -> Result<String, Stop> {
        match self {
            Format::Table => Ok(report::case_table(result)),
            Format::Csv => {
                let text = csv(std::slice::from_ref(result))?;
                let rows = text.split_once('\n').map(|(_, rows)| rows);
                Ok(rows.unwrap_or_default().to_owned())
            }
            Format::Json => Ok(String::new()),
        }
    }

    /// What comes behind the last case.
    fn closing(self, results: &[CaseResult], states: bool) -> Result<String, Stop> {
        match self {
            Format::Table => Ok(report::legend()),
            Format::Csv => Ok(String::new()),
            Format::Json => json(results, states),
        }
    }
}

/// Writes the files that were asked for, and prints what is left to print.
fn hand_out(arguments: &RunArguments, results: &[CaseResult]) -> Result<(), Stop> {
    if let Some(folder) = &arguments.out {
        write(folder, results, arguments.states)?;
    }
    print(&arguments.format.closing(results, arguments.states)?)
}

/// What became of finished results, in words.
pub(super) fn handed_out(folder: Option<&Path>) -> String {
    match folder {
        Some(folder) => format!("printed and written to {}", folder.display()),
        None => "printed".to_owned(),
    }
}

fn csv(results: &[CaseResult]) -> Result<String, Stop> {
    report::csv(results).map_err(|e| Stop::bad_input(format!("error: cannot write CSV: {e}")))
}

fn json(results: &[CaseResult], states: bool) -> Result<String, Stop> {
    let text = if states {
        report::json_with_states(results)
    } else {
        report::json(results)
    };
    text.map_err(|e| Stop::bad_input(format!("error: cannot write JSON: {e}")))
}

/// Writes results.csv, results.json, with the states where those are wanted, and the records.
pub(super) fn write(folder: &Path, results: &[CaseResult], states: bool) -> Result<(), Stop> {
    let mut files = vec![
        ("results.csv".to_owned(), csv(results)?),
        ("results.json".to_owned(), json(results, states)?),
    ];
    files.extend(
        results
            .iter()
            .map(|r| (format!("{}.txt", r.case.name), record(r))),
    );
    for (name, text) in files {
        let path = folder.join(name);
        write_whole(&path, &text)
            .map_err(|e| Stop::bad_input(format!("error: cannot write {}: {e}", path.display())))?;
    }
    Ok(())
}

/// Whether any record differs from the accepted one.
fn compare(folder: &Path, results: &[CaseResult]) -> Result<bool, Stop> {
    let mut changed = false;
    for result in results {
        let compared = compare_record(folder, &result.case.name, &record(result));
        match compared.map_err(|e| Stop::bad_input(format!("error: {e}")))? {
            RecordChange::Same => {}
            RecordChange::Changed(path) => {
                eprintln!(
                    "changed: {} (see it with `cargo insta review`)",
                    path.display()
                );
                changed = true;
            }
        }
    }
    Ok(changed)
}

/// Whether a result failed or a reference or relation is violated.
pub(super) fn refuted(results: &[CaseResult]) -> bool {
    let failed = |r: &CaseResult| {
        r.rows
            .iter()
            .any(|row| row.outcome.status == Status::Failed)
    };
    let violated = |r: &CaseResult| r.checks.iter().any(|c| c.verdict == Verdict::Violated);
    results
        .iter()
        .any(|result| failed(result) || violated(result))
}
