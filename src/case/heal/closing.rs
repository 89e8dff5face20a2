//! Closing the gaps of a whole wall: what was moved, what is in doubt, and what cannot be closed.

use super::joints::joints;
use super::line::to_outline;
use super::nodes::Meeting;
use super::outline::outlines;
use super::void::{Reach, Void};
use crate::case::complaint::Complaint;
use crate::scene::{Point, Polygon, close_pairs, extent, overlap, signed_area};
use crate::text::counted;

/// An outline keeps at least this part of its area.
const LEAST_LEFT: f64 = 0.5;

/// What is said of one that does not.
const SWALLOWED: &str = "closing the gaps beside it would swallow this outline, or turn it over";

const MOST_NAMED: usize = 2;

/// Bodies with the gaps between them closed.
pub(in crate::case) struct Closed {
    pub shapes: Vec<Polygon>,
    /// How far corners were moved, where any was.
    pub moved: Option<String>,
    /// What the gaps do not say.
    pub doubt: Option<Complaint>,
}

/// A body whose gaps cannot be closed, and why.
pub(in crate::case) struct CannotClose {
    pub body: usize,
    pub why: String,
}

/// Closes the gaps within reach, each to one line in its middle, of bodies with names of which some are
/// fixed; `None` where bodies lie in each other deeper than the reach. Shapes that fit already stay as they
/// are, to the last bit.
///
/// # Errors
/// A body that would not be what it was.
pub(in crate::case) fn close(
    shapes: &[Polygon],
    fixed: &[bool],
    reach: Reach,
    name: &dyn Fn(usize) -> String,
) -> Result<Option<Closed>, CannotClose> {
    let all: Vec<&Polygon> = shapes.iter().collect();
    let lie_in_each_other = close_pairs(0.0, &all, &[]).into_iter().any(|(one, other)| {
        let (one, other) = (all[one], all[other]);
        overlap(one, other) > reach.between(one, other)
    });
    let void = (!lie_in_each_other).then(|| Void::new(shapes, fixed, reach));
    let Some(mut void) = void.flatten() else {
        return Ok(None);
    };
    let (joints, meetings) = joints(&mut void);
    let outlines = outlines(&void, &joints);
    let (mut ways, mut bodies) = (Vec::new(), 0);
    let mut closed = shapes.to_vec();
    for (body, corners) in outlines.iter().enumerate() {
        let old = &shapes[body];
        if old.corners() == corners.as_slice() {
            continue;
        }
        let cannot = |why: &str| CannotClose {
            body,
            why: why.to_owned(),
        };
        if corners.len() < 3 || signed_area(corners) < LEAST_LEFT * old.area() {
            return Err(cannot(SWALLOWED));
        }
        let before = ways.len();
        let moved = moved(old, corners, reach).map_err(|why| cannot(&why))?;
        ways.extend(moved.into_iter().map(|way| (way, body)));
        bodies += usize::from(ways.len() > before);
        closed[body] = Polygon::new(corners.clone()).map_err(|_| cannot(SWALLOWED))?;
    }
    ways.sort_by(|a, b| a.0.total_cmp(&b.0));
    let moved = ways.last().map(|&(farthest, body)| {
        let (count, median) = (ways.len(), ways[ways.len() / 2].0);
        format!(
            "moved {count} corners of {bodies} outlines so that neighbours touch, half of them by at most \
             {median:.3e}, the farthest, of `{}`, by {farthest:.3e}",
            name(body)
        )
    });
    Ok(Some(Closed {
        shapes: closed,
        moved,
        doubt: doubt(&meetings, name),
    }))
}

/// How far the corners of an outline were moved that were; an error where one was too far.
fn moved(old: &Polygon, corners: &[Point], reach: Reach) -> Result<Vec<f64>, String> {
    let size = extent(old);
    let farthest = 2.0 * reach.width.min(reach.part * size);
    let far = |p: &&Point, others: &[Point]| to_outline(**p, others) > farthest;
    let left = old.corners().iter().find(|p| far(p, corners));
    if let Some(at) = left.or_else(|| corners.iter().find(|p| far(p, old.corners()))) {
        return Err(format!(
            "a corner at ({:.4}, {:.4}) would have to move by more than {:.2} % of its block to touch its \
             neighbours",
            at.x,
            at.y,
            100.0 * farthest / size
        ));
    }
    let ways = old.corners().iter().map(|p| {
        let near = corners.iter().map(|new| (new - p).norm());
        let near = near.fold(f64::INFINITY, f64::min);
        // Where a joint became straight, no corner is left.
        if near > farthest {
            to_outline(*p, corners)
        } else {
            near
        }
    });
    Ok(ways.filter(|way| *way > 0.0).collect())
}

/// Where four bodies meet so nearly in one point that gaps and corners do not say which two touch.
fn doubt(meetings: &[Meeting], name: &dyn Fn(usize) -> String) -> Option<Complaint> {
    let apart = meetings.iter().map(|meeting| meeting.apart.abs());
    let longest = apart.fold(0.0, f64::max);
    let place = |meeting: &Meeting| {
        let ([a, b, c, d], at) = (meeting.bodies.map(name), meeting.at);
        let taken = match meeting.is_joint {
            true => format!("`{a}` and `{b}` are taken to touch"),
            false => "none is taken to touch the one across".to_owned(),
        };
        format!(
            "`{a}`, `{c}`, `{b}`, `{d}` at ({:.4}, {:.4}): {taken}",
            at.x, at.y
        )
    };
    let title = format!(
        "four stones meet nearly in one point at {}, and their corners are too far off to say which of them \
         touch",
        counted(meetings.len(), "place")
    );
    let help = format!(
        "λ may depend on a joint of up to {longest:.1e} there; draw the corners nearer to each other where it \
         is one: {}",
        named(meetings, place)
    );
    (!meetings.is_empty()).then(|| Complaint::new(title).help(help).into_warning())
}

/// The first of several places, and how many more there are.
pub(super) fn named<T>(places: &[T], place: impl Fn(&T) -> String) -> String {
    let named: Vec<String> = places.iter().take(MOST_NAMED).map(place).collect();
    let named = named.join("; ");
    match places.len().saturating_sub(MOST_NAMED) {
        0 => named,
        more => format!("{named}; and {more} more"),
    }
}
