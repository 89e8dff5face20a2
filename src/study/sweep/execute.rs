//! Runs the points of a sweep on all cores.

use std::any::Any;
use std::io;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::{Mutex, OnceLock};

use super::{Journal, Point, Row};
use crate::answer::{Outcome, Status};
use crate::run::{Answer, Task, in_turn, solve};

/// Runs every point that the journal does not know, long ones first, and returns the rows in the
/// order of the points. Each row goes to the journal as it finishes, and then to `finished`; rows
/// that the journal knows go there at once.
///
/// # Errors
/// Where the journal cannot be written; nothing further is begun then.
pub fn run(
    points: &[Point],
    journal: Option<&Journal>,
    finished: impl Fn(&Point, &Row) + Sync,
) -> io::Result<Vec<Row>> {
    let rows: Vec<OnceLock<Row>> = points.iter().map(|_| OnceLock::new()).collect();
    let mut open = Vec::new();
    for (index, point) in points.iter().enumerate() {
        match journal.and_then(|journal| journal.get(point.id())) {
            Some(row) => {
                finished(point, row);
                rows[index].get_or_init(|| row.clone());
            }
            None => open.push(index),
        }
    }
    let longest = |index: &usize| -points[*index].expected_seconds();
    // A stable sort: of equal points, the first.
    open.sort_by(|a, b| longest(a).total_cmp(&longest(b)));
    let error: Mutex<Option<io::Error>> = Mutex::new(None);
    in_turn(&open, |index| {
        let has_failed = error.lock().expect("no other thread panicked").is_some();
        if has_failed {
            return;
        }
        let row = row(&points[index]);
        match journal.map_or(Ok(()), |journal| journal.append(&row)) {
            Ok(()) => finished(&points[index], &row),
            Err(e) => *error.lock().expect("no other thread panicked") = Some(e),
        }
        rows[index].get_or_init(|| row);
    });
    match error.into_inner().expect("no other thread panicked") {
        Some(error) => Err(error),
        None => Ok(rows.into_iter().filter_map(OnceLock::into_inner).collect()),
    }
}

/// Runs one point. A method that panics has failed, and the other points go on.
fn row(point: &Point) -> Row {
    let sides = point.sides();
    let task = Task {
        sides: &sides,
        method: point.method(),
        settings: point.settings(),
    };
    let solved = catch_unwind(AssertUnwindSafe(|| solve(&task)));
    let answer = solved.unwrap_or_else(|panic| Answer {
        outcome: Outcome::without_number(Status::Failed, said(&*panic)),
        side: 0,
        residual: None,
        seconds: 0.0,
    });
    let scene = &sides[answer.side];
    Row::new(point, [scene.blocks().len(), scene.joints().len()], &answer)
}

fn said(panic: &(dyn Any + Send)) -> String {
    let text = panic.downcast_ref::<String>().map(String::as_str);
    let text = text.or_else(|| panic.downcast_ref::<&str>().copied());
    let words: Vec<&str> = text
        .unwrap_or("without a word")
        .split_whitespace()
        .collect();
    format!("the method panicked: {}", words.join(" "))
}

#[cfg(test)]
mod tests {
    use std::fs;
    use std::sync::atomic::{AtomicUsize, Ordering};

    use super::*;
    use crate::case;
    use crate::method::{Method, Settings};
    use crate::scene::{HeadJoints, Scene};
    use crate::study::sweep::{Subject, sweep_csv};

    /// Counts its calls; panics on the third point.
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

    fn points(calls: &AtomicUsize) -> Vec<Point<'_>> {
        let number = |number: usize| {
            let subject = Subject {
                case: "sliding-block".into(),
                parameters: vec![("number".into(), number.to_string())],
                blocks: number,
                sides: Box::new(|| {
                    let case = case::find("sliding-block").expect("it is built in");
                    case[0].sides(HeadJoints::Contact)
                }),
                determined_by: Vec::new(),
            };
            Point::new(subject, Counting(calls, number), Settings::default())
        };
        (1..=5).map(number).collect()
    }

    #[test]
    fn a_torn_journal_is_completed_and_nothing_is_repeated() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("deep/journal.jsonl");
        let calls = AtomicUsize::new(0);
        let points = points(&calls);
        let sweep = |journal: Option<&Journal>| run(&points, journal, |_, _| {}).unwrap();
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
        run(&points(&calls), Some(&journal), |_, _| {}).unwrap();
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
