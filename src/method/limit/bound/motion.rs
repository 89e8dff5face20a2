//! Motions in unknowns of which one is the live load's power.
//!
//! The power is a sum over all blocks: as a term of the linear systems it would couple each of them
//! with every other one. So the velocity of a block in the direction of its load gives way to the
//! power of all blocks up to it, in some order. Each joint then has a few unknowns more, and the whole
//! power is a single one: that of the last block.

use nalgebra::DMatrix;

use super::parameters::{DEPENDENT, ROUNDING};
use crate::certificate::{Conditions, Entry};

/// How rates follow from a motion's unknowns: the velocities, then the forward slip of every joint.
#[derive(Clone, Debug)]
pub(super) struct Motion {
    /// Every rate in the unknowns: four a joint, the power, then those of slip bounds.
    pub(super) rows: Vec<Vec<Entry>>,
    /// Row of the live load's power among them.
    pub(super) power: usize,
    pub(super) unknowns: usize,
}

/// A rate that is zero, and the unknown that follows from others for it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Pivot {
    pub(super) rate: usize,
    pub(super) unknown: usize,
}

impl Motion {
    /// One rate alone, which is its own unknown.
    pub(super) fn of_one_rate() -> Self {
        Self {
            rows: vec![vec![(0, 1.0)]],
            power: 0,
            unknowns: 1,
        }
    }

    /// In the velocities of the blocks.
    pub(super) fn of_velocities(conditions: &Conditions) -> Self {
        let rates = 0..=conditions.power();
        let mut rows: Vec<Vec<Entry>> = rates.map(|rate| conditions.rate_row(rate)).collect();
        for bound in &conditions.slip_bounds {
            let forward = (4 * bound.joint + 2, -1.0);
            let shares = bound.shares.iter().copied().chain([forward]);
            rows.push(combined(shares, |rate| rows[rate].clone()));
        }
        Self {
            rows,
            power: conditions.power(),
            unknowns: conditions.motions(),
        }
    }

    /// Without the unknowns that follow from others where these rates are zero, and which of these rates
    /// each of them follows from: what is left of the others are the rates of all such motions. Rates that
    /// follow from others are left out.
    pub(super) fn where_zero(
        mut self,
        conditions: &Conditions,
        is_zero: impl Fn(usize) -> bool,
    ) -> (Self, Vec<Pivot>) {
        let mut followed = Substitution::none(self.unknowns);
        let mut pivots = Vec::new();
        for rate in (0..self.rows.len()).filter(|&rate| is_zero(rate)) {
            let row = followed.of(&self.rows[rate]);
            let largest = row
                .iter()
                .fold(0.0, |most: f64, entry| most.max(entry.1.abs()));
            if largest < DEPENDENT {
                continue;
            }
            // A slip stands in few rates, a velocity in many.
            let is_slip = |entry: &&Entry| entry.0 >= conditions.velocities();
            let velocity = || row.iter().max_by(|a, b| a.1.abs().total_cmp(&b.1.abs()));
            let pivot = row.iter().find(is_slip).or_else(velocity);
            let &(unknown, value) = pivot.expect("the row is not empty");
            let others = row.iter().filter(|entry| entry.0 != unknown);
            let others = others.filter(|entry| entry.1.abs() > DEPENDENT * largest);
            let others = others.map(|&(k, other)| (k, -other / value)).collect();
            followed.replace(unknown, others);
            pivots.push(Pivot { rate, unknown });
        }
        for (rate, row) in self.rows.iter_mut().enumerate() {
            *row = if is_zero(rate) {
                Vec::new()
            } else {
                followed.of(row)
            };
        }
        (self, pivots)
    }

