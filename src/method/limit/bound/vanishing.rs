//! Up to which λ forces can vanish in equilibrium, and what follows beyond: their rates are zero.
//!
//! In every collapse state one factor of each product is zero. Where the force of a product vanishes
//! in no admissible state with λ ≥ a, its rate is zero in all collapse states there. Columns of the
//! lift that are zero without being assumed so leave it without an interior, on which its interior
//! point breaks down; and what is assumed of one product excludes others.

use clarabel::algebra::CscMatrix;
use nalgebra::{DMatrix, DVector};

use super::dense;
use super::lift::Lift;
use super::slice::{balance, grain};
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

/// How far beyond the λ up to which forces can vanish that is used. Nearer, the multipliers of its proof
/// grow until rounding takes it; a proof that does not hold is dropped, whatever this is.
const CLEAR: f64 = 1e-4;

/// What is added to all rates' multipliers, so that they absorb what rounding leaves.
const ABSORBED: f64 = 1e-6;

/// Rounds of taking away what multipliers leave of their identity.
const ROUNDS: usize = 3;

/// How small a multiplier can be beside the largest and still move.
const SMALL: f64 = 1e-13;

impl Vanishing {
    /// Of these forces together, four a joint; `None` where no λ is too large for them.
    pub(super) fn of(conditions: &Conditions, forces: &[usize]) -> Option<Self> {
        let joints = conditions.joints.len();
        let velocities = conditions.velocities();
        let mut entries = Vec::new();
        let live = conditions.live.iter().enumerate();
        entries.extend(live.map(|(row, &value)| (0, row, value)));
        for (j, joint) in conditions.joints.iter().enumerate() {
            for (kind, rates) in joint.rates.iter().enumerate() {
                let column = 1 + 3 * j + kind;
                entries.extend(rates.iter().map(|&(row, value)| (column, row, value)));
            }
        }
        let condition = |force: usize, row: usize, sign: f64| {
            let (joint, kind) = (force / 4, force % 4);
            let [one, other, shear] = [0, 1, 2].map(|k| 1 + 3 * joint + k);
            let friction = conditions.joints[joint].friction;
            let entries = match kind {
                0 => vec![(one, 1.0)],
                1 => vec![(other, 1.0)],
                2 => vec![(one, friction), (other, friction), (shear, 1.0)],
                _ => vec![(one, friction), (other, friction), (shear, -1.0)],
            };
            let entries = entries.into_iter();
            entries.map(move |(column, value)| (column, row, sign * value))
        };
        for (k, &force) in forces.iter().enumerate() {
            entries.extend(condition(force, velocities + k, 1.0));
        }
        let equations = velocities + forces.len();
        for force in 0..4 * joints {
            entries.extend(condition(force, equations + force, -1.0));
        }
        let rows = equations + 4 * joints;
        let columns = 1 + 3 * joints;
        let mut cost = vec![0.0; columns];
        cost[0] = -1.0;
        let mut right = vec![0.0; rows];
        for (right, dead) in right.iter_mut().zip(&conditions.dead) {
            *right = -dead;
        }
        let part = |k: usize| entries.iter().map(move |entry| [entry.0, entry.1][k]);
        let values = entries.iter().map(|entry| entry.2).collect();
        let matrix = CscMatrix::new_from_triplets(
            rows,
            columns,
            part(1).collect(),
            part(0).collect(),
            values,
        );
        let found = multipliers(&cost, &matrix, &right, equations)?;
        let power = conditions.dead.iter().zip(&found);
        let power: f64 = power.map(|(dead, velocity)| dead * velocity).sum();
        // At an optimum the multipliers balance the cost, else nothing.
        let of_multiplier: f64 = conditions.live.iter().zip(&found).map(|(l, v)| l * v).sum();
        let (share, unit) = if (of_multiplier - 1.0).abs() < 1e-6 {
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
    pub(super) fn is_excluded(&self, from: f64) -> bool {
        self.share * from - self.upto > CLEAR
    }

    /// The slice of a certificate that shows that no collapse state meets these assumptions, which
    /// hold that the forces vanish.
    pub(super) fn slice(&self, lift: &Lift, [from, to]: [f64; 2], assumed: &[Assumption]) -> Slice {
        let conditions = lift.force_conditions(from, to);
        let rows = conditions.nrows();
        let one = rows - 3;
        let excess = self.share * from - self.upto;
        let mut impossible = DVector::zeros(rows);
        for (own, value) in impossible.iter_mut().zip(&self.multipliers) {
            *own = value / excess;
        }
        impossible[one + 1] = self.share / excess;
        let vanishes = |pair: usize| {
            let zero = Factor::Force;
            assumed.contains(&Assumption { pair, zero })
        };
        let target = -lift.basis.row(0).transpose();
        clean(&conditions, &target, &mut impossible, vanishes);
        let sigma = to * 1.01 + 0.01;
        let rates = lift.conditions.rate_rows();
        let values = DMatrix::from_fn(rows, rates, |force, rate| {
            if rate == lift.conditions.power() {
                let of_slice = if force == one + 1 { 1.0 } else { 0.0 };
                grain((sigma - from) * impossible[force] + of_slice)
            } else if rate > lift.conditions.power() {
                0.0
            } else {
                let of_one = if force == one { 1.0 } else { 0.0 };
                grain(ABSORBED * (impossible[force] + of_one))
            }
        });
        Slice {
            from,
            to,
            assumed: assumed.to_vec(),
            sigma,
            balance: balance(lift, [from, to], sigma, &values),
            multipliers: values.transpose().as_slice().to_vec(),
        }
    }
}

/// Takes away what multipliers of force conditions leave of a combination that they are to be, each
/// changed in proportion to its square.
fn clean(
    conditions: &DMatrix<f64>,
    target: &DVector<f64>,
    multipliers: &mut DVector<f64>,
    is_free: impl Fn(usize) -> bool,
) {
    for _ in 0..ROUNDS {
        let left = target - conditions.tr_mul(multipliers);
        let largest = multipliers.amax();
        let weights = multipliers.map_with_location(|force, _, value: f64| {
            if is_free(force) {
                largest * largest
            } else if value < SMALL * largest {
                0.0
            } else {
                value * value
            }
        });
        let mut weighted = conditions.clone();
        for (mut row, weight) in weighted.row_iter_mut().zip(&weights) {
            row *= *weight;
        }
        let mut system = conditions.tr_mul(&weighted);
        let floor = 1e-14 * system.diagonal().amax();
        for k in 0..system.nrows() {
            system[(k, k)] += floor;
        }
        dense::factor(&mut system);
        let mut moved = left;
        system.solve_lower_triangular_mut(&mut moved);
        system.tr_solve_lower_triangular_mut(&mut moved);
        *multipliers += &weighted * moved;
        for (force, value) in multipliers.iter_mut().enumerate() {
            if !is_free(force) {
                *value = value.max(0.0);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::answer::Work;
    use crate::certificate::Prover;
    use crate::method::Settings;
    use crate::method::limit::bound::{opening, orders};
    use crate::method::limit::interval::lowest;
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
        let lift = Lift::new(conditions, &orders(&scene)).unwrap();
        let mut refuted = 0;
        for (pair, vanishing) in vanishings(&scene) {
            assert!(vanishing.share == 0.0 || !vanishing.is_excluded(vanishing.upto - 1e-3));
            let from = (vanishing.upto + 0.01).max(0.0);
            assert!(vanishing.is_excluded(from));
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

    /// No verified state has a force zero beyond the λ up to which it can vanish.
    #[test]
    fn states_do_not_contradict() {
        let scene = wall(4, Push::Right);
        let found = lowest(&scene, &Settings::default(), f64::NEG_INFINITY);
        assert!(!found.evidence.states().is_empty());
        let vanishings = vanishings(&scene);
        for state in found.evidence.states() {
            for (force, vanishing) in &vanishings {
                let forces = &state.forces[force / 4];
                let friction = scene.joints()[force / 4].friction;
                let limit = friction * (forces.normal[0] + forces.normal[1]);
                let value = match force % 4 {
                    kind @ (0 | 1) => forces.normal[kind],
                    2 => limit + forces.shear,
                    _ => limit - forces.shear,
                };
                let is_zero = value < 1e-9 * scene.total_weight();
                let lambda = state.lambda / scene.multiplier_unit();
                assert!(
                    !is_zero || lambda <= vanishing.upto + 1e-6,
                    "{force}: {vanishing:?}"
                );
            }
        }
    }
}
