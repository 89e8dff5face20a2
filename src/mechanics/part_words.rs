//! What one part of a mechanism does, in words, and on what.

use super::mechanism::Motion;
use super::moved::{Moved, STILL};
use crate::number::short;
use crate::scene::{Joint, JointClass, Point, Push, Side, Vector, bounds_of};

/// Sizes of what moves beyond which a centre of rotation is so far away that nothing turns.
const FAR: f64 = 20.0;

/// How a part moves.
pub(super) enum RigidMotion {
    /// Without turning, along a velocity.
    Slides(Vector),
    Turns(Point),
}

impl RigidMotion {
    /// Of a body of this size, at the speed of its fastest point.
    fn of(motion: Motion, centroid: Point, size: f64, speed: f64) -> Self {
        let Motion { velocity, rotation } = motion;
        if rotation.abs() * size * FAR < speed {
            return RigidMotion::Slides(velocity);
        }
        RigidMotion::Turns(centroid + Vector::new(-velocity.y, velocity.x) / rotation)
    }
}

impl<'a> Moved<'a> {
    pub(super) fn motion(&self, part: usize) -> RigidMotion {
        let first = self.parts[part].blocks[0];
        let blocks = self.parts[part].blocks.iter();
        let speeds = blocks.map(|&block| self.mechanism.speed(self.scene, block, None));
        let (low, high) = self.bounds(part);
        RigidMotion::of(
            self.mechanism.motions[first],
            self.scene.blocks()[first].shape.centroid(),
            (high - low).norm(),
            speeds.fold(0.0, f64::max),
        )
    }

    /// What a part does, and on what; `s` ends its verb.
    pub(super) fn part_words(&self, part: usize, s: &str) -> String {
        let (low, high) = self.bounds(part);
        let centre = match self.motion(part) {
            RigidMotion::Turns(centre) => centre,
            RigidMotion::Slides(velocity) => {
                return match self.slips_on(part).filter(|_| is_level(velocity)) {
                    Some(on) => format!("slide{s} {} {on}", way(velocity)),
                    None => format!("move{s} {}", way(velocity)),
                };
            }
        };
        let rotation = self.mechanism.motions[self.parts[part].blocks[0]].rotation;
        let at = format!("({}, {})", short(centre.x, 3), short(centre.y, 3));
        match self.bears_at(part, centre) {
            Some(joint) => {
                let toe = match self.scene.push() {
                    Push::Right => rotation < 0.0 && centre.x > (low.x + high.x) / 2.0,
                    Push::Left => rotation > 0.0 && centre.x < (low.x + high.x) / 2.0,
                };
                let toe = toe && centre.y <= low.y + 0.02 * (high.y - low.y);
                let about = if toe { "the toe" } else { "the edge" };
                format!("rock{s} about {about} at {at}, {}", self.on(joint))
            }
            None => format!("turn{s} about {at}"),
        }
    }

    fn bounds(&self, part: usize) -> (Point, Point) {
        let blocks = self.parts[part].blocks.iter();
        bounds_of(blocks.map(|&block| &self.scene.blocks()[block].shape))
    }

    /// Joints of a part with other bodies.
    fn rim(&self, part: usize) -> impl Iterator<Item = (usize, &'a Joint)> + '_ {
        let joints = self.scene.joints().iter().enumerate();
        joints.filter(move |(_, joint)| {
            let from = joint.from.block().map(|from| self.part_of[from]);
            let to = self.part_of[joint.to];
            joint.class != JointClass::Guide && (to == part) != (from == Some(part))
        })
    }

    /// What a part slips on: the level joint below it that slips.
    fn slips_on(&self, part: usize) -> Option<String> {
        let rates = self.mechanism.joint_rates(self.scene);
        let slips = |(index, joint): &(usize, &Joint)| {
            joint.class != JointClass::Head && rates[*index].slip.abs() > STILL * self.fastest
        };
        let slipping = self.rim(part).filter(slips).map(|(_, joint)| joint);
        let lowest = slipping.min_by(|a, b| a.ends[0].y.total_cmp(&b.ends[0].y))?;
        Some(self.on(lowest))
    }

    /// The joint at whose end a part turns.
    fn bears_at(&self, part: usize, centre: Point) -> Option<&'a Joint> {
        let near = STILL * self.scene.height();
        // A plumb joint bears nothing.
        let at_end = |joint: &&Joint| {
            let bears = joint.class != JointClass::Head;
            bears && joint.ends.iter().any(|end| (end - centre).norm() <= near)
        };
        self.rim(part).map(|(_, joint)| joint).find(at_end)
    }

    /// What lies under a joint, or beside it.
    fn on(&self, joint: &Joint) -> String {
        let course = self.scene.coursing().map(|coursing| {
            let (low, _) = self.scene.bounds();
            coursing.courses_up_to(joint.ends[0].y - low.y)
        });
        match (joint.from, course) {
            (Side::Support(_), _) => "on the base".to_owned(),
            (_, Some(course)) if joint.class == JointClass::Bed => format!("on course {course}"),
            (Side::Block(from), _) => {
                let lower = if joint.normal.y < 0.0 { joint.to } else { from };
                format!("on {}", self.scene.block_name(lower))
            }
        }
    }
}

fn is_level(velocity: Vector) -> bool {
    velocity.x.abs() >= velocity.y.abs()
}

fn way(velocity: Vector) -> &'static str {
    match (is_level(velocity), velocity.x > 0.0, velocity.y > 0.0) {
        (true, true, _) => "to the right",
        (true, false, _) => "to the left",
        (false, _, true) => "upwards",
        (false, _, false) => "downwards",
    }
}
