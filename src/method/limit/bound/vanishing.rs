//! Up to which λ forces can vanish in equilibrium, and what follows beyond: their rates are zero.
//!
//! In every collapse state one factor of each product is zero. Where the force of a product vanishes
//! in no admissible state with λ ≥ a, its rate is zero in all collapse states there. Columns of the
//! lift that are zero without being assumed so leave it without an interior, on which its interior
//! point breaks down; and what is assumed of one product excludes others.

use std::cmp::Ordering;

use clarabel::algebra::CscMatrix;
use nalgebra::{DMatrix, DVector};

use super::cleaner::Cleaner;
use super::face::Face;
use super::lift::Lift;
use super::parameters::OPTIMAL;
use super::products::Products;
use super::slice::certified;
use crate::certificate::{Assumption, Conditions, Factor, Slice};
use crate::method::limit::solver::multipliers;

/// Multipliers that bound λ over all admissible forces some of which vanish:
/// Σ multiplier · condition + share · λ = upto · 1 in equilibrium, with share 1; or, where there are
/// no such forces at all, with share 0 and upto −1.
#[derive(Clone, Debug)]
pub(super) struct Vanishing {
    upto: f64,
    share: f64,
    /// Of four conditions a joint; of any sign for forces that vanish.
    multipliers: Vec<f64>,
}

impl Vanishing {
    /// Of these forces together, four a joint; `None` where no λ is too large for them.
    pub(super) fn of(conditions: &Conditions, forces: &[usize]) -> Option<Self> {
        let joints = conditions.joints.len();
        let velocities = conditions.velocities();
        let equations = velocities + forces.len();
        // Rows, columns (λ, then three a joint) and values.
        let mut entries: Vec<(usize, usize, f64)> = Vec::new();
        let live = conditions.live.iter().enumerate();
        entries.extend(live.map(|(row, &value)| (row, 0, value)));
        for (j, joint) in conditions.joints.iter().enumerate() {
            for (kind, rates) in joint.rates.iter().enumerate() {
                let column = 1 + 3 * j + kind;
                entries.extend(rates.iter().map(|&(row, value)| (row, column, value)));
            }
        }
        let mut condition = |force: usize, row: usize, sign: f64| {
            let (joint, kind) = (force / 4, force % 4);
            let friction = conditions.joints[joint].friction;
            let parts = match kind {
                0 => vec![(0, 1.0)],
                1 => vec![(1, 1.0)],
                2 => vec![(0, friction), (1, friction), (2, 1.0)],
                _ => vec![(0, friction), (1, friction), (2, -1.0)],
            };
            let parts = parts.into_iter();
            entries.extend(parts.map(|(k, value)| (row, 1 + 3 * joint + k, sign * value)));
        };
        for (k, &force) in forces.iter().enumerate() {
            condition(force, velocities + k, 1.0);
        }
        for force in 0..4 * joints {
            condition(force, equations + force, -1.0);
        }
        let (rows, columns) = (equations + 4 * joints, 1 + 3 * joints);
        let mut cost = vec![0.0; columns];
        cost[0] = -1.0;
        let mut right: Vec<f64> = conditions.dead.iter().map(|dead| -dead).collect();
        right.resize(rows, 0.0);
        let at = |part: fn(&(usize, usize, f64)) -> usize| entries.iter().map(part).collect();
        let values = entries.iter().map(|entry| entry.2).collect();
        let (of_rows, of_columns) = (at(|entry| entry.0), at(|entry| entry.1));
        let matrix = CscMatrix::new_from_triplets(rows, columns, of_rows, of_columns, values);
        let found = multipliers(&cost, &matrix, &right, equations)?;
        let power = conditions.dead.iter().zip(&found);
        let power: f64 = power.map(|(dead, velocity)| dead * velocity).sum();
        // At an optimum the multipliers balance the cost, else nothing.
        let of_multiplier: f64 = conditions.live.iter().zip(&found).map(|(l, v)| l * v).sum();
        let (share, unit) = if (of_multiplier - 1.0).abs() < OPTIMAL {
            (1.0, 1.0)
        } else if power > 0.0 {
            (0.0, power)
        } else {
            return None;
        };
        let mut multipliers: Vec<f64> = found[equations..]
            .iter()
            .map(|y| y.max(0.0) / unit)
            .collect();
        for (k, &force) in forces.iter().enumerate() {
            multipliers[force] -= found[velocities + k] / unit;
        }
        Some(Self {
            upto: -power / unit,
            share,
            multipliers,
        })
    }

