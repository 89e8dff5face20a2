//! The void between bodies as triangles, and the gaps that they make.
//!
//! A constrained Delaunay triangulation of all outlines, with the foot of every corner on the edges that
//! it faces, so that a gap between two edges is a strip of short crossings. Outlines are inset by a
//! little, so that touching ones have a void between them, and overlapping ones too.

use std::collections::BTreeMap;

use spade::HasPosition;

use super::line::to_segment;
use crate::scene::{Point, Polygon, Vector, bounds, extent};

/// What is closed.
#[derive(Clone, Copy, Debug)]
pub struct Reach {
    /// The part of the smaller body's extent that gaps may have.
    pub part: f64,
    /// The width that gaps may have.
    pub width: f64,
}

/// Gaps wider than this part of the smaller body's extent are openings.
const MOST_OF_A_BODY: f64 = 0.1;

/// Gaps that are to be closed, wider than this part of a body's extent, are openings; and so are those
/// that no width was named for, wider than the other.
const OPENING: (f64, f64) = (0.3, 0.015);

impl Reach {
    /// Gaps up to a width, as long as they are no openings.
    pub fn of_gap(width: f64) -> Reach {
        Reach {
            part: MOST_OF_A_BODY,
            width,
        }
    }

    /// Slips of the pen up to a part of the smaller body's extent.
    pub fn of_tolerance(part: f64) -> Reach {
        Reach {
            part,
            width: f64::INFINITY,
        }
    }

    /// What may not stay open.
    pub fn meant(self) -> Reach {
        let (closed, other) = OPENING;
        Reach {
            part: if self.width.is_finite() {
                closed
            } else {
                other
            },
            ..self
        }
    }

    /// How wide a gap between two bodies may be.
    pub fn between(self, one: &Polygon, other: &Polygon) -> f64 {
        (self.part * extent(one).min(extent(other))).min(self.width)
    }
}

/// Outlines are inset by this part of what is closed.
const INSET: f64 = 0.55;

/// A point of an outline: a corner, or the foot of another body's corner.
#[derive(Clone, Copy, Debug)]
pub(super) struct Vertex {
    pub body: usize,
    /// The edge that begins at the corner, or on which the foot lies.
    pub edge: usize,
    /// The place on that edge, 0 for a corner.
    pub along: f64,
    pub at: Point,
    /// Where it is in the inset outline.
    pub inset: Point,
}

impl Vertex {
    pub fn is_corner(&self) -> bool {
        self.along == 0.0
    }
}

impl HasPosition for Vertex {
    type Scalar = f64;

    fn position(&self) -> spade::Point2<f64> {
        // Numbers so near to 0 are refused.
        let [x, y] = [self.inset.x, self.inset.y].map(|c| if c.abs() < 1e-100 { 0.0 } else { c });
        spade::Point2::new(x, y)
    }
}

/// What a gap ends at.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum End {
    /// A triangle of three bodies, by its place in the triangulation.
    Junction(usize),
    Open,
}

/// A gap between two bodies, from end to end: counter-clockwise about the first of them.
#[derive(Debug)]
pub(super) struct Gap {
    pub bodies: [usize; 2],
    /// From a vertex of the first body to one of the second.
    pub crossings: Vec<[usize; 2]>,
    pub ends: [End; 2],
}

/// All gaps within reach.
pub(super) struct Void<'a> {
    pub shapes: &'a [Polygon],
    pub fixed: &'a [bool],
    pub reach: Reach,
    pub vertices: Vec<Vertex>,
    pub gaps: Vec<Gap>,
    pub junctions: BTreeMap<usize, [usize; 3]>,
    /// By how much outlines are inset, and their corners then.
    pub insets: Vec<f64>,
    pub inset: Vec<Vec<Point>>,
}

impl<'a> Void<'a> {
    /// How wide a gap between two bodies may be between their inset outlines.
    pub fn limit(&self, one: usize, other: usize) -> f64 {
        let insets = self.insets[one] + self.insets[other];
        self.reach.between(&self.shapes[one], &self.shapes[other]) + insets
    }

    /// The corners and feet of every outline in order, and the edges between them.
    pub fn place(&mut self, pairs: &[(usize, usize)]) -> Vec<[usize; 2]> {
        let mut feet = vec![Vec::new(); self.shapes.len()];
        for &(one, other) in pairs {
            let near = self.limit(one, other);
            for (from, to) in [(one, other), (other, one)] {
                feet_on(&self.inset[from], &self.inset[to], near, &mut feet[to]);
            }
        }
        let mut edges = Vec::new();
        for (body, feet) in feet.iter_mut().enumerate() {
            let corners = self.shapes[body].corners();
            feet.extend((0..corners.len()).map(|edge| (edge, 0.0)));
            feet.sort_by(|a, b| a.0.cmp(&b.0).then(a.1.total_cmp(&b.1)));
            feet.dedup_by(|a, b| a.0 == b.0 && a.1 - b.1 < 1e-7);
            let first = self.vertices.len();
            for &(edge, along) in feet.iter() {
                let next = (edge + 1) % corners.len();
                let on = |of: &[Point]| of[edge] + (of[next] - of[edge]) * along;
                self.vertices.push(Vertex {
                    body,
                    edge,
                    along,
                    at: on(corners),
                    inset: on(&self.inset[body]),
                });
            }
            let count = feet.len();
            edges.extend((0..count).map(|k| [first + k, first + (k + 1) % count]));
        }
        edges
    }