    /// In sums of the power along the blocks in this order, instead of one velocity each. A sum is over
    /// the velocities of its last block, in the direction in which their power is largest, so that it is a
    /// velocity too. Where that is less than this share of another term of the sum, the block's power goes
    /// on to the next sum: divided by it, the others would be large.
    pub(super) fn with_sums(
        mut self,
        conditions: &Conditions,
        order: &[usize],
        least_share: f64,
    ) -> Self {
        let mut in_sums = Substitution::none(self.unknowns);
        let larger = |a: &Entry, b: &Entry| a.1.abs().total_cmp(&b.1.abs());
        // The last sum, and what is not in it.
        let mut terms: Vec<Entry> = Vec::new();
        for &block in order {
            // Supports that move have one velocity, the last.
            let own = 3 * block..(3 * block + 3).min(conditions.velocities());
            let own = self.power().iter().filter(|entry| own.contains(&entry.0));
            let own: Vec<Entry> = own.copied().collect();
            let largest = own.iter().copied().max_by(larger);
            terms.extend(own);
            let Some((at, load)) = largest else {
                continue;
            };
            if terms
                .iter()
                .any(|term| load.abs() < least_share * term.1.abs())
            {
                continue;
            }
            let others = terms.iter().filter(|entry| entry.0 != at);
            let others = others.map(|&(k, value)| (k, -value / load));
            in_sums.0[at] = Some([(at, 1.0)].into_iter().chain(others).collect());
            terms = vec![(at, load)];
        }
        self.rows = self.rows.iter().map(|row| in_sums.of(row)).collect();
        // The sum of all, without what rounding leaves of the others.
        self.rows[self.power] = terms;
        self
    }

    /// With the unknowns alone that stand in a rate.
    pub(super) fn numbered(mut self) -> Self {
        let mut places = vec![None; self.unknowns];
        for &(k, _) in self.rows.iter().flatten() {
            places[k] = Some(());
        }
        let mut count = 0..;
        let places: Vec<Option<usize>> = (places.iter())
            .map(|stands| stands.and_then(|()| count.next()))
            .collect();
        for (k, _) in self.rows.iter_mut().flatten() {
            *k = places[*k].expect("it stands in a rate");
        }
        self.unknowns = places.iter().flatten().count();
        self
    }

    /// The unknowns that meet in one rate, for each of them.
    pub(super) fn meetings(&self) -> impl Iterator<Item = Vec<usize>> {
        let unknowns = |entries: &Vec<Entry>| entries.iter().map(|entry| entry.0).collect();
        self.rows.iter().map(unknowns)
    }

    /// The live load's power.
    pub(super) fn power(&self) -> &[Entry] {
        &self.rows[self.power]
    }

    /// Columns of all rates, from those of the unknowns.
    pub(super) fn rates(&self, unknowns: &DMatrix<f64>) -> DMatrix<f64> {
        let mut rates = DMatrix::zeros(unknowns.nrows(), self.rows.len());
        for (mut rate, entries) in rates.column_iter_mut().zip(&self.rows) {
            for &(k, value) in entries {
                rate.axpy(value, &unknowns.column(k), 1.0);
            }
        }
        rates
    }

    /// The transpose of [`Motion::rates`].
    pub(super) fn of_rates(&self, rates: &DMatrix<f64>) -> DMatrix<f64> {
        let mut unknowns = DMatrix::zeros(rates.nrows(), self.unknowns);
        for (rate, entries) in rates.column_iter().zip(&self.rows) {
            for &(k, value) in entries {
                unknowns.column_mut(k).axpy(value, &rate, 1.0);
            }
        }
        unknowns
    }
}

/// What takes the place of unknowns; the others stay.
struct Substitution(Vec<Option<Vec<Entry>>>);

impl Substitution {
    fn none(unknowns: usize) -> Self {
        Self(vec![None; unknowns])
    }

    /// What a row becomes.
    fn of(&self, row: &[Entry]) -> Vec<Entry> {
        combined(row.iter().copied(), |k| {
            self.0[k].clone().unwrap_or_else(|| vec![(k, 1.0)])
        })
    }

