//! The void between bodies as triangles, and the gaps that they make.
//!
//! A constrained Delaunay triangulation of all outlines, with the foot of every corner on the edges that
//! it faces, so that a gap between two edges is a strip of short crossings. Outlines are inset by a
//! little, so that touching ones have a void between them, and overlapping ones too.

use std::collections::BTreeMap;

use spade::handles::{FaceHandle, FixedFaceHandle, InnerTag};
use spade::{ConstrainedDelaunayTriangulation, HasPosition, Triangulation};

use super::line::to_segment;
use crate::scene::{Point, Polygon, Vector, bounds, close_pairs, extent};

/// What is closed.
#[derive(Clone, Copy, Debug)]
pub struct Reach {
    /// The part of the smaller body's extent that gaps may have.
    pub part: f64,
    /// The width that gaps may have.
    pub width: f64,
}

impl Reach {
    /// How wide a gap between two bodies may be.
    pub fn between(self, one: &Polygon, other: &Polygon) -> f64 {
        (self.part * extent(one).min(extent(other))).min(self.width)
    }
}

/// Outlines are inset by this part of what is closed.
const INSET: f64 = 0.55;

/// A crossing at the end of a gap is at most this many times as long as a gap may be wide.
const SLANT: f64 = 1.5;

/// A junction of three gaps is at most this many times as far from its corners.
const JUNCTION: f64 = 2.0;

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
    /// The corners of the junctions.
    pub junctions: BTreeMap<usize, [usize; 3]>,
    /// By how much outlines are inset, and their corners then.
    pub insets: Vec<f64>,
    inset: Vec<Vec<Point>>,
}

type Triangles = ConstrainedDelaunayTriangulation<Vertex>;
type Triangle<'t> = FaceHandle<'t, InnerTag, Vertex, (), spade::CdtEdge<()>, ()>;

