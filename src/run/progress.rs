//! What is told while tasks run.

use super::row::Row;
use super::task::Task;
use crate::method::SoFar;

/// Who is told what happens.
pub type Progress<'a> = dyn Fn(Event) + Sync + 'a;

/// What happens while tasks run.
#[derive(Clone, Copy)]
pub enum Event<'a, 't> {
    /// The open tasks may take so many CPU seconds together, roughly; none has begun.
    Expected(f64),
    /// A task was done before: a journal knows its row.
    Known(&'a Row),
    /// A task is begun.
    Begun(&'a Task<'t>),
    /// A task that goes on has proved a higher lower bound.
    Proved(&'a Task<'t>, &'a dyn Fn() -> SoFar),
    /// A task is done.
    Done(&'a Task<'t>, &'a Row),
}
