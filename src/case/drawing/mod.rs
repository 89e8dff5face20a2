//! Walls as they are drawn: from a DXF, or a model of COMPAS, to a case.
//!
//! ```text
//! text ── groups ──▶ entities ── paths ── plane ──▶ closed outlines ── heal ──▶ blocks and supports
//! JSON ── compas ─────────────────────────▶
//! ```

mod cells;
mod compas;
mod curves;
mod drawn;
mod entities;
mod groups;
mod import;
mod options;
mod outlines;
mod paths;
mod placing;
mod plane;
mod sound;
mod supports;

pub use import::Imported;
pub use options::DrawingOptions;
