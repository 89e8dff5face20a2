//! From the scene's lengths to pixels.

use super::svg::Pixel;
use crate::mechanics::Mechanism;
use crate::scene::{Point, Scene, Side, Vector};

/// Where a scene lies in a drawing.
#[derive(Clone, Copy, Debug)]
pub struct Frame {
    /// Pixels for a unit of length.
    pub scale: f64,
    /// The scene's lower-left corner, and where it lies.
    pub corner: (Point, Pixel),
}

impl Frame {
    pub fn at(&self, point: Point) -> Pixel {
        let (low, [x, y]) = self.corner;
        [
            x + self.scale * (point.x - low.x),
            y - self.scale * (point.y - low.y),
        ]
    }
}

/// Displacement that the fastest corner is shown with, as a part of the scene's smaller side.
const FASTEST: f64 = 0.11;

/// How a mechanism is shown: every point moved along its velocity.
#[derive(Clone, Copy)]
pub struct Displacement<'a> {
    scene: &'a Scene,
    mechanism: Option<&'a Mechanism>,
    /// What displacements are multiplied by.
    pub factor: f64,
}

impl<'a> Displacement<'a> {
    /// The mechanism, amplified so that its fastest corner moves by a fixed part of the scene's size;
    /// `None` leaves every block in its place.
    pub fn new(scene: &'a Scene, mechanism: Option<&'a Mechanism>) -> Self {
        let (low, high) = scene.bounds();
        let least = (high.x - low.x)
            .min(high.y - low.y)
            .max(0.5 * scene.height());
        let fastest = mechanism.map_or(0.0, |mechanism| mechanism.fastest(scene));
        Self {
            scene,
            mechanism,
            factor: if fastest > 0.0 {
                FASTEST * least / fastest
            } else {
                0.0
            },
        }
    }

    /// Displacement of a point that moves with a block.
    fn by(&self, block: usize, point: Point) -> Vector {
        let Some(mechanism) = self.mechanism else {
            return Vector::zeros();
        };
        let arm = point - self.scene.blocks()[block].shape.centroid();
        mechanism.motions[block].at(arm) * self.factor
    }

    /// A point that moves with one side of a joint.
    pub fn on(&self, side: Side, point: Point) -> Point {
        match side {
            Side::Block(block) => point + self.by(block, point),
            Side::Support(_) => point,
        }
    }

    pub fn corners(&self, block: usize) -> impl Iterator<Item = Point> + '_ {
        let corners = self.scene.blocks()[block].shape.corners().iter();
        corners.map(move |&corner| corner + self.by(block, corner))
    }

    /// Lower-left and upper-right corner of all blocks, in their place and displaced.
    pub fn bounds(&self) -> (Point, Point) {
        let blocks = 0..self.scene.blocks().len();
        let corners = blocks.flat_map(|block| self.corners(block));
        corners.fold(self.scene.bounds(), |(low, high), corner| {
            (low.inf(&corner), high.sup(&corner))
        })
    }
}
