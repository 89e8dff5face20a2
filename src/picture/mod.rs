//! Pictures as SVG: drawings of walls, grids of cells, plots, replays. The same input gives the same
//! bytes.
//!
//! ```text
//! figure ── panel (one method's view) ──▶ wall, mechanism, forces, crack ─┐
//!        └── key (its legend)                                             │
//! replay ── the wall at rest, and poses for a script ─────────────────────┼──▶ svg
//! cells (fields of coloured cells), plots over axes, ranges ───────────────┘
//! ```
//!
//! Blocks are shown displaced along their velocities, amplified: distances between them mean what a
//! mechanism is, first order in its size, so that no block seems to enter another.

mod axes;
mod cells;
mod crack;
mod dxf;
mod figure;
mod forces;
mod frame;
mod key;
mod legend;
mod marks;
mod mechanism;
mod names;
pub(crate) mod palette;
mod panel;
mod plot;
mod plotted;
#[cfg(feature = "print")]
mod print;
mod ranges;
mod replay;
mod svg;
mod view;
mod wall;
mod words;

pub(crate) use cells::{Cells, Field, PictureCell, cells};
pub(crate) use figure::common_size;
pub(crate) use legend::Sample;
pub(crate) use marks::Filling;
pub(crate) use plot::{Line, Plot, PlotAxis, PlotPoint, Ticks};
pub(crate) use plotted::{dashed_line, plots, share_axes, solid_line};
pub(crate) use ranges::{KNOWN, RangeMark, Ranges, ranges};
pub(crate) use replay::replay;

pub use dxf::dxf;
pub use figure::figure;
#[cfg(feature = "print")]
pub(crate) use print::{pdf, png};
pub use view::{Options, View};