    /// Whether no such forces are admissible from here on.
    pub(super) fn is_excluded(&self, from: f64, lift: &Lift) -> bool {
        self.share * from - self.upto > lift.parameters.clear
    }

    /// The slice of a certificate that shows that no collapse state meets these assumptions, which
    /// hold that the forces vanish.
    pub(super) fn slice(&self, lift: &Lift, [from, to]: [f64; 2], assumed: &[Assumption]) -> Slice {
        let own = &lift.parameters;
        let face = Face::of_one_rate(lift);
        let products = Products::new(&face, [from, to]);
        let rows = products.conditions.nrows();
        let one = rows - 3;
        let excess = self.share * from - self.upto;
        let mut impossible = DMatrix::zeros(rows, 1);
        for (own, value) in impossible.iter_mut().zip(&self.multipliers) {
            *own = value / excess;
        }
        impossible[one + 1] = self.share / excess;
        let vanishes = |pair: usize, _| {
            let zero = Factor::Force;
            assumed.contains(&Assumption { pair, zero })
        };
        // Together they are to be −1.
        let cleaner = Cleaner {
            products: &products,
            aim: DVector::zeros(face.free()),
            is_zero: &vanishes,
            exponent: 2,
        };
        let (impossible, _) = cleaner.clean(impossible, 1.0, 0.0);
        let sigma = to + own.above[0] * to + own.above[1];
        let rates = lift.conditions.rate_rows();
        let power = lift.conditions.power();
        let values = DMatrix::from_fn(rows, rates, |force, rate| match rate.cmp(&power) {
            Ordering::Less => {
                let of_one = if force == one { 1.0 } else { 0.0 };
                own.absorbed * (impossible[force] + of_one)
            }
            Ordering::Equal => {
                let of_slice = if force == one + 1 { 1.0 } else { 0.0 };
                (sigma - from) * impossible[force] + of_slice
            }
            Ordering::Greater => 0.0,
        });
        certified(lift, [from, to], assumed, sigma, values)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::answer::Work;
    use crate::certificate::Prover;
    use crate::method::limit::bound::parameters::Parameters;
    use crate::method::limit::bound::proving::opening;
    use crate::method::limit::walls::wall;
    use crate::scene::{Push, Scene};

    fn vanishings(scene: &Scene) -> Vec<(usize, Vanishing)> {
        let conditions = Conditions::of(scene);
        let forces = 0..4 * conditions.joints.len();
        let of = |force| Vanishing::of(&conditions, &[force]).map(|found| (force, found));
        forces.filter_map(of).collect()
    }

    /// Beyond the λ up to which a force can vanish, what it would take is refuted; before, it is not
    /// excluded.
    #[test]
    fn forces_that_cannot_vanish_are_refuted() {
        let scene = wall(4, Push::Right);
        let conditions = Conditions::of(&scene);
        let opening = opening(&scene, &mut Work::default()).unwrap();
        let prover = Prover::new(&scene, conditions.clone(), &opening).unwrap();
        let lift = Lift::new(conditions, Parameters::TUNED).unwrap();
        let mut refuted = 0;
        for (pair, vanishing) in vanishings(&scene) {
            assert!(vanishing.share == 0.0 || !vanishing.is_excluded(vanishing.upto - 1e-3, &lift));
            let from = (vanishing.upto + 0.01).max(0.0);
            assert!(vanishing.is_excluded(from, &lift));
            let zero = Factor::Force;
            let assumed = [Assumption { pair, zero }];
            let slice = vanishing.slice(&lift, [from, from + 0.2], &assumed);
            let proof = prover.slice(&slice, 1e4, 0).unwrap();
            assert!(
                proof.least >= from + 0.2 && proof.deficit == 0.0,
                "{proof:?}"
            );
            // Without the assumption it speaks of all states, and proves nothing of them.
            let all = Slice {
                assumed: Vec::new(),
                ..slice
            };
            let said = prover.slice(&all, 1e4, 0);
            let is_refused = said.is_err() || said.is_ok_and(|proof| proof.least < from);
            refuted += usize::from(is_refused);
        }
        assert!(refuted > 10, "{refuted}");
    }
}
