//! # trilith
//!
//! A validation and regression harness for the limit analysis of dry-joint masonry walls. The flow,
//! which the modules follow:
//!
//! ```text
//! cases/**.toml ── case ──▶ scene ──▶ method ──▶ answer ──▶ judge ──▶ record ──▶ snapshots
//!                                       │
//!              run (the only clock, the only schedule) ──▶ rows ──▶ study, picture, report
//! ```
//!
//! The modules are floors of a house. Each uses only those before it, and no two files use each
//! other (a test holds both): number, files; scene; answer; method; case; external; judge; run;
//! record; picture; study; report. The command line stands on top.
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
