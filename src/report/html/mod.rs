//! The report: everything about a run on one page that needs nothing else, to be mailed, archived
//! or printed.
//!
//! ```text
//! html ── summary, multipliers ── ranges (Fig. 6), sweeps (Fig. 7)
//!     └── a panel a case: drawings, replay, certificates, record
//! manual ── a page a case: drawing, ranges, references, answers, residuals
//! ```

mod document;
mod manual;
mod page;
mod panel;
mod prose;
mod ranges;
mod residuals;
mod sortable;
mod summary;
mod sweep;
mod witnesses;

pub use manual::manual;
pub(crate) use manual::pages;
pub use page::page;
