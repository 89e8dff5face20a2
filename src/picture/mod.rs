//! Pictures as SVG: drawings of walls, grids of cells, plots, replays. The same input gives the same
//! bytes.
//!
//! ```text
//! figure ── panel (one method's view) ──▶ wall, mechanism, forces, crack ─┐
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
mod legend;
mod marks;
mod mechanism;
mod names;
pub(crate) mod palette;
mod panel;
mod parts;
mod path;
mod plot;
mod plotted;
mod ranges;
mod replay;
mod svg;
mod view;
mod wall;
mod words;

pub(crate) use cells::{Cells, Field, PictureCell, cells};
pub(crate) use figure::{common_scale, legend};
pub(crate) use plot::{Band, Line, Marks, Note, Plot, PlotAxis, PlotPoint, Ticks};
pub(crate) use plotted::{panels, plot};
pub(crate) use ranges::{RangeMark, Ranges, ranges};
pub(crate) use replay::{Replay, replay};
pub(crate) use words::lines;

pub use dxf::dxf;
pub use figure::figure;
pub use parts::{RigidPart, parts, threshold};
pub use view::{Options, View};
