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
