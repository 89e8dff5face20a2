//! What every method does.

use std::time::Duration;

use super::Settings;
use crate::answer::Outcome;
use crate::scene::Scene;

/// A way to find the collapse multiplier of a scene. It sees neither another method's answer nor
/// a published value, and holds no clock.
pub trait Method: Sync {
    /// The name in tables, cases and on the command line.
    fn name(&self) -> &str;

    /// Texts that determine the answer beyond the scene, the settings and this program: for an outside
    /// program its command.
    fn determined_by(&self) -> Vec<String> {
        Vec::new()
    }

    /// The answer for one scene. Every ending is a status; nothing here panics on a valid scene.
    fn solve(&self, scene: &Scene, settings: &Settings) -> Outcome;

    /// The same with the CPU time spent, from a method that works in a process of its own, where the
    /// runner's clock cannot see it; `None` from all others.
    fn solve_timed(&self, scene: &Scene, settings: &Settings) -> (Outcome, Option<Duration>) {
        (self.solve(scene, settings), None)
    }
}

impl<M: Method + ?Sized> Method for &M {
    fn name(&self) -> &str {
        (**self).name()
    }

    fn determined_by(&self) -> Vec<String> {
        (**self).determined_by()
    }

    fn solve(&self, scene: &Scene, settings: &Settings) -> Outcome {
        (**self).solve(scene, settings)
    }

    fn solve_timed(&self, scene: &Scene, settings: &Settings) -> (Outcome, Option<Duration>) {
        (**self).solve_timed(scene, settings)
    }
}
