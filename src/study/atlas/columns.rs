//! Columns of equal blocks but for their tops, alone or side by side.

use super::towers::{self, Tower};
use crate::scene::Scene;

/// Columns of equal blocks side by side, in one unit of length and one of force.
#[derive(Clone, Debug, PartialEq)]
pub struct Columns {
    /// Blocks of each column.
    pub courses: usize,
    /// Width of a block.
    pub width: f64,
    /// Height of a block.
    pub height: f64,
    /// Weight of the top block over that of each other one.
    pub mass_ratio: f64,
    /// Load on the top, dead and live, over the weight of the column.
    pub overburden: f64,
    /// Coefficient of friction.
    pub friction: f64,
    /// Number of columns.
    pub count: usize,
    /// Distance between columns.
    pub gap: f64,
}

impl Default for Columns {
    fn default() -> Self {
        Self {
            courses: 3,
            width: 1.0,
            height: 0.5,
            mass_ratio: 1.0,
            overburden: 0.0,
            friction: 0.6,
            count: 1,
            gap: 0.1,
        }
    }
}

impl Columns {
    fn towers(&self) -> Vec<Tower> {
        let column = |column: usize| {
            let axis = column as f64 * (self.width + self.gap) + self.width / 2.0;
            let mut tower = Tower::of_equal(axis, self.width, self.height, self.courses);
            if let Some(top) = tower.stones.last_mut() {
                top.weight = self.mass_ratio;
            }
            let weights = tower.stones.iter().map(|stone| stone.weight);
            tower.load = self.overburden * weights.sum::<f64>();
            tower
        };
        (0..self.count).map(column).collect()
    }

    /// The exact multiplier of the tower, see `Tower::multiplier`.
    pub fn multiplier(&self) -> f64 {
        towers::multiplier(&self.towers(), self.friction)
    }

    /// The scene.
    pub fn scene(&self) -> Scene {
        towers::scene(&self.towers(), self.friction)
    }
}
