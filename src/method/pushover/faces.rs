//! Contacts where the scene has joints, and nowhere else: behind every joint a thin rectangle on
//! either of its bodies, and only these two ever meet.
//!
//! Limit analysis knows joints only. Whole shapes would also meet where nothing carries: open head
//! joints, inner sides of stones that are not convex, corners that come close.

use super::apart::{Groups, groups};
use super::portion::Portion;
use crate::answer::PushoverFact;
use crate::scene::{Joint, Point, Polygon, Scene, Side, Vector, bounds};

/// Course heights by which a face goes on beyond its joint where its body's side does, and by which
/// joints that may meet no face of each other are apart: as far as any point moves until a recorded
/// fall ends.
pub const REACH: f64 = 1.0;

/// Depth of a face in course heights. It only has to be larger than what contacts give.
pub const DEPTH: f64 = 0.25;

/// A rectangle behind a joint, on one of its bodies; lengths in course heights.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Face {
    /// The joint's place in the scene.
    pub joint: usize,
    /// The body that carries it.
    pub body: Side,
    /// Whether that is the block that the joint's normal points into.
    pub is_second: bool,
    /// Its middle.
    pub centre: [f64; 2],
    /// Unit vector along the joint.
    pub along: [f64; 2],
    /// Half its length along the joint.
    pub half: f64,
    /// Coefficient of friction.
    pub friction: f64,
    /// What it collides with.
    pub groups: Groups,
}

/// The faces of all joints of a portion that are not between two fixed bodies; points are relative to
/// an origin, lengths divided by a course height.
///
/// # Errors
/// Too many joints lie close together to be told apart.
pub fn faces(
    scene: &Scene,
    portion: &Portion,
    (origin, length): (Point, f64),
) -> Result<Vec<Face>, PushoverFact> {
    let carries = |(_, joint): &(usize, &Joint)| {
        // A pin holds its block by itself.
        joint.length() > 0.0
            && !(portion.is_absent(joint.to)
                || portion.is_fixed(joint.from) && portion.is_fixed(Side::Block(joint.to)))
    };
    let joints = scene.joints().iter().enumerate().filter(carries);
    let both = |(index, joint): (usize, &Joint)| {
        let on = |body| face(scene, (index, joint), body, (origin, length));
        [joint.from, Side::Block(joint.to)].map(on)
    };
    let mut pairs: Vec<[Face; 2]> = joints.map(both).collect();
    let boxes: Vec<(Point, Point)> = pairs.iter().map(about).collect();
    for (pair, groups) in pairs.iter_mut().zip(groups(&boxes, REACH)?) {
        [pair[0].groups, pair[1].groups] = groups;
    }
    Ok(pairs.concat())
}

/// The face of a joint on one of its bodies, without groups: behind the joint, and along the body's side as
/// far as that goes on, so that a block that slides keeps what it rests on, and loses it at the corner.
fn face(
    scene: &Scene,
    (index, joint): (usize, &Joint),
    body: Side,
    (origin, length): (Point, f64),
) -> Face {
    let is_second = body == Side::Block(joint.to);
    let shape = match body {
        Side::Block(block) => &scene.blocks()[block].shape,
        Side::Support(support) => &scene.supports()[support],
    };
    let along = (joint.ends[1] - joint.ends[0]).normalize();
    let (from, to) = side(shape, joint);
    let at = |point: Point| (point - joint.ends[0]).dot(&along);
    let reach = REACH * length;
    let low = at(from).min(at(to)).clamp(-reach, 0.0);
    let high = at(from).max(at(to));
    let high = high.clamp(joint.length(), joint.length() + reach);
    let behind = if is_second {
        joint.normal
    } else {
        -joint.normal
    };
    let middle = joint.ends[0] + along * low.midpoint(high) + behind * (DEPTH / 2.0 * length);
    Face {
        joint: index,
        body,
        is_second,
        centre: Point::from((middle - origin) / length).into(),
        along: along.into(),
        half: (high - low) / 2.0 / length,
        friction: joint.friction,
        groups: Groups::default(),
    }
}

