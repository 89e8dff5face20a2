//! Limit analysis of the rigid blocks by linear programming.

mod associative;
mod columns;
mod interval;
mod own_weight;
mod program;
mod reduction;
mod scale;
mod sequential;
mod vertical;

pub use associative::Associative;
pub use interval::Interval;
pub(crate) use interval::lowest;
pub use program::{Ending, Program, Solution};
pub use sequential::Sequential;
