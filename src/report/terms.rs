//! Answers in the terms of those who judge a wall: how far it could be tilted, its base shear, what
//! moves first, and the mechanism in words.

use std::cmp::Reverse;
use std::fmt;

use crate::judge::Conclusion;
use crate::mechanics::Mechanism;
use crate::mechanics::{RigidPart, parts};
use crate::number::short;
use crate::run::{CaseResult, Row};
use crate::scene::{Block, Joint, JointClass, Point, Push, Scene, Side, Vector};

/// The best answer about a scene in these terms.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Terms {
    /// The ground may be tilted by arctan λ, in degrees, where the live load is every weight sideways.
    pub tilt: Option<f64>,
    /// What the supports carry along x, positive in the direction of the live load, in the case's unit of
    /// force: the dead loads' part and λ times the live load.
    pub base_shear: Option<f64>,
    /// The part of it that comes from the push.
    pub push_shear: Option<f64>,
    /// The blocks that move fastest.
    pub first_blocks: Vec<String>,
    /// The joints that open or slip fastest.
    pub first_joints: Vec<String>,
    /// How it moves.
    pub mechanism: Option<String>,
}

/// Blocks and joints that are named.
const NAMED: usize = 3;

/// Parts that are described one by one, and hinges that are named.
const DESCRIBED: usize = 3;
const HINGES: usize = 8;

/// Part of the fastest corner's velocity below which a joint neither opens nor slips.
const STILL: f64 = 0.02;

/// The conclusion about a head-joint setting in these terms; `None` where there is no answer behind it.
pub(crate) fn terms(result: &CaseResult, conclusion: &Conclusion) -> Option<Terms> {
    let rows = result.rows.iter();
    let mut rows = rows.filter(|row| row.head_joints == conclusion.head_joints);
    let first = conclusion.methods.first()?;
    let row = rows
        .find(|row| row.method == *first)?
        .of_side(conclusion.push);
    let row = &*row;
    let scene = result.scene(row);
    let lambda = conclusion.bracket.map(|bracket| bracket.lower);
    let along = |load: fn(&Block) -> [f64; 3]| -> f64 {
        let blocks = scene.blocks().iter();
        blocks.map(|block| load(block)[0]).sum()
    };
    // In the direction of the live load, whatever the case calls its push.
    let sign = if along(Block::live) < 0.0 { -1.0 } else { 1.0 };
    let push_shear = lambda.map(|lambda| sign * lambda * along(Block::live));
    let moved = mechanism(row).map(|mechanism| Moved::new(scene, mechanism, row));
    Some(Terms {
        tilt: lambda
            .filter(|_| weights_push(scene))
            .map(|lambda| lambda.atan().to_degrees()),
        base_shear: push_shear.map(|push| sign * along(Block::dead) + push),
        push_shear,
        first_blocks: moved.as_ref().map_or(Vec::new(), Moved::first_blocks),
        first_joints: moved.as_ref().map_or(Vec::new(), Moved::first_joints),
        mechanism: moved.as_ref().and_then(Moved::words),
    })
}

/// The mechanism at the multiplier that the answer gives: of several states, the lowest.
fn mechanism(row: &Row) -> Option<&Mechanism> {
    row.outcome.evidence.mechanism()
}

/// Whether every live force is its dead one turned sideways, and so the push a tilt of the ground.
fn weights_push(scene: &Scene) -> bool {
    let sign = scene.push().sign();
    let loads = scene.blocks().iter().flat_map(|block| &block.loads);
    let mut loads = loads.map(|load| {
        let turned = Vector::new(-sign * load.dead.y, 0.0);
        (load.live - turned).norm() <= 1e-9 * load.dead.norm() && load.dead.x == 0.0
    });
    loads.all(|alike| alike)
}

/// A scene and how it moves.
struct Moved<'a> {
    scene: &'a Scene,
    mechanism: &'a Mechanism,
    /// Velocity of the fastest corner.
    fastest: f64,
    parts: Vec<RigidPart>,
    /// The part of every block.
    part_of: Vec<usize>,
}

