//! What makes an assembly one: no block inside another, no joint missed by a hair, none in the air.

use super::assembly::Assembly;
use super::close_pairs::{close_pairs, extent};
use super::connected::connected;
use super::joints::{Side, find_joints, shared_edges};
use super::polygon::{Point, Polygon};

/// Edges nearer than this fraction of the smaller block's extent that are no joint: nobody builds
/// such a gap, so the coordinates were rounded.
const NEAR: f64 = 1e-3;

/// Why an assembly is none. Bodies are named by their place in it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Unsound {
    /// A block lies in another body.
    Overlap {
        /// The other body.
        one: Side,
        /// The block.
        other: usize,
        /// How deep, in the unit of length.
        depth: f64,
    },
    /// Two edges nearly touch.
    NearMiss {
        /// The other body.
        one: Side,
        /// The block.
        other: usize,
        /// Tolerance at which they would touch, a fraction of the smaller body's extent.
        needed: f64,
    },
    /// No chain of joints leads from the block to a support.
    Floating {
        /// The block.
        block: usize,
        /// A body that it touches at a corner alone.
        touches: Option<Side>,
    },
}

impl Assembly {
    /// The first thing that is wrong with it: overlaps, then near misses, then floating blocks.
    ///
    /// # Errors
    /// [`Unsound`].
    pub fn check(&self) -> Result<(), Unsound> {
        let shapes: Vec<&Polygon> = self.blocks.iter().map(|block| &block.shape).collect();
        let supports: Vec<Polygon> = self.supports.iter().map(|s| s.shape.clone()).collect();
        let pairs = close_pairs(NEAR.max(self.tolerance), &shapes, &supports);
        let mut near_miss = None;
        for (one, other) in pairs {
            let (one, shape) = match one.checked_sub(supports.len()) {
                None => (Side::Support(one), &supports[one]),
                Some(block) => (Side::Block(block), shapes[block]),
            };
            let size = extent(shape).min(extent(shapes[other]));
            let depth = overlap(shape, shapes[other]);
            if depth > self.tolerance * size {
                return Err(Unsound::Overlap { one, other, depth });
            }
            let needed = || missed(shape, shapes[other], self.tolerance);
            if let Some(needed) = near_miss.is_none().then(needed).flatten() {
                near_miss = Some(Unsound::NearMiss { one, other, needed });
            }
        }
        let floating = || {
            // Head joints in contact.
            let joints = find_joints(self.tolerance, &shapes, &supports);
            let mut connected = connected(shapes.len(), &joints).into_iter();
            let block = connected.position(|connected| !connected)?;
            let touches = self.touched(block);
            Some(Unsound::Floating { block, touches })
        };
        near_miss.or_else(floating).map_or(Ok(()), Err)
    }

    /// The first body that a block touches without a joint.
    fn touched(&self, block: usize) -> Option<Side> {
        let supports = self.supports.iter().map(|support| &support.shape);
        let blocks = self.blocks.iter().map(|block| &block.shape);
        let sides = (0..self.supports.len()).map(Side::Support);
        let sides = sides.chain((0..self.blocks.len()).map(Side::Block));
        let shape = &self.blocks[block].shape;
        let mut others = sides.zip(supports.chain(blocks));
        let (side, _) = others.find(|&(side, other)| {
            let size = extent(shape).min(extent(other));
            side != Side::Block(block)
                && overlap(shape, other) > -self.tolerance * size
                && shared_edges(shape, other, self.tolerance).is_empty()
        })?;
        Some(side)
    }
}

/// How deep two polygons lie in each other: the deepest of their convex pieces; negative where all
/// are apart.
pub(crate) fn overlap(a: &Polygon, b: &Polygon) -> f64 {
    let pieces = |shape: &Polygon| -> Vec<Vec<Point>> {
        let at = |corner: usize| shape.corners()[corner];
        let pieces = shape.convex_pieces().into_iter();
        pieces
            .map(|piece| piece.into_iter().map(at).collect())
            .collect()
    };
    let (a, b) = (pieces(a), pieces(b));
    let pairs = a
        .iter()
        .flat_map(|a| b.iter().map(move |b| convex_overlap(a, b)));
    pairs.fold(f64::NEG_INFINITY, f64::max)
}

/// How deep two convex outlines lie in each other; negative where they are apart. The depth is along
/// the normal of the edge that parts them best, which for convex shapes is one of theirs.
fn convex_overlap(a: &[Point], b: &[Point]) -> f64 {
    let beyond = |edges: &[Point], other: &[Point]| {
        let next = edges.iter().cycle().skip(1);
        let distances = edges.iter().zip(next).map(|(from, to)| {
            let along = (to - from).normalize();
            let heights = other.iter().map(|corner| {
                let arm = corner - from;
                // Outward is to the right of an edge.
                -along.perp(&arm)
            });
            heights.fold(f64::INFINITY, f64::min)
        });
        distances.fold(f64::NEG_INFINITY, f64::max)
    };
    -beyond(a, b).max(beyond(b, a))
}

/// The tolerance at which two bodies without a joint would have one, where it is small.
fn missed(a: &Polygon, b: &Polygon, tolerance: f64) -> Option<f64> {
    if tolerance >= NEAR
        || !shared_edges(a, b, tolerance).is_empty()
        || shared_edges(a, b, NEAR).is_empty()
    {
        return None;
    }
    let decades = (1..).map(|decade| tolerance * 10f64.powi(decade));
    let mut steps = decades.map(|step| step.min(NEAR));
    steps.find(|&step| step >= NEAR || !shared_edges(a, b, step).is_empty())
}
