//! The one runner: tasks on the schedule, with a journal of those that are finished.

use std::io;
use std::sync::{Mutex, OnceLock};

use super::journal::Journal;
use super::kept::Keeps;
use super::progress::{Event, Progress};
use super::row::Row;
use super::schedule::{Expected, next_and_longest};
use super::task::Task;
use crate::method::{SoFar, Watch};

/// Says of which task a proof is.
struct Watched<'a, 'b> {
    task: &'a Task<'b>,
    progress: &'a Progress<'a>,
}

impl Watch for Watched<'_, '_> {
    fn proved(&self, so_far: &dyn Fn() -> SoFar) {
        (self.progress)(Event::Proved(self.task, so_far));
    }
}

/// Runs every task that the journal does not know. Each row goes to `finished` with the place of its
/// task as it finishes, then to `progress`, then to the journal; rows that the journal knows go to
/// the former at once. Without a journal `keeps` says how much of a row is left. `turns` has for each
/// task when its result is shown; where it is empty, nothing is shown before the end.
///
/// # Errors
/// Where the journal cannot be written; nothing further is begun then.
pub fn run_tasks(
    tasks: &[Task],
    turns: &[usize],
    keeps: Keeps,
    journal: Option<&Journal>,
    progress: &Progress,
    finished: &(dyn Fn(usize, Row) + Sync),
) -> io::Result<()> {
    let mut open = Vec::new();
    for (index, task) in tasks.iter().enumerate() {
        match journal.and_then(|journal| journal.get(task.id())) {
            Some(row) => {
                finished(index, row.clone());
                progress(Event::Known(row));
            }
            None => open.push(index),
        }
    }
    let expected = open.iter().map(|&index| Expected {
        seconds: tasks[index].seconds_alone(),
        turn: turns.get(index).copied().unwrap_or(0),
    });
    let expected: Vec<Expected> = expected.collect();
    let seconds = open.iter().map(|&index| tasks[index].expected_seconds());
    progress(Event::Expected(seconds.sum()));
    let error: Mutex<Option<io::Error>> = Mutex::new(None);
    next_and_longest(&expected, |place| {
        let index = open[place];
        let has_failed = error.lock().expect("no other thread panicked").is_some();
        if has_failed {
            return;
        }
        progress(Event::Begun(&tasks[index]));
        let watch = Watched {
            task: &tasks[index],
            progress,
        };
        let row = keeps.of(tasks[index].run(&watch));
        finished(index, row.clone());
        progress(Event::Done(&tasks[index], &row));
        // Last, so that what the journal has is handed out too, should the program be told to end.
        if let Some(Err(e)) = journal.map(|journal| journal.append(&row)) {
            *error.lock().expect("no other thread panicked") = Some(e);
        }
    });
    match error.into_inner().expect("no other thread panicked") {
        Some(error) => Err(error),
        None => Ok(()),
    }
}

/// As `run_tasks`, with the flat part of the rows in the order of the tasks.
///
/// # Errors
/// As `run_tasks`.
pub fn run_rows(
    tasks: &[Task],
    journal: Option<&Journal>,
    progress: &Progress,
) -> io::Result<Vec<Row>> {
    let rows: Vec<OnceLock<Row>> = tasks.iter().map(|_| OnceLock::new()).collect();
    run_tasks(
        tasks,
        &[],
        Keeps::Numbers,
        journal,
        progress,
        &|index, row| {
            rows[index].get_or_init(|| row);
        },
    )?;
    Ok(rows.into_iter().filter_map(OnceLock::into_inner).collect())
}
