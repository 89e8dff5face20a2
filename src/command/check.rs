//! `trilith check`.

use trilith::case;
use trilith::report;

use super::run::{refuted, with_progress, write};
use super::{CheckArguments, REFUTED, Stop, print};

pub(super) fn check(arguments: &CheckArguments) -> Result<u8, Stop> {
    let (cases, plan) = arguments.plan.read(&arguments.cases, case::library)?;
    let results = with_progress(&cases, &plan);
    if let Some(folder) = &arguments.out {
        write(folder, &results)?;
    }
    print(&report::library(&results))?;
    Ok(if refuted(&results) { REFUTED } else { 0 })
}
