//! Which way a scene is pushed, and what its head joints carry.

use serde::{Deserialize, Serialize};

/// Which way the live load pushes the wall.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Push {
    /// Towards +x: the toe is the lower right corner.
    Right,
    /// Towards −x.
    Left,
}

impl Push {
    /// +1 for a push to the right, −1 to the left.
    pub fn sign(self) -> f64 {
        match self {
            Push::Right => 1.0,
            Push::Left => -1.0,
        }
    }

    /// The word that cases use.
    pub fn name(self) -> &'static str {
        match self {
            Push::Right => "right",
            Push::Left => "left",
        }
    }
}

/// What the head joints (perpends) of a scene carry.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
pub enum HeadJoints {
    /// Coulomb contact.
    Contact,
    /// Nothing: dry-laid, the state before pushing.
    Open,
}

impl HeadJoints {
    /// The word that cases and the command line use.
    pub fn name(self) -> &'static str {
        match self {
            HeadJoints::Contact => "contact",
            HeadJoints::Open => "open",
        }
    }
}
