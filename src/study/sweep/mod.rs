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

mod compare;
mod file;
mod library;
mod name;
mod neighbours;
mod plan;
mod replace;
mod shard;
mod table;
mod values;
mod variants;

pub use compare::{SweepCheck, compare};
pub use library::embedded;
pub use plan::Sweep;
pub use shard::{MOST_SHARDS, Shard, merge};
pub use table::{sweep_csv, times_csv};
