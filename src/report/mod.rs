//! Results for people and for machines: table, CSV, JSON, files.

pub mod html;
mod library;
mod rows;
mod screen;
mod styles;
mod terms;

pub(crate) use library::library_heading;
pub use library::{library_case, library_closing};
pub(crate) use rows::json;
pub use rows::{csv, json_with_states};
pub(crate) use screen::legend;
pub use screen::{case_table, table};
pub(crate) use styles::of_verdict;
