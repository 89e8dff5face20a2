//! `trilith check`.

use trilith::case;
use trilith::report;
use trilith::run::CaseResult;

use super::run::{handed_out, refuted, write};
use super::solve::solve;
use super::{CheckArguments, REFUTED, Stop, print};

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
        write(folder, results)?;
    }
    print(&report::library_closing(results))
}
