//! Results for people and for machines: table, CSV, JSON, files.

mod governing;
pub mod html;
mod in_use;
mod library;
mod rows;
mod screen;
mod styles;
mod terms;

pub(crate) use library::library_heading;
pub use library::{library_case, library_closing};
pub(crate) use rows::json;
pub use rows::{csv, json_with_states};
pub use screen::case_table;
pub(crate) use screen::legend;
pub(crate) use styles::of_verdict;
