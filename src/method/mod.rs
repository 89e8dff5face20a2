//! The methods: one file or folder each, one list that names them, one small trait.

pub mod auto;
pub mod limit;
pub mod macro_block;
pub mod pushover;
mod settings;

pub use settings::{Accuracy, Collapse, Settings};

use std::time::Duration;

use crate::answer::Outcome;
use crate::scene::Scene;

/// A way to find the collapse multiplier of a scene. It sees neither another method's answer nor
/// a published value, and holds no clock.
pub trait Method: Sync {
    /// The name in tables, cases and on the command line.
    fn name(&self) -> &str;

    /// The answer for one scene. Every ending is a status; nothing here panics on a valid scene.
    fn solve(&self, scene: &Scene, settings: &Settings) -> Outcome;

    /// The same with the CPU time spent, from a method that works in a process of its own, where the
    /// runner's clock cannot see it; `None` from all others.
    fn solve_apart(&self, scene: &Scene, settings: &Settings) -> (Outcome, Option<Duration>) {
        (self.solve(scene, settings), None)
    }
}

impl<M: Method + ?Sized> Method for &M {
    fn name(&self) -> &str {
        (**self).name()
    }

    fn solve(&self, scene: &Scene, settings: &Settings) -> Outcome {
        (**self).solve(scene, settings)
    }

    fn solve_apart(&self, scene: &Scene, settings: &Settings) -> (Outcome, Option<Duration>) {
        (**self).solve_apart(scene, settings)
    }
}

/// Every method, in the order in which tables show them. A new one is one file and one line.
pub const METHODS: [&dyn Method; 6] = [
    &macro_block::MacroBlock,
    &limit::Associative,
    &limit::Sequential,
    &limit::Interval,
    &pushover::Pushover,
    &auto::Auto,
];

/// The methods of a run that names none: all but the last, which is made of the others and would
/// only repeat them.
pub fn defaults() -> &'static [&'static dyn Method] {
    const { METHODS.split_at(METHODS.len() - 1).0 }
}