/// The side of a shape that a joint lies on: the one from which its ends are least far.
fn side(shape: &Polygon, joint: &Joint) -> (Point, Point) {
    let off = |(from, to): &(Point, Point)| {
        let distance = |point: Point| {
            let along = to - from;
            let part = ((point - from).dot(&along) / along.norm_squared()).clamp(0.0, 1.0);
            (from + along * part - point).norm()
        };
        distance(joint.ends[0]) + distance(joint.ends[1])
    };
    let nearest = shape.edges().min_by(|a, b| off(a).total_cmp(&off(b)));
    nearest.unwrap_or((joint.ends[0], joint.ends[1]))
}

/// The box about both faces of a joint.
fn about(pair: &[Face; 2]) -> (Point, Point) {
    let corners = pair.iter().flat_map(|face| {
        let half = Vector::from(face.along) * face.half;
        let deep = Vector::new(-half.y, half.x).normalize() * (DEPTH / 2.0);
        [half + deep, half - deep, deep - half, -half - deep]
            .map(|to| Point::from(face.centre) + to)
    });
    bounds(&corners.collect::<Vec<Point>>())
}

#[cfg(test)]
mod tests {
    use super::super::model::Model;
    use super::super::parameters::{Asked, Parameters};
    use super::super::physics::{BodyState, Physics};
    use super::*;
    use crate::method::PushoverSettings;
    use crate::scene::{Block, Load, SceneParts};

    fn rectangle(x: [f64; 2], y: [f64; 2]) -> Polygon {
        Polygon::rectangle(x[0], x[1], y[0], y[1]).unwrap()
    }

    /// A block of 1 × 1 that is pushed over a support by more than its friction, until its middle has
    /// moved by so much.
    fn slid(support: [f64; 2], friction: f64, by: f64) -> BodyState {
        let shape = rectangle([0.0, 1.0], [0.0, 1.0]);
        let load = Load {
            point: shape.centroid(),
            dead: Vector::new(0.0, -1.0),
            live: Vector::new(1.0, 0.0),
        };
        let loads = vec![load];
        let parts = SceneParts::new(
            vec![Block { shape, loads }],
            vec![rectangle(support, [-1.0, 0.0])],
            friction,
        );
        let scene = Scene::new(parts).unwrap();
        let settings = PushoverSettings::default();
        let asked = Asked::new(&settings);
        let whole = Portion::default();
        let model = Model::new(&scene, &whole, &asked.tuned).unwrap();
        let mut physics = Physics::new(&model, &Parameters::new(&model, &asked));
        physics.multiplier = friction + 0.02;
        let from = physics.states()[0].position[0];
        while physics.states()[0].position[0] < from + by {
            physics.step();
            assert!(physics.steps < 20_000);
        }
        physics.states()[0]
    }

    /// A block that slides along a longer side keeps what it rests on, as far as blocks are followed.
    #[test]
    fn a_block_keeps_what_it_rests_on_where_its_neighbour_goes_on() {
        let at = slid([-1.0, 3.0], 0.1, 0.9);
        assert!(
            (at.position[1] - 0.5).abs() < 1e-3 && at.rotation.abs() < 1e-3,
            "{at:?}"
        );
    }

    /// Beyond a corner nothing carries: the block tips over it with its middle past it by the part of
    /// its height that the push moves its resultant, and not before.
    #[test]
    fn a_block_that_slides_off_its_neighbour_tips() {
        let before = slid([-1.0, 1.0], 0.1, 0.3);
        assert!(before.rotation.abs() < 1e-3, "{before:?}");
        let after = slid([-1.0, 1.0], 0.1, 0.6);
        assert!(after.rotation < -0.02, "{after:?}");
    }
}
