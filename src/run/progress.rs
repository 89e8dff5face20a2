//! What is told while tasks run.

use super::row::Row;
use super::task::Task;
use crate::method::SoFar;

/// Who is told.
pub trait Progress: Sync {
    /// CPU seconds that tasks may take together, roughly, before the first of them begins.
    fn expected(&self, _seconds: f64) {}

    /// A task was done before: a journal knows its row.
    fn known(&self, _task: &Task, _row: &Row) {}

    /// A task is begun.
    fn begun(&self, _task: &Task) {}

    /// A task that goes on has proved a higher lower bound.
    fn proved(&self, _task: &Task, _so_far: &dyn Fn() -> SoFar) {}

    /// A task is done.
    fn done(&self, _task: &Task, _row: &Row) {}
}

/// Nobody.
impl Progress for () {}
