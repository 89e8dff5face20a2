//! Lines, and where they meet.

use crate::scene::{Point, Vector};

/// Sine of the angle below which two lines have no good intersection.
const PARALLEL: f64 = 0.02;

/// A corner moves at most this many times its distance from the lines beside it.
const FARTHEST: f64 = 3.0;

/// A line through a point.
#[derive(Clone, Copy, Debug)]
pub(super) struct Line {
    pub point: Point,
    pub along: Vector,
}

impl Line {
    pub fn through(from: Point, to: Point) -> Line {
        Line {
            point: from,
            along: (to - from).normalize(),
        }
    }

    /// The line from which the squares of the distances of the points are least in sum.
    pub fn fitted(points: &[Point]) -> Line {
        let count = points.len() as f64;
        let middle = points.iter().map(|p| p.coords).sum::<Vector>() / count;
        let (mut xx, mut xy, mut yy) = (0.0, 0.0, 0.0);
        for p in points {
            let arm = p.coords - middle;
            xx += arm.x * arm.x;
            xy += arm.x * arm.y;
            yy += arm.y * arm.y;
        }
        let turn = 0.5 * (2.0 * xy).atan2(xx - yy);
        Line {
            point: Point::from(middle),
            along: Vector::new(turn.cos(), turn.sin()),
        }
    }

    /// Positive to the left.
    pub fn distance(&self, p: Point) -> f64 {
        self.along.perp(&(p - self.point))
    }

    pub fn nearest(&self, p: Point) -> Point {
        self.point + self.along * self.along.dot(&(p - self.point))
    }

    /// Where two lines meet, if that is near a corner for its distance from them.
    pub fn meet(&self, other: &Line, corner: Point) -> Option<Point> {
        let sine = self.along.perp(&other.along);
        if sine.abs() <= PARALLEL {
            return None;
        }
        let crossing = self.point - self.along * (other.distance(self.point) / -sine);
        let off = self
            .distance(corner)
            .abs()
            .max(other.distance(corner).abs());
        ((crossing - corner).norm() <= FARTHEST * off).then_some(crossing)
    }
}

/// Takes out points round an outline that are as near as this to the one before.
pub fn without_repeats(points: &mut Vec<Point>, near: f64) {
    points.dedup_by(|a, b| (*a - *b).norm() <= near);
    while points.len() > 1 && (points[0] - points[points.len() - 1]).norm() <= near {
        points.pop();
    }
}

/// How far a point is from the straight way between two others.
pub fn to_segment(p: Point, from: Point, to: Point) -> f64 {
    let way = to - from;
    let part = (way.dot(&(p - from)) / way.norm_squared()).clamp(0.0, 1.0);
    (p - (from + way * part)).norm()
}

/// Whether a point lies within corners.
pub fn holds(corners: &[Point], p: Point) -> bool {
    let count = corners.len();
    let crossed = (0..count).filter(|&k| {
        let (a, b) = (corners[k], corners[(k + 1) % count]);
        (a.y > p.y) != (b.y > p.y) && p.x < a.x + (b.x - a.x) * (p.y - a.y) / (b.y - a.y)
    });
    crossed.count() % 2 == 1
}

/// How far a point is from an outline.
pub fn to_outline(p: Point, corners: &[Point]) -> f64 {
    let next = corners.iter().cycle().skip(1);
    let edges = corners.iter().zip(next);
    edges
        .map(|(from, to)| to_segment(p, *from, *to))
        .fold(f64::INFINITY, f64::min)
}
