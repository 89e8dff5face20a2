//! How a mechanism moves, in words: what moves first, each part by itself, and all of it.

use std::cmp::Reverse;

use super::mechanism::{JointRate, Mechanism, Motion};
use super::residual::live_power;
use super::rigid_parts::{RigidPart, parts};
use crate::number::{number, short};
use crate::scene::{Joint, JointClass, Point, Push, Scene, Side, Vector};

/// Blocks and joints that are named.
const NAMED: usize = 3;

/// Parts that are described one by one, and hinges that are named.
const DESCRIBED: usize = 3;
const HINGES: usize = 8;

/// Part of the fastest corner's velocity below which a joint neither opens nor slips.
const STILL: f64 = 0.02;

/// Part of the same below which the live load, or the support that it acts on, does not move: rates
/// over its motion would be noise.
const CARRIED: f64 = 1e-6;

/// Sizes of what moves beyond which a centre of rotation is so far away that nothing turns.
const FAR: f64 = 20.0;

enum RigidMotion {
    /// Without turning, along a velocity.
    Slides(Vector),
    /// About a point.
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

/// A scene and how it moves.
pub struct Moved<'a> {
    scene: &'a Scene,
    /// How it moves.
    pub mechanism: &'a Mechanism,
    /// Velocity of the fastest corner.
    pub fastest: f64,
    parts: Vec<RigidPart>,
    /// The part of every block.
    part_of: Vec<usize>,
}

impl<'a> Moved<'a> {
    /// Relative motion below `threshold` of the fastest is none.
    pub fn new(scene: &'a Scene, mechanism: &'a Mechanism, threshold: f64) -> Self {
        let parts = parts(scene, mechanism, threshold);
        let mut part_of = vec![0; scene.blocks().len()];
        for (index, part) in parts.iter().enumerate() {
            part.blocks.iter().for_each(|&block| part_of[block] = index);
        }
        Self {
            fastest: mechanism.fastest(scene),
            scene,
            mechanism,
            parts,
            part_of,
        }
    }

    /// Every block in exactly one part, largest area first.
    pub fn parts(&self) -> &[RigidPart] {
        &self.parts
    }

    /// The blocks that move fastest.
    pub fn first_blocks(&self) -> Vec<String> {
        let speeds = self.mechanism.speeds(self.scene).into_iter().enumerate();
        let blocks = speeds.filter(|&(block, _)| !self.scene.is_moving_support(block));
        let first = self.first(blocks);
        first
            .map(|(block, _)| self.scene.block_name(block))
            .collect()
    }

    /// The joints that open or slip fastest.
    pub fn first_joints(&self) -> Vec<String> {
        let rates = self.mechanism.joint_rates(self.scene).into_iter();
        let rates =
            rates.map(|JointRate { opening, slip }| opening[0].max(opening[1]).max(slip.abs()));
        let first = self.first(rates.enumerate());
        first.map(|(joint, _)| self.joint_name(joint)).collect()
    }

    /// The joints that open most, each with its opening over the motion of the live load: where a support
    /// moves, over the support's motion.
    pub fn cracks(&self) -> Vec<(String, f64)> {
        let motion = live_power(self.scene, self.mechanism);
        let rates = self.mechanism.joint_rates(self.scene).into_iter();
        let openings = rates.map(|rate| rate.opening[0].max(rate.opening[1]));
        let first = self.first(openings.enumerate());
        let first = first.filter(|_| motion > CARRIED * self.fastest);
        first
            .map(|(joint, opening)| (self.joint_name(joint), opening / motion))
            .collect()
    }

    /// The first of these by their rates. What is equal to a thousandth keeps its order.
    fn first(
        &self,
        rates: impl Iterator<Item = (usize, f64)>,
    ) -> impl Iterator<Item = (usize, f64)> {
        let moving = rates.filter(|(_, rate)| *rate > STILL * self.fastest);
        let mut order: Vec<(usize, f64)> = moving.collect();
        order.sort_by_key(|(_, rate)| Reverse((1e3 * rate / self.fastest).round() as i64));
        order.into_iter().take(NAMED)
    }

    fn joint_name(&self, joint: usize) -> String {
        let joint = &self.scene.joints()[joint];
        let to = self.scene.block_name(joint.to);
        match joint.from {
            Side::Support(_) => format!("{to} on its support"),
            Side::Block(from) => format!("{} | {to}", self.scene.block_name(from)),
        }
    }

    /// The mechanism in words; `None` where nothing moves.
    pub fn words(&self) -> Option<String> {
        let moving: Vec<usize> = (0..self.parts.len())
            .filter(|&part| self.parts[part].moves && self.count(part) > 0)
            .collect();
        if self.fastest <= 0.0 {
            return None;
        }
        if moving.is_empty() {
            return self.scene.reaction().map(|_| "no block moves".to_owned());
        }
        let blocks: usize = moving.iter().map(|&part| self.count(part)).sum();
        let all: usize = (0..self.parts.len()).map(|part| self.count(part)).sum();
        let who = match (blocks, all) {
            (1, 1) => "the block".to_owned(),
            (blocks, all) if blocks == all => format!("all {all} blocks"),
            (blocks, all) => format!("{blocks} of {all} blocks"),
        };
        if let [part] = moving[..] {
            return Some(format!("{who} {}", self.part_words(part)));
        }
        let mut text = format!("{who} move in {} parts: ", moving.len());
        match self.hinges() {
            Some(hinges) => {
                let names = hinges.iter().map(|&joint| self.joint_name(joint));
                let names: Vec<String> = names.collect();
                text.push_str(&format!(
                    "they turn about {} hinges ({})",
                    hinges.len(),
                    names.join(", ")
                ));
            }
            None => {
                let described = moving.iter().take(DESCRIBED).map(|&part| {
                    let count = self.count(part);
                    let plural = if count == 1 { "block" } else { "blocks" };
                    format!("{count} {plural} {}", self.part_words(part))
                });
                text.push_str(&described.collect::<Vec<_>>().join(", "));
                if moving.len() > DESCRIBED {
                    text.push_str(", …");
                }
            }
        }
        Some(text)
    }

