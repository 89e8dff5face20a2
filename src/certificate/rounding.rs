//! What rounding leaves of a certificate's identity, and what it can cost.

use super::conditions::{Chain, Conditions};
use super::forces::{ForceBound, OUTWARD};
use super::sum::Sum;
use super::types::{Slice, left_side};

/// What rounding leaves of the identity: one number at most a force and a kinematic unknown.
pub(super) struct Rounding {
    /// By kinematic unknown, then by force: 1, λ, and three a joint.
    columns: Vec<Vec<f64>>,
}

impl Rounding {
    pub(super) fn of(conditions: &Conditions, slice: &Slice) -> Self {
        let (forces, motions) = (conditions.forces(), conditions.motions());
        let velocities = conditions.velocities();
        let mut columns = vec![vec![Sum::default(); forces]; motions];
        let ([of_one, of_lambda], of_dead) = left_side(slice.to, slice.sigma);
        for (c, &live) in conditions.live.iter().enumerate() {
            columns[c][0].add_product(of_one, live);
            columns[c][1].add_product(of_lambda, live);
            columns[c][0].add_product(of_dead, conditions.dead[c]);
        }
        // No entry is a sum of more than this: the power's column of every joint, the slip bounds, the loads.
        let steps = 64.0 * (conditions.rate_rows() + velocities) as f64;
        // What slip bounds leave out, by column and force.
        let mut left_out = vec![vec![0.0; forces]; motions];
        for rate in 0..conditions.rate_rows() {
            let multiple = force_combination(conditions, slice, rate);
            let mut add = |rate: usize, multiple: &[Sum]| {
                for (c, value) in conditions.rate_row(rate) {
                    for (sum, part) in columns[c].iter_mut().zip(multiple) {
                        sum.add_multiple(-value, *part);
                    }
                }
            };
            let Some(bound) = rate.checked_sub(conditions.power() + 1) else {
                add(rate, &multiple);
                continue;
            };
            let bound = &conditions.slip_bounds[bound];
            let forward = (4 * bound.joint + 2, -1.0);
            for &(part, share) in bound.shares.iter().chain([&forward]) {
                add(part, &times(share, &multiple));
            }
            for &(c, rounding) in &bound.rounding {
                for (own, part) in left_out[c].iter_mut().zip(&multiple) {
                    *own += rounding * part.largest(steps);
                }
            }
        }
        for (c, column) in columns.iter_mut().enumerate() {
            let balance = |row: usize| -slice.balance[row * motions + c];
            for row in 0..velocities {
                column[0].add_product(balance(row), conditions.dead[row]);
                column[1].add_product(balance(row), conditions.live[row]);
            }
            for (j, joint) in conditions.joints.iter().enumerate() {
                for (kind, entries) in joint.rates.iter().enumerate() {
                    for &(row, value) in entries {
                        column[2 + 3 * j + kind].add_product(balance(row), value);
                    }
                }
            }
        }
        let columns = columns.into_iter().zip(left_out);
        let largest = |(column, left_out): (Vec<Sum>, Vec<f64>)| {
            let sums = column.iter().map(|sum| sum.largest(steps));
            sums.zip(left_out)
                .map(|(sum, left)| sum + left * OUTWARD)
                .collect()
        };
        Self {
            columns: columns.map(largest).collect(),
        }
    }

    pub(super) fn largest(&self) -> f64 {
        self.columns.iter().flatten().copied().fold(0.0, f64::max)
    }

    /// The largest that one kinematic unknown's column can be, times any forces; over 1 + λ* where the slice has
    /// no upper end.
    fn over_forces(
        &self,
        motion: usize,
        conditions: &Conditions,
        slice: &Slice,
        forces: &ForceBound,
    ) -> f64 {
        let column = &self.columns[motion];
        let of_loads = match slice.to.is_finite() {
            true => column[0] + slice.from.abs().max(slice.to.abs()) * column[1],
            false => column[0].max(column[1]),
        };
        let joints = conditions.joints.iter().zip(&forces.margin).enumerate();
        let of_joint = joints.map(|(j, (joint, margin))| {
            let at = 2 + 3 * j;
            (column[at].max(column[at + 1]) + joint.friction * column[at + 2]) / margin
        });
        let of_joints = of_joint.fold(0.0, f64::max);
        (of_loads + forces.total(slice.to) * of_joints) * OUTWARD
    }
}

