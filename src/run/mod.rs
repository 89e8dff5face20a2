//! Running: tasks on one schedule, answered as rows; cases, with what their rows are compared with.
//!
//! ```text
//! subject × method × settings ── task ── schedule ──▶ row ── columns ──▶ tables, files, studies
//! ```

mod cases;
mod columns;
mod execute;
mod journal;
mod kept;
mod partial;
mod progress;
mod remaining;
mod results;
mod row;
mod schedule;
mod stored;
mod task;
mod weaker;

pub use cases::{CaseRuns, run};
pub use columns::{COLUMNS, Column, ColumnKind, Value, column, csv, values};
pub use execute::{run_rows, run_tasks};
pub use journal::Journal;
pub use kept::Keeps;
pub(crate) use kept::{lines, read_line};
pub use partial::{PARTIAL_MARK, Partial, marked, titled};
pub use progress::Progress;
pub use remaining::Remaining;
pub use results::{CaseResult, CaseScenes, Plan};
pub use row::{Row, StrongerSide, scene_name};
pub use stored::{Stored, certificates, stored};
pub(crate) use task::fingerprint;
pub use task::{Sides, Subject, Task, answer};
