//! The one way to make a scene: bodies, friction and push in, joints found and everything checked.

use std::collections::BTreeMap;

use super::block::{Block, Load};
use super::friction::Friction;
use super::joints::{
    Joint, JointClass, NamedJoint, Side, TOUCHING, call_voussoir_joints_beds, find_joints,
};
use super::labels::Labels;
use super::model::Scene;
use super::polygon::Polygon;
use super::push::{HeadJoints, Push};
use super::regular::WallFacts;

/// What a scene is made of, before its joints are found.
#[derive(Clone, Debug, PartialEq)]
pub struct SceneParts {
    /// Blocks that may move, with their forces for this push.
    pub blocks: Vec<Block>,
    /// Shapes that never move.
    pub supports: Vec<Polygon>,
    /// Coefficients of friction.
    pub friction: Friction,
    /// Coefficients of friction of single blocks by their place. In a joint that of either block counts,
    /// or of its class where the block has none, and the smaller one.
    pub own_friction: BTreeMap<usize, f64>,
    /// Edges touch within this fraction of the smaller body's extent.
    pub tolerance: f64,
    /// Whether joints between blocks are bed joints whichever way they run, as in an arch.
    pub radial: bool,
    /// Joints that have a class or a friction of their own, or are open.
    pub named_joints: Vec<NamedJoint>,
    /// Direction of the live load.
    pub push: Push,
    /// What only a coursed wall has.
    pub wall: Option<WallFacts>,
}

impl SceneParts {
    /// Bodies that touch within 1e-6 of the smaller one's extent, pushed to the right.
    pub fn new(blocks: Vec<Block>, supports: Vec<Polygon>, friction: impl Into<Friction>) -> Self {
        Self {
            blocks,
            supports,
            friction: friction.into(),
            own_friction: BTreeMap::new(),
            tolerance: TOUCHING,
            radial: false,
            named_joints: Vec::new(),
            push: Push::Right,
            wall: None,
        }
    }
}

/// Why parts make no scene. Blocks and loads are named by their place, from 0.
#[allow(missing_docs, reason = "the sentence of each says it")]
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum SceneError {
    #[error("load {load} of block {block} is not finite")]
    Load { block: usize, load: usize },
    #[error("{} joints have the friction {value}; it must be finite and not negative", class.name())]
    Friction { class: JointClass, value: f64 },
    #[error("a block or a joint has the friction {0}; it must be finite and not negative")]
    OwnFriction(f64),
    #[error("edges cannot touch within {0} of a body's extent")]
    Tolerance(f64),
}

impl Scene {
    /// Checks the parts and finds their joints. Head joints are in contact; for open ones see
    /// [`Scene::with_head_joints`].
    ///
    /// # Errors
    /// [`SceneError`], where a number in the parts means nothing.
    pub fn new(parts: SceneParts) -> Result<Self, SceneError> {
        parts.check_friction()?;
        if !(parts.tolerance > 0.0 && parts.tolerance < 1.0) {
            return Err(SceneError::Tolerance(parts.tolerance));
        }
        for (block, of_block) in parts.blocks.iter().enumerate() {
            let finite = |load: &Load| {
                let numbers = [load.point.coords, load.dead, load.live];
                numbers.iter().all(|v| v.x.is_finite() && v.y.is_finite())
            };
            if let Some(load) = of_block.loads.iter().position(|load| !finite(load)) {
                return Err(SceneError::Load { block, load });
            }
        }
        let shapes: Vec<&Polygon> = parts.blocks.iter().map(|block| &block.shape).collect();
        let mut joints = find_joints(parts.tolerance, &shapes, &parts.supports);
        call_voussoir_joints_beds(&mut joints, shapes.len());
        let found = joints.len();
        parts.settle(&mut joints);
        Ok(Self {
            blocks: parts.blocks,
            supports: parts.supports,
            left_out: found - joints.len(),
            joints,
            head_joints: HeadJoints::Contact,
            push: parts.push,
            wall: parts.wall,
            labels: Labels::default(),
            reaction: None,
        })
    }
}

impl SceneParts {
    fn check_friction(&self) -> Result<(), SceneError> {
        let sound = |value: f64| value.is_finite() && value >= 0.0;
        for class in JointClass::ALL {
            let value = self.friction.of(class);
            if !sound(value) {
                return Err(SceneError::Friction { class, value });
            }
        }
        let joints = self.named_joints.iter().filter_map(|named| named.friction);
        let mut own = self.own_friction.values().copied().chain(joints);
        own.find(|&value| !sound(value))
            .map_or(Ok(()), |value| Err(SceneError::OwnFriction(value)))
    }

    /// Gives joints their class and friction, and takes away the head joints that are open.
    fn settle(&self, joints: &mut Vec<Joint>) {
        let named = self.named_joints.iter();
        let named: BTreeMap<[Side; 2], &NamedJoint> =
            named.map(|named| (named.bodies(), named)).collect();
        joints.retain_mut(|joint| {
            let named = named.get(&joint.bodies());
            if self.radial && joint.class == JointClass::Head {
                joint.class = JointClass::Bed;
            }
            joint.class = named.and_then(|named| named.class).unwrap_or(joint.class);
            let of_class = self.friction.of(joint.class);
            let of = |body| match body {
                Side::Block(block) => self.own_friction.get(&block).copied().unwrap_or(of_class),
                Side::Support(_) => of_class,
            };
            let [one, other] = joint.bodies().map(of);
            joint.friction = (named.and_then(|named| named.friction)).unwrap_or(one.min(other));
            !(joint.class == JointClass::Head && named.is_some_and(|named| named.open))
        });
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::{Load, Point, Vector};

    fn parts() -> SceneParts {
        let shape = |bottom, top| Polygon::rectangle(0.0, 1.0, bottom, top).unwrap();
        let load = Load {
            point: Point::new(0.5, 0.5),
            dead: Vector::new(0.0, -1.0),
            live: Vector::new(1.0, 0.0),
        };
        let block = Block {
            shape: shape(0.0, 1.0),
            loads: vec![load],
        };
        SceneParts::new(vec![block], vec![shape(-1.0, 0.0)], 0.5)
    }

    #[test]
    fn numbers_that_mean_nothing_make_no_scene() {
        assert_eq!(Scene::new(parts()).unwrap().joints().len(), 1);
        let mut broken = parts();
        broken.blocks[0].loads[0].live.x = f64::NAN;
        let refused = SceneError::Load { block: 0, load: 0 };
        assert_eq!(Scene::new(broken), Err(refused));
        for value in [-0.1, f64::INFINITY] {
            let friction = Friction {
                head: value,
                ..0.5.into()
            };
            let refused = Scene::new(SceneParts {
                friction,
                ..parts()
            })
            .unwrap_err();
            assert!(refused.to_string().contains("head joints"), "{refused}");
        }
        let tolerance = f64::NAN;
        assert!(
            Scene::new(SceneParts {
                tolerance,
                ..parts()
            })
            .is_err()
        );
    }
}
