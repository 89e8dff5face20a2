//! The linear system of one step: H dx + Eᵀ dy = p, E dx + a dλ = e, aᵀ dy = l, with the joints'
//! blocks H eliminated in closed form. What is left has three unknowns a block and λ as a border.

use super::factor::Factor;
use super::joint::Joints;
use super::law::{Forces, LANES, Lanes};
use super::symbolic::Slot;

/// A system that is solved for many weights.
pub(super) struct Newton {
    /// The column of λ; empty where there is none.
    live: Vec<f64>,
    /// Where a joint's blocks of the matrix stand: of either body, and between them.
    slots: Vec<[[Slot; 3]; LANES]>,
    factor: Factor,
    /// The factor's solution for the column of λ, on which the push has unit power, and the power
    /// that it had before it was scaled.
    border: Vec<f64>,
    across: f64,
    /// A right side of the factor.
    side: Vec<f64>,
    /// What a solution leaves.
    left: Balance,
    unrefined: Change,
}

/// Equilibrium and the push: the right sides e and l, or what is left of them.
#[derive(Clone, Debug, Default)]
pub(super) struct Balance {
    pub(super) blocks: Vec<f64>,
    pub(super) push: f64,
}

impl Balance {
    /// The largest entry.
    pub(super) fn size(&self) -> f64 {
        let sizes = self.blocks.iter().map(|value| value.abs());
        sizes.fold(self.push.abs(), f64::max)
    }
}

/// A solution but for the forces, which stand with the joints: dλ and dy.
#[derive(Clone, Debug, Default)]
pub(super) struct Change {
    pub(super) lambda: f64,
    pub(super) velocities: Vec<f64>,
}

impl Newton {
    pub(super) fn new(blocks: usize, joints: &[Joints], live: Vec<f64>) -> Self {
        let bodies = || joints.iter().map(|joints| &joints.bodies);
        let both = bodies().flat_map(|joints| joints.to.into_iter().zip(joints.from));
        let pairs: Vec<_> = both.filter(|(to, from)| to != from).collect();
        let factor = Factor::new(blocks, &pairs);
        let slots = bodies().map(|joints| {
            std::array::from_fn(|lane| {
                let (to, from) = (joints.to[lane], joints.from[lane]);
                [(to, to), (from, from), (to, from)].map(|(row, column)| factor.slot(row, column))
            })
        });
        Self {
            slots: slots.collect(),
            border: vec![0.0; live.len()],
            across: 0.0,
            side: vec![0.0; 3 * blocks],
            left: Balance::default(),
            unrefined: Change::default(),
            live,
            factor,
        }
    }

    /// The column of λ; empty where there is none.
    pub(super) fn live(&self) -> &[f64] {
        &self.live
    }

    /// Takes the weights of all inequalities from the joints.
    pub(super) fn factorise(&mut self, joints: &mut [Joints]) {
        let matrix = self.factor.cleared();
        for (joints, slots) in joints.iter_mut().zip(&self.slots) {
            joints.inverse = joints.law.inverse(joints.inverse_weights);
            let [to, from] = joints
                .bodies
                .wrench
                .map(|wrench| joints.inverse.lower(&wrench));
            let [scaled_to, scaled_from] = [&to, &from].map(|lower| joints.inverse.scaled(lower));
            let of_to = product(&scaled_to, &to);
            let of_from = product(&scaled_from, &from);
            let between = product(&scaled_to, &from);
            for (lane, slots) in slots.iter().enumerate() {
                add_lower_half(matrix, slots[0], &of_to, lane);
                if joints.bodies.from[lane] != joints.bodies.to[lane] {
                    add_lower_half(matrix, slots[1], &of_from, lane);
                    add_product(matrix, slots[2], &between, lane);
                }
            }
        }
        self.factor.factorise();
        self.border.copy_from_slice(&self.live);
        if !self.live.is_empty() {
            self.factor.solve(&mut self.border);
            self.across = dot(&self.live, &self.border);
            self.border.iter_mut().for_each(|rate| *rate /= self.across);
        }
    }

