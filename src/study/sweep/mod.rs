//! Sweeps: an enumeration of points, run on all cores and kept as rows.
//!
//! ```text
//! FILE.sweep.toml ── plan ──▶ points ── run ──▶ rows ──▶ sweep.csv, times.csv, sweep.svg
//!                                        │
//!                                     journal (resume), shards (more machines)
//! ```
//!
//! A point is a method with its settings on a wall, named by a fingerprint of everything that
//! determines the answer. Charts and atlas make points in code and run them the same way.

mod compare;
mod curves;
mod file;
mod given;
mod library;
mod picture;
mod plan;
mod points;
mod replace;
mod shard;
mod values;
mod variants;

pub use compare::compare;
pub use library::embedded;
pub use picture::{sweep_picture, sweep_pictures};
pub use plan::Sweep;
pub use points::{SweepTable, VariableKind, times_csv};
pub use shard::{MOST_SHARDS, Shard, merge};
