//! Results for people and for machines: table, CSV, JSON, files.

pub mod html;
mod library;
mod rows;
mod screen;
mod styles;
mod terms;

pub use library::{library_case, library_closing, library_heading};
pub use rows::{csv, json, json_with_states};
pub use screen::{case_table, legend, table};
pub use styles::of_verdict;
