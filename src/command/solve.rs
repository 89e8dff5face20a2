//! Running a plan with progress and a journal, results shown as they come.

use std::path::Path;
use std::sync::Mutex;

use crate::case::Case;
use crate::run::{CaseResult, CaseRuns, Journal, Keeps, Partial, Plan};

use super::progress::Bar;
use super::screen::tell;
use super::stop::Stop;
use super::{interrupt, output};

/// Missing results that are named one by one.
const NAMED: usize = 10;

/// Runs the plan with progress and a journal, where there is a folder for one; shows each case's
/// result as soon as those before it are shown, and hands them out. On a signal, or where the journal
/// cannot be written, what is finished is shown and handed out as partial, and standard error says
/// why and what is missing.
///
/// # Errors
/// Where results cannot be shown or handed out, or the journal cannot be written.
pub(super) fn solve(
    cases: &[Case],
    plan: &Plan,
    kept: Option<(&Path, &str)>,
    show: impl Fn(&CaseResult) -> Result<(), Stop> + Sync,
    hand_out: impl Fn(&[CaseResult], Option<&Partial>) -> Result<(), Stop>,
) -> Result<Vec<CaseResult>, Stop> {
    let scenes = plan.scenes(cases);
    let runs = CaseRuns::new(cases, &scenes, plan);
    let journal = kept.map(|(folder, name)| output::journal(folder, name, Keeps::Everything));
    let journal = journal.transpose()?;
    if let Some(journal) = &journal {
        output::tell_known(journal, runs.tasks());
    }
    let bar = Bar::new();
    let failed: Mutex<Option<Stop>> = Mutex::new(None);
    // The first result that cannot be shown is the last that is tried.
    let show = |result: &CaseResult| {
        let mut failed = failed.lock().expect("showing does not panic");
        if failed.is_none() {
            *failed = bar.aside(|| show(result)).err();
        }
    };
    let leave = |why: &str| {
        bar.clear();
        let (results, shown) = runs.finished();
        let [finished, of] = runs.counts();
        let partial = Partial {
            why: why.to_owned(),
            finished,
            of,
        };
        let partial = (finished < of).then_some(&partial);
        results[shown..].iter().for_each(&show);
        let handed_out = match finished {
            0 => Ok(()),
            _ => hand_out(&results, partial),
        };
        tell(why, &runs, journal.as_ref(), handed_out);
    };
    let work = || runs.run(journal.as_ref(), &bar, &show);
    let done = interrupt::or_leave(work, leave);
    if let Err(error) = done {
        leave(&format!(
            "stopped because the journal cannot be written: {error}"
        ));
        return Err(Stop::bad_input("error: not all results were computed"));
    }
    bar.clear();
    let (results, _) = runs.finished();
    let failed = failed.lock().expect("showing does not panic").take();
    let handed_out = hand_out(&results, None);
    failed.map_or(handed_out, Err)?;
    if let Some(journal) = journal {
        output::finish(journal);
    }
    Ok(results)
}

/// Says on standard error what became of results that are not all there.
fn tell(why: &str, runs: &CaseRuns, journal: Option<&Journal>, handed_out: Result<(), Stop>) {
    if let Err(stop) = handed_out {
        tell!("{}", stop.text.trim_end());
    }
    let [finished, of] = runs.counts();
    tell!("{why}: {finished} of {of} results are finished");
    let missing = runs.missing();
    if !missing.is_empty() {
        let more = missing.len().saturating_sub(NAMED);
        let more = if more > 0 {
            format!(" and {more} more")
        } else {
            String::new()
        };
        let named: Vec<&str> = missing.iter().take(NAMED).map(String::as_str).collect();
        tell!("missing: {}{more}", named.join(", "));
    }
    if let Some(journal) = journal {
        let path = journal.path().display();
        tell!("run the same command again to go on from {path}");
    }
}
