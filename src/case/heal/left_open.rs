//! What stays open between bodies: edges that face each other and do not touch.
//!
//! This asks the outlines alone, and nothing of how gaps are closed.

use super::closing::named;
use super::line::{holds, to_outline};
use super::void::Reach;
use crate::case::complaint::Complaint;
use crate::scene::{Point, Polygon, TOUCHING, Vector, close_pairs, extent};

/// Edges face each other whose normals are this far against each other, as a cosine.
const AGAINST: f64 = 0.5;

/// Places along a gap at which something may stand in it.
const PLACES: usize = 5;

/// A gap between two edges that face each other over more than they are apart.
pub(in crate::case) struct LeftOpen {
    pub bodies: [usize; 2],
    pub at: Point,
    /// How wide it is drawn at most, and over the smaller body's extent.
    pub width: f64,
    pub part: f64,
    /// Whether the bodies touch elsewhere.
    pub has_joint: bool,
}

impl LeftOpen {
    /// Whether it was to be closed: it is no wider than that, or all that is between the two.
    pub fn is_refused(&self, reach: Reach) -> bool {
        !self.has_joint || self.part <= reach.part && self.width <= reach.width
    }
}

/// Which gaps are open where they are wider than what is closed.
pub(in crate::case) fn stay_open(
    wider: &[LeftOpen],
    name: &dyn Fn(usize) -> String,
) -> Option<Complaint> {
    let title = match wider.len() {
        1 => "a gap stays open in part, where it is wider than what is closed".to_owned(),
        count => {
            format!("{count} gaps stay open in part, where they are wider than what is closed")
        }
    };
    let place = |gap: &LeftOpen| {
        let ([one, other], at, width) = (gap.bodies.map(name), gap.at, gap.width);
        format!(
            "`{one}` and `{other}` at ({:.4}, {:.4}), {width:.3e} wide",
            at.x, at.y
        )
    };
    let help = format!(
        "name a larger `gap`, or draw them closed: {}",
        named(wider, place)
    );
    (!wider.is_empty()).then(|| Complaint::new(title).help(help).into_warning())
}

/// The gaps between bodies within reach, as wide as they were before they were closed.
pub(in crate::case) fn left_open(
    before: &[Polygon],
    closed: &[Polygon],
    fixed: &[bool],
    reach: Reach,
) -> Vec<LeftOpen> {
    let all: Vec<&Polygon> = closed.iter().collect();
    let mut beside: Vec<Vec<usize>> = vec![Vec::new(); closed.len()];
    let pairs = close_pairs(reach.part, &all, &[]);
    for &(one, other) in &pairs {
        beside[one].push(other);
        beside[other].push(one);
    }
    let mut found = Vec::new();
    for (one, other) in pairs {
        if fixed[one] && fixed[other] {
            continue;
        }
        let bodies = [one, other];
        let limit = reach.between(&before[one], &before[other]);
        let size = extent(&before[one]).min(extent(&before[other]));
        let facing = |limits: [f64; 2]| {
            let edges = closed[one].edges();
            edges.flat_map(move |edge| {
                let others = closed[other].edges();
                others.filter_map(move |other| Facing::between(edge, other, limits))
            })
        };
        let touching = TOUCHING * size;
        let has_joint = facing([-touching, touching]).next().is_some();
        for facing in facing([touching, limit]) {
            let between: Vec<Point> = (0..PLACES)
                .map(|k| facing.middle((k as f64 + 0.5) / PLACES as f64))
                .filter(|p| {
                    let mut others = beside[one].iter().filter(|&&body| body != other);
                    !others.any(|&body| holds(closed[body].corners(), *p))
                })
                .collect();
            let Some(&at) = between.get(between.len() / 2) else {
                continue;
            };
            let drawn = |p: Point| bodies.map(|body| to_outline(p, before[body].corners()));
            let width =
                [facing.middle(0.0), at, facing.middle(1.0)].map(|p| drawn(p).iter().sum::<f64>());
            let width = width.into_iter().fold(0.0, f64::max);
            if facing.length() <= width {
                continue;
            }
            found.push(LeftOpen {
                bodies,
                at,
                width,
                part: width / size,
                has_joint,
            });
        }
    }
    found
}

/// A part of an edge, and of another one that faces it.
struct Facing {
    from: [Point; 2],
    to: [Point; 2],
}

impl Facing {
    /// Where two edges face each other, as far apart as the limits say.
    fn between(
        (a, b): (Point, Point),
        (c, d): (Point, Point),
        [least, most]: [f64; 2],
    ) -> Option<Facing> {
        let (along, length) = ((b - a).normalize(), (b - a).norm());
        let outwards = Vector::new(along.y, -along.x);
        if (d - c).normalize().dot(&along) > -AGAINST {
            return None;
        }
        // The other edge from its end on, seen from this one: place and distance.
        let [(s, near), (t, far)] = [d, c].map(|p| (along.dot(&(p - a)), outwards.dot(&(p - a))));
        let (mut first, mut last) = (0.0_f64, 1.0_f64);
        for (before, after) in [
            (s, t),
            (length - s, length - t),
            (near - least, far - least),
            (most - near, most - far),
        ] {
            let root = before / (before - after);
            match (before >= 0.0, after >= 0.0) {
                (true, true) => {}
                (true, false) => last = last.min(root),
                (false, true) => first = first.max(root),
                (false, false) => return None,
            }
        }
        let at = |part: f64| (s + (t - s) * part, near + (far - near) * part);
        let ((s, near), (t, far)) = (at(first), at(last));
        let on = |s: f64, off: f64| a + along * s + outwards * off;
        (first < last && s < t).then(|| Facing {
            from: [on(s, 0.0), on(t, 0.0)],
            to: [on(s, near), on(t, far)],
        })
    }

    fn length(&self) -> f64 {
        (self.from[1] - self.from[0]).norm()
    }

    /// The point in the middle of the gap, at a part of its length.
    fn middle(&self, part: f64) -> Point {
        let at = |[from, to]: [Point; 2]| from + (to - from) * part;
        nalgebra::center(&at(self.from), &at(self.to))
    }
}
