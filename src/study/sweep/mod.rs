//! Sweeps: an enumeration of points, run on all cores and kept as rows.
//!
//! ```text
//! FILE.sweep.toml ── plan ──▶ points ── run ──▶ rows ──▶ sweep.csv, times.csv
//!                                        │
//!                                     journal (resume), shards (more machines)
//! ```
//!
//! A point is a method with its settings on a wall, named by a fingerprint of everything that
//! determines the answer. Charts and atlas make points in code and run them the same way.

mod execute;
mod file;
mod fingerprint;
mod journal;
mod library;
mod neighbours;
mod plan;
mod point;
mod replace;
mod row;
mod shard;
mod values;
mod variants;

pub use execute::run;
pub use journal::Journal;
pub use library::embedded;
pub use plan::Sweep;
pub use point::{Point, Subject};
pub use row::{Row, sweep_csv, times_csv};
pub use shard::{MOST_SHARDS, Shard, merge};
