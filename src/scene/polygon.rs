//! Simple polygons: the shape of every block and support.

use nalgebra::{Point2, Vector2};

use super::simple::{STRAIGHT, convex_pieces, crossing, sine};

/// A point of the wall's plane, in the case's own length unit; x to the right, y up.
pub type Point = Point2<f64>;

/// A free vector of the plane: a force, a velocity, a direction.
pub type Vector = Vector2<f64>;

/// Why a list of corners is not a usable shape.
#[allow(missing_docs, reason = "the sentence of each says it")]
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum PolygonError {
    #[error("a polygon needs at least 3 corners, this one has {0}")]
    TooFewCorners(usize),
    #[error("corner {0} is not a finite point")]
    NotFinite(usize),
    /// The outline crosses or touches itself, or comes straight back, in the edge behind a corner.
    #[error("the outline crosses itself behind corner {0}")]
    NotSimple(usize),
    /// The area vanishes against the square of the longest edge.
    #[error("the polygon is a sliver: area {area:e} for a longest edge of {edge:e}")]
    Sliver { area: f64, edge: f64 },
}

/// A polygon that does not cross itself, convex or not, with its corners in counter-clockwise order
/// and none of them on a straight edge.
#[derive(Clone, Debug, PartialEq)]
pub struct Polygon {
    corners: Vec<Point>,
    area: f64,
    centroid: Point,
}

