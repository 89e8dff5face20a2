//! Named blocks of any shape on named supports: explicit scenes, and what generators make.

use super::block::{Block, Load};
use super::friction::Friction;
use super::joints::NamedJoint;
use super::model::Scene;
use super::parts::{SceneError, SceneParts};
use super::polygon::{Point, Polygon, Vector};
use super::push::{HeadJoints, Push};

/// A block of an assembly.
#[derive(Clone, Debug, PartialEq)]
pub struct NamedBlock {
    /// Its name in the case.
    pub name: String,
    /// Outline.
    pub shape: Polygon,
    /// Weight; positive.
    pub weight: f64,
    /// Where the weight acts.
    pub centre: Point,
}

/// A shape that never moves.
#[derive(Clone, Debug, PartialEq)]
pub struct Support {
    /// Its name in the case.
    pub name: String,
    /// Outline.
    pub shape: Polygon,
}

/// A force on a block, beside its weight.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Force {
    /// Index of the block.
    pub block: usize,
    /// Where it acts; of a line load, the middle of the line.
    pub point: Point,
    /// Dead part.
    pub dead: Vector,
    /// Live part for λ = 1 and a push to the right; a push to the left turns its x round.
    pub live: Vector,
}

/// What pushes: the forces of an assembly.
#[derive(Clone, Debug, PartialEq)]
pub struct Forces {
    /// Whether every weight also acts sideways as live load.
    pub weight_is_live: bool,
    /// Forces beside the weights.
    pub extra: Vec<Force>,
}

/// Every weight sideways, and nothing else.
impl Default for Forces {
    fn default() -> Self {
        Self {
            weight_is_live: true,
            extra: Vec::new(),
        }
    }
}

/// Blocks, supports, friction and forces.
#[derive(Clone, Debug, PartialEq)]
pub struct Assembly {
    /// Blocks that may move.
    pub blocks: Vec<NamedBlock>,
    /// Shapes that never move.
    pub supports: Vec<Support>,
    /// Coefficients of friction.
    pub friction: Friction,
    /// Forces beside the dead weights.
    pub forces: Forces,
    /// Edges touch within this fraction of the smaller block's extent.
    pub tolerance: f64,
    /// Whether joints between blocks are bed joints whichever way they run, as in an arch.
    pub radial: bool,
    /// Joints that are bed or head joints whatever the rule says.
    pub named_joints: Vec<NamedJoint>,
}

impl Assembly {
    /// Blocks, joints and forces for one setting and one direction of the push.
    ///
    /// # Errors
    /// [`SceneError`], where a number in the assembly means nothing.
    pub fn scene(&self, head_joints: HeadJoints, push: Push) -> Result<Scene, SceneError> {
        Ok(Scene::new(self.parts(push))?.with_head_joints(head_joints))
    }

    /// What its scene is made of, for one direction of the push.
    pub(super) fn parts(&self, push: Push) -> SceneParts {
        let supports = self.supports.iter().map(|support| support.shape.clone());
        SceneParts {
            tolerance: self.tolerance,
            radial: self.radial,
            named_joints: self.named_joints.clone(),
            push,
            ..SceneParts::new(self.loaded(push), supports.collect(), self.friction)
        }
    }

    /// Names of the blocks, in their order.
    pub fn block_names(&self) -> Vec<String> {
        self.blocks.iter().map(|block| block.name.clone()).collect()
    }

    fn loaded(&self, push: Push) -> Vec<Block> {
        let sideways = if self.forces.weight_is_live {
            push.sign()
        } else {
            0.0
        };
        let weighted = |block: &NamedBlock| Block {
            shape: block.shape.clone(),
            loads: vec![Load {
                point: block.centre,
                dead: Vector::new(0.0, -block.weight),
                live: Vector::new(sideways * block.weight, 0.0),
            }],
        };
        let mut blocks: Vec<Block> = self.blocks.iter().map(weighted).collect();
        for force in &self.forces.extra {
            blocks[force.block].loads.push(Load {
                point: force.point,
                dead: force.dead,
                live: Vector::new(push.sign() * force.live.x, force.live.y),
            });
        }
        blocks
    }
}
