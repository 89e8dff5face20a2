//! What a person writes: one wall in one TOML file, with the values it is compared with.
//!
//! ```text
//! argument ── find ──▶ text of a case ── read ──▶ case ──▶ scenes
//! ```

mod complaint;
mod convert;
mod drawing;
mod find;
mod geometry;
mod heal;
mod model;
mod moved;
mod name;
mod outside_name;
mod printable;
mod read;
mod reference;
mod suggestion;
mod template;
mod words;
mod written;

pub use complaint::Complaint;
pub(crate) use complaint::Document;
pub(crate) use convert::BlocksFiles;
pub use drawing::{DrawingOptions, Imported};
pub(crate) use find::{UnreadCase, locate};
pub use find::{collect, find, library};
pub(crate) use find::{embedded, paper};
pub use geometry::Geometry;
pub use model::Case;
pub(crate) use name::plain;
pub(crate) use outside_name::outside_name;
pub(crate) use printable::printable;
pub(crate) use read::{Written, explain, read_by_visitor};
pub use reference::{Quantity, Reference, SourceKind};
pub(crate) use suggestion::{listed, nearest};
pub(crate) use template::Template;
pub(crate) use words::{geometry_words, push_words};
pub(crate) use written::quoted;
