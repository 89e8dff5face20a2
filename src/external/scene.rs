//! The scene as JSON.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::scene::{JointClass, Point, Polygon, Scene, Side, Vector};

/// A scene of rigid blocks with forces, joints and friction, all in the units of the case. x points
/// to the right, y up, rotations and moments are positive counter-clockwise, and λ multiplies the
/// live loads. Blocks, supports and joints are named by their index from 0.
#[derive(Debug, PartialEq, Deserialize, Serialize, JsonSchema)]
#[schemars(title = "trilith scene")]
#[serde(deny_unknown_fields)]
pub struct SceneFile {
    /// Version of this format: 1.
    pub format: u32,
    /// Name of the case; empty where the scene is of none.
    pub case: String,
    /// Whether head joints carry Coulomb contact ("contact") or nothing ("open"); joints that carry
    /// nothing are not listed.
    pub head_joints: String,
    /// Which way the live load pushes: "right" (+x) or "left".
    pub push: String,
    /// Blocks that may move.
    pub blocks: Vec<BlockFile>,
    /// Shapes that never move.
    pub supports: Vec<ShapeFile>,
    /// Every joint that can carry a force.
    pub joints: Vec<JointFile>,
}

/// A rigid block.
#[derive(Debug, PartialEq, Deserialize, Serialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct BlockFile {
    /// What the case calls it, or where it lies in a coursed wall ("course 3 piece 2": courses from
    /// the bottom, pieces from the left with gaps); empty where there is no name.
    pub name: String,
    /// Corners [x, y] of the outline, counter-clockwise; it may bend inwards.
    pub corners: Vec<[f64; 2]>,
    /// Centroid [x, y] of the outline, which wrenches and velocities are about.
    pub centroid: [f64; 2],
    /// Constant wrench [x, y, moment] of all loads about the centroid.
    pub dead: [f64; 3],
    /// Wrench [x, y, moment] about the centroid that λ multiplies.
    pub live: [f64; 3],
    /// The loads one by one: what `dead` and `live` are the sums of.
    pub loads: Vec<LoadFile>,
}

/// A force at a point that moves with its block.
#[derive(Debug, PartialEq, Deserialize, Serialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct LoadFile {
    /// What it is: "self-weight", of the block itself; "overburden", on top of a coursed wall; or
    /// "load", any other.
    pub kind: String,
    /// Where it acts.
    pub point: [f64; 2],
    /// Constant part.
    pub dead: [f64; 2],
    /// Part that λ multiplies.
    pub live: [f64; 2],
}

/// A shape.
#[derive(Debug, PartialEq, Deserialize, Serialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ShapeFile {
    /// Corners [x, y], counter-clockwise.
    pub corners: Vec<[f64; 2]>,
}

/// A segment that a block shares with another body.
#[derive(Debug, PartialEq, Deserialize, Serialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct JointFile {
    /// The block that the normal points away from; null where it is a support.
    pub from_block: Option<usize>,
    /// The support that the normal points away from; null where it is a block.
    pub from_support: Option<usize>,
    /// The block that the normal points into.
    pub to: usize,
    /// The two ends; corner forces act here.
    pub ends: [[f64; 2]; 2],
    /// Unit normal into `to`: a compressive force on `to` points along it.
    pub normal: [f64; 2],
    /// Unit tangent, the normal turned clockwise: a positive shear on `to` points along it.
    pub tangent: [f64; 2],
    /// Coefficient of friction.
    pub friction: f64,
    /// How it runs: "base", "bed" or "head".
    pub class: String,
}

/// JSON schema of the scene that a program reads.
pub fn scene_schema() -> schemars::Schema {
    schemars::schema_for!(SceneFile)
}

/// The scene as one line of JSON.
pub fn export(scene: &Scene) -> String {
    serde_json::to_string(&SceneFile::from(scene)).expect("the keys of a scene are words")
}

impl From<&Scene> for SceneFile {
    fn from(scene: &Scene) -> Self {
        let carried = if scene.wall().is_some() {
            "overburden"
        } else {
            "load"
        };
        let names = &scene.labels().blocks;
        let block = |(index, block): (usize, &crate::scene::Block)| BlockFile {
            name: names.get(index).cloned().unwrap_or_default(),
            corners: corners(&block.shape),
            centroid: pair(block.shape.centroid()),
            dead: block.dead(),
            live: block.live(),
            loads: (block.loads.iter().enumerate())
                .map(|(place, load)| LoadFile {
                    // A block's own weight stands first.
                    kind: if place == 0 { "self-weight" } else { carried }.to_owned(),
                    point: pair(load.point),
                    dead: load.dead.into(),
                    live: load.live.into(),
                })
                .collect(),
        };
        let joint = |joint: &crate::scene::Joint| {
            let (from_block, from_support) = match joint.from {
                Side::Block(block) => (Some(block), None),
                Side::Support(support) => (None, Some(support)),
            };
            let vector = |v: Vector| -> [f64; 2] { v.into() };
            JointFile {
                from_block,
                from_support,
                to: joint.to,
                ends: joint.ends.map(pair),
                normal: vector(joint.normal),
                tangent: vector(joint.tangent()),
                friction: joint.friction,
                class: JointClass::name(joint.class).to_owned(),
            }
        };
        let shape = |shape: &Polygon| ShapeFile {
            corners: corners(shape),
        };
        Self {
            format: 1,
            case: scene.labels().case.clone(),
            head_joints: scene.head_joints().name().to_owned(),
            push: scene.push().name().to_owned(),
            blocks: scene.blocks().iter().enumerate().map(block).collect(),
            supports: scene.supports().iter().map(shape).collect(),
            joints: scene.joints().iter().map(joint).collect(),
        }
    }
}

fn pair(point: Point) -> [f64; 2] {
    [point.x, point.y]
}

fn corners(shape: &Polygon) -> Vec<[f64; 2]> {
    shape.corners().iter().map(|&corner| pair(corner)).collect()
}
