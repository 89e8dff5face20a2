//! Long work with progress and a journal, and what is finished handed out also where it is ended early: a
//! plan, whose results are shown as they come; a study of many rows, as sweeps, charts and atlases are.

use std::io;
use std::path::Path;
use std::sync::Mutex;

use crate::case::Case;
use crate::run::{
    CaseResult, CaseRuns, Event, Journal, Keeps, Partial, Plan, Progress, Proof, Row,
};

use super::progress::Bar;
use super::screen::tell;
use super::stop::Stop;
use super::{interrupt, output};

/// Missing results that are named one by one.
const NAMED: usize = 10;

/// Where a run keeps what it has by then, so that ending it early loses nothing.
#[derive(Clone, Copy, Default)]
pub(super) struct Keeping<'a> {
    /// The folder and the name of a journal of finished results.
    pub(super) journal: Option<(&'a Path, &'a str)>,
    /// The folder for certificates of lower bounds.
    pub(super) certificates: Option<&'a Path>,
}

/// Runs the plan with progress and a journal, where there is a folder for one; shows each case's
/// result as soon as those before it are shown, and hands them out. On a signal, or where the journal
/// cannot be written, what is finished is shown and handed out as partial, and standard error says
/// why, what is missing, and what lower bounds were proved of that by then.
///
/// # Errors
/// Where results cannot be shown or handed out, or the journal cannot be written.
pub(super) fn solve(
    cases: &[Case],
    plan: &Plan,
    keeping: Keeping,
    show: impl Fn(&CaseResult) -> Result<(), Stop> + Sync,
    hand_out: impl Fn(&[CaseResult], Option<&Partial>) -> Result<(), Stop>,
) -> Result<Vec<CaseResult>, Stop> {
    let scenes = plan.scenes(cases);
    let runs = CaseRuns::new(cases, &scenes, plan);
    let journal = keeping
        .journal
        .map(|(folder, name)| output::journal(folder, name, Keeps::Everything));
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
        // First: what is finished meanwhile is proved no less, and its certificate takes the place.
        keep_proofs(&runs.proofs(), keeping.certificates);
        let (results, shown) = runs.finished();
        let [finished, of] = runs.counts();
        let partial = output::partial(Some(why).filter(|_| finished < of), finished, of);
        results[shown..].iter().for_each(&show);
        let handed_out = match finished {
            0 => Ok(()),
            _ => hand_out(&results, partial.as_ref()),
        };
        tell(why, &runs, journal.as_ref(), handed_out);
    };
    or_leave(
        &bar,
        || runs.run(journal.as_ref(), &|event| bar.tell(event), &show),
        leave,
    )?;
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
    tell_of(handed_out);
    let [finished, of] = runs.counts();
    tell!("{why}: {finished} of {of} results are finished");
    let missing = runs.missing();
    if !missing.is_empty() {
        let more = match missing.len().saturating_sub(NAMED) {
            0 => String::new(),
            more => format!(" and {more} more"),
        };
        let named: Vec<&str> = missing.iter().take(NAMED).map(String::as_str).collect();
        tell!("missing: {}{more}", named.join(", "));
    }
    if let Some(journal) = journal {
        let path = journal.path().display();
        tell!("run the same command again to go on from {path}");
    }
}

/// Says on standard error what tasks that are not finished have proved, and writes what proves it.
fn keep_proofs(proofs: &[Proof], certificates: Option<&Path>) {
    for proof in proofs {
        let write = |folder| {
            // Seconds for a large one, in which a second signal would lose it.
            tell!("so far, {proof}; its certificate is being written");
            let bytes = proof.so_far.certificate.to_bytes();
            output::write_certificate(folder, &proof.file, bytes)
        };
        match certificates.map(write) {
            Some(Ok(path)) => tell!("the certificate is {}", path.display()),
            Some(Err(stop)) => tell!("{}", stop.text.trim_end()),
            None => tell!("so far, {proof}; `--certificate DIR` keeps the certificate"),
        }
    }
}

/// Says on standard error why something was not handed out.
fn tell_of(handed_out: Result<(), Stop>) {
    if let Err(stop) = handed_out {
        tell!("{}", stop.text.trim_end());
    }
}

/// Runs `work` with progress and hands its rows out. On a signal, or where the journal cannot be
/// written, the finished rows are handed out with the reason, and standard error says so.
///
/// # Errors
/// Where results cannot be handed out, or the journal cannot be written.
pub(super) fn run_study<T>(
    journal: &Journal,
    work: impl FnOnce(&Progress) -> io::Result<Vec<Row>> + Send,
    hand_out: impl Fn(Vec<Row>, Option<&str>) -> Result<T, Stop>,
) -> Result<T, Stop> {
    let bar = Bar::new();
    let kept: Mutex<Vec<Row>> = Mutex::default();
    let kept = || kept.lock().expect("no other thread panicked");
    let tell = |event: Event| {
        bar.tell(event);
        if let Event::Known(row) | Event::Done(_, row) = event {
            kept().push(row.clone());
        }
    };
    let leave = |why: &str| {
        bar.clear();
        let rows = kept().clone();
        let finished = rows.len();
        let handed_out = match finished {
            0 => Ok(()),
            _ => hand_out(rows, Some(why)).map(drop),
        };
        tell_of(handed_out);
        let path = journal.path().display();
        tell!(
            "{why}: {finished} results are finished; run the same command again to go on from {path}"
        );
    };
    let rows = or_leave(&bar, || work(&tell), leave)?;
    hand_out(rows, None)
}

/// Runs `work`; on a signal, or where the journal cannot be written, `leave`, which is told why.
fn or_leave<T: Send>(
    bar: &Bar,
    work: impl FnOnce() -> io::Result<T> + Send,
    leave: impl Fn(&str),
) -> Result<T, Stop> {
    let done = interrupt::or_leave(work, &leave);
    bar.clear();
    done.map_err(|error| {
        leave(&format!(
            "stopped because the journal cannot be written: {error}"
        ));
        Stop::bad_input("error: not all results were computed")
    })
}
