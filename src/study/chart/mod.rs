//! Speed against accuracy: every method over its ladder of settings, on one plane.
//!
//! ```text
//! cases × ladder ── sweep runner ──▶ table ──▶ chart.csv, chart.svg (a plot a scene)
//!                                      └────▶ summary.csv (a line a method and setting)
//! ```

mod ladder;
mod measurement;
mod picture;
mod reference;
mod summary;

pub use ladder::ladder;
pub use measurement::{Chart, Measurement, csv};
pub use picture::{front, picture};
pub use reference::reference;
pub use summary::{csv as summary_csv, summaries, table as summary_table};
