//! `trilith check`.

use std::path::PathBuf;

use clap::Args;
use trilith::case;
use trilith::report;
use trilith::run::{CaseResult, Partial};

use super::output;
use super::plan::PlanArguments;
use super::run::{files, refuted};
use super::solve::solve;
use super::stop::{REFUTED, Stop, print};

#[derive(Args)]
pub(super) struct CheckArguments {
    /// Case files, folders of them, or names of built-in cases; none: the whole library.
    #[arg(value_name = "CASE")]
    cases: Vec<String>,
    #[command(flatten)]
    plan: PlanArguments,
    /// Also write results.csv, results.json and one record a case into this folder.
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
    /// Keep finished results in a journal in this folder, and go on from it [default: that of --out].
    #[arg(long, value_name = "DIR")]
    resume: Option<PathBuf>,
    /// Also put the scene, forces, velocities, rays and ceilings of every answer into results.json,
    /// in the formats of outside programs.
    #[arg(long, requires = "out")]
    states: bool,
}

pub(super) fn check(arguments: &CheckArguments) -> Result<u8, Stop> {
    let (cases, plan) = arguments.plan.read(&arguments.cases, case::library)?;
    if let Some(folder) = &arguments.out {
        output::test(folder)?;
    }
    print(&report::library_heading())?;
    let show = |result: &CaseResult| print(&report::library_case(result));
    let kept = arguments.resume.as_deref().or(arguments.out.as_deref());
    let kept = kept.map(|folder| (folder, "check.journal"));
    let results = solve(&cases, &plan, kept, show, |results, partial| {
        hand_out(arguments, results, partial)
    })?;
    Ok(if refuted(&results) { REFUTED } else { 0 })
}

fn hand_out(
    arguments: &CheckArguments,
    results: &[CaseResult],
    partial: Option<&Partial>,
) -> Result<(), Stop> {
    let said = partial.map_or(String::new(), |partial| format!("\n{partial}\n"));
    let printed = print(&format!("{said}{}", report::library_closing(results)));
    if let Some(folder) = &arguments.out {
        output::write(folder, files(results, arguments.states, partial)?)?;
    }
    printed
}
