//! How the sources are kept.

mod floors;
mod sources;
