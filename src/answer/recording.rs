//! What follows a collapse.

use serde::{Deserialize, Serialize};

use crate::mechanics::Mechanism;

/// How the blocks move from when a collapse was called until some point has moved by a course height H,
/// or for 100 √(H/g). Here the motions are displacements since the scene settled: of the
/// centroid in the scene's unit of length, and rotations in radians, neither of them small.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Recording {
    /// States, a constant time apart.
    pub frames: Vec<Mechanism>,
    /// Time between two of them, in √(L/g), L being the scene's unit of length: times 0.319 in seconds,
    /// where that is the metre.
    pub interval: f64,
}
