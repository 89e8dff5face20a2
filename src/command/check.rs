//! `trilith check`.

use std::path::PathBuf;

use clap::Args;
use trilith::case;
use trilith::report;
use trilith::run::CaseResult;

use super::plan::PlanArguments;
use super::run::{handed_out, refuted, write};
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
    /// Also put the scene, forces, velocities, rays and ceilings of every answer into results.json,
    /// in the formats of outside programs.
    #[arg(long, requires = "out")]
    states: bool,
}

pub(super) fn check(arguments: &CheckArguments) -> Result<u8, Stop> {
    let (cases, plan) = arguments.plan.read(&arguments.cases, case::library)?;
    print(&report::library_heading())?;
    let show = |result: &CaseResult| print(&report::library_case(result));
    let results = solve(&cases, &plan, show, |complete| {
        hand_out(arguments, complete)?;
        Ok(handed_out(arguments.out.as_deref()))
    })?;
    hand_out(arguments, &results)?;
    Ok(if refuted(&results) { REFUTED } else { 0 })
}

fn hand_out(arguments: &CheckArguments, results: &[CaseResult]) -> Result<(), Stop> {
    if let Some(folder) = &arguments.out {
        write(folder, results, arguments.states)?;
    }
    print(&report::library_closing(results))
}
