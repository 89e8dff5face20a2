//! How the sources are kept.

mod floors;
mod public;
mod records;
mod sources;