    /// Solves the system for the forces H⁻¹ p of the joints, and again for what is left of the balance
    /// until that is below `small` or does not shrink; without that where `small` is infinite.
    pub(super) fn solve(
        &mut self,
        joints: &mut [Joints],
        forces: impl Fn(&Joints) -> Forces,
        balance: &Balance,
        small: f64,
        out: &mut Change,
    ) {
        out.velocities.clear();
        out.velocities.resize(self.side.len(), 0.0);
        out.lambda = 0.0;
        for (side, value) in self.side.iter_mut().zip(&balance.blocks) {
            *side = -value;
        }
        for joints in joints.iter_mut() {
            let forces = forces(joints);
            joints.step.forces = forces;
            joints.bodies.push(forces, &mut self.side);
        }
        self.add_solution(joints, balance.push, out);
        if small == f64::INFINITY {
            return;
        }
        let mut size = f64::INFINITY;
        for _ in 0..REFINEMENTS {
            self.measure_left(joints, balance, out);
            let now = self.left.size();
            if now >= size {
                out.clone_from(&self.unrefined);
                for joints in joints.iter_mut() {
                    joints.step.forces = joints.unrefined;
                }
            }
            if now <= small || now > 0.5 * size {
                break;
            }
            size = now;
            self.unrefined.clone_from(out);
            for joints in joints.iter_mut() {
                joints.unrefined = joints.step.forces;
            }
            for (side, value) in self.side.iter_mut().zip(&self.left.blocks) {
                *side = -value;
            }
            self.add_solution(joints, self.left.push, out);
        }
    }

    /// Adds the solution for the right side of the factor that has been set, and for that of the push.
    ///
    /// The border is nearly the collapse mechanism, which the matrix hardly resists. So λ is found
    /// first, and the factor sees a right side that does no work on that mechanism.
    fn add_solution(&mut self, joints: &mut [Joints], push: f64, out: &mut Change) {
        if self.live.is_empty() {
            self.factor.solve(&mut self.side);
        } else {
            let lambda = push / self.across - dot(&self.border, &self.side);
            out.lambda += lambda;
            add(&mut self.side, lambda, &self.live);
            self.factor.solve(&mut self.side);
            let missing = push - dot(&self.live, &self.side);
            add(&mut self.side, missing, &self.border);
        }
        for joints in joints.iter_mut() {
            let less = joints.inverse.apply(joints.bodies.pull(&self.side));
            for (force, less) in joints.step.forces.iter_mut().zip(less) {
                *force -= less;
            }
        }
        add(&mut out.velocities, 1.0, &self.side);
    }

    /// What a solution leaves of the balance.
    fn measure_left(&mut self, joints: &[Joints], balance: &Balance, change: &Change) {
        let left = &mut self.left;
        left.blocks.clone_from(&balance.blocks);
        add(&mut left.blocks, -change.lambda, &self.live);
        for joints in joints {
            let against = joints.step.forces.map(|force| -force);
            joints.bodies.push(against, &mut left.blocks);
        }
        left.push = balance.push - dot(&self.live, &change.velocities);
    }
}

/// Solutions for what is left, at most.
const REFINEMENTS: usize = 4;

/// The sum over the entries that both have.
pub(super) fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// Adds a multiple of b to a.
pub(super) fn add(a: &mut [f64], times: f64, b: &[f64]) {
    for (a, b) in a.iter_mut().zip(b) {
        *a += times * b;
    }
}

/// a bᵀ, row by row.
fn product(a: &[Lanes; 9], b: &[Lanes; 9]) -> [[f64; LANES]; 9] {
    std::array::from_fn(|k| {
        let (a, b) = (&a[3 * (k / 3)..][..3], &b[3 * (k % 3)..][..3]);
        (a[0] * b[0] + a[1] * b[1] + a[2] * b[2]).to_array()
    })
}

/// Adds the lower half of a symmetric product, of one lane.
fn add_lower_half(matrix: &mut [f64], slot: Slot, product: &[[f64; LANES]; 9], lane: usize) {
    for column in 0..3 {
        let target = &mut matrix[slot.at + column * slot.stride..][..3];
        for (row, target) in target.iter_mut().enumerate().skip(column) {
            *target += product[3 * row + column][lane];
        }
    }
}

/// Adds a product, of one lane.
fn add_product(matrix: &mut [f64], slot: Slot, product: &[[f64; LANES]; 9], lane: usize) {
    let (along, across) = if slot.transposed { (1, 3) } else { (3, 1) };
    for column in 0..3 {
        let target = &mut matrix[slot.at + column * slot.stride..][..3];
        for (row, target) in target.iter_mut().enumerate() {
            *target += product[along * row + across * column][lane];
        }
    }
}
