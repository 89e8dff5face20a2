//! Signals: what is finished is left behind.
//!
//! Long work runs inside [`or_leave`] and puts each finished result where `leave` finds it: in a
//! journal on disk, or behind a `Mutex`. On SIGINT (Ctrl-C), SIGTERM (batch systems) or SIGHUP (a
//! closed terminal) `leave` prints and writes what is there while the work still goes on, so it takes
//! the same lock; then the program ends with exit status 128 and the number of the signal. Work that
//! is done is handed out whole, whatever comes meanwhile. Before and without long work a signal ends
//! the program at once.
//!
//! Further signals do nothing for two seconds, as two may come at once; later ones end the program,
//! should handing out hang. Files are written whole, so that even that leaves none half-written. A
//! signal that the program was started to ignore, as `nohup` does with SIGHUP, is ignored.

use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::{Arc, OnceLock};
use std::thread;
use std::time::Duration;

use crate::external::stop_all;
use signal_hook::consts::{SIGINT, SIGTERM};
use signal_hook::flag;

use super::screen::tell;

/// Time for which further signals do nothing.
const DELAY: Duration = Duration::from_secs(2);

/// Time between two looks at what has come.
const POLL_INTERVAL: Duration = Duration::from_millis(20);

/// The signals, with the names that people know.
const SIGNALS: &[(i32, &str)] = &[
    (SIGINT, "SIGINT"),
    (SIGTERM, "SIGTERM"),
    #[cfg(unix)]
    (signal_hook::consts::SIGHUP, "SIGHUP"),
];

/// What the handlers do and tell.
struct Watch {
    /// Whether a signal ends the program at once.
    at_once: Arc<AtomicBool>,
    /// The last signal that has come while none did; 0 for none.
    came: Arc<AtomicUsize>,
}

static WATCH: OnceLock<Watch> = OnceLock::new();

/// Begins to watch for signals: the first thing that the program does.
pub(super) fn watch() {
    let watch = WATCH.get_or_init(|| Watch {
        at_once: Arc::new(AtomicBool::new(true)),
        came: Arc::default(),
    });
    for &(signal, name) in SIGNALS {
        if is_ignored(signal) {
            continue;
        }
        let at_once = flag::register_conditional_shutdown(
            signal,
            status(signal as usize).into(),
            watch.at_once.clone(),
        );
        let told =
            at_once.and_then(|_| flag::register_usize(signal, watch.came.clone(), signal as usize));
        // Without a handler the signal ends the program as it does any other.
        if let Err(error) = told {
            tell!("warning: {name} will not leave finished results behind: {error}");
        }
    }
}

/// Whether the program was started to ignore a signal. Where nothing tells, SIGHUP is left as it is,
/// because `nohup` counts on it.
fn is_ignored(signal: i32) -> bool {
    let about = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let mask = about.lines().find_map(|line| line.strip_prefix("SigIgn:"));
    match mask.and_then(|mask| u64::from_str_radix(mask.trim(), 16).ok()) {
        Some(mask) => mask >> (signal - 1) & 1 == 1,
        None => signal != SIGINT && signal != SIGTERM,
    }
}

fn status(signal: usize) -> u8 {
    128 + signal as u8
}

/// Runs `work` to its end, or until a signal: then `leave`, which is told why, and the program ends.
pub(super) fn or_leave<T: Send>(work: impl FnOnce() -> T + Send, leave: impl FnOnce(&str)) -> T {
    let Some(watch) = WATCH.get() else {
        return work();
    };
    watch.at_once.store(false, Ordering::SeqCst);
    let (at_once, came) = (watch.at_once.clone(), watch.came.clone());
    thread::spawn(move || end_at_once_after_delay(&at_once, &came));
    let here = thread::current();
    thread::scope(|scope| {
        let worker = scope.spawn(move || {
            let done = work();
            here.unpark();
            done
        });
        while !worker.is_finished() {
            let signal = watch.came.load(Ordering::SeqCst);
            if signal != 0 {
                leave(&format!("interrupted by {}", name(signal)));
                stop_all();
                std::process::exit(status(signal).into());
            }
            thread::park_timeout(POLL_INTERVAL);
        }
        match worker.join() {
            Ok(done) => done,
            Err(panic) => std::panic::resume_unwind(panic),
        }
    })
}

/// Lets signals end the program at once, a while after the first.
fn end_at_once_after_delay(at_once: &AtomicBool, came: &AtomicUsize) {
    while came.load(Ordering::SeqCst) == 0 {
        thread::sleep(POLL_INTERVAL);
    }
    thread::sleep(DELAY);
    at_once.store(true, Ordering::SeqCst);
}

fn name(signal: usize) -> &'static str {
    let known = SIGNALS.iter().find(|(known, _)| *known as usize == signal);
    known.map_or("a signal", |(_, name)| name)
}
