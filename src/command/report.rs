//! `trilith report`.

use std::path::PathBuf;

use clap::Args;

use crate::case;
use crate::method::Settings;
use crate::report::html::{manual, page, pages};
use crate::run::{CaseResult, Partial};
use crate::study::sweep::SweepTable;

use super::output;
use super::plan::PlanArguments;
use super::run::{RESULTS, files, refuted};
use super::screen::print_lines;
use super::solve::{Keeping, solve};
use super::stop::{Stop, status};

#[derive(Args)]
#[command(next_help_heading = RESULTS)]
pub(super) struct ReportArguments {
    /// Case files, folders of them, names of built-in cases, or `-` for a case in standard input; where
    /// none is named, the three walls of the paper.
    #[arg(value_name = "CASE", help_heading = None)]
    cases: Vec<String>,
    /// Also plot this `sweep.csv`; that of the sweep fig-7 is the paper's Fig. 7.
    #[arg(long, value_name = "FILE.csv")]
    sweep: Vec<PathBuf>,
    /// Write the verification manual instead, a page for each case; where none is named, for the whole
    /// library.
    #[arg(long, conflicts_with = "sweep")]
    manual: bool,
    /// Write a page for each case to print or to file instead, one sheet each: the verdict, the wall as it
    /// was read and how it collapses, what every method answers, and what was checked.
    #[arg(long, conflicts_with_all = ["sweep", "manual"])]
    page: bool,
    /// Folder for report.html, manual.html or page.html, results.csv, results.json and one record a case.
    #[arg(long, value_name = "DIR")]
    out: PathBuf,
    /// Also put the scene and the forces and velocities of every answer into results.json, in the formats
    /// of outside programs (`trilith schema`).
    #[arg(long, hide_short_help = true)]
    states: bool,
    #[command(flatten)]
    plan: PlanArguments,
}

pub(super) fn report(arguments: &ReportArguments) -> Result<u8, Stop> {
    let none_named = if arguments.manual {
        case::library
    } else {
        case::paper
    };
    let (cases, mut plan) = arguments.plan.read(&arguments.cases, none_named)?;
    plan.settings.pushover.recording = true;
    // Before the long work: a file that cannot be read is known now.
    let read = |path| SweepTable::read(path).map_err(|e| Stop::bad_input(format!("error: {e}")));
    let sweeps = arguments.sweep.iter().map(|path| read(path));
    let sweeps = sweeps.collect::<Result<Vec<_>, Stop>>()?;
    let settings = plan.settings;
    let keeping = Keeping {
        journal: Some((arguments.out.as_path(), "report.journal")),
        ..Keeping::default()
    };
    let results = solve(
        &cases,
        &plan,
        keeping,
        |_| Ok(()),
        |results, partial| {
            let path = hand_out(arguments, results, &settings, &sweeps, partial)?;
            let said = output::said(partial);
            print_lines(&format!("{said}wrote {path}\n"))
        },
    )?;
    Ok(status(refuted(&results)))
}

/// Writes the page and, beside it, what `run` writes.
fn hand_out(
    arguments: &ReportArguments,
    results: &[CaseResult],
    settings: &Settings,
    sweeps: &[SweepTable],
    partial: Option<&Partial>,
) -> Result<String, Stop> {
    let folder = &arguments.out;
    let (name, text) = if arguments.manual {
        ("manual.html", manual(results, settings, partial))
    } else if arguments.page {
        ("page.html", pages(results, partial))
    } else {
        ("report.html", page(results, settings, sweeps, partial))
    };
    let mut files = files(results, arguments.states, partial);
    files.push((name.to_owned(), text));
    output::write(folder, files)?;
    Ok(folder.join(name).display().to_string())
}
