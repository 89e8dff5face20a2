//! Blocks and the forces on them.

use super::polygon::{Point, Polygon, Vector};

/// A force on a block at a point that moves with it: constant part `dead`, and `λ · live`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Load {
    /// Where both parts act.
    pub point: Point,
    /// Dead force.
    pub dead: Vector,
    /// Live force for a multiplier of 1.
    pub live: Vector,
}

/// A rigid block.
#[derive(Clone, Debug, PartialEq)]
pub struct Block {
    /// Outline.
    pub shape: Polygon,
    /// The block's own weight with its live part first, then what it carries.
    pub loads: Vec<Load>,
}

/// Force x, force y and moment (counter-clockwise) about a block's centroid.
pub type Wrench = [f64; 3];

impl Block {
    /// Resultant of the dead forces about the centroid.
    pub fn dead(&self) -> Wrench {
        self.resultant(|load| load.dead)
    }

    /// Resultant of the live forces about the centroid, for a multiplier of 1.
    pub fn live(&self) -> Wrench {
        self.resultant(|load| load.live)
    }

    /// Resultant of all forces about the centroid at this multiplier.
    pub fn loads_at(&self, lambda: f64) -> Wrench {
        let (dead, live) = (self.dead(), self.live());
        std::array::from_fn(|k| dead[k] + lambda * live[k])
    }

    fn resultant(&self, part: impl Fn(&Load) -> Vector) -> Wrench {
        let centroid = self.shape.centroid();
        self.loads.iter().fold([0.0; 3], |[x, y, m], load| {
            let force = part(load);
            let arm = load.point - centroid;
            [x + force.x, y + force.y, m + arm.perp(&force)]
        })
    }
}
