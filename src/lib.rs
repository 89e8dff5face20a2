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
//! record; picture; study; report. The command line stands on top. Public are scene, method, answer,
//! case, judge and run; the rest is the program's own.
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
//! let results = run::run(&cases, &plan, &|_| {});
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
mod external;
mod files;
mod fingerprint;
pub mod judge;
mod mechanics;
pub mod method;
mod number;
mod picture;
mod record;
mod report;
pub mod run;
pub mod scene;
mod study;
mod text;

/// The program: reads the command line, and returns its exit status.
#[doc(hidden)]
pub fn main() -> std::process::ExitCode {
    command::main()
}

/// For this house's own tests: what they look at inside. No contract, and gone without notice.
#[doc(hidden)]
pub mod inside {
    pub use crate::answer::bracket::magnitude;
    pub use crate::answer::fact::{
        AutoFact, Fact, JudgedFact, LimitFact, ProgramEnding, ProgramFailure, PushoverFact,
        SearchFailure, Uniqueness,
    };
    pub use crate::answer::standing::Standing;
    pub use crate::answer::{Checked, Repetition, SelfCheck};
    pub use crate::certificate::{LongestWay, Refusal, prove};
    pub use crate::external::{
        AnswerFile, External, SceneFile, answer_schema, export, parse, scene_schema,
    };
    pub use crate::mechanics::{
        dead_power, falling_violation, kinematic_multiplier, parts, thrust,
    };
    pub use crate::method::entries::{METHODS, without_lower_bounds};
    pub use crate::method::limit::ending::Ending;
    pub use crate::method::limit::program::Program;
    pub use crate::method::pushover::parameters::Parameters;
    pub use crate::method::pushover::run::solve_with;
    pub use crate::picture::{Options, View, dxf, figure};
    pub use crate::record::record;
    pub use crate::report::html::{manual, page};
    pub use crate::report::{case_table, csv, json_with_states, library_case, library_closing};
    pub use crate::run::execute::run_rows;
    pub use crate::run::task::{Subject, Task};
    pub use crate::text::Layout;

    /// The map of where methods are right.
    pub mod atlas {
        pub use crate::study::atlas::{
            Atlas, Cell, CellVerdict, Columns, Grid, grids, picture, running_bond,
        };
    }

    /// Speed against accuracy.
    pub mod chart {
        pub use crate::study::chart::{
            Chart, Measurement, csv, front, ladder, picture, reference, summaries,
        };
    }

    /// Values varied over ranges.
    pub mod sweep {
        pub use crate::study::sweep::{Sweep, SweepTable, embedded, sweep_picture};
    }
}

/// The example of README compiles and runs.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
