//! The one schedule: what is expected to take longest is begun first, so that no core waits for
//! another at the end, while one core works on whatever is shown next; and results are shown in order.

use std::cmp::Ordering::Equal;
use std::collections::BTreeMap;
use std::sync::Mutex;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};

/// Some work, as the schedule sees it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Expected {
    /// Seconds that it may take, roughly, where other cores help as far as they can.
    pub seconds: f64,
    /// When its result is shown: those of a lower turn come first.
    pub turn: usize,
}

/// Does the work of every index on all cores. One of them takes what is shown next, so that the first
/// result does not wait for the longest work; the others take the longest that is left. Of equal work
/// the first comes first. With one core everything is done in the order of the turns.
pub fn next_and_longest(expected: &[Expected], work: impl Fn(usize) + Sync) {
    let longer = |&a: &usize, &b: &usize| expected[b].seconds.total_cmp(&expected[a].seconds);
    let mut longest: Vec<usize> = (0..expected.len()).collect();
    longest.sort_by(longer);
    let mut shown_next = longest.clone();
    shown_next.sort_by(|&a, &b| match expected[a].turn.cmp(&expected[b].turn) {
        Equal => longer(&a, &b),
        turn => turn,
    });
    let taken: Vec<AtomicBool> = expected.iter().map(|_| AtomicBool::new(false)).collect();
    let take_turns = |order: &[usize]| {
        for &index in order {
            if !taken[index].swap(true, Ordering::Relaxed) {
                work(index);
            }
        }
    };
    let workers = AtomicUsize::new(0);
    rayon::scope(|scope| {
        for _ in 0..rayon::current_num_threads().min(expected.len()) {
            scope.spawn(|_| match workers.fetch_add(1, Ordering::Relaxed) {
                0 => take_turns(&shown_next),
                _ => take_turns(&longest),
            });
        }
    });
}

/// Results that come in any order and are shown in theirs, each as soon as those before it are
/// there.
pub struct InOrder<T> {
    waiting: Mutex<Waiting<T>>,
}

struct Waiting<T> {
    next: usize,
    results: BTreeMap<usize, T>,
    /// Results that were shown.
    shown: Vec<T>,
}

impl<T> Default for InOrder<T> {
    fn default() -> Self {
        let waiting = Waiting {
            next: 0,
            results: BTreeMap::new(),
            shown: Vec::new(),
        };
        Self {
            waiting: Mutex::new(waiting),
        }
    }
}

impl<T> InOrder<T> {
    /// Takes the result of an index, and shows it and those behind it whose turn has come. One
    /// thread shows at a time.
    pub fn add(&self, index: usize, result: T, mut show: impl FnMut(&T)) {
        let mut waiting = self.waiting.lock().expect("showing does not panic");
        waiting.results.insert(index, result);
        let mut next = waiting.next;
        while let Some(result) = waiting.results.remove(&next) {
            show(&result);
            waiting.shown.push(result);
            next += 1;
        }
        waiting.next = next;
    }

    /// Takes what is there, in order: results that were shown, and results whose turn has not come,
    /// because one before them is missing. Nothing is shown afterwards.
    pub fn take(&self) -> (Vec<T>, Vec<(usize, T)>) {
        let mut waiting = self.waiting.lock().expect("showing does not panic");
        waiting.next = usize::MAX;
        let shown = std::mem::take(&mut waiting.shown);
        let rest = std::mem::take(&mut waiting.results);
        (shown, rest.into_iter().collect())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn done_on(threads: usize, expected: &[Expected]) -> Vec<usize> {
        let done = Mutex::new(Vec::new());
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads);
        let pool = pool.build().unwrap();
        pool.install(|| next_and_longest(expected, |index| done.lock().unwrap().push(index)));
        done.into_inner().unwrap()
    }

    #[test]
    fn every_index_is_done_once_and_long_ones_first() {
        let seconds = [1.0, 5.0, 0.1, 5.0, 2.0];
        let expected = seconds.map(|seconds| Expected { seconds, turn: 0 });
        assert_eq!(done_on(1, &expected), [1, 3, 4, 0, 2]);
        let mut done = done_on(3, &expected);
        done.sort_unstable();
        assert_eq!(done, [0, 1, 2, 3, 4]);
    }

    #[test]
    fn what_is_shown_first_does_not_wait_for_what_is_long() {
        let expected = [(0.1, 0), (0.2, 0), (24.0, 1), (0.1, 1), (30.0, 2)];
        let expected = expected.map(|(seconds, turn)| Expected { seconds, turn });
        assert_eq!(done_on(1, &expected), [1, 0, 2, 3, 4]);
    }

    #[test]
    fn results_are_shown_in_order_as_soon_as_possible() {
        let in_order = InOrder::default();
        let mut shown = Vec::new();
        for (index, expected) in [(1, vec![]), (0, vec![0, 1]), (3, vec![0, 1])] {
            in_order.add(index, index, |&result| shown.push(result));
            assert_eq!(shown, expected);
        }
        assert_eq!(in_order.take(), (vec![0, 1], vec![(3, 3)]));
        in_order.add(2, 2, |&result| shown.push(result));
        assert_eq!(shown, [0, 1], "nothing is shown once the rest was taken");
    }
}
