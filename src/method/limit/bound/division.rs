//! Which product a branch is divided by: it is tried.
//!
//! No number of a lift tells what a division by a product gains: on a wall of 17 blocks divisions by the
//! six products that its lift violates most gained nothing, and the seventh closed the gap. So one is
//! tried after the other (strong branching of mixed-integer programming), those first that gained most
//! elsewhere. What gained nothing is forgotten, so that it does not double the branches that follow.

use std::collections::BTreeMap;

use super::branches::Leaf;
use super::slices::{Goal, Search, Slices};
use crate::answer::Budget;
use crate::certificate::{Slice, SliceProof};

/// What divisions by each product have gained: their sum and number.
#[derive(Default)]
pub(super) struct Gains(BTreeMap<usize, (f64, usize)>);

impl Gains {
    /// Notes what a division by a product gained.
    fn add(&mut self, pair: usize, gain: f64) {
        let own = self.0.entry(pair).or_default();
        *own = (own.0 + gain, own.1 + 1);
    }

    /// What a division by a product can be expected to gain: the mean of those by it, or else of all.
    fn expected(&self, pair: usize) -> f64 {
        let all = (self.0.values()).fold((0.0, 0), |all, own| (all.0 + own.0, all.1 + own.1));
        let (sum, times) = self.0.get(&pair).copied().unwrap_or(all);
        sum / times.max(1) as f64
    }

    /// Products in the order in which divisions by them are tried; of equals, as they are given.
    fn in_order(&self, violated: &[usize]) -> Vec<usize> {
        let mut order = violated.to_vec();
        order.sort_by(|&a, &b| self.expected(b).total_cmp(&self.expected(a)));
        order
    }
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
        let mut best: Option<(f64, Vec<Leaf>, Vec<(Slice, SliceProof)>)> = None;
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
            if best.as_ref().is_none_or(|(most, ..)| gain > *most) {
                best = Some((gain, parts.into(), slices));
            }
            if gain >= own.least_division {
                break;
            }
        }
        let Some((_, parts, slices)) = best else {
            return Ok(Vec::new());
        };
        found.slices.extend(slices);
        Ok(parts)
    }
}
