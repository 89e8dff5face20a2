//! The joints that gaps are closed to: lines in their middle, and the points where they meet.

use std::collections::BTreeMap;

use nalgebra::Matrix2;

use super::line::Line;
use super::void::{End, Gap, Void};
use crate::scene::{Point, Vector, extent};

/// A joint is straight where its bends are within this part of the gap's width and this part of how much
/// the width varies.
const STRAIGHT: (f64, f64) = (0.02, 0.25);

/// As far as this from a line, as a part of the extent, points lie on it.
const EXACT: f64 = 1e-9;

/// Lines at a still body count this much more than others where joints meet.
const STILL: f64 = 1e6;

/// Lines whose directions spread less than this have no good meeting point.
const SPREAD: f64 = 0.02;

/// A joint from end to end.
pub(super) struct Joint {
    /// The ends; `None` where no other joint begins.
    pub ends: [Option<Point>; 2],
    /// A line for each straight part, and the bends between them.
    pub lines: Vec<Line>,
    pub bends: Vec<Point>,
    /// The width that half of the gap has no more of.
    pub width: f64,
    /// The point in its middle.
    pub at: Point,
}

/// A straight part of a joint.
struct Part {
    points: Vec<Point>,
    /// How far its points may be from its line.
    within: f64,
    /// The drawn edge of either body that it mostly lies along.
    along: [Option<(usize, usize)>; 2],
}

/// What is measured along a gap.
struct Measured {
    /// Points in its middle, or on the body of the two that is still, and the crossings they lie on.
    points: Vec<(usize, Point)>,
    widths: Vec<f64>,
    /// Whether it is too short to have a direction.
    is_stub: bool,
    within: f64,
}

