//! From paths to closed outlines: lines and arcs joined end to end.

use super::cells::cells;
use super::paths::{Path, leads_nowhere};
use crate::case::complaint::Complaint;
use crate::case::heal::to_segment;
use crate::scene::{Point, Polygon};

/// Most lines and arcs that are joined.
const MOST_OPEN: usize = 50_000;

/// The closed outlines among the paths, and those that open paths of one layer add up to; where they add
/// up to none, the cells between them. Ends join within `tolerance` times the shorter path's length.
///
/// # Errors
/// A path whose end leads nowhere.
pub(super) fn outlines(
    paths: Vec<Path>,
    tolerance: f64,
    remarks: &mut Vec<String>,
) -> Result<Vec<Path>, Complaint> {
    let (mut closed, mut open) = (Vec::new(), Vec::new());
    for mut path in paths {
        path.points.dedup();
        if ends(&mut path.points, tolerance) {
            path.closed = true;
        }
        let is_dot = path.points.iter().all(|p| *p == path.points[0]);
        if is_dot {
            continue;
        }
        if path.closed {
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
    let chains = std::iter::from_fn(|| {
        let first = used.iter().position(|used| !used)?;
        Some(chain(&open, &mut used, first, tolerance))
    });
    let chained: Result<Vec<Path>, Complaint> = chains.collect();
    // Of stones that are drawn line by line, a chain may go on along a neighbour.
    let is_outline = |path: &Path| Polygon::new(path.points.clone()).is_ok();
    match chained {
        Ok(chained) if chained.iter().all(is_outline) => closed.extend(chained),
        _ => {
            let shares = |path: &Path| open.iter().any(|other| other.layer == path.layer);
            let (shared, whole) = closed.into_iter().partition(shares);
            closed = whole;
            let lines = [open, shared].concat();
            let shortest = lines.iter().flat_map(edges).filter(|length| *length > 0.0);
            let near = tolerance * shortest.fold(f64::INFINITY, f64::min);
            let cells = cells(&lines, near)?;
            remarks.push(format!(
                "{} cells between {} lines are taken for stones; a closed outline on a layer `openings` \
                 says which are none",
                cells.len(),
                lines.len()
            ));
            closed.extend(cells);
        }
    }
    // In the order of the drawing.
    closed.sort_by_key(|path| path.place.start);
    Ok(closed)
}

/// Whether points come back to where they began; what is drawn beyond, along the edges that are there, is
/// cut off.
fn ends(points: &mut Vec<Point>, tolerance: f64) -> bool {
    let Some(&first) = points.first() else {
        return false;
    };
    let lengths = points.windows(2).map(|pair| (pair[1] - pair[0]).norm());
    let shortest = lengths
        .filter(|length| *length > 0.0)
        .fold(f64::INFINITY, f64::min);
    let near = tolerance * shortest;
    let comes_back = |k: &usize| to_segment(first, points[k - 1], points[*k]) <= near;
    let Some(end) = (3..points.len()).find(comes_back) else {
        return false;
    };
    let is_drawn = |p: &Point| {
        let mut edges = points[..end].windows(2);
        edges.any(|edge| to_segment(*p, edge[0], edge[1]) <= near)
    };
    let is_end = points[end..].iter().all(is_drawn);
    if is_end {
        points.truncate(end);
    }
    is_end
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
