//! Convex polygons: the shape of every block and support.

use nalgebra::{Point2, Vector2};

/// A point of the wall's plane, in the case's own length unit; x to the right, y up.
pub type Point = Point2<f64>;

/// A free vector of the plane: a force, a velocity, a direction.
pub type Vector = Vector2<f64>;

/// Why a list of corners is not a usable shape.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum PolygonError {
    /// Fewer than three corners.
    #[error("a polygon needs at least 3 corners, this one has {0}")]
    TooFewCorners(usize),
    /// A coordinate is NaN or infinite.
    #[error("corner {0} is not a finite point")]
    NotFinite(usize),
    /// A corner bends inwards or is straight, or the outline crosses itself.
    #[error("the outline is not strictly convex at corner {0}")]
    NotConvex(usize),
    /// The area vanishes against the square of the longest edge.
    #[error("the polygon is a sliver: area {area:e} for a longest edge of {edge:e}")]
    Sliver {
        /// Enclosed area.
        area: f64,
        /// Longest edge.
        edge: f64,
    },
}

/// A strictly convex polygon with its corners in counter-clockwise order.
#[derive(Clone, Debug, PartialEq)]
pub struct Polygon {
    corners: Vec<Point>,
    area: f64,
    centroid: Point,
}

impl Polygon {
    /// Takes the corners in either order round the outline.
    ///
    /// # Errors
    /// [`PolygonError`] names the first corner that makes the shape unusable (0-based).
    pub fn new(mut corners: Vec<Point>) -> Result<Self, PolygonError> {
        let count = corners.len();
        if count < 3 {
            return Err(PolygonError::TooFewCorners(count));
        }
        if let Some(i) = corners
            .iter()
            .position(|p| !(p.x.is_finite() && p.y.is_finite()))
        {
            return Err(PolygonError::NotFinite(i));
        }
        if signed_area(&corners) < 0.0 {
            corners.reverse();
        }
        let area = signed_area(&corners);
        let edge = longest_edge(&corners);
        if area <= 1e-9 * edge * edge {
            return Err(PolygonError::Sliver { area, edge });
        }
        let mut turn = 0.0;
        for i in 0..count {
            let before = corners[i] - corners[(i + count - 1) % count];
            let after = corners[(i + 1) % count] - corners[i];
            let bend = before.perp(&after);
            if bend <= 1e-9 * before.norm() * after.norm() {
                return Err(PolygonError::NotConvex(i));
            }
            turn += bend.atan2(before.dot(&after));
        }
        // A pentagram turns left everywhere, but twice round.
        if turn > 3.0 * std::f64::consts::PI {
            return Err(PolygonError::NotConvex(0));
        }
        let centroid = centroid(&corners, area);
        Ok(Self {
            corners,
            area,
            centroid,
        })
    }

    /// The rectangle `[x0, x1] × [y0, y1]`.
    ///
    /// # Errors
    /// As [`Polygon::new`].
    pub fn rectangle(x0: f64, x1: f64, y0: f64, y1: f64) -> Result<Self, PolygonError> {
        Self::new(vec![
            Point::new(x0, y0),
            Point::new(x1, y0),
            Point::new(x1, y1),
            Point::new(x0, y1),
        ])
    }

    /// Corners, counter-clockwise.
    pub fn corners(&self) -> &[Point] {
        &self.corners
    }

    /// Enclosed area, length unit squared.
    pub fn area(&self) -> f64 {
        self.area
    }

    /// Centre of the area.
    pub fn centroid(&self) -> Point {
        self.centroid
    }

    /// Edges as (from, to), counter-clockwise, so the outward normal is to the right of each.
    pub fn edges(&self) -> impl Iterator<Item = (Point, Point)> + '_ {
        let next = self.corners.iter().cycle().skip(1);
        self.corners.iter().copied().zip(next.copied())
    }

    /// Lower-left and upper-right corner of the bounding box.
    pub fn bounds(&self) -> (Point, Point) {
        let mut low = self.corners[0];
        let mut high = self.corners[0];
        for p in &self.corners {
            low = low.inf(p);
            high = high.sup(p);
        }
        (low, high)
    }
}

fn signed_area(corners: &[Point]) -> f64 {
    // Relative to the first corner: a wall far from the origin keeps its digits.
    let origin = corners[0];
    corners
        .windows(2)
        .map(|w| (w[0] - origin).perp(&(w[1] - origin)) / 2.0)
        .sum()
}

fn centroid(corners: &[Point], area: f64) -> Point {
    let origin = corners[0];
    let moment: Vector = corners
        .windows(2)
        .map(|w| {
            let (a, b) = (w[0] - origin, w[1] - origin);
            (a + b) * (a.perp(&b) / 6.0)
        })
        .sum();
    origin + moment / area
}

fn longest_edge(corners: &[Point]) -> f64 {
    let next = corners.iter().cycle().skip(1);
    corners
        .iter()
        .zip(next)
        .map(|(a, b)| (b - a).norm())
        .fold(0.0, f64::max)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_rectangle_far_away_keeps_area_and_centroid() {
        let r = Polygon::rectangle(1e6, 1e6 + 4.0, -1e6, -1e6 + 1.75).unwrap();
        assert!((r.area() - 7.0).abs() < 1e-8);
        assert!((r.centroid() - Point::new(1e6 + 2.0, -1e6 + 0.875)).norm() < 1e-8);
    }

    #[test]
    fn corners_may_come_clockwise() {
        let r = Polygon::new(vec![
            Point::new(0.0, 0.0),
            Point::new(0.0, 1.0),
            Point::new(1.0, 0.0),
        ])
        .unwrap();
        assert!(signed_area(r.corners()) > 0.0);
    }

    #[test]
    fn unusable_outlines_are_named() {
        let at =
            |v: &[(f64, f64)]| Polygon::new(v.iter().map(|&(x, y)| Point::new(x, y)).collect());
        assert_eq!(
            at(&[(0., 0.), (1., 0.)]),
            Err(PolygonError::TooFewCorners(2))
        );
        assert_eq!(
            at(&[(0., 0.), (1., f64::NAN), (0., 1.)]),
            Err(PolygonError::NotFinite(1))
        );
        assert_eq!(
            at(&[(0., 0.), (2., 0.), (2., 2.), (1., 0.5), (0., 2.)]),
            Err(PolygonError::NotConvex(3))
        );
        assert!(matches!(
            at(&[(0., 0.), (1., 0.), (2., 0.)]),
            Err(PolygonError::Sliver { .. })
        ));
    }
}
