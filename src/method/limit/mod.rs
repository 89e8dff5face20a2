//! Limit analysis of the rigid blocks by linear programming.

mod associative;
mod interval;
mod program;
mod reduction;
mod sequential;

use associative::without_optimum;

pub use associative::Associative;
pub use interval::Interval;
pub use program::{Ending, Friction, Margins, Program, Scale, Solution};
pub use sequential::{Sequential, SequentialSettings, sequential};
