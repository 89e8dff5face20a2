//! Progress of long work, with the time left: on standard error, and only where that is a terminal.

use std::time::Duration;

use indicatif::{ProgressBar, ProgressStyle};
use trilith::run::{Progress, Row, Task};

/// A bar that fills with the seconds expected of what is done: tasks differ much in length. In a
/// pipe, nothing is ever printed.
pub(super) struct Bar(ProgressBar);

impl Bar {
    /// An empty bar.
    pub(super) fn new() -> Self {
        let bar = ProgressBar::new(0);
        let template = "{bar:30} {percent}% {elapsed} (left: {eta}) {wide_msg}";
        let style = ProgressStyle::with_template(template);
        bar.set_style(style.expect("the template is valid"));
        bar.enable_steady_tick(Duration::from_millis(200));
        Self(bar)
    }

    /// Does something that prints, with the bar off the screen.
    pub(super) fn aside<T>(&self, work: impl FnOnce() -> T) -> T {
        self.0.suspend(work)
    }

    /// Takes the bar off the screen, before anything else is printed.
    pub(super) fn clear(&self) {
        self.0.finish_and_clear();
    }
}

impl Progress for Bar {
    fn expected(&self, seconds: f64) {
        self.0.inc_length(milliseconds(seconds));
    }

    fn done(&self, task: &Task, _row: &Row) {
        self.0.set_message(task.describe());
        self.0.inc(milliseconds(task.expected_seconds()));
    }
}

fn milliseconds(seconds: f64) -> u64 {
    (seconds * 1e3).ceil() as u64
}
