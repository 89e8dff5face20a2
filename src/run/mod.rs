//! Running: tasks on one schedule, answered as rows; cases, with what their rows are compared with.
//!
//! ```text
//! subject × method × settings ── task ── schedule ──▶ row ── columns ──▶ tables, files, studies
//! ```

mod columns;
mod kept;
mod progress;
mod results;
mod row;
mod schedule;
mod task;
mod weaker;

pub use columns::{Audience, COLUMNS, Column, Value, column, csv, values};
pub use progress::Progress;
pub use results::{CaseResult, Plan, Results, run, run_into};
pub use row::{Row, StrongerSide, scene_name};
pub use schedule::InOrder;
pub(crate) use schedule::longest_first;
pub use task::{Sides, Subject, Task, answer};
