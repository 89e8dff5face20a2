//! Mechanisms: how every block moves at collapse, and the crack slope read from it.

use crate::scene::{Point, Push, Scene, Vector};

/// Rigid motion of a block: velocity of its centroid and rotation rate (counter-clockwise).
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Motion {
    /// Velocity of the centroid.
    pub velocity: Vector,
    /// Rotation rate.
    pub rotation: f64,
}

impl Motion {
    /// Velocity of the point `arm` away from the centroid.
    pub fn at(&self, arm: Vector) -> Vector {
        self.velocity + Vector::new(-arm.y, arm.x) * self.rotation
    }
}

/// Motions of all blocks, in the scene's order. Only ratios mean something.
#[derive(Clone, Debug, PartialEq)]
pub struct Mechanism {
    /// One motion a block.
    pub motions: Vec<Motion>,
}

/// Relative motion at a joint: of the block that the normal points into against the other body.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct JointRate {
    /// Opening rate at each end, positive where the joint opens.
    pub opening: [f64; 2],
    /// Slip rate along the tangent.
    pub slip: f64,
}

impl Mechanism {
    /// Opening and slip rates of every joint.
    pub fn joint_rates(&self, scene: &Scene) -> Vec<JointRate> {
        let rates = scene.joints.iter().map(|joint| {
            let moves = |point: Point| {
                let of = |block: usize| {
                    let arm = point - scene.blocks[block].shape.centroid();
                    self.motions[block].at(arm)
                };
                of(joint.to)
                    - match joint.from {
                        crate::scene::Side::Block(from) => of(from),
                        crate::scene::Side::Support(_) => Vector::zeros(),
                    }
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
        let shape = &scene.blocks[block].shape;
        let own = self.motions[block];
        let speed = |corner: &Point| {
            let other = reference.map_or(Vector::zeros(), |r| {
                self.motions[r].at(corner - scene.blocks[r].shape.centroid())
            });
            (own.at(corner - shape.centroid()) - other).norm()
        };
        shape.corners().iter().map(speed).fold(0.0, f64::max)
    }

    /// Largest corner velocity of all blocks; 0 where nothing moves.
    pub fn fastest(&self, scene: &Scene) -> f64 {
        let blocks = 0..self.motions.len();
        blocks
            .map(|block| self.speed(scene, block, None))
            .fold(0.0, f64::max)
    }

    /// Which blocks move: largest corner velocity beyond `threshold` of the scene's largest.
    pub fn moving(&self, scene: &Scene, threshold: f64) -> Vec<bool> {
        let speeds: Vec<f64> = (0..self.motions.len())
            .map(|block| self.speed(scene, block, None))
            .collect();
        let limit = threshold * speeds.iter().copied().fold(0.0, f64::max);
        speeds.iter().map(|&speed| speed > limit).collect()
    }
}

/// Crack slope of a wall (paper, Fig. 5), with what it is made of.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Crack {
    /// Width that moves as one rigid body along the top, from the edge above the toe.
    pub c: Option<f64>,
    /// Width that moves at all along the top, from the same edge; e ≥ c.
    pub e: Option<f64>,
    /// tan β = ((c + e)/2 − s) / H.
    pub tan_beta: f64,
    /// False where c or e changes with the threshold.
    pub sharp: bool,
}

/// c and e of a mechanism at one threshold, or `None` where nothing moves at the edge.
fn widths(scene: &Scene, mechanism: &Mechanism, threshold: f64) -> Option<(f64, f64)> {
    let (low, high) = scene.bounds();
    let tolerance = 1e-6 * (high.y - low.y);
    let edge = match scene.push {
        Push::Right => high.x,
        Push::Left => low.x,
    };
    // Top blocks by distance from the edge that the push points to.
    let mut top: Vec<(f64, f64, usize)> = Vec::new();
    for (i, block) in scene.blocks.iter().enumerate() {
        let (l, h) = block.shape.bounds();
        if (h.y - high.y).abs() < tolerance {
            let span = [(l.x - edge).abs(), (h.x - edge).abs()];
            top.push((span[0].min(span[1]), span[0].max(span[1]), i));
        }
    }
    top.sort_by(|a, b| a.0.total_cmp(&b.0));
    let first = top.first()?.2;
    let limit = threshold * mechanism.fastest(scene);
    let reach = |still: &dyn Fn(usize) -> bool| {
        let part = top.iter().take_while(|&&(_, _, block)| !still(block));
        part.map(|&(_, far, _)| far).fold(0.0, f64::max)
    };
    let e = reach(&|block| mechanism.speed(scene, block, None) <= limit);
    let c = reach(&|block| mechanism.speed(scene, block, Some(first)) > limit);
    (e > 0.0).then_some((c.min(e), e))
}

/// Crack slope at two thresholds (fractions of the largest corner velocity), the finer one
/// reported; `None` where the scene is no wall of units and halves, or nothing moves at its top edge.
pub fn crack_slope(scene: &Scene, mechanism: &Mechanism, thresholds: [f64; 2]) -> Option<Crack> {
    let wall = scene.coursed.filter(|wall| wall.halves)?;
    let (c, e) = widths(scene, mechanism, thresholds[0])?;
    let again = widths(scene, mechanism, thresholds[1]);
    let same = |(c2, e2): (f64, f64)| {
        let tolerance = 1e-6 * wall.height;
        (c2 - c).abs() < tolerance && (e2 - e).abs() < tolerance
    };
    Some(Crack {
        c: Some(c),
        e: Some(e),
        tan_beta: ((c + e) / 2.0 - wall.overlap) / wall.height,
        sharp: again.is_some_and(same),
    })
}

/// Thresholds for velocities of a linear program: 1e-6 as defined, repeated at 1e-4.
pub const VELOCITY_THRESHOLDS: [f64; 2] = [1e-6, 1e-4];
