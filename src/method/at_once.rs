//! Parts of one answer at once, where a core has nothing else to do.
//!
//! What another thread spends on a part is the owner's time and not its own: [`borrowed`] says by how
//! much a thread's clock is to be corrected. Answers never depend on it.

use std::cell::Cell;
use std::thread::{self, ThreadId};

use cpu_time::ThreadTime;

thread_local! {
    /// CPU seconds that others spent for this thread, less those that it spent for others.
    static BORROWED: Cell<f64> = const { Cell::new(0.0) };
}

/// CPU seconds that other threads have spent for this one, less those that this one has spent for
/// others, since it began.
pub(crate) fn borrowed() -> f64 {
    BORROWED.get()
}

fn add(seconds: f64) {
    BORROWED.set(BORROWED.get() + seconds);
}

/// Does both, the second on another thread where one is free, and returns what both return.
pub(super) fn both<A: Send, B: Send>(
    first: impl FnOnce() -> A + Send,
    second: impl FnOnce() -> B + Send,
) -> (A, B) {
    let owner = thread::current().id();
    let done = rayon::join(|| lent(owner, first), || lent(owner, second));
    let ((first, of_first), (second, of_second)) = done;
    add(of_first + of_second);
    (first, second)
}

/// Does something to each of them, some of it on other threads where those are free.
pub(super) fn each<T: Send>(items: &mut [T], work: &(impl Fn(&mut T) + Sync)) {
    match items {
        [] => {}
        [one] => work(one),
        _ => {
            let (some, others) = items.split_at_mut(items.len() / 2);
            both(|| each(some, work), || each(others, work));
        }
    }
}

/// Does something for a thread: what comes of it, and the CPU seconds that another thread spent on it.
fn lent<T>(owner: ThreadId, work: impl FnOnce() -> T) -> (T, f64) {
    let (clock, before) = (ThreadTime::now(), borrowed());
    let done = work();
    if thread::current().id() == owner {
        return (done, 0.0);
    }
    // What others lent meanwhile is part of it.
    let spent = clock.elapsed().as_secs_f64() + borrowed() - before;
    BORROWED.set(before - clock.elapsed().as_secs_f64());
    (done, spent)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// CPU seconds of some work, by the clock of the thread that does it.
    fn spend() -> f64 {
        let clock = ThreadTime::now();
        let mut sum = 0.0;
        while clock.elapsed().as_secs_f64() < 0.02 {
            sum += f64::sqrt(sum + 1.0);
        }
        assert!(sum > 0.0);
        clock.elapsed().as_secs_f64()
    }

    #[test]
    fn time_is_its_owners_whoever_spends_it() {
        let (clock, before) = (ThreadTime::now(), borrowed());
        let nested = || both(spend, spend);
        let (first, (second, third)) = both(spend, nested);
        let spent = clock.elapsed().as_secs_f64() + borrowed() - before;
        let sum = first + second + third;
        assert!((spent - sum).abs() < 0.2 * sum, "{spent}, not {sum}");
    }
}
