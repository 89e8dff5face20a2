//! The outline of a body between its joints.

use std::collections::HashMap;

use super::joints::Joint;
use super::line::{Line, to_segment, without_repeats};
use super::void::{End, Gap, Vertex, Void};
use crate::scene::{Point, extent};

/// Points as near as this to what is drawn, as a part of the extent, are what is drawn.
const EXACT: f64 = 1e-9;

/// The joints of a body from one open end to the next or once round, counter-clockwise: each with
/// whether the body is the first of its two.
type Run = Vec<(usize, bool)>;

/// The corners of every body.
pub(super) fn outlines(void: &Void, joints: &[Joint]) -> Vec<Vec<Point>> {
    let runs = runs(void);
    let bodies = void.shapes.iter().zip(runs).enumerate();
    let outlines = bodies.map(|(body, (shape, runs))| {
        if runs.is_empty() || void.fixed[body] {
            return shape.corners().to_vec();
        }
        let mut points = Vec::new();
        for (k, run) in runs.iter().enumerate() {
            follow(joints, run, &mut points);
            if open_end(void, run).is_some() {
                let next = &runs[(k + 1) % runs.len()];
                between(void, joints, body, [run, next], &mut points);
            }
        }
        as_drawn(points, shape.corners(), EXACT * extent(shape))
    });
    outlines.collect()
}

/// The runs of each body, in the order of its corners.
fn runs(void: &Void) -> Vec<Vec<Run>> {
    let mut begins: HashMap<(usize, usize), (usize, bool)> = HashMap::new();
    let both = [(0, true), (1, false)];
    for (index, gap) in void.gaps.iter().enumerate() {
        for (side, is_first) in both {
            if let End::Junction(face) = gap.ends[side] {
                begins.insert((face, gap.bodies[side]), (index, is_first));
            }
        }
    }
    let mut used = vec![[false; 2]; void.gaps.len()];
    let mut runs: Vec<Vec<Run>> = vec![Vec::new(); void.shapes.len()];
    // Those from open ends first; what is left goes once round.
    for rings in [false, true] {
        for (index, gap) in void.gaps.iter().enumerate() {
            for (side, is_first) in both {
                if used[index][side] || (gap.ends[side] != End::Open && !rings) {
                    continue;
                }
                let body = gap.bodies[side];
                let (mut run, mut next) = (Vec::new(), Some((index, is_first)));
                while let Some((index, is_first)) = next {
                    let side = usize::from(!is_first);
                    if std::mem::replace(&mut used[index][side], true) {
                        break;
                    }
                    run.push((index, is_first));
                    next = match void.gaps[index].ends[1 - side] {
                        End::Junction(face) => begins.get(&(face, body)).copied(),
                        End::Open => None,
                    };
                }
                runs[body].push(run);
            }
        }
    }
    let place = |run: &Run| {
        let vertex = start(void, run);
        vertex.edge as f64 + vertex.along
    };
    for runs in &mut runs {
        runs.sort_by(|a, b| place(a).total_cmp(&place(b)));
    }
    runs
}

/// The vertex of the body at which a run begins.
fn start<'v>(void: &'v Void, run: &Run) -> &'v Vertex {
    let (index, is_first) = run[0];
    let crossings = &void.gaps[index].crossings;
    match is_first {
        true => &void.vertices[crossings[0][0]],
        false => &void.vertices[crossings[crossings.len() - 1][1]],
    }
}

/// The vertex of the body at which a run ends; `None` where it goes once round.
fn open_end<'v>(void: &'v Void, run: &Run) -> Option<&'v Vertex> {
    let (index, is_first) = run[run.len() - 1];
    let Gap {
        crossings, ends, ..
    } = &void.gaps[index];
    let (vertex, end) = match is_first {
        true => (crossings[crossings.len() - 1][0], ends[1]),
        false => (crossings[0][1], ends[0]),
    };
    (end == End::Open).then(|| &void.vertices[vertex])
}

/// Adds the points of a run but for its open ends.
fn follow(joints: &[Joint], run: &Run, points: &mut Vec<Point>) {
    for &(index, is_first) in run {
        let joint = &joints[index];
        match is_first {
            true => points.extend(&joint.bends),
            false => points.extend(joint.bends.iter().rev()),
        }
        points.extend(joint.ends[usize::from(is_first)]);
    }
}

/// Adds the corners from the end of a run to the beginning of the next: those of the edges between them
/// as they are drawn, the first and the last on the joints' lines.
fn between(
    void: &Void,
    joints: &[Joint],
    body: usize,
    [run, next]: [&Run; 2],
    points: &mut Vec<Point>,
) {
    let corners = void.shapes[body].corners();
    let count = corners.len();
    let own = |edge: usize| Line::through(corners[edge % count], corners[(edge + 1) % count]);
    let line_at = |(index, from): (usize, bool)| {
        let lines = &joints[index].lines;
        lines[if from { 0 } else { lines.len() - 1 }]
    };
    let (index, is_first) = run[run.len() - 1];
    let before = line_at((index, !is_first));
    let after = line_at(next[0]);
    let (from, to) = (open_end(void, run).expect("it is open"), start(void, next));
    if from.edge == to.edge && !from.is_corner() && from.along <= to.along {
        // One edge between two joints, on one line or from one to the other.
        points.extend([before.nearest(from.at), after.nearest(to.at)]);
        return;
    }
    let first = from.edge + usize::from(!from.is_corner());
    let whole = (to.edge + count - first % count) % count;
    let mut line = before;
    for k in 0..=whole {
        let corner = corners[(first + k) % count];
        let following = if k == whole { after } else { own(first + k) };
        let is_drawn = k > 0 && k < whole;
        match line.meet(&following, corner) {
            _ if is_drawn => points.push(corner),
            Some(meeting) => points.push(meeting),
            None if whole == 0 => points.extend([line.nearest(from.at), following.nearest(to.at)]),
            None if k == 0 => points.extend([line.nearest(corner), corner]),
            None => points.extend([corner, following.nearest(corner)]),
        }
        line = following;
    }
}

/// Points without those that lie on the way between their neighbours, and drawn corners in place of
/// what differs by rounding.
fn as_drawn(mut points: Vec<Point>, corners: &[Point], near: f64) -> Vec<Point> {
    without_repeats(&mut points, near);
    let mut kept: Vec<Point> = Vec::new();
    let count = points.len();
    for k in 0..count {
        let before = kept
            .last()
            .copied()
            .unwrap_or(points[(k + count - 1) % count]);
        if to_segment(points[k], before, points[(k + 1) % count]) > near {
            let corner = corners
                .iter()
                .find(|corner| (*corner - points[k]).norm() <= near);
            kept.push(corner.copied().unwrap_or(points[k]));
        }
    }
    // From the corner on that is drawn first, where it is still one.
    if let Some(first) = corners
        .first()
        .and_then(|first| kept.iter().position(|p| p == first))
    {
        kept.rotate_left(first);
    }
    kept
}
