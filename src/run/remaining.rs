//! The time that is left, told by what the work is expected to take and not by how many rows are done.

use std::collections::BTreeMap;

/// What is known of tasks while they run. Times are seconds since the first was begun.
#[derive(Debug)]
pub struct Remaining {
    threads: usize,
    /// Expected CPU seconds of all tasks.
    all: f64,
    /// Expected CPU seconds of those that are done, and what they took.
    done: [f64; 2],
    /// Those that run, by their ids.
    running: BTreeMap<String, Running>,
}

/// A task that runs.
#[derive(Clone, Copy, Debug)]
struct Running {
    /// Expected CPU seconds.
    expected: f64,
    /// Of these, those that no second thread can take off.
    alone: f64,
    begun: f64,
}

/// Seconds that this machine is taken to need for as many expected ones, until some tasks are done.
const PRIOR: f64 = 1.0;

/// Least part of the time that a task has run that it is taken to run on: it may take longer than
/// expected.
const ON: f64 = 0.1;

impl Remaining {
    /// Nothing is expected yet, on so many threads.
    pub fn new(threads: usize) -> Self {
        Self {
            threads: threads.max(1),
            all: 0.0,
            done: [0.0; 2],
            running: BTreeMap::new(),
        }
    }

    /// More work is expected, CPU seconds.
    pub fn expect(&mut self, seconds: f64) {
        self.all += seconds;
    }

    /// A task is begun, of so many expected CPU seconds, and so many of these that no second thread can
    /// take off.
    pub fn begin(&mut self, id: &str, [expected, alone]: [f64; 2], now: f64) {
        let running = Running {
            expected,
            alone,
            begun: now,
        };
        self.running.insert(id.to_owned(), running);
    }

    /// A task is done and took so many CPU seconds.
    pub fn end(&mut self, id: &str, expected: f64, took: f64) {
        self.running.remove(id);
        self.done[0] += expected;
        self.done[1] += took;
    }

    /// How many times as long tasks take as expected, judged by those that are done.
    fn pace(&self) -> f64 {
        let [expected, took] = self.done;
        (took + PRIOR) / (expected + PRIOR)
    }

    /// What is left of a task that runs.
    fn left_of(&self, task: Running, now: f64) -> f64 {
        let run = (now - task.begun).max(0.0);
        (task.expected * self.pace() - run).max(ON * run)
    }

    /// Seconds until all is done, roughly.
    pub fn left(&self, now: f64) -> f64 {
        let running = || {
            self.running
                .values()
                .map(|&task| (task, self.left_of(task, now)))
        };
        let expected: f64 = running().map(|(task, _)| task.expected).sum();
        let left: f64 = running().map(|(_, left)| left).sum();
        let waiting = (self.all - self.done[0] - expected).max(0.0) * self.pace();
        let shared = (left + waiting) / self.threads as f64;
        // Other threads may take parts of a task off, but not all of it.
        let alone = running().map(|(task, left)| left * task.alone / task.expected.max(1e-9));
        alone.fold(shared, f64::max)
    }

    /// How much of the work is done, from 0 to 1.
    pub fn share_done(&self, now: f64) -> f64 {
        let running = self.running.values().map(|&task| {
            let run = (now - task.begun).max(0.0);
            task.expected * run / (run + self.left_of(task, now)).max(1e-9)
        });
        let done = self.done[0] + running.sum::<f64>();
        if self.all > 0.0 {
            (done / self.all).min(1.0)
        } else {
            0.0
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// CPU seconds of the main job's long tasks, measured: expected and taken.
    const TASKS: [[f64; 2]; 6] = [
        [30.4, 42.7],
        [19.9, 31.7],
        [10.0, 7.2],
        [1.8, 3.4],
        [1.3, 1.7],
        [0.9, 0.6],
    ];

    /// At any moment of the first task that is done, the time left is right to a factor of two, where
    /// rows that are done say nothing at all.
    #[test]
    fn the_time_left_knows_the_long_work() {
        let mut remaining = Remaining::new(2);
        remaining.expect(TASKS.iter().map(|task| task[0]).sum());
        // The longest runs alone on one thread; the other takes the rest, one after the other.
        remaining.begin("0", [TASKS[0][0]; 2], 0.0);
        let end = TASKS[1..].iter().map(|task| task[1]).sum::<f64>();
        assert!(end > TASKS[0][1]);
        let mut now = 0.0;
        for (index, [expected, took]) in TASKS.into_iter().enumerate().skip(1) {
            let id = index.to_string();
            remaining.begin(&id, [expected; 2], now);
            let middle = now + took / 2.0;
            if middle < 0.8 * end {
                let (left, truth) = (remaining.left(middle), end - middle);
                assert!(
                    (0.5..2.0).contains(&(left / truth)),
                    "{middle}: {left}, not {truth}"
                );
            }
            now += took;
            remaining.end(&id, expected, took);
        }
        remaining.end("0", TASKS[0][0], TASKS[0][1]);
        assert_eq!(remaining.left(now), 0.0);
        assert!((remaining.share_done(now) - 1.0).abs() < 1e-9);
    }

    #[test]
    fn a_task_that_takes_longer_than_expected_is_not_done() {
        let mut remaining = Remaining::new(4);
        remaining.expect(1.0);
        remaining.begin("a", [1.0, 1.0], 0.0);
        assert!((remaining.left(50.0) - 5.0).abs() < 1e-9);
        remaining.begin("a", [1.0, 0.5], 0.0);
        assert!((remaining.left(50.0) - 2.5).abs() < 1e-9);
        assert!(remaining.share_done(50.0) < 1.0);
    }
}
