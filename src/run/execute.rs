//! The one runner: tasks on the schedule, with a journal of those that are finished.

use std::io;
use std::sync::{Mutex, OnceLock};

use super::journal::Journal;
use super::kept::Keeps;
use super::progress::Progress;
use super::row::Row;
use super::schedule::{Expected, next_and_longest};
use super::task::Task;

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
    progress: &dyn Progress,
    finished: &(dyn Fn(usize, Row) + Sync),
) -> io::Result<()> {
    let mut open = Vec::new();
    for (index, task) in tasks.iter().enumerate() {
        match journal.and_then(|journal| journal.get(task.id())) {
            Some(row) => {
                finished(index, row.clone());
                progress.known(task, row);
            }
            None => open.push(index),
        }
    }
    let expected = open.iter().map(|&index| Expected {
        seconds: tasks[index].seconds_alone(),
        turn: turns.get(index).copied().unwrap_or(0),
    });
    let expected: Vec<Expected> = expected.collect();
    progress.expected(open.iter().map(|&i| tasks[i].expected_seconds()).sum());
    let error: Mutex<Option<io::Error>> = Mutex::new(None);
    next_and_longest(&expected, |place| {
        let index = open[place];
        let has_failed = error.lock().expect("no other thread panicked").is_some();
        if has_failed {
            return;
        }
        progress.begun(&tasks[index]);
        let row = keeps.of(tasks[index].run());
        finished(index, row.clone());
        progress.done(&tasks[index], &row);
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
    progress: &dyn Progress,
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

#[cfg(test)]
mod tests {
    use std::borrow::Cow;
    use std::fs;
    use std::path::Path;
    use std::sync::atomic::{AtomicUsize, Ordering};

    use super::*;
    use crate::answer::{Outcome, Status};
    use crate::case::{self, Complaint};
    use crate::method::{Method, Settings};
    use crate::run::{Subject, csv, read_line, values};
    use crate::scene::{HeadJoints, Scene};

    fn open(path: &Path) -> Result<Journal, Complaint> {
        Journal::open(path, Keeps::Numbers)
    }

    /// What rows say, apart from the time.
    fn told(rows: &[Row]) -> Result<String, csv::Error> {
        let names = ["case", "method", "status", "reason"];
        csv(names, rows.iter().map(|row| values(row, &names)))
    }

    /// Counts its calls; panics on the third task.
    struct Counting<'a>(&'a AtomicUsize, usize);

    impl Method for Counting<'_> {
        fn name(&self) -> &str {
            "counting"
        }

        fn solve(&self, _scene: &Scene, _settings: &Settings) -> Outcome {
            self.0.fetch_add(1, Ordering::SeqCst);
            assert_ne!(self.1, 3, "three is too many");
            Outcome::without_number(Status::Undecided, format!("number {}", self.1))
        }
    }

    fn tasks(calls: &AtomicUsize) -> Vec<Task<'_>> {
        let number = |number: usize| {
            let subject = Subject {
                case: "sliding-block".into(),
                parameters: vec![("number".into(), number.to_string())],
                blocks: number,
                head_joints: HeadJoints::Contact,
                sides: Box::new(|| {
                    let case = case::find("sliding-block").expect("it is built in");
                    Cow::Owned(case[0].sides(HeadJoints::Contact))
                }),
                determined_by: Vec::new(),
            };
            Task::new(subject, Counting(calls, number), Settings::default())
        };
        (1..=5).map(number).collect()
    }

    #[test]
    fn a_torn_journal_is_completed_and_nothing_is_repeated() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("deep/journal.jsonl");
        let calls = AtomicUsize::new(0);
        let tasks = tasks(&calls);
        let sweep = |journal: Option<&Journal>| run_rows(&tasks, journal, &()).unwrap();
        let alone = told(&sweep(None)).unwrap();
        let crashed = "sliding-block,counting,failed,";
        assert!(alone.contains(crashed), "{alone}");
        calls.store(0, Ordering::SeqCst);
        let first = told(&sweep(Some(&open(&path).unwrap()))).unwrap();
        assert_eq!((first.as_str(), calls.load(Ordering::SeqCst)), (&*alone, 5));
        // The end of the program in the middle of the last line, and rubbish before.
        let text = fs::read_to_string(&path).unwrap();
        fs::write(&path, format!("\0\0\n{}", &text[..text.len() - 9])).unwrap();
        let again = told(&sweep(Some(&open(&path).unwrap()))).unwrap();
        assert_eq!((again.as_str(), calls.load(Ordering::SeqCst)), (&*alone, 6));
        sweep(Some(&open(&path).unwrap()));
        assert_eq!(calls.load(Ordering::SeqCst), 6);
    }

    #[test]
    fn a_journal_has_one_writer_and_says_one_thing() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("journal.jsonl");
        let calls = AtomicUsize::new(0);
        let journal = open(&path).unwrap();
        let refused = open(&path).err().unwrap();
        assert!(refused.title().contains("another process"), "{refused}");
        run_rows(&tasks(&calls), Some(&journal), &()).unwrap();
        drop(journal);
        let text = fs::read_to_string(&path).unwrap();
        let line = text.lines().next().unwrap();
        fs::write(&path, format!("{text}{line}\n")).unwrap();
        assert!(open(&path).is_ok(), "the same row twice");
        let mut row = read_line(line.as_bytes()).unwrap();
        row.method = "accounting".to_owned();
        let other = Keeps::Numbers.line(&row).unwrap().unwrap();
        fs::write(&path, format!("{text}{other}")).unwrap();
        let refused = open(&path).err().unwrap();
        assert!(refused.title().contains("says two things"), "{refused}");
    }
}
