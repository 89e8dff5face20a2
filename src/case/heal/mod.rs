//! Healing of drawings and of explicit blocks: gaps between bodies are closed to joints in their middle.
//!
//! Corners cannot be moved one by one: where two stones meet under a third, the corner between them has to
//! lie on that one's edge. So the joints are made first, from the void between the bodies, and each body's
//! outline follows from its joints; what faces no other body stays where it is drawn, and so do bodies
//! that never move.
//!
//! ```text
//! outlines ── void ──▶ gaps ── joints ──▶ lines, bends, meeting points ── outline ──▶ outlines
//! ```

mod closing;
mod joints;
mod left_open;
mod line;
mod measured;
mod nodes;
mod outline;
mod parts;
mod triangles;
mod void;

pub(super) use closing::{CannotClose, Closed, close};
pub(super) use left_open::{LeftOpen, left_open, stay_open};
pub(super) use line::{holds, to_outline, to_segment, without_repeats};
pub(super) use void::Reach;
