//! Running: tasks on one schedule, answered as rows; cases, with what their rows are compared with.
//!
//! ```text
//! subject × method × settings ── task ── schedule ──▶ row ── columns ──▶ tables, files, studies
//! ```

mod cases;
mod columns;
mod ends;
pub(crate) mod execute;
mod journal;
mod kept;
mod partial;
mod progress;
mod proofs;
mod references;
mod remaining;
mod results;
mod row;
mod schedule;
mod sides;
mod stored;
pub(crate) mod task;

pub(crate) use cases::CaseRuns;
pub use cases::run;
pub(crate) use columns::{
    COLUMNS, Column, ColumnKind, Heading, Value, column, csv, csv_of, values,
};
pub(crate) use execute::run_rows;
pub(crate) use journal::Journal;
pub(crate) use kept::{Keeps, lines, read_line};
pub use partial::Partial;
pub(crate) use partial::{PARTIAL_MARK, marked, titled};
pub use progress::Event;
pub(crate) use progress::Progress;
pub(crate) use proofs::Proof;
pub(crate) use remaining::Remaining;
pub(crate) use results::named;
pub use results::{CaseResult, Plan};
pub use row::Row;
pub use sides::OtherSide;
pub(crate) use stored::{Stored, certificates, stored, strays};
pub use task::answer;
pub(crate) use task::{Subject, Task, fingerprint};
