//! Results for people and for machines: table, CSV, JSON, files.

mod files;
pub mod html;
mod library;
mod rows;
mod snapshot;

pub use files::write_whole;
pub use library::library;
pub use rows::{csv, json, table};
pub use snapshot::{Comparison, compare};
