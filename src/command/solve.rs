//! Running a plan with progress and Ctrl-C, results shown as they come.

use std::sync::Mutex;

use trilith::case::Case;
use trilith::run::{CaseResult, Plan, Results, run_into};

use super::interrupt;
use super::progress::Bar;
use super::stop::Stop;

/// Runs the plan with progress and shows each case's result as soon as those before it are shown. On
/// Ctrl-C the results of all complete cases are shown, `keep` writes what else is to be left of them
/// and says where; standard error names those cases and the missing ones.
///
/// # Errors
/// Where a result cannot be shown.
pub(super) fn solve(
    cases: &[Case],
    plan: &Plan,
    show: impl Fn(&CaseResult) -> Result<(), Stop> + Sync,
    keep: impl FnOnce(&[CaseResult]) -> Result<String, Stop>,
) -> Result<Vec<CaseResult>, Stop> {
    let bar = Bar::new();
    let results = Results::default();
    let failed: Mutex<Option<Stop>> = Mutex::new(None);
    // The first result that cannot be shown is the last that is tried.
    let show = |result: &CaseResult| {
        let mut failed = failed.lock().expect("showing does not panic");
        if failed.is_none() {
            *failed = bar.aside(|| show(result)).err();
        }
    };
    let work = || run_into(&results, cases, plan, &bar, &show);
    interrupt::or_leave(work, || {
        bar.clear();
        let (mut complete, rest) = results.take();
        for (_, result) in rest {
            show(&result);
            complete.push(result);
        }
        report_interruption(cases, &complete, || keep(&complete));
    });
    bar.clear();
    let failed = failed.lock().expect("showing does not panic").take();
    failed.map_or_else(|| Ok(results.take().0), Err)
}

/// Says on standard error which cases are complete and what became of them, and which are missing.
fn report_interruption(
    cases: &[Case],
    complete: &[CaseResult],
    keep: impl FnOnce() -> Result<String, Stop>,
) {
    let is_complete = |case: &&Case| complete.iter().any(|result| result.case.name == case.name);
    let (complete, missing): (Vec<&Case>, Vec<&Case>) = cases.iter().partition(is_complete);
    let [complete, missing] = [complete, missing].map(|cases| {
        let names: Vec<&str> = cases.iter().map(|case| case.name.as_str()).collect();
        names.join(", ")
    });
    if complete.is_empty() {
        eprintln!("interrupted: no case is complete; missing: {missing}");
        return;
    }
    match keep() {
        Ok(how) => eprintln!("interrupted: {how}: {complete}; missing: {missing}"),
        Err(stop) => eprintln!("interrupted: {}", stop.text.trim_end()),
    }
}
