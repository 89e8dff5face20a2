//! A grid: what is varied, on which scenes, against which value.

use crate::method::{Kind, Settings};
use crate::scene::Scene;

/// A grid over two properties that make methods fail.
pub struct Grid {
    /// A word for file names.
    pub name: &'static str,
    /// What is varied from left to right, with its unit.
    pub x: &'static str,
    /// What is varied from bottom to top, with its unit.
    pub y: &'static str,
    /// The kinds of methods that it says something about; empty: all.
    pub kinds: &'static [Kind],
    /// What it shows, where methods fail in it, and why.
    pub causes: &'static str,
    /// Its cells, row by row.
    pub cells: Vec<GridPoint>,
}

/// A place on a grid: one scene and setting, and what the answer must be.
pub struct GridPoint {
    /// Value from left to right.
    pub x: String,
    /// Value from bottom to top.
    pub y: String,
    /// The scene.
    pub scene: Box<dyn Fn() -> Scene + Send + Sync>,
    /// Number of blocks.
    pub blocks: usize,
    /// Settings of the methods.
    pub settings: Settings,
    /// The multiplier, from elsewhere than the methods.
    pub reference: f64,
    /// How far the reference itself may be off, relative.
    pub accuracy: f64,
}
