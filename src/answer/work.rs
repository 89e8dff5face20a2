//! Effort in counts.

use std::ops::Add;

use serde::{Deserialize, Serialize};

/// Effort in counts that do not depend on the machine's speed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Work {
    /// Blocks that were modelled as movable; 0 where the method does not count them.
    pub modelled: usize,
    /// Linear programs solved.
    pub programs: usize,
    /// Interior-point iterations over all programs.
    pub iterations: usize,
    /// Time steps of the pushover, times the blocks that can move.
    pub block_steps: usize,
    /// Linear programs that another solver had to solve than the one that was asked for.
    pub fallbacks: usize,
}

impl Add for Work {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self {
            modelled: self.modelled + other.modelled,
            programs: self.programs + other.programs,
            iterations: self.iterations + other.iterations,
            block_steps: self.block_steps + other.block_steps,
            fallbacks: self.fallbacks + other.fallbacks,
        }
    }
}
