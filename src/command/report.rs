//! `trilith report`.

use std::path::{Path, PathBuf};

use clap::Args;

use trilith::case;
use trilith::method::Settings;
use trilith::report::html::{Report, page};
use trilith::run::{CaseResult, Partial};
use trilith::study::sweep::SweepTable;

use super::output;
use super::plan::PlanArguments;
use super::run::{files, refuted};
use super::solve::solve;
use super::stop::{REFUTED, Stop, print};

#[derive(Args)]
pub(super) struct ReportArguments {
    /// Case files, folders of them, or names of built-in cases; none: the paper's three walls.
    #[arg(value_name = "CASE")]
    cases: Vec<String>,
    #[command(flatten)]
    plan: PlanArguments,
    /// Also plot this sweep's `sweep.csv`; the overburden's is the paper's Fig. 7.
    #[arg(long, value_name = "FILE.csv")]
    sweep: Vec<PathBuf>,
    /// Folder for report.html, results.csv, results.json and one record a case.
    #[arg(long, value_name = "DIR")]
    out: PathBuf,
}

pub(super) fn report(arguments: &ReportArguments) -> Result<u8, Stop> {
    let (cases, mut plan) = arguments.plan.read(&arguments.cases, case::paper)?;
    plan.settings.pushover.recording = true;
    // Before the long work: a file that cannot be read is known now.
    let sweeps = read(&arguments.sweep)?;
    let settings = plan.settings;
    let kept = Some((arguments.out.as_path(), "report.journal"));
    let results = solve(
        &cases,
        &plan,
        kept,
        |_| Ok(()),
        |results, partial| {
            let path = hand_out(&arguments.out, results, &settings, &sweeps, partial)?;
            let said = partial.map_or(String::new(), |partial| format!("{partial}\n"));
            print(&format!("{said}wrote {path}\n"))
        },
    )?;
    Ok(if refuted(&results) { REFUTED } else { 0 })
}

/// The sweeps that the report plots.
fn read(paths: &[PathBuf]) -> Result<Vec<SweepTable>, Stop> {
    let read =
        |path: &PathBuf| SweepTable::read(path).map_err(|e| Stop::bad_input(format!("error: {e}")));
    paths.iter().map(read).collect()
}

/// Writes the page and, beside it, what `run` writes.
fn hand_out(
    folder: &Path,
    results: &[CaseResult],
    settings: &Settings,
    sweeps: &[SweepTable],
    partial: Option<&Partial>,
) -> Result<String, Stop> {
    let text = page(&Report {
        results,
        settings,
        sweeps,
        partial,
    });
    let mut files = files(results, false, partial)?;
    files.push(("report.html".to_owned(), text));
    output::write(folder, files)?;
    Ok(folder.join("report.html").display().to_string())
}
