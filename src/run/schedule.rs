//! The one schedule: what is expected to take longest is begun first, so that no core waits for
//! another at the end; and results are shown in order all the same.

use std::collections::BTreeMap;
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};

/// Does the work of every index on all cores, in the order of the seconds expected, longest first;
/// of equal ones, the first.
pub fn longest_first(expected_seconds: &[f64], work: impl Fn(usize) + Sync) {
    let mut order: Vec<usize> = (0..expected_seconds.len()).collect();
    order.sort_by(|&a, &b| expected_seconds[b].total_cmp(&expected_seconds[a]));
    let next = AtomicUsize::new(0);
    let take_turns = || {
        while let Some(&index) = order.get(next.fetch_add(1, Ordering::Relaxed)) {
            work(index);
        }
    };
    rayon::scope(|scope| {
        for _ in 0..rayon::current_num_threads().min(order.len()) {
            scope.spawn(|_| take_turns());
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

    #[test]
    fn every_index_is_done_once_and_long_ones_first() {
        let done = Mutex::new(Vec::new());
        let pool = rayon::ThreadPoolBuilder::new().num_threads(1);
        let pool = pool.build().unwrap();
        let seconds = [1.0, 5.0, 0.1, 5.0, 2.0];
        pool.install(|| longest_first(&seconds, |index| done.lock().unwrap().push(index)));
        assert_eq!(done.into_inner().unwrap(), [1, 3, 4, 0, 2]);
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
