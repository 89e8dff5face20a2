//! Joints: where an edge of one block lies on an edge of another, found from the geometry.

use super::polygon::{Point, Polygon, Vector};

/// What a joint rests against.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Side {
    /// A support, by its index in the scene.
    Support(usize),
    /// A block, by its index in the scene.
    Block(usize),
}

/// How a joint runs through the masonry.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum JointClass {
    /// Between a block and a support.
    Base,
    /// Nearer to horizontal, between two blocks.
    Bed,
    /// Nearer to vertical, between two blocks (a perpend).
    Head,
}

impl JointClass {
    /// The word in records.
    pub fn name(self) -> &'static str {
        match self {
            JointClass::Base => "base",
            JointClass::Bed => "bed",
            JointClass::Head => "head",
        }
    }
}

/// A segment that two bodies share.
#[derive(Clone, Debug, PartialEq)]
pub struct Joint {
    /// The body that the normal points away from.
    pub from: Side,
    /// The block that the normal points into.
    pub to: usize,
    /// The two ends; corner forces act here.
    pub ends: [Point; 2],
    /// Unit normal from `from` into `to`.
    pub normal: Vector,
    /// Coefficient of friction, tan φ.
    pub friction: f64,
    /// How it runs.
    pub class: JointClass,
}

impl Joint {
    /// Unit tangent: the normal turned clockwise, so (0, 1) gives (1, 0).
    pub fn tangent(&self) -> Vector {
        Vector::new(self.normal.y, -self.normal.x)
    }

    /// Distance between the ends.
    pub fn length(&self) -> f64 {
        (self.ends[1] - self.ends[0]).norm()
    }
}

/// Edges count as touching within this fraction of the smaller block's extent.
const TOUCHING: f64 = 1e-6;

/// Finds every joint among blocks and supports, ordered by (`from`, `to`), supports first.
///
/// Bodies are binned on a grid of the median block's size, so the work grows with the number of
/// blocks and not with its square. `friction` gives each joint its coefficient by class.
pub fn find_joints(
    shapes: &[&Polygon],
    supports: &[Polygon],
    friction: impl Fn(JointClass) -> f64,
) -> Vec<Joint> {
    let mut joints = Vec::new();
    for (one, other) in close_pairs(shapes, supports) {
        let to = shapes[other];
        let (from, from_shape) = match one.checked_sub(supports.len()) {
            None => (Side::Support(one), &supports[one]),
            Some(block) => (Side::Block(block), shapes[block]),
        };
        for (ends, normal) in shared_edges(from_shape, to) {
            let class = match from {
                Side::Support(_) => JointClass::Base,
                Side::Block(_) if normal.y.abs() >= normal.x.abs() => JointClass::Bed,
                Side::Block(_) => JointClass::Head,
            };
            let friction = friction(class);
            joints.push(Joint {
                from,
                to: other,
                ends,
                normal,
                friction,
                class,
            });
        }
    }
    joints
}

/// Pairs whose bounding boxes share a grid cell: (body, block) with the body first in the order
/// supports, blocks. Sorted and without repeats.
fn close_pairs(shapes: &[&Polygon], supports: &[Polygon]) -> Vec<(usize, usize)> {
    let mut extents: Vec<f64> = shapes.iter().map(|s| extent(s)).collect();
    extents.sort_by(f64::total_cmp);
    let Some(&cell) = extents.get(extents.len() / 2) else {
        return Vec::new();
    };
    let origin = shapes[0].bounds().0;
    let index = |p: Point, grow: f64| {
        let q = (p - origin + Vector::repeat(grow)) / cell;
        (q.x.floor() as i64, q.y.floor() as i64)
    };
    // Only blocks make cells; a support of any extent then looks its blocks up by their cells.
    let mut bins: Vec<((i64, i64), usize)> = Vec::new();
    for (i, shape) in shapes.iter().enumerate() {
        let (low, high) = shape.bounds();
        let margin = TOUCHING * cell;
        let ((x0, y0), (x1, y1)) = (index(low, -margin), index(high, margin));
        for x in x0..=x1 {
            bins.extend((y0..=y1).map(|y| ((x, y), i)));
        }
    }
    bins.sort_unstable();
    let mut pairs = Vec::new();
    for bin in bins.chunk_by(|a, b| a.0 == b.0) {
        for (k, &(_, i)) in bin.iter().enumerate() {
            pairs.extend(bin[k + 1..].iter().map(|&(_, j)| (supports.len() + i, j)));
        }
    }
    for (s, support) in supports.iter().enumerate() {
        let (low, high) = support.bounds();
        let reach = |i: &usize| {
            let (l, h) = shapes[*i].bounds();
            let margin = TOUCHING * cell;
            l.x <= high.x + margin
                && low.x <= h.x + margin
                && l.y <= high.y + margin
                && low.y <= h.y + margin
        };
        pairs.extend((0..shapes.len()).filter(reach).map(|i| (s, i)));
    }
    pairs.sort_unstable();
    pairs.dedup();
    pairs
}

