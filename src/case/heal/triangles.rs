//! The triangles of the void between bodies, and which of them are parts of gaps.

use std::collections::BTreeMap;

use spade::handles::{FaceHandle, FixedFaceHandle, InnerTag};
use spade::{CdtEdge, ConstrainedDelaunayTriangulation, Triangulation};

use super::void::{End, Gap, Reach, Vertex, Void, inset_by, insets};
use crate::scene::{Polygon, close_pairs};

/// A crossing at the end of a gap is at most this many times as long as a gap may be wide.
const SLANT: f64 = 1.5;

/// A junction of three gaps is at most this many times as far from its corners.
const JUNCTION: f64 = 2.0;

type Triangles = ConstrainedDelaunayTriangulation<Vertex>;
type Triangle<'t> = FaceHandle<'t, InnerTag, Vertex, (), CdtEdge<()>, ()>;
type Edge<'t> = spade::handles::DirectedEdgeHandle<'t, Vertex, (), CdtEdge<()>, ()>;

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
            let third = |edge: Edge| {
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
