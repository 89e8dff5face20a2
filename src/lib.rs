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
//! other (a test holds both): number, text, files; scene; mechanics, certificate; answer; method; case; external; judge; run;
//! record; picture; study; report. The command line stands on top.
//!
//! A case read, solved and judged:
//!
//! ```
//! use trilith::{answer::Status, case, method, run};
//!
//! let cases = case::find("paper-1").expect("a file, a folder, or a case that is built in");
//! let plan = run::Plan {
//!     methods: method::methods().into_iter().filter(|m| m.name() == "associative").collect(),
//!     settings: method::Settings::default(),
//!     head_joints: None, // those of the case: in contact, then open
//! };
//! let results = run::run(&cases, &plan, &());
//! let row = &results[0].rows[0];
//! assert_eq!(row.status(), Status::Verified); // the judge's word, and not the method's
//! let lambda = row.bracket().expect("verified with both ends");
//! assert!((lambda.upper - 0.642859).abs() < 1e-6 && row.residual().is_some_and(|r| r < 1e-8));
//! ```
//!
//! A case of one's own is a TOML file, or its text in [`case::Case::read`]; a scene of one's own is
//! made by [`scene::Wall`], [`scene::Arch`] or [`scene::Scene::new`], and [`run::answer`] asks a
//! method about it and has the answer judged. A mistake in a case is a [`case::Complaint`] with file,
//! line and what to write instead; a method has no errors, as every ending is a
//! [`answer::Status`] with [`answer::Fact`]s that say why.
//!
//! Units and signs, once for all: x to the right, y up, rotations and moments counter-clockwise;
//! lengths and forces in any one consistent system. λ multiplies the live load, which for a wall is
//! the weight of each block (and of the overburden) acting sideways, so λ is also the horizontal
//! acceleration in units of g. Compression is positive; an opening joint has a positive rate.

pub mod answer;
pub mod case;
mod certificate;
mod command;
pub mod external;
pub mod files;
mod fingerprint;
pub mod judge;
mod mechanics;
pub mod method;
pub mod number;
pub mod picture;
pub mod record;
pub mod report;
pub mod run;
pub mod scene;
pub mod study;
pub mod text;

/// The program: reads the command line, and returns its exit status.
#[doc(hidden)]
pub fn main() -> std::process::ExitCode {
    command::main()
}

/// The example of README compiles and runs.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
