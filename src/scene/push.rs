//! Which way a scene is pushed, and what its head joints carry.

use serde::{Deserialize, Serialize};

use crate::text::worded;

worded! {
    /// Which way the live load pushes the wall.
    #[derive(Serialize, Deserialize)]
    Push {
        /// Towards +x: the toe is the lower right corner.
        Right = "right",
        /// Towards −x.
        Left = "left",
    }
}

impl Push {
    /// +1 for a push to the right, −1 to the left.
    pub fn sign(self) -> f64 {
        match self {
            Push::Right => 1.0,
            Push::Left => -1.0,
        }
    }
}

worded! {
    /// What the head joints (perpends) of a scene carry.
    #[derive(PartialOrd, Ord, Serialize, Deserialize)]
    HeadJoints {
        /// Coulomb contact.
        Contact = "contact",
        /// Nothing: dry-laid, the state before pushing.
        Open = "open",
    }
}

impl HeadJoints {
    /// How head joints are: `in contact` or `open`.
    pub fn in_words(self) -> &'static str {
        match self {
            HeadJoints::Contact => "in contact",
            HeadJoints::Open => "open",
        }
    }
}
