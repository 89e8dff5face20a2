//! # trilith
//!
//! A validation and regression harness for the limit analysis of dry-joint masonry walls. The flow,
//! which the modules follow:
//!
//! ```text
//! cases/**.toml ── case ──▶ scene ──▶ method ──▶ outcome ──▶ judge ──▶ record ──▶ snapshots, tables
//!                                         │
//!                                  run (the only clock) ──▶ table, CSV, JSON
//! ```
//!
//! Units and signs, once for all: x to the right, y up, rotations and moments counter-clockwise;
//! lengths and forces in any one consistent system. λ multiplies the live load, which for a wall is
//! the weight of each block (and of the overburden) acting sideways, so λ is also the horizontal
//! acceleration in units of g. Compression is positive; an opening joint has a positive rate.

pub mod answer;
pub mod case;
pub mod external;
pub mod files;
mod fingerprint;
pub mod judge;
pub mod method;
pub mod number;
pub mod picture;
pub mod record;
pub mod report;
pub mod run;
pub mod scene;
pub mod study;