/// The joints of all gaps.
pub(super) fn joints(void: &Void) -> Vec<Joint> {
    let measured: Vec<Measured> = void.gaps.iter().map(|gap| measured(void, gap)).collect();
    let (mut parts, mut first) = (Vec::new(), vec![0]);
    for (index, of) in measured.iter().enumerate() {
        parts.extend(parts_of(void, index, of));
        first.push(parts.len());
    }
    let lines = lines(&parts);
    let nodes = nodes(void, &measured, &lines, &first);
    let joint = |(index, gap): (usize, &Gap)| {
        let (own, lines) = (first[index]..first[index + 1], &lines);
        let bends = own.clone().skip(1).map(|part| {
            let corner = parts[part].points[0];
            let meeting = lines[part - 1].meet(&lines[part], corner);
            meeting.unwrap_or(corner)
        });
        let bends: Vec<Point> = bends.collect();
        let node = |end: End| match end {
            End::Junction(face) => Some(nodes[&face]),
            End::Open => None,
        };
        let ends = gap.ends.map(node);
        let mut lines = lines[own].to_vec();
        // An end line goes through the point at its other end, as both bodies' outlines do.
        let last = lines.len() - 1;
        for (line, through, end) in [
            (0, bends.first().copied().or(ends[1]), ends[0]),
            (last, bends.last().copied().or(ends[0]), ends[1]),
        ] {
            if let (Some(point), None) = (through, end) {
                lines[line].point = point;
            }
        }
        let Measured { points, widths, .. } = &measured[index];
        let mut sorted = widths.clone();
        sorted.sort_by(f64::total_cmp);
        Joint {
            ends,
            lines,
            bends,
            width: sorted[sorted.len() / 2],
            at: nalgebra::center(&points[0].1, &points[points.len() - 1].1),
        }
    };
    void.gaps.iter().enumerate().map(joint).collect()
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
fn measured(void: &Void, gap: &Gap) -> Measured {
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
    let within = match gap.bodies.iter().any(|&body| void.fixed[body]) {
        true => exact,
        false => (STRAIGHT.0 * most.min(limit) + STRAIGHT.1 * (most - least)).max(exact),
    };
    Measured {
        points,
        widths,
        is_stub,
        within,
    }
}

/// The length below which a joint is none but a corner: the widest of the gaps that meet there, but no
/// more than most of what is closed.
fn shortest(void: &Void, gap: &Gap) -> f64 {
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
fn centre(void: &Void, face: usize) -> Point {
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

/// The straight parts of a gap's joint.
fn parts_of(void: &Void, gap: usize, measured: &Measured) -> Vec<Part> {
    let points: Vec<Point> = measured.points.iter().map(|(_, point)| *point).collect();
    let mut bends = vec![0];
    bends_between(&points, 0, points.len() - 1, measured.within, &mut bends);
    let part = |pair: &[usize]| Part {
        points: points[pair[0]..=pair[1]].to_vec(),
        within: measured.within,
        along: drawn_edges(
            void,
            gap,
            [measured.points[pair[0]].0, measured.points[pair[1]].0],
        ),
    };
    bends.windows(2).map(part).collect()
}

/// Adds the last of the points, and before it those that are farther than `within` from the way between
/// those beside them (Douglas and Peucker).
fn bends_between(points: &[Point], from: usize, to: usize, within: f64, bends: &mut Vec<usize>) {
    let way = Line::through(points[from], points[to]);
    let off = |k: &usize| way.distance(points[*k]).abs();
    let farthest = (from + 1..to).max_by(|a, b| off(a).total_cmp(&off(b)));
    match farthest.filter(|k| off(k) > within) {
        Some(k) => {
            bends_between(points, from, k, within, bends);
            bends_between(points, k, to, within, bends);
        }
        None => bends.push(to),
    }
}

/// The edge of either body that lies along most of the crossings in a range.
fn drawn_edges(void: &Void, gap: usize, [from, to]: [usize; 2]) -> [Option<(usize, usize)>; 2] {
    let crossings = &void.gaps[gap].crossings[from..=to];
    [0, 1].map(|side| {
        let mut lengths: BTreeMap<(usize, usize), f64> = BTreeMap::new();
        for pair in crossings.windows(2) {
            // The second body is followed clockwise.
            let [before, after] =
                [pair[side][side], pair[1 - side][side]].map(|v| &void.vertices[v]);
            let length = (after.at - before.at).norm();
            *lengths.entry((before.body, before.edge)).or_default() += length;
        }
        let longest = lengths.into_iter().max_by(|a, b| a.1.total_cmp(&b.1));
        longest
            .filter(|(_, length)| *length > 0.0)
            .map(|(edge, _)| edge)
    })
}

/// The line of each part: one for all parts along a drawn edge that are straight together, as a bed
/// joint through a whole course is.
fn lines(parts: &[Part]) -> Vec<Line> {
    let mut along: BTreeMap<(usize, usize), Vec<usize>> = BTreeMap::new();
    for (index, part) in parts.iter().enumerate() {
        for edge in part.along.iter().flatten() {
            along.entry(*edge).or_default().push(index);
        }
    }
    let mut group: Vec<usize> = (0..parts.len()).collect();
    let mut members: Vec<Vec<usize>> = (0..parts.len()).map(|part| vec![part]).collect();
    let points_of = |members: &[usize]| -> Vec<Point> {
        members
            .iter()
            .flat_map(|&part| parts[part].points.iter().copied())
            .collect()
    };
    for pair in along.values().flat_map(|of| of.windows(2)) {
        let (one, other) = (group[pair[0]], group[pair[1]]);
        if one == other {
            continue;
        }
        let together = [members[one].as_slice(), members[other].as_slice()].concat();
        let line = Line::fitted(&points_of(&together));
        let is_straight = together.iter().all(|&part| {
            let Part { points, within, .. } = &parts[part];
            points
                .iter()
                .all(|point| line.distance(*point).abs() <= *within)
        });
        if is_straight {
            let (kept, gone) = (one.min(other), one.max(other));
            together.iter().for_each(|&part| group[part] = kept);
            members[gone].clear();
            members[kept] = together;
        }
    }
    let fitted: Vec<Option<Line>> = members
        .iter()
        .map(|of| (!of.is_empty()).then(|| Line::fitted(&points_of(of))))
        .collect();
    let line = |part: usize| fitted[group[part]].expect("a group has members");
    (0..parts.len()).map(line).collect()
}

/// The point of every junction: the nearest to all lines that end there. Junctions that a stub joins are
/// one where the lines do not tell them apart.
fn nodes(
    void: &Void,
    measured: &[Measured],
    lines: &[Line],
    first: &[usize],
) -> BTreeMap<usize, Point> {
    let mut ending: BTreeMap<usize, Vec<(Line, f64)>> = BTreeMap::new();
    for (index, gap) in void.gaps.iter().enumerate() {
        let still = gap.bodies.iter().any(|&body| void.fixed[body]);
        let weight = if still { STILL } else { 1.0 };
        let own = [first[index], first[index + 1] - 1];
        for (end, part) in gap.ends.iter().zip(own) {
            if let (End::Junction(face), false) = (end, measured[index].is_stub) {
                ending.entry(*face).or_default().push((lines[part], weight));
            }
        }
    }
    let node = |faces: &[usize]| {
        let of = faces
            .iter()
            .flat_map(|face| ending.get(face).into_iter().flatten());
        let centres = faces.iter().map(|&face| centre(void, face).coords);
        let middle = Point::from(centres.sum::<Vector>() / faces.len() as f64);
        let width = faces.iter().map(|&face| {
            let [a, b, c] = void.junctions[&face].map(|vertex| void.vertices[vertex].at);
            (a - b).norm().max((b - c).norm()).max((c - a).norm())
        });
        nearest_to(of.copied(), middle, 2.0 * width.fold(0.0, f64::max))
    };
    let mut of: BTreeMap<usize, (Point, Vec<usize>)> = (void.junctions.keys())
        .map(|&face| (face, (node(&[face]), vec![face])))
        .collect();
    for (gap, measured) in void.gaps.iter().zip(measured) {
        let (true, [End::Junction(from), End::Junction(to)]) = (measured.is_stub, gap.ends) else {
            continue;
        };
        let (one, other) = (&of[&from], &of[&to]);
        if one.1 == other.1 {
            continue;
        }
        // Forward is to the left of a crossing.
        let [start, end] = gap.crossings[0].map(|vertex| void.vertices[vertex].inset);
        let forward = Vector::new(start.y - end.y, end.x - start.x).normalize();
        if (other.0 - one.0).dot(&forward) > shortest(void, gap) {
            continue;
        }
        let mut faces = [one.1.as_slice(), other.1.as_slice()].concat();
        faces.sort_unstable();
        let joined = (node(&faces), faces);
        for face in joined.1.clone() {
            of.insert(face, joined.clone());
        }
    }
    of.into_iter()
        .map(|(face, (point, _))| (face, point))
        .collect()
}

/// The point nearest to lines with weights; where they spread too little, near a middle.
fn nearest_to(
    lines: impl Iterator<Item = (Line, f64)> + Clone,
    middle: Point,
    farthest: f64,
) -> Point {
    let solved = |own: f64, heaviest: f64| {
        let mut matrix = Matrix2::identity() * own;
        let mut right = Vector::zeros();
        for (line, weight) in lines.clone() {
            let normal = Vector::new(-line.along.y, line.along.x);
            let weight = weight / heaviest;
            matrix += normal * normal.transpose() * weight;
            right -= normal * (weight * line.distance(middle));
        }
        (matrix, right)
    };
    let (plain, _) = solved(0.0, 1.0);
    let spread = |matrix: Matrix2<f64>| matrix.determinant() / matrix.trace().max(1.0);
    let (matrix, right) = match spread(plain) > SPREAD {
        true => solved(0.0, 1.0),
        false => solved(1e-3, 1.0),
    };
    let step = matrix
        .try_inverse()
        .map_or(Vector::zeros(), |inverse| inverse * right);
    match step.norm() <= farthest {
        true => middle + step,
        false => middle,
    }
}
