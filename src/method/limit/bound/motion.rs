//! How the rates of a lift follow from the unknowns of a motion, and which unknowns meet in a rate.

use nalgebra::{DMatrix, DVector};

use super::parameters::{DEPENDENT, ROUNDING};
use super::pattern::Pattern;
use crate::certificate::{Conditions, Entry};

/// How rates follow from a motion's unknowns: the velocities, then the forward slip of every joint.
#[derive(Clone, Debug)]
pub(super) struct Motion {
    /// Every rate in the unknowns: four a joint, the power, then those of slip bounds.
    pub(super) rows: Vec<Vec<Entry>>,
    /// Row of the live load's power among them.
    pub(super) power: usize,
    pub(super) unknowns: usize,
    /// The unknowns of all motions, in those that are left.
    all: Vec<Vec<Entry>>,
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
            all: vec![vec![(0, 1.0)]],
        }
    }

    /// In the velocities of the blocks, and the forward slips of the joints.
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
            all: (0..conditions.motions()).map(|k| vec![(k, 1.0)]).collect(),
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
        for row in &mut self.all {
            *row = followed.of(row);
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

    /// Without the rates of slip bounds along ways of three joints.
    pub(super) fn leave_out_long_ways(&mut self, conditions: &Conditions) {
        let bounds = &mut self.rows[conditions.power() + 1..];
        for (row, bound) in bounds.iter_mut().zip(&conditions.slip_bounds) {
            if bound.is_long {
                row.clear();
            }
        }
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
        for row in &mut self.all {
            let left = row
                .iter()
                .filter_map(|&(k, value)| Some((places[k]?, value)));
            *row = left.collect();
        }
        self.unknowns = places.iter().flatten().count();
        self
    }

    /// Whether a rate is the live load's power, and one of several unknowns: each of these would meet every
    /// other one.
    pub(super) fn couples_all(&self, rate: usize) -> bool {
        rate == self.power && self.rows[rate].len() > 1
    }

    /// Which unknowns meet in a rate, but for one that couples all.
    pub(super) fn pattern(&self) -> Pattern {
        let rates = 0..self.rows.len();
        let rates = rates.filter(|&rate| !self.couples_all(rate));
        let meetings = rates.map(|rate| self.rows[rate].iter().map(|entry| entry.0).collect());
        Pattern::new(self.unknowns, meetings)
    }

    /// The live load's power.
    pub(super) fn power(&self) -> &[Entry] {
        &self.rows[self.power]
    }

    /// The dead load's power as a column of the unknowns.
    pub(super) fn dead_power(&self, conditions: &Conditions) -> DVector<f64> {
        let mut power = DVector::zeros(self.unknowns);
        for (row, dead) in self.all.iter().zip(&conditions.dead) {
            for &(k, value) in row {
                power[k] += dead * value;
            }
        }
        power
    }

    /// Columns of all rates, from those of the unknowns.
    pub(super) fn rates(&self, unknowns: &DMatrix<f64>) -> DMatrix<f64> {
        columns(&self.rows, unknowns)
    }

    /// Columns of the unknowns of all motions, from those of the unknowns that are left.
    pub(super) fn all(&self, unknowns: &DMatrix<f64>) -> DMatrix<f64> {
        columns(&self.all, unknowns)
    }

    /// Columns of the unknowns that are left, from those of all motions.
    pub(super) fn left_of(&self, all: &DMatrix<f64>) -> DMatrix<f64> {
        let place = |k: usize| self.all.iter().position(|row| row[..] == [(k, 1.0)]);
        let places = (0..self.unknowns).map(|k| place(k).expect("each is left of all"));
        all.select_columns(&places.collect::<Vec<usize>>())
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

/// Sums of columns.
fn columns(sums: &[Vec<Entry>], of: &DMatrix<f64>) -> DMatrix<f64> {
    let mut columns = DMatrix::zeros(of.nrows(), sums.len());
    for (mut column, entries) in columns.column_iter_mut().zip(sums) {
        for &(k, value) in entries {
            column.axpy(value, &of.column(k), 1.0);
        }
    }
    columns
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
    use crate::certificate::LongestWay;
    use crate::mechanics::CollapseState;
    use crate::method::Settings;
    use crate::method::limit::interval::lowest;
    use crate::method::limit::walls::wall;
    use crate::scene::{HeadJoints, Push, Scene, Wall};

    /// Slips of verified collapse states are within their bounds, all rates not negative.
    #[test]
    fn slips_of_collapse_states_are_within_their_bounds() {
        let of_courses = |friction| {
            let wall = Wall::laid([4.0, 1.75], friction, &["h1h", "11", "h1h", "11"]);
            wall.scene(HeadJoints::Open).unwrap()
        };
        let scenes = [wall(4, Push::Right), of_courses(0.65), of_courses(0.2)];
        for scene in scenes {
            let conditions = Conditions::of(&scene);
            let conditions = conditions.with_slip_bounds(&scene, LongestWay::ThreeJoints);
            assert!(!conditions.slip_bounds.is_empty());
            let found = lowest(&scene, &Settings::default(), f64::NEG_INFINITY);
            assert!(!found.evidence.states().is_empty());
            for state in found.evidence.states() {
                assert_rates_are_not_negative(&scene, &conditions, state);
            }
        }
    }

    fn assert_rates_are_not_negative(
        scene: &Scene,
        conditions: &Conditions,
        state: &CollapseState,
    ) {
        let velocities = state.mechanism.motions.iter().map(|&motion| motion.into());
        let scaled = velocities.flat_map(|[x, y, turn]: [f64; 3]| [x, y, turn * scene.height()]);
        let mut unknowns: Vec<f64> = scaled.collect();
        let largest = unknowns.iter().fold(0.0, |most: f64, v| most.max(v.abs()));
        for joint in &conditions.joints {
            let slip = joint.rates[2].iter().map(|&(k, value)| value * unknowns[k]);
            let slip: f64 = slip.sum();
            unknowns.push(slip.max(0.0));
        }
        let motion = Motion::of_velocities(conditions);
        let rates = motion.rates(&DMatrix::from_row_slice(1, motion.unknowns, &unknowns));
        assert!(rates.iter().all(|rate| *rate > -1e-6 * largest), "{rates}");
    }
}