fn extent(shape: &Polygon) -> f64 {
    let (low, high) = shape.bounds();
    (high - low).norm()
}

/// Segments where an edge of `from` lies against an edge of `to`, with the normal into `to`.
fn shared_edges(from: &Polygon, to: &Polygon) -> Vec<([Point; 2], Vector)> {
    let tolerance = TOUCHING * extent(from).min(extent(to));
    let mut found = Vec::new();
    for (a, b) in from.edges() {
        let along = (b - a).normalize();
        let normal = Vector::new(along.y, -along.x);
        let length = (b - a).norm();
        for (c, d) in to.edges() {
            let facing = (d - c).dot(&along) < 0.0;
            let level =
                (c - a).dot(&normal).abs() < tolerance && (d - a).dot(&normal).abs() < tolerance;
            if !(facing && level) {
                continue;
            }
            let low = (d - a).dot(&along).max(0.0);
            let high = (c - a).dot(&along).min(length);
            if high - low > tolerance {
                found.push(([a + along * low, a + along * high], normal));
            }
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    fn square(x: f64, y: f64) -> Polygon {
        Polygon::rectangle(x, x + 1.0, y, y + 1.0).unwrap()
    }

    #[test]
    fn corners_alone_are_no_joint() {
        let (a, b) = (square(0.0, 0.0), square(1.0, 1.0));
        assert!(find_joints(&[&a, &b], &[], |_| 0.5).is_empty());
    }

    #[test]
    fn normals_point_from_the_first_body_into_the_block() {
        let ground = Polygon::rectangle(-5.0, 5.0, -1.0, 0.0).unwrap();
        let (a, b, c) = (square(0.0, 0.0), square(1.0, 0.0), square(0.25, 1.0));
        let joints = find_joints(&[&a, &b, &c], &[ground], |_| 0.5);
        let classes: Vec<_> = joints.iter().map(|j| (j.from, j.to, j.class)).collect();
        use {JointClass::*, Side::*};
        assert_eq!(
            classes,
            [
                (Support(0), 0, Base),
                (Support(0), 1, Base),
                (Block(0), 1, Head),
                (Block(0), 2, Bed),
                (Block(1), 2, Bed)
            ]
        );
        assert_eq!(joints[2].normal, Vector::new(1.0, 0.0));
        assert_eq!(joints[3].normal, Vector::new(0.0, 1.0));
        assert!((joints[3].length() - 0.75).abs() < 1e-12);
        assert!((joints[4].length() - 0.25).abs() < 1e-12);
    }

    #[test]
    fn blocks_of_very_different_size_meet() {
        let long = Polygon::rectangle(0.0, 100.0, 0.0, 0.5).unwrap();
        let small: Vec<Polygon> = (0..50).map(|i| square(2.0 * f64::from(i), 0.5)).collect();
        let mut shapes: Vec<&Polygon> = small.iter().collect();
        shapes.push(&long);
        assert_eq!(find_joints(&shapes, &[], |_| 0.5).len(), 50);
    }
}
