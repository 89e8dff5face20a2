//! Which product a branch is divided by: it is tried.
//!
//! No number of a lift tells what a division by a product gains: on a wall of 17 blocks divisions by the
//! first seven products gained 1 % of the gap each, and the eighth closed it. So one is tried after the
//! other (strong branching of mixed-integer programming), those first that gained most elsewhere. What
//! gained nothing is forgotten, so that it does not double the branches that follow.

use super::branches::Leaf;
use super::slices::{Goal, Search, Slices};
use crate::answer::Budget;
use crate::certificate::{Slice, SliceProof};

/// A division that was tried.
struct Tried {
    gain: f64,
    parts: [Leaf; 2],
    /// The slices that raised its parts.
    slices: Vec<(Slice, SliceProof)>,
}

impl Search<'_> {
    /// The parts of a leaf after their first slices: of the first division that gains enough, or of the
    /// one that gains most. None where the leaf violates no product.
    pub(super) fn divide(
        &self,
        found: &mut Slices,
        leaf: &Leaf,
        goal: Goal,
    ) -> Result<Vec<Leaf>, Budget> {
        let own = &self.lift.parameters;
        let before = found.slices.len();
        let mut best: Option<Tried> = None;
        let order = found.gains.in_order(&leaf.violated);
        for pair in order.into_iter().take(own.divisions) {
            let mut parts = leaf.parts(pair);
            for part in &mut parts {
                if let Err(budget) = self.advance(found, part, goal) {
                    found.slices.truncate(before);
                    return Err(budget);
                }
            }
            let gain =
                |part: &Leaf| ((part.lower - leaf.lower) / (goal.state - leaf.lower)).min(1.0);
            let gain = parts.iter().map(gain).sum();
            found.gains.add(pair, gain);
            let slices = found.slices.split_off(before);
            if best.as_ref().is_none_or(|best| gain > best.gain) {
                best = Some(Tried {
                    gain,
                    parts,
                    slices,
                });
            }
            if gain >= own.least_division {
                break;
            }
        }
        let Some(best) = best else {
            return Ok(Vec::new());
        };
        found.slices.extend(best.slices);
        Ok(best.parts.into())
    }
}
