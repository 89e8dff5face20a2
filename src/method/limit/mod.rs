//! Limit analysis of the rigid blocks by linear programming.

mod associative;
mod bound;
mod columns;
pub(crate) mod ending;
mod equilibration;
mod falling;
mod interval;
mod moving;
mod noise;
mod numbers;
mod own_weight;
pub(crate) mod program;
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
pub use interval::Interval;
pub(crate) use interval::lowest;
pub(crate) use moving::moving;
pub use sequential::Sequential;
