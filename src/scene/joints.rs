//! Joints: where an edge of one block lies on an edge of another, found from the geometry.

use super::close_pairs::{close_pairs, extent};
use super::polygon::{Point, Polygon, Vector};

/// What a joint rests against.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Side {
    /// A support, by its index in the scene.
    Support(usize),
    /// A block, by its index in the scene.
    Block(usize),
}

impl Side {
    /// The block, where it is one.
    pub fn block(self) -> Option<usize> {
        match self {
            Side::Block(block) => Some(block),
            Side::Support(_) => None,
        }
    }
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
    /// Without friction, between a support that moves and what guides it.
    Guide,
}

impl JointClass {
    /// Every class that has friction.
    pub const ALL: [JointClass; 3] = [JointClass::Base, JointClass::Bed, JointClass::Head];

    /// The word in records.
    pub fn name(self) -> &'static str {
        match self {
            JointClass::Base => "base",
            JointClass::Bed => "bed",
            JointClass::Head => "head",
            JointClass::Guide => "guide",
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

    /// What it lies between: supports come before blocks, and blocks in their order.
    pub(crate) fn bodies(&self) -> [Side; 2] {
        [self.from, Side::Block(self.to)]
    }

    /// Distance between the ends.
    pub fn length(&self) -> f64 {
        (self.ends[1] - self.ends[0]).norm()
    }

    /// Its blocks, `to` first, each with the sign of what the joint's forces are on it.
    pub fn blocks(&self) -> impl Iterator<Item = (usize, f64)> {
        let from = self.from.block().map(|from| (from, -1.0));
        [(self.to, 1.0)].into_iter().chain(from)
    }
}

/// What a case says itself of the joint between two bodies; of all, where they share several.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NamedJoint {
    /// The two bodies, in any order.
    pub between: [Side; 2],
    /// Bed or head joint, whichever way it runs.
    pub class: Option<JointClass>,
    /// Coefficient of friction, instead of that of its class and of its blocks.
    pub friction: Option<f64>,
    /// Whether it carries nothing, if it is a head joint.
    pub open: bool,
}

impl NamedJoint {
    /// Its bodies in the order of [`Joint::bodies`].
    pub(crate) fn bodies(&self) -> [Side; 2] {
        let [a, b] = self.between;
        [a.min(b), a.max(b)]
    }
}

/// Edges count as touching within this fraction of the smaller body's extent, unless a case says
/// otherwise.
pub const TOUCHING: f64 = 1e-6;

/// Finds every joint among blocks and supports, ordered by (`from`, `to`), supports first: where
/// edges touch within `tolerance` times the smaller body's extent. Friction is left at 0.
pub(super) fn find_joints(tolerance: f64, shapes: &[&Polygon], supports: &[Polygon]) -> Vec<Joint> {
    let mut joints = Vec::new();
    for (one, other) in close_pairs(tolerance, shapes, supports) {
        let to = shapes[other];
        let (from, from_shape) = match one.checked_sub(supports.len()) {
            None => (Side::Support(one), &supports[one]),
            Some(block) => (Side::Block(block), shapes[block]),
        };
        for (ends, normal) in shared_edges(from_shape, to, tolerance) {
            let class = match from {
                Side::Support(_) => JointClass::Base,
                Side::Block(_) if normal.y.abs() >= normal.x.abs() => JointClass::Bed,
                Side::Block(_) => JointClass::Head,
            };
            joints.push(Joint {
                from,
                to: other,
                ends,
                normal,
                friction: 0.0,
                class,
            });
        }
    }
    joints
}

/// Component along y of a unit normal from which on a steep joint is inclined and not plumb.
const INCLINED: f64 = 1e-3;

/// The one rule for bed and head joints: between two blocks, a joint nearer to horizontal is a bed joint
/// and one nearer to vertical a head joint, but for those of voussoirs. These carry the arch's thrust,
/// however steep: they are called bed joints, as those of a radial arch, or open head joints would empty
/// an arch at its crown. A voussoir rests on nothing but steep joints, one of them inclined; the plumb
/// joint between two of them, in the crown, is theirs too. In walls of level courses none is. A stone
/// that hangs between inclined sides in rubble is one too: 64 of 500 random piles
/// (`tests/reference/scenes.py`, seed 31) have one, and were its joints open head joints, 18 of them would
/// fall unpushed and 46 have the same λ_A. A case may name its joints itself ([`NamedJoint`]), and
/// `trilith show` says which are which.
pub(super) fn call_voussoir_joints_beds(joints: &mut [Joint], blocks: usize) {
    let (mut rests, mut wedged) = (vec![false; blocks], vec![false; blocks]);
    for joint in joints.iter() {
        let ends = [
            (Some(joint.to), joint.normal.y),
            (joint.from.block(), -joint.normal.y),
        ];
        for (of, upward) in ends {
            let Some(of) = of else { continue };
            match joint.class {
                JointClass::Base | JointClass::Bed => rests[of] |= upward > INCLINED,
                JointClass::Head => wedged[of] |= upward.abs() > INCLINED,
                JointClass::Guide => {}
            }
        }
    }
    let is_voussoir = |of: Option<usize>| of.is_some_and(|of| wedged[of] && !rests[of]);
    for joint in joints.iter_mut().filter(|j| j.class == JointClass::Head) {
        let of = [Some(joint.to), joint.from.block()].map(is_voussoir);
        let inclined = joint.normal.y.abs() > INCLINED;
        if of[0] && of[1] || inclined && (of[0] || of[1]) {
            joint.class = JointClass::Bed;
        }
    }
}

/// Segments where an edge of `from` lies against an edge of `to`, with the normal into `to`.
pub(super) fn shared_edges(
    from: &Polygon,
    to: &Polygon,
    tolerance: f64,
) -> Vec<([Point; 2], Vector)> {
    let tolerance = tolerance * extent(from).min(extent(to));
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
        assert!(find_joints(1e-6, &[&a, &b], &[]).is_empty());
    }

    #[test]
    fn normals_point_from_the_first_body_into_the_block() {
        let ground = Polygon::rectangle(-5.0, 5.0, -1.0, 0.0).unwrap();
        let (a, b, c) = (square(0.0, 0.0), square(1.0, 0.0), square(0.25, 1.0));
        let joints = find_joints(1e-6, &[&a, &b, &c], &[ground]);
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
        assert_eq!(find_joints(1e-6, &shapes, &[]).len(), 50);
    }
}
