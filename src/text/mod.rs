//! Text for people: tables and sentences that fit a screen.

mod grid;
mod layout;
mod worded;

pub use grid::{GridColumn, grid, numbers, words};
pub use layout::{LEAST_WIDTH, Layout, bold, counted, ended, enumerated, sentence, wrapped};
pub(crate) use worded::worded;
