//! Healing of drawings: edges of neighbours that nearly lie on one line are laid on it.
//!
//! Corners cannot be snapped one by one: where two stones of a course meet under a third, the corner
//! between them has to lie on that one's edge, and its ends on theirs. So edges that face each other
//! within the tolerance are gathered, a bed joint through a whole course at a time; each gathering gets
//! one line, and corners become intersections of lines.

use crate::scene::{Point, Polygon, Vector, close_pairs, extent};

/// A corner that healing moved.
#[derive(Clone, Copy, Debug)]
pub(super) struct Moved {
    pub body: usize,
    pub from: Point,
    pub to: Point,
}

/// Two bodies whose edges face each other without touching.
#[derive(Clone, Copy, Debug)]
pub(super) struct Gap {
    pub bodies: [usize; 2],
    pub at: Point,
    pub width: f64,
    /// The width over the smaller body's extent.
    pub part: f64,
}

/// What is closed.
#[derive(Clone, Copy, Debug)]
pub(super) struct Reach {
    /// The part of the smaller body's extent that gaps may have.
    pub part: f64,
    /// The width that gaps may have.
    pub width: f64,
}

impl Reach {
    /// How far apart two bodies may face each other.
    pub fn between(self, one: &Polygon, other: &Polygon) -> f64 {
        (self.part * extent(one).min(extent(other))).min(self.width)
    }
}

/// Edges that are as far from one line as this part of the extent lie on it already.
const EXACT: f64 = 1e-9;

/// Sine of the angle between edges that may lie on one line.
const SAME_DIRECTION: f64 = 0.2;

/// Sine of the angle below which two lines have no good intersection.
const PARALLEL: f64 = 0.02;

/// A corner moves at most this many times its distance from the lines beside it.
const FARTHEST: f64 = 3.0;

#[derive(Clone, Copy)]
struct Edge {
    body: usize,
    from: Point,
    to: Point,
}

impl Edge {
    fn line(&self) -> Line {
        Line {
            point: self.from,
            along: (self.to - self.from).normalize(),
        }
    }
}

/// A line through a point.
#[derive(Clone, Copy)]
struct Line {
    point: Point,
    along: Vector,
}

impl Line {
    fn distance(&self, p: Point) -> f64 {
        self.along.perp(&(p - self.point))
    }

    fn nearest(&self, p: Point) -> Point {
        self.point + self.along * self.along.dot(&(p - self.point))
    }
}

/// The shapes with edges that face each other within reach laid on common lines, and what was moved. Shapes that fit already stay as they are, to the last bit.
pub(super) fn heal(shapes: &[Polygon], reach: Reach) -> (Vec<Vec<Point>>, Vec<Moved>) {
    let (edges, first) = edges_of(shapes);
    let mut groups = Groups((0..edges.len()).collect());
    each_facing(shapes, &edges, &first, reach, |a, b, _, _| {
        groups.join(a, b)
    });
    let lines = lines(&edges, shapes, &mut groups);
    let (mut healed, mut moved) = (Vec::new(), Vec::new());
    for (body, shape) in shapes.iter().enumerate() {
        let count = shape.corners().len();
        let corner = |k: usize| {
            let old = shape.corners()[k];
            let (before, after) = (first[body] + (k + count - 1) % count, first[body] + k);
            let new = corner(
                old,
                [before, after].map(|edge| edges[edge].line()),
                [lines[before], lines[after]],
            );
            (old, new)
        };
        let corners: Vec<(Point, Point)> = (0..count).map(corner).collect();
        moved.extend(
            (corners.iter().filter(|(old, new)| old != new)).map(|&(from, to)| Moved {
                body,
                from,
                to,
            }),
        );
        healed.push(corners.into_iter().map(|(_, new)| new).collect());
    }
    (healed, moved)
}

/// Edges that face each other within `within`, and are farther apart than joints may be.
pub(super) fn gaps(shapes: &[Polygon], touching: f64, within: f64) -> Vec<Gap> {
    let (edges, first) = edges_of(shapes);
    let mut found: Vec<Gap> = Vec::new();
    let reach = Reach {
        part: within,
        width: f64::INFINITY,
    };
    each_facing(shapes, &edges, &first, reach, |a, b, at, width| {
        let bodies = [edges[a].body, edges[b].body];
        let size = bodies.map(|body| extent(&shapes[body]));
        let part = width / size[0].min(size[1]);
        let gap = Gap {
            bodies,
            at,
            width,
            part,
        };
        // The edges of two bodies are told of one after the other. Where some of them touch, the bodies
        // have a joint.
        match found.last_mut().filter(|known| known.bodies == bodies) {
            Some(known) if part < known.part => *known = gap,
            Some(_) => {}
            None => found.push(gap),
        }
    });
    found.retain(|gap| gap.part > touching);
    found
}

