//! How a mechanism moves, in words: what moves first, each part by itself, and all of it.

use std::cmp::Reverse;

use super::mechanism::JointRate;
use super::moved::{Moved, STILL};
use super::part_words::RigidMotion;
use super::places::Places;
use super::residual::live_power;
use crate::scene::{JointClass, Point, Side};
use crate::text::counted;

/// Blocks and joints that are named.
const NAMED: usize = 3;

/// Parts that are described one by one, and hinges that are named.
const DESCRIBED: usize = 3;
const HINGES: usize = 8;

/// Part of the fastest corner's velocity below which the live load, or the support that it acts on, does not move: rates
/// over its motion would be noise.
const CARRIED: f64 = 1e-6;

/// A part that moves as one body.
#[derive(Clone, Debug, PartialEq)]
pub struct MovingPart {
    pub blocks: Vec<String>,
    /// What it turns about; `None` where it does not turn.
    pub centre: Option<Point>,
    /// What it does: "rock about the toe at (3, 0), on the base".
    pub words: String,
}

impl Moved<'_> {
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
        if self.fastest <= 0.0 {
            return None;
        }
        let moving = self.moving();
        if moving.is_empty() {
            return self.scene.reaction().map(|_| "no block moves".to_owned());
        }
        let blocks: Vec<usize> = moving.iter().flat_map(|&part| self.blocks(part)).collect();
        let all: usize = (0..self.parts.len())
            .map(|part| self.blocks(part).len())
            .sum();
        let places = Places::new(self.scene);
        let (place, several) = places.of(&blocks);
        let (who, several) = match (blocks.len(), all) {
            (1, 1) => ("the block".to_owned(), false),
            (2, 2) => ("both blocks".to_owned(), true),
            (count, all) if count == all => (format!("all {all} blocks"), true),
            (count, all) if moving.len() == 1 => {
                (format!("{place}, {count} of {all} blocks,"), several)
            }
            _ => (place, several),
        };
        let s = if several { "" } else { "s" };
        if let [part] = moving[..] {
            return Some(format!("{who} {}", self.part_words(part, s)));
        }
        let mut text = format!("{who} move{s}");
        if blocks.len() < all {
            text.push_str(&format!(", {} of {all} blocks", blocks.len()));
        }
        text.push_str(&format!(" in {} parts: ", moving.len()));
        match self.hinges() {
            Some(hinges) => {
                let names = hinges.iter().map(|&joint| self.joint_name(joint));
                let (count, names) = (hinges.len(), names.collect::<Vec<_>>().join(", "));
                text.push_str(&format!("they turn about {count} hinges ({names})"));
            }
            None => {
                let described = moving.iter().take(DESCRIBED).map(|&part| {
                    let blocks = self.blocks(part);
                    let s = if blocks.len() == 1 { "s" } else { "" };
                    format!("{} {}", places.counted(&blocks), self.part_words(part, s))
                });
                text.push_str(&described.collect::<Vec<_>>().join(", "));
                if moving.len() > DESCRIBED {
                    text.push_str(", …");
                }
            }
        }
        Some(text)
    }

    /// Every part that moves by itself.
    pub fn moving_parts(&self) -> Vec<MovingPart> {
        let part = |part: usize| {
            let (motion, blocks) = (self.motion(part), self.blocks(part));
            let s = if blocks.len() == 1 { "s" } else { "" };
            MovingPart {
                centre: match motion {
                    RigidMotion::Turns(centre) => Some(centre),
                    RigidMotion::Slides(_) => None,
                },
                words: self.part_words(part, s),
                blocks: blocks
                    .into_iter()
                    .map(|block| self.scene.block_name(block))
                    .collect(),
            }
        };
        self.moving().into_iter().map(part).collect()
    }

    /// How a part moves by itself, or that it does not.
    pub fn in_figures(&self, part: usize) -> String {
        let count = self.parts[part].blocks.len();
        let (s, count) = (if count == 1 { "s" } else { "" }, counted(count, "block"));
        match self.parts[part].moves {
            true => format!("{count} {}", self.part_words(part, s)),
            false => format!("{count} stand{s} still"),
        }
    }

    /// The parts with blocks that move.
    fn moving(&self) -> Vec<usize> {
        (0..self.parts.len())
            .filter(|&part| self.parts[part].moves && !self.blocks(part).is_empty())
            .collect()
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
