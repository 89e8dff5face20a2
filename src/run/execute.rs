//! Runs the tasks of a sweep, with its journal.

use std::io;
use std::sync::{Mutex, OnceLock};

use super::Journal;
use crate::run::{Progress, Row, Task, longest_first};

/// Runs every task that the journal does not know and returns the rows in the order of the tasks.
/// Each row goes to the journal as it finishes, and then to `progress`; rows that the journal knows
/// go there at once.
///
/// # Errors
/// Where the journal cannot be written; nothing further is begun then.
pub fn run(
    tasks: &[Task],
    journal: Option<&Journal>,
    progress: &dyn Progress,
) -> io::Result<Vec<Row>> {
    let rows: Vec<OnceLock<Row>> = tasks.iter().map(|_| OnceLock::new()).collect();
    let mut open = Vec::new();
    for (index, task) in tasks.iter().enumerate() {
        match journal.and_then(|journal| journal.get(task.id())) {
            Some(row) => {
                progress.done(task, row);
                rows[index].get_or_init(|| row.clone());
            }
            None => open.push(index),
        }
    }
    let seconds: Vec<f64> = (open.iter().map(|&index| tasks[index].expected_seconds())).collect();
    progress.expected(seconds.iter().sum());
    let error: Mutex<Option<io::Error>> = Mutex::new(None);
    longest_first(&seconds, |turn| {
        let index = open[turn];
        let has_failed = error.lock().expect("no other thread panicked").is_some();
        if has_failed {
            return;
        }
        let row = tasks[index].run().kept();
        match journal.map_or(Ok(()), |journal| journal.append(&row)) {
            Ok(()) => progress.done(&tasks[index], &row),
            Err(e) => *error.lock().expect("no other thread panicked") = Some(e),
        }
        rows[index].get_or_init(|| row);
    });
    match error.into_inner().expect("no other thread panicked") {
        Some(error) => Err(error),
        None => Ok(rows.into_iter().filter_map(OnceLock::into_inner).collect()),
    }
}

#[cfg(test)]
mod tests {
    use std::borrow::Cow;
    use std::fs;
    use std::sync::atomic::{AtomicUsize, Ordering};

    use super::*;
    use crate::answer::{Outcome, Status};
    use crate::case;
    use crate::method::{Method, Settings};
    use crate::run::Subject;
    use crate::scene::{HeadJoints, Scene};
    use crate::study::sweep::sweep_csv;

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
        let sweep = |journal: Option<&Journal>| run(&tasks, journal, &()).unwrap();
        let alone = sweep_csv(&sweep(None)).unwrap();
        let crashed = "sliding-block,counting,failed,,,,,,,";
        assert!(alone.contains(crashed), "{alone}");
        calls.store(0, Ordering::SeqCst);
        let first = sweep_csv(&sweep(Some(&Journal::open(&path).unwrap()))).unwrap();
        assert_eq!((first.as_str(), calls.load(Ordering::SeqCst)), (&*alone, 5));
        // The end of the program in the middle of the last line, and rubbish before.
        let text = fs::read_to_string(&path).unwrap();
        fs::write(&path, format!("\0\0\n{}", &text[..text.len() - 9])).unwrap();
        let again = sweep_csv(&sweep(Some(&Journal::open(&path).unwrap()))).unwrap();
        assert_eq!((again.as_str(), calls.load(Ordering::SeqCst)), (&*alone, 6));
        sweep(Some(&Journal::open(&path).unwrap()));
        assert_eq!(calls.load(Ordering::SeqCst), 6);
    }

    #[test]
    fn a_journal_has_one_writer_and_says_one_thing() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("journal.jsonl");
        let calls = AtomicUsize::new(0);
        let journal = Journal::open(&path).unwrap();
        let refused = Journal::open(&path).err().unwrap();
        assert!(refused.title().contains("another process"), "{refused}");
        run(&tasks(&calls), Some(&journal), &()).unwrap();
        drop(journal);
        let text = fs::read_to_string(&path).unwrap();
        let line = text.lines().next().unwrap();
        fs::write(&path, format!("{text}{line}\n")).unwrap();
        assert!(Journal::open(&path).is_ok(), "the same row twice");
        let other = line.replace("counting", "accounting");
        fs::write(&path, format!("{text}{other}\n")).unwrap();
        let refused = Journal::open(&path).err().unwrap();
        assert!(refused.title().contains("says two things"), "{refused}");
    }
}
