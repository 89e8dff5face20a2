//! Limit analysis of the rigid blocks by linear programming.

mod associative;
mod bound;
mod columns;
mod ending;
mod equilibration;
mod falling;
mod interval;
mod numbers;
mod own_weight;
mod program;
mod reduction;
mod scale;
mod sequential;
mod solver;
mod structured;
mod vertical;
#[cfg(test)]
mod walls;

pub use associative::Associative;
pub use bound::Bound;
pub use ending::{Ending, Solution};
pub use interval::Interval;
pub(crate) use interval::lowest;
pub use program::Program;
pub use sequential::Sequential;
