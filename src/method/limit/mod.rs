//! Limit analysis of the rigid blocks by linear programming.

mod associative;
mod columns;
mod interval;
mod program;
mod reduction;
mod scale;
mod sequential;
mod standing;
mod vertical;

pub use associative::Associative;
pub use interval::Interval;
pub(crate) use interval::lowest;
pub use program::{Ending, Friction, Margins, Program, Solution};
pub use scale::Scale;
pub use sequential::Sequential;
