//! The stability map: grids over what makes each method fail, and what its answers are worth there.
//!
//! ```text
//! grids × methods ── sweep runner ──▶ cells ──▶ atlas.csv, GRID.svg, a table
//! ```
//!
//! A cell is right, inaccurate (outside 1 % as an estimate), refused (no answer), or wrong: a claim
//! that the reference refutes. References come from formulas and from another code, never from the
//! methods; wrong cells must not exist.

mod cell;
mod factors;
mod grid;
mod grids;
mod openings;
mod shown;
mod towers;
mod unequal;
mod walls;

pub use cell::{Atlas, Cell, CellVerdict};
pub use grid::Grid;
pub use grids::grids;
pub use shown::{csv, picture, table};
pub use towers::Columns;
pub use walls::running_bond;