impl<'a> Void<'a> {
    /// Gaps between bodies of which one moves; `None` where bodies lie in each other deeper than the
    /// reach.
    pub fn new(shapes: &'a [Polygon], fixed: &'a [bool], reach: Reach) -> Option<Void<'a>> {
        let all: Vec<&Polygon> = shapes.iter().collect();
        let mut pairs = close_pairs(reach.part, &all, &[]);
        pairs.retain(|&(one, other)| !(fixed[one] && fixed[other]));
        let insets = insets(shapes, &pairs, reach);
        let (inset, insets): (Vec<_>, Vec<_>) = (shapes.iter().zip(insets))
            .map(|(shape, by)| inset_by(shape.corners(), by))
            .unzip();
        let mut void = Void {
            shapes,
            fixed,
            reach,
            vertices: Vec::new(),
            gaps: Vec::new(),
            junctions: BTreeMap::new(),
            insets,
            inset,
        };
        let edges = void.place(&pairs);
        let mut conflict = false;
        let vertices = void.vertices.clone();
        let triangles = Triangles::try_bulk_load_cdt(vertices, edges, |_| conflict = true).ok()?;
        if conflict || triangles.num_vertices() != void.vertices.len() {
            return None;
        }
        let closed = void.closed(&triangles);
        void.follow(&triangles, &closed);
        Some(void)
    }

    /// How wide a gap between two bodies may be between their inset outlines.
    fn limit(&self, one: usize, other: usize) -> f64 {
        let insets = self.insets[one] + self.insets[other];
        self.reach.between(&self.shapes[one], &self.shapes[other]) + insets
    }

    /// The corners and feet of every outline in order, and the edges between them.
    fn place(&mut self, pairs: &[(usize, usize)]) -> Vec<[usize; 2]> {
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

    /// Which triangles are parts of gaps: those that are narrow, but for those at an end that is wide.
    fn closed(&self, triangles: &Triangles) -> Vec<bool> {
        let mut closed = vec![false; triangles.num_all_faces()];
        for face in triangles.inner_faces() {
            closed[face.fix().index()] = self.is_narrow(face);
        }
        let mut open: Vec<FixedFaceHandle<InnerTag>> = (triangles.inner_faces())
            .map(|face| face.fix())
            .filter(|face| closed[face.index()])
            .collect();
        while let Some(face) = open.pop() {
            let edges = triangles.face(face).adjacent_edges();
            let crossings = || {
                edges
                    .iter()
                    .filter(|e| e.from().data().body != e.to().data().body)
            };
            // Three bodies that meet at an open end have a joint less between them.
            let is_junction = crossings().count() == 3;
            let wide = closed[face.index()]
                && crossings().any(|edge| {
                    let [one, other] = edge.vertices().map(|vertex| vertex.data().body);
                    let free = !(self.fixed[one] && self.fixed[other]);
                    let beyond = closed[edge.rev().face().fix().index()];
                    let is_long = edge.length_2().sqrt() > SLANT * self.limit(one, other);
                    free && !beyond && (is_junction || is_long)
                });
            if wide {
                closed[face.index()] = false;
                open.extend(
                    crossings().filter_map(|edge| Some(edge.rev().face().as_inner()?.fix())),
                );
            }
        }
        closed
    }

    fn is_narrow(&self, face: Triangle) -> bool {
        let edges = face.adjacent_edges();
        let body = |k: usize| edges[k].from().data().body;
        let limits = [0, 1, 2].map(|k| self.limit(body(k), body((k + 1) % 3)));
        let own = [0, 1, 2].map(|k| body(k) == body((k + 1) % 3));
        match own {
            [false, false, false] => {
                let (_, radius_2) = face.circumcircle();
                let free = [0, 1, 2].iter().any(|&k| !self.fixed[body(k)]);
                let limit = limits.into_iter().fold(0.0, f64::max);
                free && radius_2.sqrt() <= JUNCTION * limit
            }
            [true, true, true] => false,
            _ => {
                let base = own.iter().position(|own| *own).expect("two of one body");
                let edge = edges[base];
                let limit = limits[(base + 1) % 3];
                let free = !(self.fixed[body(base)] && self.fixed[body((base + 2) % 3)]);
                let length = edge.length_2().sqrt();
                // A pocket of an outline that is wide stays open.
                let along = edge.is_constraint_edge() || length <= limit;
                free && along && 2.0 * face.area() <= limit * length
            }
        }
    }

    /// Follows the crossings of each gap from end to end.
    fn follow(&mut self, triangles: &Triangles, closed: &[bool]) {
        let is_closed = |face: usize| closed[face];
        for edge in triangles.directed_edges() {
            let (from, to) = (edge.from(), edge.to());
            let bodies = [from.data().body, to.data().body];
            let free = !(self.fixed[bodies[0]] && self.fixed[bodies[1]]);
            if bodies[0] >= bodies[1] || !free {
                continue;
            }
            let third = |edge: spade::handles::DirectedEdgeHandle<
                '_,
                Vertex,
                (),
                spade::CdtEdge<()>,
                (),
            >| {
                let face = edge.face().fix().index();
                match is_closed(face) {
                    true => edge
                        .opposite_vertex()
                        .map(|v| (face, v.fix().index(), v.data().body)),
                    false => None,
                }
            };
            let end = |third: Option<(usize, usize, usize)>| match third {
                Some((face, ..)) => End::Junction(face),
                None => End::Open,
            };
            let (ahead, behind) = (third(edge), third(edge.rev()));
            let goes_on = |third: Option<(usize, usize, usize)>| {
                third.filter(|(_, _, body)| bodies.contains(body)).is_some()
            };
            if goes_on(behind) || (ahead.is_none() && behind.is_none()) {
                continue;
            }
            let mut crossings = vec![[from.fix().index(), to.fix().index()]];
            let (mut edge, mut ahead) = (edge, ahead);
            while let Some((_, _, body)) = ahead.filter(|_| goes_on(ahead)) {
                edge = match body == bodies[0] {
                    true => edge.next().rev(),
                    false => edge.prev().rev(),
                };
                crossings.push([edge.from().fix().index(), edge.to().fix().index()]);
                ahead = third(edge);
            }
            for (face, corner, pair) in [
                behind.map(|(face, corner, _)| (face, corner, crossings[0])),
                ahead.map(|(face, corner, _)| (face, corner, crossings[crossings.len() - 1])),
            ]
            .into_iter()
            .flatten()
            {
                self.junctions.insert(face, [corner, pair[0], pair[1]]);
            }
            self.gaps.push(Gap {
                bodies,
                crossings,
                ends: [end(behind), end(ahead)],
            });
        }
    }
}

/// More than half of what is closed about each body, so that what overlaps by as much is parted too, and
/// gaps that vary by as much are strips still.
fn insets(shapes: &[Polygon], pairs: &[(usize, usize)], reach: Reach) -> Vec<f64> {
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
fn inset_by(corners: &[Point], by: f64) -> (Vec<Point>, f64) {
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