impl<'a> Moved<'a> {
    fn new(scene: &'a Scene, mechanism: &'a Mechanism, row: &Row) -> Self {
        let parts = parts(scene, mechanism, row.outcome.evidence.still());
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

    fn first_blocks(&self) -> Vec<String> {
        let speed = |block: usize| self.mechanism.speed(self.scene, block, None);
        let blocks = 0..self.scene.blocks().len();
        let mut order: Vec<(usize, f64)> = blocks.map(|block| (block, speed(block))).collect();
        order.retain(|(_, speed)| *speed > STILL * self.fastest);
        // What is equal but for rounding keeps the order of the blocks.
        order.sort_by_key(|one| Reverse(self.rank(one.1)));
        let order = order.into_iter().take(NAMED);
        order
            .map(|(block, _)| self.scene.block_name(block))
            .collect()
    }

    fn first_joints(&self) -> Vec<String> {
        let rates = self.mechanism.joint_rates(self.scene).into_iter();
        let rate = |rate: crate::mechanics::JointRate| {
            let [a, b] = rate.opening;
            a.max(b).max(rate.slip.abs())
        };
        let mut order: Vec<(usize, f64)> = rates.map(rate).enumerate().collect();
        order.retain(|(_, rate)| *rate > STILL * self.fastest);
        order.sort_by_key(|one| Reverse(self.rank(one.1)));
        let order = order.into_iter().take(NAMED);
        order
            .map(|(joint, _)| self.joint_name(&self.scene.joints()[joint]))
            .collect()
    }

    /// A rate in thousandths of the fastest.
    fn rank(&self, rate: f64) -> i64 {
        (1e3 * rate / self.fastest).round() as i64
    }

    fn joint_name(&self, joint: &Joint) -> String {
        let to = self.scene.block_name(joint.to);
        match joint.from {
            Side::Support(_) => format!("{to} on its support"),
            Side::Block(from) => format!("{} | {to}", self.scene.block_name(from)),
        }
    }

    /// The mechanism in words.
    fn words(&self) -> Option<String> {
        let moving: Vec<usize> = (0..self.parts.len())
            .filter(|&part| self.parts[part].moves)
            .collect();
        if moving.is_empty() || self.fastest <= 0.0 {
            return None;
        }
        let blocks: usize = moving
            .iter()
            .map(|&part| self.parts[part].blocks.len())
            .sum();
        let all = self.scene.blocks().len();
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
                let names: Vec<String> =
                    hinges.iter().map(|joint| self.joint_name(joint)).collect();
                text.push_str(&format!(
                    "they turn about {} hinges ({})",
                    hinges.len(),
                    names.join(", ")
                ));
            }
            None => {
                let described = moving.iter().take(DESCRIBED).map(|&part| {
                    let count = self.parts[part].blocks.len();
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

    /// What a part does.
    fn part_words(&self, part: usize) -> String {
        let first = self.parts[part].blocks[0];
        let s = if self.parts[part].blocks.len() == 1 {
            "s"
        } else {
            ""
        };
        let motion = self.mechanism.motions[first];
        let (low, high) = self.bounds(part);
        let speed = self.parts[part]
            .blocks
            .iter()
            .map(|&block| self.mechanism.speed(self.scene, block, None))
            .fold(0.0, f64::max);
        let turns = motion.rotation.abs() * (high - low).norm();
        if turns < 0.05 * speed {
            return match self.slips_on(part) {
                Some(on) => format!("slide{s} {} {on}", way(motion.velocity)),
                None => format!("move{s} {}", way(motion.velocity)),
            };
        }
        let centroid = self.scene.blocks()[first].shape.centroid();
        let arm = Vector::new(-motion.velocity.y, motion.velocity.x) / motion.rotation;
        let centre = centroid + arm;
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
        let of = move |side: Side| match side {
            Side::Block(block) => Some(self.part_of[block]),
            Side::Support(_) => None,
        };
        let joints = self.scene.joints().iter().enumerate();
        joints.filter(move |(_, joint)| {
            let (from, to) = (of(joint.from), self.part_of[joint.to]);
            (to == part) != (from == Some(part))
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
            let high = coursing.height / coursing.courses as f64;
            ((joint.ends[0].y - low.y) / high).round() as usize
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
    fn hinges(&self) -> Option<Vec<&'a Joint>> {
        let rates = self.mechanism.joint_rates(self.scene);
        let limit = STILL * self.fastest;
        let mut hinges = Vec::new();
        for (joint, rate) in self.scene.joints().iter().zip(&rates) {
            let [low, high] = [
                rate.opening[0].min(rate.opening[1]),
                rate.opening[0].max(rate.opening[1]),
            ];
            if rate.slip.abs() > limit || low > limit {
                return None;
            }
            if high > limit {
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

impl fmt::Display for Terms {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let tilt = self
            .tilt
            .map(|tilt| format!("the ground may tilt by {tilt:.2} degrees"));
        let shear = self.base_shear.zip(self.push_shear).map(|(all, push)| {
            let [all, push] = [all, push].map(|shear| short(shear, 4));
            match all == push {
                true => format!("the base shear is {all}"),
                false => format!("the base shear is {all}, of which {push} comes from the push"),
            }
        });
        let first = match self.first_blocks.as_slice() {
            [] => None,
            [one] => Some(format!("{one} moves first")),
            [others @ .., last] => Some(format!("{} and {last} move first", others.join(", "))),
        };
        let all = [tilt, shear, self.mechanism.clone(), first];
        let all: Vec<String> = all.into_iter().flatten().collect();
        f.write_str(&all.join("; "))
    }
}
