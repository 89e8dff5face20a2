//! Progress of long work, with the time left: on standard error, and only where that is a terminal.

use std::time::Duration;

use indicatif::{ProgressBar, ProgressStyle};

/// A bar that fills task by task.
pub(super) struct Progress(ProgressBar);

impl Progress {
    /// A bar of `tasks` tasks. In a pipe, nothing is ever printed.
    pub(super) fn new(tasks: usize) -> Self {
        let bar = ProgressBar::new(tasks as u64);
        let template = "{bar:30} {pos}/{len} {elapsed} (left: {eta}) {wide_msg}";
        let style = ProgressStyle::with_template(template);
        bar.set_style(style.expect("the template is valid"));
        bar.enable_steady_tick(Duration::from_millis(200));
        Self(bar)
    }

    /// A bar of tasks that differ much in length, `seconds` in total: the time left follows the
    /// seconds expected of what is done, not the number of tasks.
    pub(super) fn weighted(seconds: f64) -> Self {
        let bar = ProgressBar::new(milliseconds(seconds));
        let template = "{bar:30} {percent}% {elapsed} (left: {eta}) {wide_msg}";
        let style = ProgressStyle::with_template(template);
        bar.set_style(style.expect("the template is valid"));
        bar.enable_steady_tick(Duration::from_millis(200));
        Self(bar)
    }

    /// A task is done that was expected to take so many seconds.
    pub(super) fn advance(&self, seconds: f64, what: impl Into<String>) {
        self.0.set_message(what.into());
        self.0.inc(milliseconds(seconds));
    }

    /// One task more is done, and what it was.
    pub(super) fn done(&self, what: impl Into<String>) {
        self.0.set_message(what.into());
        self.0.inc(1);
    }

    /// Takes the bar off the screen, before anything else is printed.
    pub(super) fn clear(&self) {
        self.0.finish_and_clear();
    }
}

fn milliseconds(seconds: f64) -> u64 {
    (seconds * 1e3).ceil() as u64
}
