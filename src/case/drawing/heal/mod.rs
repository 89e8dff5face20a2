//! Healing of drawings: gaps between bodies are closed to joints in their middle.
//!
//! Corners cannot be moved one by one: where two stones meet under a third, the corner between them has to
//! lie on that one's edge. So the joints are made first, from the void between the bodies, and each body's
//! outline follows from its joints; what faces no other body stays where it is drawn, and so do bodies
//! that never move.
//!
//! ```text
//! outlines ── void ──▶ gaps ── joints ──▶ lines, bends, meeting points ── outline ──▶ outlines
//! ```

mod joints;
mod line;
mod outline;
mod void;

use joints::{Joint, joints};
use outline::outlines;
use void::Void;

pub(super) use line::{holds, to_segment};
pub(super) use void::Reach;

use crate::scene::{Point, Polygon, extent};

/// A joint that was closed, or is to be.
#[derive(Clone, Copy, Debug)]
pub(super) struct Gap {
    pub bodies: [usize; 2],
    pub at: Point,
    /// The width that half of it has no more of, and over the smaller body's extent.
    pub width: f64,
    pub part: f64,
}

/// The corners of each body with gaps within reach closed; `None` where bodies lie in each other deeper
/// than the reach. Shapes that fit already stay as they are, to the last bit.
pub(super) fn heal(shapes: &[Polygon], fixed: &[bool], reach: Reach) -> Option<Vec<Vec<Point>>> {
    let void = Void::new(shapes, fixed, reach)?;
    Some(outlines(&void, &joints(&void)))
}

/// The gaps within reach, of which one body moves: of each pair the narrowest, as bodies that touch
/// somewhere have a joint.
pub(super) fn gaps(shapes: &[Polygon], fixed: &[bool], reach: Reach) -> Vec<Gap> {
    let Some(void) = Void::new(shapes, fixed, reach) else {
        return Vec::new();
    };
    let found = void.gaps.iter().zip(joints(&void)).map(|(gap, joint)| {
        let Joint { width, at, .. } = joint;
        let [one, other] = gap.bodies.map(|body| extent(&shapes[body]));
        Gap {
            bodies: gap.bodies,
            at,
            width,
            part: width / one.min(other),
        }
    });
    let mut found: Vec<Gap> = found.collect();
    found.sort_by(|a, b| a.bodies.cmp(&b.bodies).then(a.part.total_cmp(&b.part)));
    found.dedup_by_key(|gap| gap.bodies);
    found
}
