//! Many rows at once, as sweeps, charts and atlases are: with progress, a journal, and what is
//! finished handed out also where they are ended early.

use std::io;
use std::path::Path;
use std::sync::Mutex;

use crate::run::{Journal, Progress, Row, Task};

use super::interrupt;
use super::progress::Bar;
use super::screen::tell;
use super::stop::Stop;

/// A bar that also keeps the finished rows.
struct Kept {
    bar: Bar,
    rows: Mutex<Vec<Row>>,
}

impl Kept {
    fn add(&self, row: &Row) {
        let mut rows = self.rows.lock().expect("no other thread panicked");
        rows.push(row.clone());
    }
}

impl Progress for Kept {
    fn expected(&self, seconds: f64) {
        self.bar.expected(seconds);
    }

    fn known(&self, _: &Task, row: &Row) {
        self.add(row);
    }

    fn done(&self, task: &Task, row: &Row) {
        self.bar.done(task, row);
        self.add(row);
    }
}

/// Runs `work` with progress and hands its rows out. On a signal, or where the journal cannot be
/// written, the finished rows are handed out with the reason, and standard error says so.
///
/// # Errors
/// Where results cannot be handed out, or the journal cannot be written.
pub(super) fn run_study<T>(
    journal: &Journal,
    work: impl FnOnce(&dyn Progress) -> io::Result<Vec<Row>> + Send,
    hand_out: impl Fn(Vec<Row>, Option<&str>) -> Result<T, Stop>,
) -> Result<T, Stop> {
    let kept = Kept {
        bar: Bar::new(),
        rows: Mutex::default(),
    };
    let leave = |why: &str| {
        kept.bar.clear();
        let rows = kept.rows.lock().expect("no other thread panicked").clone();
        let finished = rows.len();
        let handed_out = match finished {
            0 => Ok(()),
            _ => hand_out(rows, Some(why)).map(drop),
        };
        tell(why, finished, journal.path(), handed_out);
    };
    let done = interrupt::or_leave(|| work(&kept), leave);
    kept.bar.clear();
    match done {
        Ok(rows) => hand_out(rows, None),
        Err(error) => {
            let path = journal.path().display();
            let why = format!("stopped because {path} cannot be written: {error}");
            leave(&why);
            Err(Stop::bad_input("error: not all results were computed"))
        }
    }
}

/// Says on standard error what became of results that are not all there.
pub(super) fn tell(why: &str, finished: usize, journal: &Path, handed_out: Result<(), Stop>) {
    if let Err(stop) = handed_out {
        tell!("{}", stop.text.trim_end());
    }
    tell!(
        "{why}: {finished} results are finished; run the same command again to go on from {}",
        journal.display()
    );
}