/// All edges, and the place of each body's first one.
fn edges_of(shapes: &[Polygon]) -> (Vec<Edge>, Vec<usize>) {
    let (mut edges, mut first) = (Vec::new(), Vec::new());
    for (body, shape) in shapes.iter().enumerate() {
        first.push(edges.len());
        edges.extend(shape.edges().map(|(from, to)| Edge { body, from, to }));
    }
    first.push(edges.len());
    (edges, first)
}

/// Tells of every two edges of different bodies that face each other within reach: their places,
/// a point between them and how far apart they are.
fn each_facing(
    shapes: &[Polygon],
    edges: &[Edge],
    first: &[usize],
    reach: Reach,
    mut tell: impl FnMut(usize, usize, Point, f64),
) {
    let all: Vec<&Polygon> = shapes.iter().collect();
    for (one, other) in close_pairs(reach.part, &all, &[]) {
        let near = reach.between(&shapes[one], &shapes[other]);
        for a in first[one]..first[one + 1] {
            for b in first[other]..first[other + 1] {
                if let Some((at, width)) = facing(&edges[a], &edges[b], near) {
                    tell(a, b, at, width);
                }
            }
        }
    }
}

/// Where two edges face each other within `near`, and how far apart they are there at most.
fn facing(one: &Edge, other: &Edge, near: f64) -> Option<(Point, f64)> {
    let (along, line) = (one.line().along, other.line());
    let back = line.along;
    if along.dot(&back) > 0.0 || along.perp(&back).abs() > SAME_DIRECTION {
        return None;
    }
    let place = |p: Point| along.dot(&(p - one.from));
    let low = place(other.to).max(0.0);
    let high = place(other.from).min((one.to - one.from).norm());
    if high - low <= 2.0 * near {
        return None;
    }
    let far = [low, high].map(|at| line.distance(one.from + along * at).abs());
    let width = far[0].max(far[1]);
    (width <= near).then(|| (one.from + along * ((low + high) / 2.0), width))
}

/// Edges that belong together, each under the first of them.
struct Groups(Vec<usize>);

impl Groups {
    fn of(&mut self, edge: usize) -> usize {
        let mut root = edge;
        while self.0[root] != root {
            self.0[root] = self.0[self.0[root]];
            root = self.0[root];
        }
        root
    }

    fn join(&mut self, a: usize, b: usize) {
        let (a, b) = (self.of(a), self.of(b));
        self.0[a.max(b)] = a.min(b);
    }
}

/// The common line of every edge that has one and does not lie on it already.
fn lines(edges: &[Edge], shapes: &[Polygon], groups: &mut Groups) -> Vec<Option<Line>> {
    let mut members: Vec<Vec<usize>> = vec![Vec::new(); edges.len()];
    for edge in 0..edges.len() {
        members[groups.of(edge)].push(edge);
    }
    let mut lines = vec![None; edges.len()];
    for group in members.iter().filter(|group| group.len() > 1) {
        let line = fitted(group.iter().map(|&edge| edges[edge]));
        let exact = |line: Line| {
            group.iter().all(|&edge| {
                let Edge { body, from, to } = edges[edge];
                let near = EXACT * extent(&shapes[body]);
                line.distance(from).abs() <= near && line.distance(to).abs() <= near
            })
        };
        if !exact(line) {
            group.iter().for_each(|&edge| lines[edge] = Some(line));
        }
    }
    lines
}

/// The line through edges, longer ones counting more.
fn fitted(edges: impl Iterator<Item = Edge> + Clone) -> Line {
    let mut all = edges.clone();
    let ahead = all.next().expect("a group has edges").line().along;
    let mut direction = Vector::zeros();
    let (mut middle, mut total) = (Vector::zeros(), 0.0);
    for edge in edges {
        let way = edge.to - edge.from;
        direction += if way.dot(&ahead) < 0.0 { -way } else { way };
        middle += nalgebra::center(&edge.from, &edge.to).coords * way.norm();
        total += way.norm();
    }
    Line {
        point: Point::from(middle / total),
        along: direction.normalize(),
    }
}

/// A corner between two edges, of which some have a common line with others.
fn corner(old: Point, own: [Line; 2], common: [Option<Line>; 2]) -> Point {
    let [before, after] = [0, 1].map(|k| common[k].unwrap_or(own[k]));
    let sine = before.along.perp(&after.along);
    match common {
        [None, None] => old,
        _ if sine.abs() > PARALLEL => {
            // The point of the first line that lies on the second.
            let step = after.distance(before.point) / -after.along.perp(&before.along);
            let crossing = before.point + before.along * step;
            let off = before.distance(old).abs().max(after.distance(old).abs());
            if (crossing - old).norm() <= FARTHEST * off {
                return crossing;
            }
            // Lines that cross far away: the corner goes to the middle between them.
            nalgebra::center(&before.nearest(old), &after.nearest(old))
        }
        [Some(line), _] | [None, Some(line)] => line.nearest(old),
    }
}
