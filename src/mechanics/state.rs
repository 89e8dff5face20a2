//! Forces of the joints, and collapse states made of forces and mechanism.

use serde::{Deserialize, Serialize};

use super::mechanism::Mechanism;

/// Forces of one joint, in the case's force unit.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct JointForce {
    /// Normal force at each end of the joint, compression positive.
    pub normal: [f64; 2],
    /// Shear on the block that the normal points into, along the joint's tangent.
    pub shear: f64,
}

/// Forces of every joint, and the multiplier at which they are in equilibrium.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct ForceState {
    /// Multiplier of the forces.
    pub lambda: f64,
    /// Forces of every joint.
    pub forces: Vec<JointForce>,
}

/// A mechanism with dilatancy, and the upper bound that it proves of every collapse multiplier.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Ceiling {
    /// The bound: no less than the mechanism's own multiplier.
    pub lambda: f64,
    /// Velocities of every block.
    pub mechanism: Mechanism,
}

/// A non-associative collapse state: forces and mechanism that satisfy every condition together.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct CollapseState {
    /// Multiplier of the forces.
    pub lambda: f64,
    /// Forces of every joint.
    pub forces: Vec<JointForce>,
    /// Velocities of every block.
    pub mechanism: Mechanism,
}