    /// Puts others in the place of an unknown, everywhere.
    fn replace(&mut self, unknown: usize, by: Vec<Entry>) {
        let mut one = Self::none(self.0.len());
        one.0[unknown] = Some(by);
        for row in self.0.iter_mut().flatten() {
            if row.iter().any(|entry| entry.0 == unknown) {
                *row = one.of(row);
            }
        }
        self.0[unknown] = one.0[unknown].take();
    }
}

/// A combination of rows, without what cancels.
fn combined(entries: impl Iterator<Item = Entry>, row: impl Fn(usize) -> Vec<Entry>) -> Vec<Entry> {
    let mut found: Vec<(Entry, f64)> = Vec::new();
    for (place, value) in entries {
        for (k, factor) in row(place) {
            let part = value * factor;
            match found.iter_mut().find(|(entry, _)| entry.0 == k) {
                Some((entry, magnitude)) => {
                    entry.1 += part;
                    *magnitude += part.abs();
                }
                None => found.push(((k, part), part.abs())),
            }
        }
    }
    let is_left = |&(entry, magnitude): &(Entry, f64)| entry.1.abs() > ROUNDING * magnitude;
    found
        .into_iter()
        .filter(is_left)
        .map(|(entry, _)| entry)
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::method::Settings;
    use crate::method::limit::interval::lowest;
    use crate::method::limit::walls::wall;
    use crate::scene::Push;

    /// Rates of velocities are those of the same motion in sums, whose last one is its power.
    #[test]
    fn sums_describe_the_same_motions() {
        let scene = wall(3, Push::Right);
        let conditions = Conditions::of(&scene).with_slip_bounds(&scene);
        let blocks = conditions.velocities() / 3;
        let order: Vec<usize> = (0..blocks).rev().collect();
        let (plain, sums) = (
            Motion::of_velocities(&conditions),
            Motion::of_velocities(&conditions).with_sums(&conditions, &order, 0.1),
        );
        let columns = |of: &dyn Fn(usize) -> f64| {
            DMatrix::from_fn(1, plain.unknowns, |_, k| {
                if k < 3 * blocks {
                    of(k)
                } else {
                    (k as f64).cos()
                }
            })
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
        assert!((expected - &found).amax() < 1e-11);
        assert_eq!(sums.power().len(), 1);

        let multipliers = DMatrix::from_fn(1, found.ncols(), |_, rate| (rate as f64).sin());
        let transposed = sums.of_rates(&multipliers).dot(&in_sums);
        assert!((found.dot(&multipliers) - transposed).abs() < 1e-11);
    }

    /// Slips of verified collapse states are within their bounds, all rates not negative.
    #[test]
    fn slips_of_collapse_states_are_within_their_bounds() {
        let scene = wall(4, Push::Right);
        let conditions = Conditions::of(&scene).with_slip_bounds(&scene);
        assert!(!conditions.slip_bounds.is_empty());
        let motion = Motion::of_velocities(&conditions);
        let found = lowest(&scene, &Settings::default(), f64::NEG_INFINITY);
        assert!(!found.evidence.states().is_empty());
        for state in found.evidence.states() {
            let velocities = state.mechanism.motions.iter().map(|&motion| motion.into());
            let scaled =
                velocities.flat_map(|[x, y, turn]: [f64; 3]| [x, y, turn * scene.height()]);
            let mut unknowns: Vec<f64> = scaled.collect();
            let largest = unknowns.iter().fold(0.0, |most: f64, v| most.max(v.abs()));
            for joint in &conditions.joints {
                let slip = joint.rates[2].iter().map(|&(k, value)| value * unknowns[k]);
                let slip: f64 = slip.sum();
                unknowns.push(slip.max(0.0));
            }
            let rates = motion.rates(&DMatrix::from_row_slice(1, motion.unknowns, &unknowns));
            assert!(rates.iter().all(|rate| *rate > -1e-6 * largest), "{rates}");
        }
    }
}
