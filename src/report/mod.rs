//! Results for people and for machines: table, CSV, JSON, files.

pub mod html;
mod library;
mod rows;

pub use library::library;
pub use rows::{csv, json, table};