fn times(factor: f64, sums: &[Sum]) -> Vec<Sum> {
    let multiple = |sum: &Sum| {
        let mut multiple = Sum::default();
        multiple.add_multiple(factor, *sum);
        multiple
    };
    sums.iter().map(multiple).collect()
}

/// Σ over the force conditions of multiplier · condition, for one rate: 1, λ and three a joint.
fn force_combination(conditions: &Conditions, slice: &Slice, rate: usize) -> Vec<Sum> {
    let rates = conditions.rate_rows();
    let multiplier = |force: usize| slice.multipliers[force * rates + rate];
    let mut parts = vec![Sum::default(); conditions.forces()];
    for (j, joint) in conditions.joints.iter().enumerate() {
        let [one, other, forward, backward] = [0, 1, 2, 3].map(|k| multiplier(4 * j + k));
        for (kind, own) in [one, other].into_iter().enumerate() {
            let part = &mut parts[2 + 3 * j + kind];
            part.add(own);
            part.add_product(joint.friction, forward);
            part.add_product(joint.friction, backward);
        }
        let part = &mut parts[2 + 3 * j + 2];
        part.add(forward);
        part.add(-backward);
    }
    let [one, above, below] = [0, 1, 2].map(|k| multiplier(4 * conditions.joints.len() + k));
    parts[0].add(one);
    parts[0].add_product(-slice.from, above);
    parts[1].add(above);
    if slice.to.is_finite() {
        parts[0].add_product(slice.to, below);
        parts[1].add(-below);
    }
    parts
}

/// How much more a unit of some rate can cost by rounding than the multipliers of that rate absorb:
/// the bound is lower by this times the sum of all rates of joints; 0 where they absorb all. Then the same
/// for the power of the live load, which is 1. Both are over 1 + λ* where the slice has no upper end; then 1 + λ*
/// times that power is no more than what σ is multiplied with.
pub(super) fn deficits(
    conditions: &Conditions,
    slice: &Slice,
    rounding: &Rounding,
    forces: &ForceBound,
    chains: &[Chain],
) -> [f64; 2] {
    let over = |motion| rounding.over_forces(motion, conditions, slice, forces);
    let velocities = conditions.velocities();
    let mut needed = vec![0.0; conditions.power() + 1];
    for (velocity, chain) in chains.iter().enumerate() {
        let of_velocity = over(velocity);
        for &(rate, share) in chain {
            let cost = share.abs() * of_velocity;
            needed[rate] += cost;
            if rate < conditions.power() && rate % 4 == 2 {
                needed[rate + 1] += cost;
            }
        }
    }
    for joint in 0..conditions.joints.len() {
        needed[4 * joint + 2] += over(velocities + joint);
    }
    let rates = conditions.rate_rows();
    let of_joints = 4 * conditions.joints.len();
    let zeros = slice.zeros(conditions.joints.len());
    let moving = needed.iter().enumerate();
    // A rate that is zero costs nothing, and its multipliers, of any sign, absorb nothing.
    let moving = moving.filter(|(rate, _)| !zeros.rate(*rate));
    let mut largest = [0.0f64; 2];
    for (rate, needed) in moving {
        let [one, above, below] =
            [0, 1, 2].map(|k| slice.multipliers[(of_joints + k) * rates + rate]);
        let absorbed = match slice.to.is_finite() {
            true => one + (slice.to - slice.from).max(0.0) * above.min(below),
            // So much one + above · λ is at least, over 1 + λ.
            false => one.min(above),
        };
        let deficit = needed * OUTWARD - absorbed * (1.0 - 1e-9);
        let largest = &mut largest[usize::from(rate == conditions.power())];
        // A NaN must not be passed over.
        *largest = match deficit.is_nan() {
            true => f64::INFINITY,
            false => largest.max(deficit),
        };
    }
    largest
}
