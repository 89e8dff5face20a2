//! Limit analysis of the rigid blocks by linear programming.

mod associative;
mod interval;
mod program;
mod reduction;
mod sequential;
mod standing;
mod vertical;

pub use associative::Associative;
pub use interval::Interval;
pub use program::{Ending, Friction, Margins, Program, Scale, Solution};
pub use sequential::{Sequential, SequentialSettings, sequential};
