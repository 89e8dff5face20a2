//! The methods: one file or folder each, one list that names them, one small trait.

pub mod limit;
pub mod macro_block;
mod outcome;
pub mod pushover;

pub use outcome::{Bracket, CollapseState, JointForce, Outcome, Status, Work};

use crate::scene::Scene;

/// A way to find the collapse multiplier of a scene. It sees neither another method's answer nor
/// a published value, and holds no clock.
pub trait Method: Sync {
    /// The name in tables, cases and on the command line.
    fn name(&self) -> &'static str;

    /// The answer for one scene. Every ending is a status; nothing here panics on a valid scene.
    fn solve(&self, scene: &Scene, settings: &Settings) -> Outcome;
}

/// What a user may change about the methods; the defaults are what tables show.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Settings {
    /// Starts of the interval's search.
    pub starts: usize,
    /// Error that the pushover may state.
    pub accuracy: Accuracy,
    /// Whether the pushover repeats itself with half the substep, mirrored and without kinetic
    /// damping, and gives no number where that changes it.
    pub verify: bool,
    /// What the pushover calls collapse.
    pub collapse: Collapse,
    /// Whether the pushover keeps how the blocks moved in the collapse.
    pub recording: bool,
    /// Whether the pushover varies head joints in contact on walls of any number of blocks.
    pub long_ranges: bool,
}

impl Default for Settings {
    fn default() -> Self {
        Self {
            starts: 2,
            accuracy: Accuracy::Normal,
            verify: false,
            collapse: Collapse::Runaway,
            recording: false,
            long_ranges: false,
        }
    }
}

/// How accurate the pushover has to be; everything else about it follows.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Accuracy {
    /// 1 %; 2 % above 30 courses.
    Coarse,
    /// 0.2 %; 0.4 % above 30 courses.
    #[default]
    Normal,
    /// 0.05 %; 0.2 % above 30 courses.
    Fine,
}

impl Accuracy {
    /// The error that a bracket states, relative to λ: of either end against the limit.
    pub fn stated_error(self, courses: f64) -> f64 {
        let tall = courses > 30.0;
        match self {
            Accuracy::Coarse if tall => 2e-2,
            Accuracy::Coarse => 1e-2,
            Accuracy::Normal if tall => 4e-3,
            Accuracy::Normal => 2e-3,
            Accuracy::Fine if tall => 2e-3,
            Accuracy::Fine => 5e-4,
        }
    }
}

/// What a pushover calls collapse.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Collapse {
    /// Blocks run away and do not slow down.
    #[default]
    Runaway,
    /// A joint has slipped by a thousandth of the course height, though it may come to rest.
    FirstSlip,
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
