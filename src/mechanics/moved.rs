//! A scene and how it moves, in parts that move as one body each.

use super::mechanism::Mechanism;
use super::rigid_parts::{RigidPart, parts};
use crate::scene::Scene;

/// Part of the fastest corner's velocity below which a joint neither opens nor slips.
pub(super) const STILL: f64 = 0.02;

/// A scene and how it moves.
pub struct Moved<'a> {
    pub(super) scene: &'a Scene,
    pub mechanism: &'a Mechanism,
    /// Velocity of the fastest corner.
    pub fastest: f64,
    pub(super) parts: Vec<RigidPart>,
    /// The part of every block.
    pub(super) part_of: Vec<usize>,
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

    /// The blocks of a part; a support that moves is none.
    pub(super) fn blocks(&self, part: usize) -> Vec<usize> {
        let blocks = self.parts[part].blocks.iter().copied();
        blocks
            .filter(|&block| !self.scene.is_moving_support(block))
            .collect()
    }
}
