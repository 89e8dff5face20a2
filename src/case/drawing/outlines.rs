//! From paths to closed outlines: lines and arcs joined end to end.

use super::entities::handle_and_layer;
use super::paths::Path;
use crate::case::complaint::Complaint;
use crate::scene::Point;

/// Most lines and arcs that are joined.
const MOST_OPEN: usize = 50_000;

/// The closed outlines among the paths, and those that open paths of one layer add up to. Ends join
/// within `tolerance` times the shorter path's length.
///
/// # Errors
/// A path whose end leads nowhere.
pub(super) fn outlines(paths: Vec<Path>, tolerance: f64) -> Result<Vec<Path>, Complaint> {
    let (mut closed, mut open) = (Vec::new(), Vec::new());
    for mut path in paths {
        path.points.dedup();
        let ends_meet = path.points.len() > 3 && {
            let first = path.points[0];
            let shortest = edges(&path).filter(|length| *length > 0.0);
            let shortest = shortest.fold(f64::INFINITY, f64::min);
            (path.points[path.points.len() - 1] - first).norm() <= tolerance * shortest
        };
        if ends_meet {
            path.points.pop();
        }
        if path.closed || ends_meet {
            closed.push(path);
        } else if path.points.len() > 1 {
            open.push(path);
        }
    }
    if let Some(path) = open.get(MOST_OPEN) {
        let title = format!("more than {MOST_OPEN} lines and arcs");
        let complaint = Complaint::at(path.place.clone(), title, "the first too many");
        return Err(complaint.help("draw each block as one closed polyline"));
    }
    let mut used = vec![false; open.len()];
    for first in 0..open.len() {
        if !used[first] {
            closed.push(chain(&open, &mut used, first, tolerance)?);
        }
    }
    // In the order of the drawing.
    closed.sort_by_key(|path| path.place.start);
    Ok(closed)
}

/// The lengths of a path's edges.
fn edges(path: &Path) -> impl Iterator<Item = f64> {
    let pairs = path.points.windows(2);
    pairs.map(|pair| (pair[1] - pair[0]).norm())
}

/// The outline that begins with an open path: each time the one that goes on from its end, until it is
/// back at its beginning.
fn chain(
    open: &[Path],
    used: &mut [bool],
    first: usize,
    tolerance: f64,
) -> Result<Path, Complaint> {
    let mut outline = open[first].clone();
    used[first] = true;
    let (mut last, mut count) = (first, 1);
    loop {
        let start = outline.points[0];
        let end = outline.points[outline.points.len() - 1];
        let length = |path: &Path| edges(path).sum::<f64>();
        let reach = |path: &Path| tolerance * length(path).min(length(&open[last]));
        if count > 1 && (end - start).norm() <= reach(&open[first]) {
            outline.points.pop();
            outline.closed = true;
            outline.kind = "lines and arcs".to_owned();
            return Ok(outline);
        }
        // Lines of one block stand beside each other in the file, those of its neighbours farther off.
        let nearest_first = (1..open.len()).flat_map(|step| {
            let behind = last + step;
            [
                (behind < open.len()).then_some(behind),
                last.checked_sub(step),
            ]
        });
        let next = nearest_first.flatten().find(|&other| {
            let path = &open[other];
            let near = |p: Point| (p - end).norm() <= reach(path);
            let ends = [path.points[0], path.points[path.points.len() - 1]];
            !used[other] && path.layer == outline.layer && ends.into_iter().any(near)
        });
        let Some(next) = next else {
            return Err(leads_nowhere(&open[last], end));
        };
        used[next] = true;
        let mut points = open[next].points.clone();
        if (points[0] - end).norm() > (points[points.len() - 1] - end).norm() {
            points.reverse();
        }
        outline.points.extend(&points[1..]);
        (last, count) = (next, count + 1);
    }
}

fn leads_nowhere(path: &Path, end: Point) -> Complaint {
    let title = format!("a {} that closes no outline", path.kind);
    let whose = handle_and_layer(&path.handle, &path.layer);
    let label = format!("{whose}: nothing goes on from ({}, {})", end.x, end.y);
    Complaint::at(path.place.clone(), title, label).help(
        "draw each block as one closed polyline, or as lines and arcs that meet; leave the layers of other \
         lines out: `without` names them",
    )
}
