//! Tall walls: the part beyond the stagger line is held fixed, which halves the work, and must be
//! shown afterwards to have had no reason to move.

use super::engine::BodyState;
use super::measure::{displacement, farthest};
use super::model::Model;
use super::parameters::SWAYING;
use crate::scene::{Push, Scene, Side};

/// Overlaps between the stagger line and the frozen part: the strip that must stay still.
const MARGIN: f64 = 3.0;

/// What is held fixed; by default nothing.
#[derive(Clone, Debug, Default)]
pub struct Freeze {
    /// Blocks held fixed, in the scene's order.
    pub frozen: Vec<bool>,
    /// Blocks between the stagger line and the frozen part.
    pub strip: Vec<bool>,
}

/// Part of the largest displacement up to which a block counts as standing still.
const STILL: f64 = 1e-2;

impl Freeze {
    /// Whether a body is fixed: a support, or a block held fixed.
    pub fn is_fixed(&self, side: Side) -> bool {
        match side {
            Side::Support(_) => true,
            Side::Block(block) => self.frozen.get(block) == Some(&true),
        }
    }

    /// Whether any block of the strip moved between two states.
    pub fn moved(&self, model: &Model, from: &[BodyState], to: &[BodyState]) -> bool {
        let limit = STILL * displacement(model, from, to);
        (0..model.blocks.len()).any(|i| {
            let block = std::slice::from_ref(&model.blocks[i]);
            self.strip.get(block[0].index) == Some(&true)
                && farthest(block, &from[i..=i], &to[i..=i]) > limit
        })
    }
}

/// The part of a tall regular wall beyond the line that rises from the toe by one course for
/// each overlap. `None` where there is nothing to gain, and for irregular walls: a part with
/// openings may fail far from that line, where nothing would tell.
pub fn beyond_stagger(scene: &Scene) -> Option<Freeze> {
    scene.regular().as_ref().ok()?;
    let wall = scene
        .coursing()
        .filter(|wall| wall.courses as f64 >= SWAYING)?;
    let (low, high) = scene.bounds();
    let unit_height = wall.height / wall.courses as f64;
    // Overlaps between the stagger line and the block's near side.
    let beyond = scene.blocks().iter().map(|block| {
        let (l, h) = block.shape.bounds();
        let near = match scene.push() {
            Push::Right => high.x - h.x,
            Push::Left => l.x - low.x,
        };
        let course = ((l.y - low.y) / unit_height).round() + 1.0;
        near / wall.overlap - course
    });
    let beyond: Vec<f64> = beyond.collect();
    let frozen: Vec<bool> = beyond.iter().map(|&by| by > MARGIN - 0.5).collect();
    let strip = beyond
        .iter()
        .zip(&frozen)
        .map(|(&by, &f)| by > -0.5 && !f)
        .collect();
    frozen.contains(&true).then_some(Freeze { frozen, strip })
}
