//! Results for people and for machines: table, CSV, JSON, files.

pub mod html;
mod library;
mod rows;
mod terms;

pub use library::{library_case, library_closing, library_heading};
pub use rows::{case_table, csv, json, json_with_states, legend, table};
