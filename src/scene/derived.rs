//! Scenes made from another scene, each by one change.

use super::block::{Block, Load};
use super::joints::{Joint, JointClass, Side};
use super::labels::Labels;
use super::model::Scene;
use super::polygon::{Point, Polygon, PolygonError, Vector};
use super::push::{HeadJoints, Push};

impl Scene {
    /// The scene with head joints that carry what this says. Open ones are taken away; a scene that
    /// has lost them does not get them back.
    pub fn with_head_joints(mut self, head_joints: HeadJoints) -> Self {
        if head_joints == HeadJoints::Open {
            let before = self.joints.len();
            self.joints.retain(|joint| joint.class != JointClass::Head);
            self.left_out += before - self.joints.len();
            self.head_joints = HeadJoints::Open;
        }
        self
    }

    /// The scene with other coefficients of friction; `friction` gets each joint and its place.
    pub fn with_friction(mut self, friction: impl Fn(usize, &Joint) -> f64) -> Self {
        for (index, joint) in self.joints.iter_mut().enumerate() {
            joint.friction = friction(index, joint);
        }
        self
    }

    /// The scene with every load changed; `change` gets the load and its block.
    pub fn with_loads(mut self, change: impl Fn(&mut Load, &Polygon)) -> Self {
        for Block { shape, loads } in &mut self.blocks {
            loads.iter_mut().for_each(|load| change(load, shape));
        }
        self
    }

    /// The scene with these names.
    pub fn with_labels(mut self, labels: Labels) -> Self {
        self.labels = labels;
        self
    }

    /// The scene without what only a coursed wall has.
    pub fn without_wall(mut self) -> Self {
        self.wall = None;
        self
    }

    /// A scene of other bodies and joints that keeps push, head joints and wall. Joints name the
    /// new bodies.
    pub(crate) fn with_bodies(
        &self,
        blocks: Vec<Block>,
        supports: Vec<Polygon>,
        joints: Vec<Joint>,
    ) -> Self {
        debug_assert!(joints.iter().all(|joint| joint.to < blocks.len()));
        Self {
            blocks,
            supports,
            joints,
            head_joints: self.head_joints,
            left_out: self.left_out,
            push: self.push,
            wall: self.wall.clone(),
            labels: Labels::default(),
            reaction: None,
        }
    }

    /// The scene with every point elsewhere and the same joints: `to` gets the body that a corner,
    /// a load or the end of a joint (of its block `to`) belongs to. Forces stay as they are.
    ///
    /// # Errors
    /// [`PolygonError`], where an outline becomes none, as by mirroring (see [`Scene::mirrored`]).
    pub fn moved(&self, to: impl Fn(Side, Point) -> Point) -> Result<Self, PolygonError> {
        let shape = |body, shape: &Polygon| {
            Polygon::new(shape.corners().iter().map(|&p| to(body, p)).collect())
        };
        let mut scene = self.clone();
        for (index, block) in scene.blocks.iter_mut().enumerate() {
            let body = Side::Block(index);
            block.shape = shape(body, &block.shape)?;
            for load in &mut block.loads {
                load.point = to(body, load.point);
            }
        }
        for (index, support) in scene.supports.iter_mut().enumerate() {
            *support = shape(Side::Support(index), support)?;
        }
        for joint in &mut scene.joints {
            joint.ends = joint.ends.map(|end| to(Side::Block(joint.to), end));
            // A pin has no length, and keeps its normal.
            if let Some(along) = (joint.ends[1] - joint.ends[0]).try_normalize(0.0) {
                joint.normal = Vector::new(along.y, -along.x);
            }
        }
        Ok(scene)
    }

    /// The scene seen from behind: everything mirrored about the middle of the blocks, the push too.
    ///
    /// # Errors
    /// Never on a valid scene; a mirrored outline is as good as the outline.
    pub fn mirrored(&self) -> Result<Self, PolygonError> {
        let (low, high) = self.bounds();
        let about = low.x + high.x;
        let vector = |v: Vector| Vector::new(-v.x, v.y);
        let mut scene = self.moved(|_, p| Point::new(about - p.x, p.y))?;
        for load in scene.blocks.iter_mut().flat_map(|block| &mut block.loads) {
            load.dead = vector(load.dead);
            load.live = vector(load.live);
        }
        for (joint, seen) in scene.joints.iter_mut().zip(&self.joints) {
            joint.normal = vector(seen.normal);
        }
        scene.push = match self.push {
            Push::Right => Push::Left,
            Push::Left => Push::Right,
        };
        Ok(scene)
    }
}
