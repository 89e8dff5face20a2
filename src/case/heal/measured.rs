//! What is measured along the gaps of the void.

use super::void::{End, Gap, Void};
use crate::scene::{Point, Vector, extent};

/// Bends within this part of the gap's width, and within this part of how much widths vary, are none.
const STRAIGHT: (f64, f64) = (0.02, 0.5);

/// As far as this from a line, as a part of the extent, points lie on it.
const EXACT: f64 = 1e-9;

/// What is measured along a gap.
pub(super) struct Measured {
    /// Points in its middle, or on the body of the two that is still, and the crossings they lie on.
    pub points: Vec<(usize, Point)>,
    /// Whether it is too short to have a direction.
    pub is_stub: bool,
    /// How much its width varies: a part of it that passes for equal, and what is beyond.
    equal: f64,
    varies: f64,
    /// Whether one of the two never moves, so that the joint is its edge.
    is_still: bool,
}

impl Measured {
    /// How far off the lines of its joint may be.
    pub fn doubt(&self) -> f64 {
        self.equal + self.varies
    }

    /// How far its line may pass by its points. They are as far to either side of it as half of what the
    /// width varies, where the edges of both bodies are as far off.
    pub fn within(&self, usual: f64) -> f64 {
        match self.is_still {
            true => self.equal,
            false => self.equal + STRAIGHT.1 * (self.varies.max(usual) + usual),
        }
    }
}

/// The point of a joint on a crossing.
fn middle(void: &Void, [one, other]: [usize; 2]) -> Point {
    let (one, other) = (&void.vertices[one], &void.vertices[other]);
    match (void.fixed[one.body], void.fixed[other.body]) {
        (true, _) => one.at,
        (_, true) => other.at,
        _ => nalgebra::center(&one.at, &other.at),
    }
}

/// Points and widths where a crossing is as short as the gap is wide.
pub(super) fn measured(void: &Void, gap: &Gap) -> Measured {
    let insets: f64 = gap.bodies.iter().map(|&body| void.insets[body]).sum();
    let (mut points, mut widths, mut all_widths) = (Vec::new(), Vec::new(), Vec::new());
    for (k, &[one, other]) in gap.crossings.iter().enumerate() {
        let length = (void.vertices[one].inset - void.vertices[other].inset).norm();
        let (there, back) = (void.to_edges(one, other), void.to_edges(other, one));
        // Negative where the bodies lie in each other.
        let sign = if length < insets { -1.0 } else { 1.0 };
        let width = sign * there[1].min(back[1]);
        all_widths.push(width);
        if length <= 1.05 * there[0].max(back[0]) {
            points.push((k, middle(void, [one, other])));
            widths.push(width);
        }
    }
    let [one, other] = gap.bodies.map(|body| &void.shapes[body]);
    let limit = void.reach.between(one, other);
    let span = |points: &[(usize, Point)]| match points {
        [(_, first), .., (_, last)] => (last - first).norm(),
        _ => 0.0,
    };
    let exact = EXACT * extent(one).min(extent(other));
    let is_stub = span(&points) <= shortest(void, gap).max(exact);
    if is_stub {
        // From end to end.
        let end = |end: End, k: usize| match end {
            End::Junction(face) => centre(void, face),
            End::Open => middle(void, gap.crossings[k]),
        };
        let last = gap.crossings.len() - 1;
        points = vec![(0, end(gap.ends[0], 0)), (last, end(gap.ends[1], last))];
        widths = all_widths;
    }
    let (least, most) = (widths.iter()).fold((f64::INFINITY, 0.0_f64), |(least, most), &width| {
        (least.min(width), most.max(width.abs()))
    });
    let is_still = gap.bodies.iter().any(|&body| void.fixed[body]);
    let equal = if is_still {
        0.0
    } else {
        STRAIGHT.0 * most.min(limit)
    };
    Measured {
        points,
        is_stub,
        equal: equal.max(exact),
        varies: most - least,
        is_still,
    }
}

/// How much the widths of half of all gaps vary.
pub(super) fn usual(measured: &[Measured]) -> f64 {
    let whole = measured.iter().filter(|measured| !measured.is_stub);
    let mut varies: Vec<f64> = whole.map(|measured| measured.varies).collect();
    varies.sort_by(f64::total_cmp);
    varies.get(varies.len() / 2).copied().unwrap_or(0.0)
}

/// The length below which a joint is none but a corner: the widest of the gaps that meet there, but no
/// more than most of what is closed.
pub(super) fn shortest(void: &Void, gap: &Gap) -> f64 {
    let [one, other] = gap.bodies.map(|body| &void.shapes[body]);
    let junctions = gap.ends.iter().filter_map(|end| match end {
        End::Junction(face) => Some(void.junctions[face].map(|vertex| void.vertices[vertex].at)),
        End::Open => None,
    });
    let sides = junctions.flat_map(|[a, b, c]| [(a - b).norm(), (b - c).norm(), (c - a).norm()]);
    sides
        .fold(0.0, f64::max)
        .min(0.75 * void.reach.between(one, other))
}

/// The middle of a junction: of the least circle about its corners.
pub(super) fn centre(void: &Void, face: usize) -> Point {
    let corners = void.junctions[&face].map(|vertex| void.vertices[vertex].at);
    let sides = [0, 1, 2].map(|k| (corners[(k + 1) % 3] - corners[(k + 2) % 3]).norm_squared());
    let longest = (0..3)
        .max_by(|&a, &b| sides[a].total_cmp(&sides[b]))
        .unwrap_or(0);
    let [a, b, c] = [0, 1, 2].map(|k| corners[(longest + k) % 3]);
    if sides[longest] >= sides[(longest + 1) % 3] + sides[(longest + 2) % 3] {
        return nalgebra::center(&b, &c);
    }
    let (b, c) = (b - a, c - a);
    let twice = 2.0 * b.perp(&c);
    let (bb, cc) = (b.norm_squared(), c.norm_squared());
    a + Vector::new(c.y * bb - b.y * cc, b.x * cc - c.x * bb) / twice
}
