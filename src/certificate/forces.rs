//! How large all forces together can be: what the proof of a certificate multiplies rounding by.

use super::conditions::{Conditions, Entry, JointRows};
use super::types::Refusal;

/// Outward rounding of the few sums that are not computed in twice the precision: their terms are
/// all positive, so that no sum is wrong by more than its number of terms times 1.2e-16.
pub(super) const OUTWARD: f64 = 1.0 + 1e-9;

/// Σ ε N ≤ dead + λ · live over all joints, for every force state.
pub(super) struct ForceBound {
    /// What each joint opens beyond μ|slip|, at least.
    pub(super) margin: Vec<f64>,
    dead: f64,
    live: f64,
}

impl ForceBound {
    pub(super) fn of(conditions: &Conditions, motion: &[f64]) -> Result<Self, Refusal> {
        if motion.len() != conditions.velocities() {
            return Err(Refusal::Size);
        }
        if !motion.iter().all(|v| v.is_finite()) {
            return Err(Refusal::NotFinite);
        }
        // A sum of at most a few hundred terms, and what it may be wrong by.
        let product = |row: &mut dyn Iterator<Item = Entry>| {
            let mut count = 0;
            let terms = row.map(|(k, value)| {
                count += 1;
                value * motion[k]
            });
            let (sum, magnitude) = terms.fold((0.0, 0.0), |(s, m), t: f64| (s + t, m + t.abs()));
            (sum, magnitude * f64::EPSILON * f64::from(count + 2))
        };
        let margin = |(index, joint): (usize, &JointRows)| {
            let [one, other, slip] = joint
                .rates
                .each_ref()
                .map(|row| product(&mut row.iter().copied()));
            let opening = (one.0 - one.1).min(other.0 - other.1);
            let slip = joint.friction * (slip.0.abs() + slip.1);
            let margin = opening - slip - f64::EPSILON * 4.0 * (opening.abs() + slip);
            if margin > 0.0 {
                Ok(margin)
            } else {
                Err(Refusal::Locks { joint: index })
            }
        };
        let margin = conditions.joints.iter().enumerate().map(margin);
        let margin = margin.collect::<Result<_, _>>()?;
        let power = |load: &[f64]| product(&mut load.iter().copied().enumerate());
        let (dead, live) = (power(&conditions.dead), power(&conditions.live));
        Ok(Self {
            margin,
            dead: -dead.0 + dead.1,
            live: live.0.abs() + live.1,
        })
    }

    /// Σ ε N at most, for λ* up to `to`; where that is infinite, over 1 + λ* for every λ* ≥ 0.
    pub(super) fn total(&self, to: f64) -> f64 {
        let most = match to.is_finite() {
            true => self.dead + to.abs() * self.live,
            false => self.dead.max(self.live),
        };
        most.max(0.0) * OUTWARD
    }
}
