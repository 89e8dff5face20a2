//! Speed against accuracy: every method over its ladder of settings, on one plane.
//!
//! ```text
//! cases × ladder ── sweep runner ──▶ table ──▶ chart.csv, chart.svg (a panel a scene)
//!                                      └────▶ summary.csv (a line a method and setting)
//! ```

mod labels;
mod ladder;
mod picture;
mod reference;
mod summary;
mod table;

pub use ladder::{Step, ladder};
pub use picture::picture;
pub use reference::reference;
pub use summary::{SHIFT, Summary, WITHIN, csv as summary_csv, summaries, table as summary_table};
pub use table::{Entry, csv, run};

/// How much smaller an error must be to be worth more time: the rest is noise of the clock.
const BETTER: f64 = 0.9;

/// Members of the front: entries that no other one beats in both time and error, fastest first.
pub fn front<'a>(entries: &[&'a Entry]) -> Vec<&'a Entry> {
    let mut answered: Vec<(&'a Entry, f64)> = (entries.iter())
        .filter_map(|entry| Some((*entry, entry.error()?)))
        .collect();
    answered.sort_by(|(a, x), (b, y)| a.row.seconds.total_cmp(&b.row.seconds).then(x.total_cmp(y)));
    let mut best = f64::INFINITY;
    answered.retain(|(_, error)| {
        // What is exact to the references' digits cannot be beaten by more digits.
        let better = *error < BETTER * best && best > picture::FLOOR;
        if better {
            best = *error;
        }
        better
    });
    answered.into_iter().map(|(entry, _)| entry).collect()
}
