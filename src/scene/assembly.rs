//! Named blocks of any shape on named supports: explicit scenes, and what generators make.

use std::collections::BTreeMap;

use super::block::{Block, Load};
use super::friction::Friction;
use super::joints::{NamedJoint, TOUCHING};
use super::model::Scene;
use super::parts::{SceneError, SceneParts};
use super::polygon::{Point, Polygon, Vector, bounds_of};
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
    /// Its own coefficient of friction. In a joint of two blocks the smaller one counts; where a block
    /// has none, and of a support, that of the joint's class.
    pub friction: Option<f64>,
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
    /// Live part of every weight for λ = 1, over the weight: x along the push, y upwards. A push to the
    /// left turns x round.
    pub of_weight: Vector,
    /// Forces beside the weights.
    pub extra: Vec<Force>,
}

/// Every weight sideways, and nothing else.
impl Default for Forces {
    fn default() -> Self {
        Self {
            of_weight: Vector::new(1.0, 0.0),
            extra: Vec::new(),
        }
    }
}

impl Forces {
    /// A weight on a block, with its live part.
    pub(super) fn weight(&self, block: usize, point: Point, weight: f64) -> Force {
        Force {
            block,
            point,
            dead: Vector::new(0.0, -weight),
            live: self.of_weight * weight,
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
    /// Overburden ratio r = p / (γ H) on the top faces, with the mean weight γ over the area of all
    /// blocks.
    pub overburden: f64,
    /// Edges touch within this fraction of the smaller block's extent.
    pub tolerance: f64,
    /// Whether joints between blocks are bed joints whichever way they run, as in an arch.
    pub radial: bool,
    /// Joints that have a class or a friction of their own, or are open.
    pub named_joints: Vec<NamedJoint>,
    /// The layers of bodies in the drawing that they come from, by their names.
    pub layers: BTreeMap<String, String>,
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
        let blocks = self.blocks.iter().enumerate();
        SceneParts {
            tolerance: self.tolerance,
            radial: self.radial,
            named_joints: self.named_joints.clone(),
            own_friction: blocks
                .filter_map(|(place, block)| Some((place, block.friction?)))
                .collect(),
            push,
            ..SceneParts::new(self.loaded(push), supports.collect(), self.friction)
        }
    }

    /// Names of the blocks, in their order.
    pub fn block_names(&self) -> Vec<String> {
        self.blocks.iter().map(|block| block.name.clone()).collect()
    }

    /// Level faces at the height of the highest corner, which the overburden lies on: block, middle and
    /// width.
    pub(crate) fn top_faces(&self) -> Vec<(usize, Point, f64)> {
        let (low, high) = self.bounds();
        let near = TOUCHING * (high.y - low.y);
        let edges = self.blocks.iter().enumerate();
        let edges = edges.flat_map(|(block, of)| of.shape.edges().map(move |edge| (block, edge)));
        let at_top = |p: Point| high.y - p.y <= near;
        // Outlines run counter-clockwise: along a top from right to left.
        let faces = edges.filter(|&(_, (a, b))| at_top(a) && at_top(b) && b.x < a.x);
        faces
            .map(|(block, (a, b))| (block, nalgebra::center(&a, &b), a.x - b.x))
            .collect()
    }

    /// The overburden p, force over width.
    pub(crate) fn pressure(&self) -> f64 {
        let blocks = self.blocks.iter();
        let [weight, area] = blocks.fold([0.0; 2], |[weight, area], block| {
            [weight + block.weight, area + block.shape.area()]
        });
        let (low, high) = self.bounds();
        self.overburden * (high.y - low.y) * weight / area
    }

    fn bounds(&self) -> (Point, Point) {
        bounds_of(self.blocks.iter().map(|block| &block.shape))
    }

    fn loaded(&self, push: Push) -> Vec<Block> {
        let weights = self.blocks.iter().enumerate();
        let weights = weights.map(|(place, b)| self.forces.weight(place, b.centre, b.weight));
        let pressure = self.pressure();
        let faces = (pressure > 0.0).then(|| self.top_faces());
        let carried = faces
            .into_iter()
            .flatten()
            .map(|(block, middle, width)| self.forces.weight(block, middle, pressure * width));
        let mut blocks: Vec<Block> = (self.blocks.iter())
            .map(|block| Block {
                shape: block.shape.clone(),
                loads: Vec::new(),
            })
            .collect();
        for force in weights
            .chain(carried)
            .chain(self.forces.extra.iter().copied())
        {
            blocks[force.block].loads.push(Load {
                point: force.point,
                dead: force.dead,
                live: Vector::new(push.sign() * force.live.x + 0.0, force.live.y),
            });
        }
        blocks
    }
}
