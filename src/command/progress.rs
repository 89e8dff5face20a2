//! Progress of long work, with the time left, on standard error: a bar where that is a terminal, and
//! lines where a program asks for them.

use std::fmt::Write;
use std::sync::{Arc, Mutex};
use std::time::{Duration, Instant};

use super::screen::tells_progress;
use crate::method::SoFar;
use crate::number::{below, number};
use crate::run::{Event, Remaining, Row, Task};
use indicatif::{ProgressBar, ProgressState, ProgressStyle};

/// A bar that fills with the seconds expected of the work: tasks differ much in length. In a pipe,
/// nothing is printed but the lines that `--progress lines` asks for.
pub(super) struct Bar {
    bar: ProgressBar,
    known: Arc<Mutex<Known>>,
}

struct Known {
    began: Instant,
    remaining: Remaining,
}

impl Known {
    fn now(&self) -> f64 {
        self.began.elapsed().as_secs_f64()
    }
}

const CELLS: usize = 24;

impl Bar {
    pub(super) fn new() -> Self {
        let known = Arc::new(Mutex::new(Known {
            began: Instant::now(),
            remaining: Remaining::new(std::thread::available_parallelism().map_or(1, Into::into)),
        }));
        let template = "{filled} {elapsed}, about {left} left {wide_msg}";
        let style = ProgressStyle::with_template(template).expect("the template is valid");
        let (of_filled, of_left) = (known.clone(), known.clone());
        let style = style
            .with_key("filled", move |_: &ProgressState, text: &mut dyn Write| {
                let known = of_filled.lock().expect("no other thread panicked");
                let share = known.remaining.share_done(known.now());
                let full = (share * CELLS as f64) as usize;
                let (full, rest) = ("█".repeat(full), "░".repeat(CELLS - full));
                let _ = write!(text, "{full}{rest} {:>2.0} %", 99.0 * share);
            })
            .with_key("left", move |_: &ProgressState, text: &mut dyn Write| {
                let known = of_left.lock().expect("no other thread panicked");
                let _ = write!(text, "{}", in_words(known.remaining.left(known.now())));
            });
        let bar = ProgressBar::new_spinner();
        bar.set_style(style);
        bar.enable_steady_tick(Duration::from_millis(200));
        Self { bar, known }
    }

    /// Does something that prints, with the bar off the screen.
    pub(super) fn aside<T>(&self, work: impl FnOnce() -> T) -> T {
        self.bar.suspend(work)
    }

    /// Takes the bar off the screen, before anything else is printed.
    pub(super) fn clear(&self) {
        self.bar.finish_and_clear();
    }

    fn known(&self) -> std::sync::MutexGuard<'_, Known> {
        self.known.lock().expect("no other thread panicked")
    }

    pub(super) fn tell(&self, event: Event) {
        match event {
            Event::Expected(seconds) => self.known().remaining.expect(seconds),
            Event::Known(_) => {}
            Event::Begun(task) => {
                let mut known = self.known();
                let now = known.now();
                let expected = [task.expected_seconds(), task.seconds_alone()];
                known.remaining.begin(task.id(), expected, now);
            }
            Event::Proved(task, so_far) => self.proved(task, &so_far()),
            Event::Done(task, row) => self.done(task, row),
        }
    }

    fn proved(&self, task: &Task, so_far: &SoFar) {
        let (lower, state) = (below(so_far.proved.lower, 6), number(so_far.state, 6));
        if tells_progress() {
            let (name, push) = (task.scene_name(), so_far.push.name());
            eprintln!("proved {name} {push} {lower} {state}");
        }
        let method = task.describe();
        let message = format!("({method}: λ ≥ {lower} proved, lowest state {state})");
        self.bar.set_message(message);
    }

    fn done(&self, task: &Task, row: &Row) {
        let expected = task.expected_seconds();
        let mut known = self.known();
        known.remaining.end(task.id(), expected, row.seconds);
        if tells_progress() {
            let now = known.now();
            let (share, left) = (known.remaining.share_done(now), known.remaining.left(now));
            eprintln!("progress {share:.4} {left:.1}");
        }
        drop(known);
        self.bar
            .set_message(format!("({} is done)", task.describe()));
    }
}

fn in_words(seconds: f64) -> String {
    let whole = seconds.ceil() as u64;
    match whole {
        0..120 => format!("{whole} s"),
        120..7200 => format!("{} min", whole.div_ceil(60)),
        _ => format!("{} h", whole.div_ceil(3600)),
    }
}

#[cfg(test)]
mod tests {
    use super::in_words;

    #[test]
    fn times_are_said_in_one_unit() {
        let said = [0.0, 0.2, 119.0, 121.0, 7100.0, 7300.0].map(in_words);
        assert_eq!(said, ["0 s", "1 s", "119 s", "3 min", "119 min", "3 h"]);
    }
}
