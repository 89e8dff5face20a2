//! Mechanisms: how every block moves at collapse.

use serde::{Deserialize, Serialize};

use crate::scene::{Point, Scene, Vector};

/// Rigid motion of a block: velocity of its centroid and rotation rate (counter-clockwise).
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(from = "[f64; 3]", into = "[f64; 3]")]
pub struct Motion {
    /// Velocity of the centroid.
    pub velocity: Vector,
    /// Rotation rate.
    pub rotation: f64,
}

impl From<[f64; 3]> for Motion {
    fn from([x, y, rotation]: [f64; 3]) -> Self {
        Self {
            velocity: Vector::new(x, y),
            rotation,
        }
    }
}

impl From<Motion> for [f64; 3] {
    fn from(Motion { velocity, rotation }: Motion) -> Self {
        [velocity.x, velocity.y, rotation]
    }
}

impl Motion {
    /// Velocity of the point `arm` away from the centroid.
    pub fn at(&self, arm: Vector) -> Vector {
        self.velocity + Vector::new(-arm.y, arm.x) * self.rotation
    }
}

/// Motions of all blocks, in the scene's order. Only ratios mean something.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Mechanism {
    /// One motion a block.
    pub motions: Vec<Motion>,
}

/// Relative motion at a joint: of the block that the normal points into against the other body.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct JointRate {
    /// Opening rate at each end, positive where the joint opens.
    pub opening: [f64; 2],
    /// Slip rate along the tangent.
    pub slip: f64,
}

impl Mechanism {
    /// Opening and slip rates of every joint.
    pub fn joint_rates(&self, scene: &Scene) -> Vec<JointRate> {
        let rates = scene.joints().iter().map(|joint| {
            let moves = |point: Point| {
                let of = |block: usize| {
                    let arm = point - scene.blocks()[block].shape.centroid();
                    self.motions[block].at(arm)
                };
                of(joint.to) - joint.from.block().map_or(Vector::zeros(), of)
            };
            let ends = joint.ends.map(moves);
            JointRate {
                opening: ends.map(|v| v.dot(&joint.normal)),
                slip: ends[0].dot(&joint.tangent()),
            }
        });
        rates.collect()
    }

    /// Largest corner velocity of a block; with a `reference`, relative to that block's motion.
    pub fn speed(&self, scene: &Scene, block: usize, reference: Option<usize>) -> f64 {
        let shape = &scene.blocks()[block].shape;
        let own = self.motions[block];
        let speed = |corner: &Point| {
            let other = reference.map_or(Vector::zeros(), |r| {
                self.motions[r].at(corner - scene.blocks()[r].shape.centroid())
            });
            (own.at(corner - shape.centroid()) - other).norm()
        };
        shape.corners().iter().map(speed).fold(0.0, f64::max)
    }

    /// Largest corner velocity of every block.
    pub fn speeds(&self, scene: &Scene) -> Vec<f64> {
        let blocks = 0..self.motions.len();
        blocks.map(|block| self.speed(scene, block, None)).collect()
    }

    /// Largest corner velocity of all blocks; 0 where nothing moves.
    pub fn fastest(&self, scene: &Scene) -> f64 {
        self.speeds(scene).into_iter().fold(0.0, f64::max)
    }

    /// Which blocks move: largest corner velocity beyond `threshold` of the scene's largest.
    pub fn moving(&self, scene: &Scene, threshold: f64) -> Vec<bool> {
        let speeds = self.speeds(scene);
        let limit = threshold * speeds.iter().copied().fold(0.0, f64::max);
        speeds.iter().map(|&speed| speed > limit).collect()
    }
}
