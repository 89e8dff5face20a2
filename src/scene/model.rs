//! The scene that every method gets.

use super::block::Block;
use super::joints::Joint;
use super::labels::Labels;
use super::polygon::{Point, Polygon, bounds_of};
use super::push::{HeadJoints, Push};
use super::reaction::Reaction;
use super::regular::{Coursing, Irregularity, RegularWall, WallFacts};

/// The scene that all methods share. Forces, not masses; no g, no velocities. Made by
/// [`Scene::new`] alone, or from another scene.
#[derive(Clone, Debug, PartialEq)]
pub struct Scene {
    pub(super) blocks: Vec<Block>,
    pub(super) supports: Vec<Polygon>,
    pub(super) joints: Vec<Joint>,
    pub(super) head_joints: HeadJoints,
    pub(super) left_out: usize,
    pub(super) push: Push,
    pub(super) wall: Option<WallFacts>,
    pub(super) labels: Labels,
    pub(super) reaction: Option<Reaction>,
}

impl Scene {
    /// Blocks that may move.
    pub fn blocks(&self) -> &[Block] {
        &self.blocks
    }

    /// Shapes that never move: the ground, springers.
    pub fn supports(&self) -> &[Polygon] {
        &self.supports
    }

    /// Every joint that can carry a force. With open head joints, those are not here.
    pub fn joints(&self) -> &[Joint] {
        &self.joints
    }

    /// What the head joints carry.
    pub fn head_joints(&self) -> HeadJoints {
        self.head_joints
    }

    /// How many head joints were left out of [`Scene::joints`], as open.
    pub fn left_out(&self) -> usize {
        self.left_out
    }

    /// What only a coursed wall has.
    pub fn wall(&self) -> Option<&WallFacts> {
        self.wall.as_ref()
    }

    /// What its case calls it and its blocks; empty where it is of none.
    pub fn labels(&self) -> &Labels {
        &self.labels
    }

    /// What a block is called in messages: by the name of its case, else "block 3", counted from 1.
    pub fn block_name(&self, block: usize) -> String {
        match self.labels.blocks.get(block) {
            // Voussoirs are called by their number alone.
            Some(name) if name.parse::<usize>().is_ok() => format!("block {name}"),
            Some(name) if !name.is_empty() => name.clone(),
            Some(_) | None => format!("block {}", block + 1),
        }
    }

    /// Direction of the live load.
    pub fn push(&self) -> Push {
        self.push
    }

    /// Height and overlap of a staggered wall, which the crack slope is measured with.
    pub fn coursing(&self) -> Option<&Coursing> {
        self.wall.as_ref()?.coursing.as_ref()
    }

    /// The wall's closed-form description, or why it has none. Only the macro-block needs it.
    ///
    /// # Errors
    /// [`Irregularity`], the first that was met.
    pub fn regular(&self) -> Result<&RegularWall, Irregularity> {
        if self.reaction.is_some() {
            return Err(Irregularity::SupportMoves);
        }
        let wall = self.wall.as_ref().ok_or(Irregularity::NotCoursed)?;
        wall.regular.as_ref().map_err(Clone::clone)
    }

    /// Sum of the magnitudes of all dead forces: the force unit of residuals.
    pub fn total_weight(&self) -> f64 {
        let loads = self.blocks.iter().flat_map(|block| &block.loads);
        loads.map(|load| load.dead.norm()).sum()
    }

    /// The same without what holds a support that moves.
    pub(crate) fn weight(&self) -> f64 {
        let reaction = self.reaction.as_ref();
        reaction.map_or_else(|| self.total_weight(), |reaction| reaction.weight)
    }

    /// Sum of the magnitudes of all live forces for λ = 1.
    pub fn total_live(&self) -> f64 {
        let loads = self.blocks.iter().flat_map(|block| &block.loads);
        loads.map(|load| load.live.norm()).sum()
    }

    /// Multiplier at which the live loads add up to the dead ones: λ over this is λ*, the multiplier
    /// without dimension that smallness is measured by. Exactly 1 where every live force is as large
    /// as the dead one, also where there is no live load.
    pub fn multiplier_unit(&self) -> f64 {
        multiplier_unit(self.total_weight(), self.total_live())
    }

    /// Lower-left and upper-right corner of all blocks.
    pub fn bounds(&self) -> (Point, Point) {
        bounds_of(self.blocks.iter().map(|block| &block.shape))
    }

    /// Height of the blocks above their lowest point: the length unit of residuals.
    pub fn height(&self) -> f64 {
        let (low, high) = self.bounds();
        high.y - low.y
    }
}

/// Multiplier at which live loads of the magnitude `live` add up to dead ones of the magnitude
/// `dead`; 1 where there are none.
pub(crate) fn multiplier_unit(dead: f64, live: f64) -> f64 {
    let unit = dead / live;
    // Inclined loads may differ from the weight by rounding.
    if dead == 0.0 || live == 0.0 || (unit - 1.0).abs() <= 1e-12 {
        1.0
    } else {
        unit
    }
}