impl Polygon {
    /// Takes the corners in either order round the outline. Corners on a straight edge are left out.
    ///
    /// # Errors
    /// [`PolygonError`] names the first corner that makes the shape unusable (0-based).
    pub fn new(mut corners: Vec<Point>) -> Result<Self, PolygonError> {
        let count = corners.len();
        if count < 3 {
            return Err(PolygonError::TooFewCorners(count));
        }
        let not_finite = |p: &Point| !(p.x.is_finite() && p.y.is_finite());
        if let Some(i) = corners.iter().position(not_finite) {
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
        if let Some(corner) = back(&corners).or_else(|| crossing_of(&corners)) {
            return Err(PolygonError::NotSimple(corner));
        }
        let corners = without_straight(corners);
        // Area and centroid of what is left: the same but for rounding.
        let area = signed_area(&corners);
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

    /// Whether no corner bends inwards.
    pub fn is_convex(&self) -> bool {
        (0..self.corners.len()).all(|i| bend(&self.corners, i) > 0.0)
    }

    /// Convex pieces that fill it, as places in [`corners`](Self::corners), counter-clockwise; one
    /// piece where it is convex.
    pub fn convex_pieces(&self) -> Vec<Vec<usize>> {
        if self.is_convex() {
            vec![(0..self.corners.len()).collect()]
        } else {
            convex_pieces(&self.corners)
        }
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
        // By place: with `cycle` the joint search took 4.8 % more instructions.
        let corners = &self.corners;
        let next = move |i: usize| corners.get(i + 1).unwrap_or(&corners[0]);
        (corners.iter().enumerate()).map(move |(i, corner)| (*corner, *next(i)))
    }

    /// Lower-left and upper-right corner of the bounding box.
    pub fn bounds(&self) -> (Point, Point) {
        bounds(&self.corners)
    }
}

/// Lower-left and upper-right corner of the box about points, of which there is one at least.
pub(crate) fn bounds(points: &[Point]) -> (Point, Point) {
    let first = (points[0], points[0]);
    let grown = points.iter();
    grown.fold(first, |(low, high), p| (low.inf(p), high.sup(p)))
}

/// Lower-left and upper-right corner of shapes; the origin where there are none.
pub(crate) fn bounds_of<'a>(shapes: impl Iterator<Item = &'a Polygon>) -> (Point, Point) {
    let mut boxes = shapes.map(Polygon::bounds);
    let first = boxes.next().unwrap_or((Point::origin(), Point::origin()));
    boxes.fold(first, |(low, high), (l, h)| (low.inf(&l), high.sup(&h)))
}

/// The edges before and behind a corner.
fn edges_at(corners: &[Point], i: usize) -> (Vector, Vector) {
    let count = corners.len();
    let before = corners[i] - corners[(i + count - 1) % count];
    (before, corners[(i + 1) % count] - corners[i])
}

/// Sine of the angle at a corner, positive to the left.
fn bend(corners: &[Point], i: usize) -> f64 {
    let (before, behind) = edges_at(corners, i);
    sine(before, behind)
}

/// The first corner at which an outline comes straight back.
fn back(corners: &[Point]) -> Option<usize> {
    (0..corners.len()).find(|&i| {
        let (before, behind) = edges_at(corners, i);
        // Not a number where a corner is written twice.
        let goes_on = sine(before, behind).abs() > STRAIGHT || before.dot(&behind) > 0.0;
        !goes_on
    })
}

/// As [`crossing`]. An outline that turns to the left everywhere, and once round, needs no search.
fn crossing_of(corners: &[Point]) -> Option<usize> {
    let mut turn = 0.0;
    let convex = (0..corners.len()).all(|i| {
        let (before, behind) = edges_at(corners, i);
        turn += before.perp(&behind).atan2(before.dot(&behind));
        sine(before, behind) > STRAIGHT
    });
    // A pentagram turns left everywhere, but twice round.
    if convex && turn < 3.0 * std::f64::consts::PI {
        None
    } else {
        crossing(corners)
    }
}

/// The corners without those on a straight edge.
fn without_straight(corners: Vec<Point>) -> Vec<Point> {
    let bends = |i: usize| bend(&corners, i).abs() > STRAIGHT;
    if (0..corners.len()).all(bends) {
        return corners;
    }
    let kept = (0..corners.len()).filter(|&i| bends(i));
    kept.map(|i| corners[i]).collect()
}

/// Enclosed area of corners in order, negative where they run clockwise.
pub(crate) fn signed_area(corners: &[Point]) -> f64 {
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

    fn at(corners: &[(f64, f64)]) -> Result<Polygon, PolygonError> {
        Polygon::new(corners.iter().map(|&(x, y)| Point::new(x, y)).collect())
    }

    #[test]
    fn a_rectangle_far_away_keeps_area_and_centroid() {
        let r = Polygon::rectangle(1e6, 1e6 + 4.0, -1e6, -1e6 + 1.75).unwrap();
        assert!((r.area() - 7.0).abs() < 1e-8);
        assert!((r.centroid() - Point::new(1e6 + 2.0, -1e6 + 0.875)).norm() < 1e-8);
    }

    #[test]
    fn corners_may_come_clockwise() {
        let r = at(&[(0., 0.), (0., 1.), (1., 0.)]).unwrap();
        assert!(signed_area(r.corners()) > 0.0);
    }

    #[test]
    fn outlines_may_bend_inwards_and_corners_on_straight_edges_are_left_out() {
        let l = at(&[
            (0., 0.),
            (1., 0.),
            (2., 0.),
            (2., 1.),
            (1., 1.),
            (1., 3.),
            (0., 3.),
        ]);
        let l = l.unwrap();
        assert_eq!((l.corners().len(), l.is_convex()), (6, false));
        assert!((l.area() - 4.0).abs() < 1e-12);
        // Of two rectangles, 2 × 1 at (1, 0.5) and 1 × 2 at (0.5, 2).
        assert!((l.centroid() - Point::new(0.75, 1.25)).norm() < 1e-12);
        assert_eq!(l.convex_pieces().len(), 2);
        let square = at(&[(0., 0.), (1., 0.), (1., 0.5), (1., 1.), (0., 1.)]).unwrap();
        assert_eq!(square, Polygon::rectangle(0., 1., 0., 1.).unwrap());
    }

    #[test]
    fn unusable_outlines_are_named() {
        assert_eq!(
            at(&[(0., 0.), (1., 0.)]),
            Err(PolygonError::TooFewCorners(2))
        );
        assert_eq!(
            at(&[(0., 0.), (1., f64::NAN), (0., 1.)]),
            Err(PolygonError::NotFinite(1))
        );
        assert_eq!(
            at(&[(0., 0.), (2., 2.), (2., 0.), (0., 3.)]),
            Err(PolygonError::NotSimple(0))
        );
        // A pentagram turns the same way everywhere.
        let tip = |k: f64| (2.0 * std::f64::consts::TAU / 5.0 * k).sin_cos();
        let star: Vec<_> = (0..5).map(|k| tip(f64::from(k))).collect();
        assert!(matches!(at(&star), Err(PolygonError::NotSimple(_))));
        assert!(matches!(
            at(&[(0., 0.), (1., 0.), (2., 0.)]),
            Err(PolygonError::Sliver { .. })
        ));
    }
}
