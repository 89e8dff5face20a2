//! The judge: recomputes every residual from forces and mechanism, outside the methods, and says
//! what holds between methods and against published values.

mod check;
mod cross_check;
mod proof;
mod references;

pub use check::{Check, Verdict};
pub(crate) use cross_check::{Answers, cross_check, open_never_raises};
pub use proof::judge;
pub use references::computed;
pub(crate) use references::{comparisons, reference_checks};
