//! The points where joints meet.

use std::collections::BTreeMap;

use nalgebra::Matrix2;

use super::line::Line;
use super::measured::{Measured, centre, shortest};
use super::void::{End, Void};
use crate::scene::{Point, Vector};

/// Lines at a still body count this much more than others where joints meet.
const STILL: f64 = 1e6;

/// Lines whose directions spread less than this have no good meeting point.
const SPREAD: f64 = 0.02;

/// Points are two where they are this many times as far apart as they may be off; else four bodies meet in
/// one, and of those that may touch none do, so that λ is rather too low. Up to more they are named.
const TOLD: f64 = 2.0;
const NAMED: f64 = 3.0;

/// Where joints meet.
pub(super) struct Nodes {
    /// The point of every junction.
    pub points: BTreeMap<usize, Point>,
    /// Short gaps that are the other two bodies' of the four that meet there.
    pub turned: Vec<usize>,
    pub meetings: Vec<Meeting>,
}

/// A place where four bodies meet nearly in one point, so that the drawing does not say well which two of
/// them touch.
#[derive(Clone, Copy, Debug)]
pub(super) struct Meeting {
    /// The two with the short gap between them, and the other two.
    pub bodies: [usize; 4],
    pub at: Point,
    /// How far apart the lines of the joints put the two points where three meet; negative where it is the
    /// other two that would touch.
    pub apart: f64,
    /// Whether the first two have a joint.
    pub is_joint: bool,
}

/// The lines that end at each junction with their weights, and how far off they may be.
struct Ending<'a> {
    void: &'a Void<'a>,
    lines: BTreeMap<usize, Vec<(Line, f64)>>,
    doubts: BTreeMap<usize, f64>,
}

impl<'a> Ending<'a> {
    fn new(
        void: &'a Void<'a>,
        measured: &[Measured],
        lines: &[Line],
        first: &[usize],
    ) -> Ending<'a> {
        let mut ending = Ending {
            void,
            lines: BTreeMap::new(),
            doubts: BTreeMap::new(),
        };
        for (index, gap) in void.gaps.iter().enumerate() {
            let still = gap.bodies.iter().any(|&body| void.fixed[body]);
            let weight = if still { STILL } else { 1.0 };
            let own = [first[index], first[index + 1] - 1];
            for (end, part) in gap.ends.iter().zip(own) {
                if let (End::Junction(face), false) = (end, measured[index].is_stub) {
                    let of = ending.lines.entry(*face).or_default();
                    of.push((lines[part], weight));
                    let doubt = ending.doubts.entry(*face).or_default();
                    *doubt = doubt.max(measured[index].doubt());
                }
            }
        }
        ending
    }

    fn doubt(&self, face: usize) -> f64 {
        self.doubts.get(&face).copied().unwrap_or(0.0)
    }

    /// The one point of several junctions.
    fn node(&self, faces: Vec<usize>) -> Node {
        let of = faces.iter().filter_map(|face| self.lines.get(face));
        let centres = faces.iter().map(|&face| centre(self.void, face).coords);
        let middle = Point::from(centres.sum::<Vector>() / faces.len() as f64);
        let width = faces.iter().map(|face| {
            let [a, b, c] = self.void.junctions[face].map(|vertex| self.void.vertices[vertex].at);
            (a - b).norm().max((b - c).norm()).max((c - a).norm())
        });
        let width = width.fold(0.0, f64::max);
        let (at, is_sharp) = nearest_to(of.flatten().copied(), middle, 2.0 * width);
        Node {
            at,
            is_sharp,
            faces,
        }
    }
}

/// A point where joints meet, and the junctions that it is of.
#[derive(Clone)]
struct Node {
    at: Point,
    /// Whether lines say where it is.
    is_sharp: bool,
    faces: Vec<usize>,
}

/// The point of every junction: the nearest to all lines that end there. Junctions that a stub joins are
/// one where the lines do not tell them apart: by more than the widths of the gaps there vary, as much as
/// is usual in the drawing at least.
pub(super) fn nodes(
    void: &Void,
    measured: &[Measured],
    usual: f64,
    lines: &[Line],
    first: &[usize],
) -> Nodes {
    let ending = Ending::new(void, measured, lines, first);
    let faces = void.junctions.keys();
    let mut of: BTreeMap<usize, Node> = faces.map(|&f| (f, ending.node(vec![f]))).collect();
    let (mut turned, mut meetings) = (Vec::new(), Vec::new());
    for (index, (gap, measured)) in void.gaps.iter().zip(measured).enumerate() {
        let (true, [End::Junction(from), End::Junction(to)]) = (measured.is_stub, gap.ends) else {
            continue;
        };
        let (one, other) = (&of[&from], &of[&to]);
        if one.faces == other.faces {
            continue;
        }
        // Forward is to the left of a crossing.
        let [start, end] = gap.crossings[0].map(|vertex| void.vertices[vertex].inset);
        let forward = Vector::new(start.y - end.y, end.x - start.x).normalize();
        let apart = (other.at - one.at).dot(&forward);
        let [a, b] = gap.bodies.map(|body| &void.shapes[body]);
        let doubt = match one.is_sharp && other.is_sharp {
            true => {
                let local = ending.doubt(from).max(ending.doubt(to));
                local.max(usual).min(void.reach.between(a, b))
            }
            false => shortest(void, gap),
        };
        let is_joint = apart > TOLD * doubt;
        let [left, right] = [to, from].map(|face| void.third(face, gap.bodies));
        if apart.abs() > measured.within(0.0) && apart.abs() < NAMED * doubt {
            meetings.push(Meeting {
                bodies: [gap.bodies[0], gap.bodies[1], left, right],
                at: nalgebra::center(&one.at, &other.at),
                apart,
                is_joint,
            });
        }
        if is_joint {
            continue;
        }
        if apart < -TOLD * doubt && left != right && !(void.fixed[left] && void.fixed[right]) {
            turned.push(index);
        }
        let mut faces = [one.faces.as_slice(), other.faces.as_slice()].concat();
        faces.sort_unstable();
        let joined = ending.node(faces);
        for &face in &joined.faces {
            of.insert(face, joined.clone());
        }
    }
    Nodes {
        points: of.into_iter().map(|(face, node)| (face, node.at)).collect(),
        turned,
        meetings,
    }
}

/// The point nearest to lines with weights; where they spread too little, which is said, near a middle.
fn nearest_to(
    lines: impl Iterator<Item = (Line, f64)> + Clone,
    middle: Point,
    farthest: f64,
) -> (Point, bool) {
    let solved = |own: f64| {
        let mut matrix = Matrix2::identity() * own;
        let mut right = Vector::zeros();
        for (line, weight) in lines.clone() {
            let normal = Vector::new(-line.along.y, line.along.x);
            matrix += normal * normal.transpose() * weight;
            right -= normal * (weight * line.distance(middle));
        }
        (matrix, right)
    };
    let (plain, _) = solved(0.0);
    let spread = |matrix: Matrix2<f64>| matrix.determinant() / matrix.trace().max(1.0);
    let is_sharp = spread(plain) > SPREAD;
    let (matrix, right) = match is_sharp {
        true => solved(0.0),
        false => solved(1e-3),
    };
    let step = matrix
        .try_inverse()
        .map_or(Vector::zeros(), |inverse| inverse * right);
    match step.norm() <= farthest {
        true => (middle + step, is_sharp),
        false => (middle, false),
    }
}
