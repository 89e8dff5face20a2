//! Motions in unknowns of which one is the live load's power.
//!
//! The power is a sum over all blocks: as a term of the linear systems it would couple each of them
//! with every other one. So the velocity of a block in the direction of its load gives way to the
//! power of all blocks up to it, in some order. Each joint then has a few unknowns more, and the whole
//! power is a single one: that of the last block.

use nalgebra::DMatrix;

use super::lift::Columns;
use crate::answer::certificate::{Conditions, Entry};

/// How rates follow from a motion's unknowns, as many as there are velocities.
pub(super) struct Motion {
    /// Of every joint: the openings of its corners, and its slip.
    pub(super) joints: Vec<[Vec<Entry>; 3]>,
    /// Of the live load's power.
    pub(super) power: Vec<Entry>,
    unknowns: usize,
}

impl Motion {
    /// In the velocities of the blocks.
    pub(super) fn of_velocities(conditions: &Conditions) -> Self {
        let live = conditions.live.iter().copied().enumerate();
        let joints = conditions.joints.iter();
        Self {
            joints: joints.map(|joint| joint.rates.clone()).collect(),
            power: live.filter(|entry| entry.1 != 0.0).collect(),
            unknowns: conditions.velocities(),
        }
    }

    /// In velocities and sums of the power along the blocks in this order. A sum is over the live load
    /// of its last block in the direction in which that is largest, so that it is a velocity too.
    pub(super) fn with_sums(conditions: &Conditions, order: &[usize]) -> Self {
        let plain = Self::of_velocities(conditions);
        // What the velocities that give way are, in what takes their place.
        let mut replaced: Vec<Option<Vec<Entry>>> = vec![None; plain.unknowns];
        let mut sum: Option<Entry> = None;
        for &block in order {
            let own = (3 * block..3 * block + 3).map(|k| (k, conditions.live[k]));
            let own: Vec<Entry> = own.filter(|entry| entry.1 != 0.0).collect();
            let largest = own.iter().max_by(|a, b| a.1.abs().total_cmp(&b.1.abs()));
            let Some(&(at, load)) = largest else {
                continue;
            };
            let others = own.iter().filter(|entry| entry.0 != at).chain(&sum);
            let others = others.map(|&(k, value)| (k, -value / load));
            replaced[at] = Some([(at, 1.0)].into_iter().chain(others).collect());
            sum = Some((at, load));
        }
        let in_sums = |entries: &[Entry]| {
            let mut found: Vec<Entry> = Vec::new();
            for &(k, value) in entries {
                let unchanged = vec![(k, 1.0)];
                for &(other, factor) in replaced[k].as_ref().unwrap_or(&unchanged) {
                    match found.iter_mut().find(|entry| entry.0 == other) {
                        Some(entry) => entry.1 += value * factor,
                        None => found.push((other, value * factor)),
                    }
                }
            }
            found
        };
        let joints = plain.joints.iter();
        Self {
            joints: joints
                .map(|rates| [0, 1, 2].map(|kind| in_sums(&rates[kind])))
                .collect(),
            power: sum.into_iter().collect(),
            unknowns: plain.unknowns,
        }
    }

    /// The unknowns that meet in one rate, for each of them.
    pub(super) fn meetings(&self) -> impl Iterator<Item = Vec<usize>> {
        let rates = self.joints.iter().flatten().chain([&self.power]);
        rates.map(|entries| entries.iter().map(|entry| entry.0).collect())
    }

    /// Columns of all rates: four a joint, then the power.
    pub(super) fn rates(&self, unknowns: &Columns) -> DMatrix<f64> {
        let velocities = &unknowns.velocities;
        let mut rates = DMatrix::zeros(velocities.nrows(), 4 * self.joints.len() + 1);
        let mut combine = |at: usize, entries: &[Entry], sign: f64| {
            for &(k, value) in entries {
                let mut column = rates.column_mut(at);
                column.axpy(sign * value, &velocities.column(k), 1.0);
            }
        };
        for (j, joint) in self.joints.iter().enumerate() {
            combine(4 * j, &joint[0], 1.0);
            combine(4 * j + 1, &joint[1], 1.0);
            combine(4 * j + 3, &joint[2], -1.0);
        }
        combine(4 * self.joints.len(), &self.power, 1.0);
        for (j, slip) in unknowns.slips.column_iter().enumerate() {
            rates.set_column(4 * j + 2, &slip);
            let mut backward = rates.column_mut(4 * j + 3);
            backward += slip;
        }
        rates
    }

    /// The transpose of [`Motion::rates`].
    pub(super) fn of_rates(&self, rates: &DMatrix<f64>) -> Columns {
        let mut out = Columns {
            velocities: DMatrix::zeros(rates.nrows(), self.unknowns),
            slips: DMatrix::zeros(rates.nrows(), self.joints.len()),
        };
        let mut spread = |at: usize, entries: &[Entry], sign: f64| {
            for &(k, value) in entries {
                let mut column = out.velocities.column_mut(k);
                column.axpy(sign * value, &rates.column(at), 1.0);
            }
        };
        for (j, joint) in self.joints.iter().enumerate() {
            spread(4 * j, &joint[0], 1.0);
            spread(4 * j + 1, &joint[1], 1.0);
            spread(4 * j + 3, &joint[2], -1.0);
        }
        spread(4 * self.joints.len(), &self.power, 1.0);
        for j in 0..self.joints.len() {
            out.slips
                .set_column(j, &(rates.column(4 * j + 2) + rates.column(4 * j + 3)));
        }
        out
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::method::limit::walls::wall;
    use crate::scene::Push;

    /// Rates of velocities are those of the same motion in sums, whose last one is its power.
    #[test]
    fn sums_describe_the_same_motions() {
        let conditions = Conditions::of(&wall(3, Push::Right));
        let blocks = conditions.velocities() / 3;
        let joints = conditions.joints.len();
        let order: Vec<usize> = (0..blocks).rev().collect();
        let (plain, sums) = (
            Motion::of_velocities(&conditions),
            Motion::with_sums(&conditions, &order),
        );
        let columns = |of: &dyn Fn(usize) -> f64| Columns {
            velocities: DMatrix::from_fn(1, 3 * blocks, |_, k| of(k)),
            slips: DMatrix::from_fn(1, joints, |_, j| (j as f64).cos()),
        };
        let velocity = |k: usize| (2.0 + k as f64).sin();
        let live = &conditions.live;
        let of_velocity = |k: usize| live[k] * velocity(k);
        let power = |block: usize| (3 * block..3 * block + 3).map(of_velocity).sum::<f64>();
        let in_sums = columns(&|k| {
            let block = k / 3;
            // The push is horizontal; the overburden's has a moment too.
            if k % 3 != 0 {
                return velocity(k);
            }
            (block..blocks).map(power).sum::<f64>() / live[k]
        });
        let (expected, found) = (plain.rates(&columns(&velocity)), sums.rates(&in_sums));
        assert!((expected - &found).amax() < 1e-12);
        assert_eq!(sums.power.len(), 1);

        let multipliers = DMatrix::from_fn(1, found.ncols(), |_, rate| (rate as f64).sin());
        let transposed = sums.of_rates(&multipliers).dot(&in_sums);
        assert!((found.dot(&multipliers) - transposed).abs() < 1e-12);
    }
}
