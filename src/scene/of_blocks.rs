//! What single blocks of a coursed wall have of their own: names, weights, loads.

use std::collections::BTreeMap;

use super::assembly::Forces;

/// Names, weights and loads of single blocks, by the block's place in the scene.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct OfBlocks {
    /// Names, instead of course and piece.
    pub names: BTreeMap<usize, String>,
    /// Weights, instead of the specific weight of the units times the block's volume; positive.
    pub weights: BTreeMap<usize, f64>,
    /// Forces beside weights and overburden, and whether those two are live load as well.
    pub forces: Forces,
}

impl OfBlocks {
    /// Whether all blocks weigh as much as units do, and nothing else pushes: what the closed form
    /// supposes.
    pub fn is_plain(&self) -> bool {
        self.weights.is_empty() && self.forces == Forces::default()
    }
}
