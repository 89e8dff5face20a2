//! Limit analysis of the rigid blocks by linear programming.

mod associative;
mod program;
mod sequential;

pub use associative::Associative;
pub use program::{Ending, Friction, Margins, Program, Scale, Solution};
pub use sequential::{Sequential, SequentialSettings, sequential};
