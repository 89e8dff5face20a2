//! The methods: one file or folder each, one list that names them, one small trait.

pub mod limit;
pub mod macro_block;
mod outcome;
pub mod pushover;
mod settings;

pub use outcome::{Bracket, Claim, CollapseState, JointForce, Outcome, Status, Work};
pub use settings::{Accuracy, Collapse, Settings};

use crate::scene::Scene;

/// A way to find the collapse multiplier of a scene. It sees neither another method's answer nor
/// a published value, and holds no clock.
pub trait Method: Sync {
    /// The name in tables, cases and on the command line.
    fn name(&self) -> &str;

    /// The answer for one scene. Every ending is a status; nothing here panics on a valid scene.
    fn solve(&self, scene: &Scene, settings: &Settings) -> Outcome;
}

impl<M: Method + ?Sized> Method for &M {
    fn name(&self) -> &str {
        (**self).name()
    }

    fn solve(&self, scene: &Scene, settings: &Settings) -> Outcome {
        (**self).solve(scene, settings)
    }
}

/// Every method, in the order in which tables show them. A new one is one file and one line.
pub const METHODS: [&dyn Method; 5] = [
    &macro_block::MacroBlock,
    &limit::Associative,
    &limit::Sequential,
    &limit::Interval,
    &pushover::Pushover,
];

#[cfg(test)]
mod tests {
    /// A case may name methods that are planned, but every method here can be named.
    #[test]
    fn every_method_can_have_references() {
        for method in super::METHODS {
            assert!(crate::case::METHOD_NAMES.contains(&method.name()));
        }
    }
}