    /// How far a vertex is from the edges at another: in the inset outlines, and as drawn.
    pub fn to_edges(&self, vertex: usize, other: usize) -> [f64; 2] {
        let (from, other) = (self.vertices[vertex], self.vertices[other]);
        let outlines = [
            (from.inset, self.inset[other.body].as_slice()),
            (from.at, self.shapes[other.body].corners()),
        ];
        outlines.map(|(p, corners)| {
            let count = corners.len();
            let to = |edge: usize| to_segment(p, corners[edge], corners[(edge + 1) % count]);
            match other.is_corner() {
                true => to(other.edge).min(to((other.edge + count - 1) % count)),
                false => to(other.edge),
            }
        })
    }

    /// The one of a junction's bodies that is none of two.
    pub fn third(&self, face: usize, two: [usize; 2]) -> usize {
        self.vertices[self.corner(face, |body| !two.contains(&body))].body
    }

    /// The corner of a junction whose body is the one that is asked for.
    fn corner(&self, face: usize, is_it: impl Fn(usize) -> bool) -> usize {
        let corners = self.junctions[&face].into_iter();
        let mut wanted = corners.filter(|&vertex| is_it(self.vertices[vertex].body));
        wanted.next().expect("a junction is of three bodies")
    }

    /// Makes a short gap between two junctions one between the other two of the four bodies that meet.
    pub fn turn(&mut self, gap: usize) {
        let Gap { bodies, ends, .. } = &self.gaps[gap];
        let (bodies, [End::Junction(behind), End::Junction(ahead)]) = (*bodies, *ends) else {
            return;
        };
        let mut others = [behind, ahead].map(|face| self.corner(face, |b| !bodies.contains(&b)));
        let own = bodies.map(|body| self.corner(ahead, |b| b == body));
        let body = |vertex: usize| self.vertices[vertex].body;
        if body(others[0]) == body(others[1]) {
            return;
        }
        // What is behind is now at the first of the old bodies, and what is ahead at the second.
        let at = [behind, ahead];
        for (_, other) in (self.gaps.iter_mut().enumerate()).filter(|(index, _)| *index != gap) {
            for end in &mut other.ends {
                if let End::Junction(face) = end
                    && at.contains(face)
                {
                    *face = at[usize::from(!other.bodies.contains(&bodies[0]))];
                }
            }
        }
        for (face, own) in at.into_iter().zip(own) {
            self.junctions.insert(face, [own, others[0], others[1]]);
        }
        // From the body behind to the one ahead, the first of the old bodies is to the left.
        let turned = match body(others[0]) < body(others[1]) {
            true => [ahead, behind],
            false => {
                others.reverse();
                at
            }
        };
        self.gaps[gap] = Gap {
            bodies: others.map(body),
            crossings: vec![others],
            ends: turned.map(End::Junction),
        };
    }
}

/// More than half of what is closed about each body, so that what overlaps by as much is parted too, and
/// gaps that vary by as much are strips still.
pub(super) fn insets(shapes: &[Polygon], pairs: &[(usize, usize)], reach: Reach) -> Vec<f64> {
    let mut insets = vec![0.0_f64; shapes.len()];
    for &(one, other) in pairs {
        let near = reach.between(&shapes[one], &shapes[other]);
        for body in [one, other] {
            insets[body] = insets[body].max(INSET * near);
        }
    }
    insets
}

/// The corners moved inwards by a distance, or by less where edges would vanish; with that distance.
pub(super) fn inset_by(corners: &[Point], by: f64) -> (Vec<Point>, f64) {
    let count = corners.len();
    let mut by = by;
    for _ in 0..40 {
        let moved = |k: usize| {
            let before = (corners[k] - corners[(k + count - 1) % count]).normalize();
            let after = (corners[(k + 1) % count] - corners[k]).normalize();
            let left = |v: Vector| Vector::new(-v.y, v.x);
            let bisector = left(before) + left(after);
            corners[k] + bisector * (2.0 * by / bisector.norm_squared())
        };
        let inset: Vec<Point> = (0..count).map(moved).collect();
        let keeps = |k: usize| {
            let next = (k + 1) % count;
            let (old, new) = (corners[next] - corners[k], inset[next] - inset[k]);
            old.dot(&new) > 0.25 * old.norm_squared()
        };
        if (0..count).all(keeps) {
            return (inset, by);
        }
        by /= 2.0;
    }
    (corners.to_vec(), 0.0)
}

/// The feet of one body's corners on the other's edges, within reach: the edge, and the place on it.
fn feet_on(from: &[Point], to: &[Point], near: f64, feet: &mut Vec<(usize, f64)>) {
    let (low, high) = bounds(to);
    let close = |p: &&Point| (0..2).all(|k| low[k] - near <= p[k] && p[k] <= high[k] + near);
    for corner in from.iter().filter(close) {
        for (edge, start) in to.iter().enumerate() {
            let way = to[(edge + 1) % to.len()] - start;
            let along = way.dot(&(corner - start)) / way.norm_squared();
            let off = way.perp(&(corner - start)).abs() / way.norm();
            if off <= near && along > 1e-7 && along < 1.0 - 1e-7 {
                feet.push((edge, along));
            }
        }
    }
}