    /// How a part moves by itself, in figures.
    pub fn in_figures(&self, part: &RigidPart) -> String {
        let count = match part.blocks.len() {
            1 => "1 block".to_owned(),
            count => format!("{count} blocks as one body"),
        };
        if !part.moves {
            return format!("{count}: stands still");
        }
        let first = part.blocks[0];
        let motion = self.mechanism.motions[first];
        let (low, high) = self.scene.bounds();
        let centroid = self.scene.blocks()[first].shape.centroid();
        let speed = motion.velocity.norm();
        match RigidMotion::of(motion, centroid, (high - low).norm(), speed) {
            RigidMotion::Slides(velocity) => {
                let degrees = number(velocity.y.atan2(velocity.x).to_degrees(), 0);
                format!("{count}: slides without turning, towards {degrees}°")
            }
            RigidMotion::Turns(centre) => {
                let direction = match motion.rotation > 0.0 {
                    true => "counter-clockwise",
                    false => "clockwise",
                };
                let (x, y) = (short(centre.x, 2), short(centre.y, 2));
                format!("{count}: turns {direction} about ({x}, {y})")
            }
        }
    }

    /// The blocks of a part; a support that moves is none.
    fn count(&self, part: usize) -> usize {
        let blocks = self.parts[part].blocks.iter();
        blocks
            .filter(|&&block| !self.scene.is_moving_support(block))
            .count()
    }

    /// What a part does, and on what.
    fn part_words(&self, part: usize) -> String {
        let first = self.parts[part].blocks[0];
        let s = if self.count(part) == 1 { "s" } else { "" };
        let motion = self.mechanism.motions[first];
        let (low, high) = self.bounds(part);
        let blocks = self.parts[part].blocks.iter();
        let speeds = blocks.map(|&block| self.mechanism.speed(self.scene, block, None));
        let speed = speeds.fold(0.0, f64::max);
        let centroid = self.scene.blocks()[first].shape.centroid();
        let centre = match RigidMotion::of(motion, centroid, (high - low).norm(), speed) {
            RigidMotion::Turns(centre) => centre,
            RigidMotion::Slides(velocity) => {
                return match self.slips_on(part) {
                    Some(on) => format!("slide{s} {} {on}", way(velocity)),
                    None => format!("move{s} {}", way(velocity)),
                };
            }
        };
        let at = format!("({}, {})", short(centre.x, 3), short(centre.y, 3));
        match self.bears_at(part, centre) {
            Some(joint) => {
                let toe = match self.scene.push() {
                    Push::Right => motion.rotation < 0.0 && centre.x > (low.x + high.x) / 2.0,
                    Push::Left => motion.rotation > 0.0 && centre.x < (low.x + high.x) / 2.0,
                };
                let toe = toe && centre.y <= low.y + 0.02 * (high.y - low.y);
                let about = if toe { "the toe" } else { "the edge" };
                format!("rock{s} about {about} at {at}, {}", self.on(joint))
            }
            None => format!("turn{s} about {at}"),
        }
    }

    fn bounds(&self, part: usize) -> (Point, Point) {
        let shapes = self.parts[part].blocks.iter();
        let mut boxes = shapes.map(|&block| self.scene.blocks()[block].shape.bounds());
        let first = boxes.next().expect("a part has blocks");
        boxes.fold(first, |(low, high), (l, h)| (low.inf(&l), high.sup(&h)))
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

    /// The joints at which parts turn against each other, where nothing slips and they are few.
    fn hinges(&self) -> Option<Vec<usize>> {
        let rates = self.mechanism.joint_rates(self.scene).into_iter();
        let limit = STILL * self.fastest;
        let mut hinges = Vec::new();
        for (joint, JointRate { opening, slip }) in rates.enumerate() {
            if self.scene.joints()[joint].class == JointClass::Guide {
                continue;
            }
            if slip.abs() > limit || opening[0].min(opening[1]) > limit {
                return None;
            }
            if opening[0].max(opening[1]) > limit {
                hinges.push(joint);
            }
        }
        (1..=HINGES).contains(&hinges.len()).then_some(hinges)
    }
}

fn way(velocity: Vector) -> &'static str {
    match (
        velocity.x.abs() >= velocity.y.abs(),
        velocity.x > 0.0,
        velocity.y > 0.0,
    ) {
        (true, true, _) => "to the right",
        (true, false, _) => "to the left",
        (false, _, true) => "upwards",
        (false, _, false) => "downwards",
    }
}
