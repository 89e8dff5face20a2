//! Ctrl-C: what is finished is left behind.
//!
//! Long work runs inside [`or_leave`] and puts each finished result where `leave` finds it: in a
//! journal on disk, or behind a `Mutex`. On Ctrl-C (or SIGTERM, which batch systems send) `leave`
//! writes or names what is there while the work still goes on, so it takes the same lock; then the
//! program ends with exit status 130. A second Ctrl-C ends it at once: files are written whole, so
//! even that leaves none half-written.

use std::sync::Once;
use std::sync::atomic::{AtomicBool, Ordering};
use std::thread;
use std::time::Duration;

/// Exit status after Ctrl-C: 128 and the number of the signal.
const INTERRUPTED: i32 = 130;

/// Set by the first Ctrl-C.
static ASKED: AtomicBool = AtomicBool::new(false);

/// Runs `work` to its end, or until Ctrl-C: then `leave`, and the program ends.
pub(super) fn or_leave<T: Send>(work: impl FnOnce() -> T + Send, leave: impl FnOnce()) -> T {
    static HANDLED: Once = Once::new();
    HANDLED.call_once(|| {
        let watched = ctrlc::set_handler(|| {
            if ASKED.swap(true, Ordering::SeqCst) {
                std::process::exit(INTERRUPTED);
            }
        });
        // Without a handler Ctrl-C ends the program as it does any other.
        if let Err(error) = watched {
            eprintln!("warning: Ctrl-C will not leave finished results behind: {error}");
        }
    });
    let here = thread::current();
    thread::scope(|scope| {
        let worker = scope.spawn(move || {
            let done = work();
            here.unpark();
            done
        });
        while !worker.is_finished() {
            if ASKED.load(Ordering::SeqCst) {
                leave();
                std::process::exit(INTERRUPTED);
            }
            thread::park_timeout(Duration::from_millis(20));
        }
        match worker.join() {
            Ok(done) => done,
            Err(panic) => std::panic::resume_unwind(panic),
        }
    })
}
