//! What every method does.

use std::sync::Arc;
use std::time::Duration;

use super::Settings;
use crate::answer::Outcome;
use crate::certificate::{Certificate, Proved};
use crate::scene::{Push, Scene};

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

    /// The same; `watch` is told of what is proved meanwhile. With the CPU time spent, from a method that
    /// works in a process of its own, where the runner's clock cannot see it; `None` from all others.
    fn solve_watched(
        &self,
        scene: &Scene,
        settings: &Settings,
        _watch: &dyn Watch,
    ) -> (Outcome, Option<Duration>) {
        (self.solve(scene, settings), None)
    }
}

/// Who is told of a lower bound each time that it has grown, while the method goes on.
pub trait Watch: Sync {
    /// It has grown to what `so_far` makes, which takes a moment.
    fn proved(&self, _so_far: &dyn Fn() -> SoFar) {}
}

/// Nobody.
impl Watch for () {}

/// A lower bound that a method has proved so far.
#[derive(Clone, Debug)]
pub struct SoFar {
    /// Direction of the push of the scene that it is about.
    pub push: Push,
    /// Whether λ is the change of a support's reaction.
    pub of_reaction: bool,
    pub proved: Proved,
    /// λ of the lowest verified state.
    pub state: f64,
    /// What proves it.
    pub certificate: Arc<Certificate>,
}
