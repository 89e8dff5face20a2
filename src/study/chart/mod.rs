//! Speed against accuracy: every method over its ladder of settings, on one plane.
//!
//! ```text
//! cases × ladder ── sweep runner ──▶ table ──▶ chart.csv, chart.svg (a plot a scene)
//!                                      └────▶ summary.csv (a line a method and setting)
//! ```

mod front;
mod highest;
mod ladder;
mod measurement;
mod picture;
mod reference;
mod summary;

pub use front::front;
pub use ladder::ladder;
pub use measurement::{Chart, Measurement, csv};
pub use picture::picture;
pub use reference::reference;
pub use summary::{csv as summary_csv, summaries, table as summary_table};
