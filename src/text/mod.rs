//! Text for people: tables and sentences that fit a screen.

mod grid;
mod layout;
mod worded;
mod wrap;

pub use grid::{GridColumn, grid, numbers, words};
pub use layout::{LEAST_WIDTH, Layout, bold, ended, sentence};
pub(crate) use worded::worded;
pub use wrap::wrapped;
