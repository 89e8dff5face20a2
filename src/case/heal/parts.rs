//! The straight parts of joints, and the lines that they lie on.

use std::collections::BTreeMap;

use super::line::Line;
use super::measured::Measured;
use super::void::Void;
use crate::scene::Point;

/// A straight part of a joint.
pub(super) struct Part {
    pub points: Vec<Point>,
    /// How far its points may be from its line.
    within: f64,
    /// The drawn edge of either body that it mostly lies along.
    along: [Option<(usize, usize)>; 2],
}

/// The straight parts of a gap's joint.
pub(super) fn parts_of(void: &Void, gap: usize, measured: &Measured, within: f64) -> Vec<Part> {
    let points: Vec<Point> = measured.points.iter().map(|(_, point)| *point).collect();
    let mut bends = vec![0];
    bends_between(&points, 0, points.len() - 1, within, &mut bends);
    let part = |pair: &[usize]| Part {
        points: points[pair[0]..=pair[1]].to_vec(),
        within,
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
pub(super) fn lines(parts: &[Part]) -> Vec<Line> {
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
