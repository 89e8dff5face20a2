//! The linear system of the interior point: Σ weight · (force condition × rate)², factored.
//!
//! Forward slips meet only their own joint's conditions and are eliminated joint by joint: what is
//! left of the two parts of a slip is their parallel sum. What remains are tiles, one row an unknown of
//! the motion. Conjugate gradients on the whole system take what rounding leaves.

use nalgebra::DMatrix;

use super::dense;
use super::factor::Tiles;
use super::lift::{Columns, Lift};
use crate::method::at_once::each;

/// The system for given weights.
pub(super) struct Newton<'a> {
    lift: &'a Lift,
    conditions: &'a DMatrix<f64>,
    transposed: &'a DMatrix<f64>,
    weights: DMatrix<f64>,
    /// Weight of the scale condition 1 − (row of 1)·power, and that row.
    scale: f64,
    one: DMatrix<f64>,
    slips: Vec<Slip>,
    tiles: Tiles<'a>,
    /// What holds the unknowns.
    held: f64,
}

/// One joint's forward slip.
struct Slip {
    /// Factor of forward + backward part.
    factor: DMatrix<f64>,
    backward: DMatrix<f64>,
}

/// What one joint adds.
struct Part {
    corners: [DMatrix<f64>; 2],
    /// Of the forward and the backward part of the slip, its forward part eliminated.
    parallel: DMatrix<f64>,
    slip: Slip,
}

impl Part {
    /// From the sums over the force conditions for the joint's four rates.
    fn new([one, other, mut forward, backward]: [DMatrix<f64>; 4], held: f64) -> Self {
        for k in 0..forward.nrows() {
            forward[(k, k)] += held;
        }
        let mut factor = &forward + &backward;
        let floor = 1e-15 * factor.diagonal().amax();
        for k in 0..factor.nrows() {
            factor[(k, k)] += 1e-15 * factor[(k, k)] + floor;
        }
        dense::factor(&mut factor);
        // Their product cancels nothing, where a difference would.
        let left = dense::solve_left(&factor, &backward);
        let right = dense::solve_left(&factor, &forward);
        let parallel = left.transpose() * right;
        Self {
            corners: [one, other],
            parallel: (&parallel + parallel.transpose()) * 0.5,
            slip: Slip { factor, backward },
        }
    }
}

/// Share of each diagonal entry, and of the largest, that is added to it.
const REGULAR: [f64; 2] = [1e-14, 1e-17];

/// Steps of conjugate gradients at most.
const STEPS: usize = 20;

impl<'a> Newton<'a> {
    /// Assembles and factors.
    pub(super) fn new(
        lift: &'a Lift,
        [conditions, transposed]: [&'a DMatrix<f64>; 2],
        weights: DMatrix<f64>,
        scale: f64,
        held: f64,
    ) -> Self {
        let free = lift.free();
        let one = lift.basis.row(0).transpose();
        let one = DMatrix::from_column_slice(free, 1, one.as_slice());
        let of_rate = |rate: usize| {
            let mut scaled = transposed.clone();
            for (mut column, weight) in scaled.column_iter_mut().zip(&weights.column(rate)) {
                column *= *weight;
            }
            &scaled * conditions
        };
        let joints = 0..lift.joints();
        let mut parts: Vec<_> = joints.map(|j| (j, None)).collect();
        each(&mut parts, &|(j, part)| {
            let sums = [0, 1, 2, 3].map(|kind| of_rate(4 * *j + kind));
            *part = Some(Part::new(sums, held));
        });
        let mut tiles = Tiles::zero(&lift.pattern, free);
        let mut add = |entries: &[(usize, f64)], part: &DMatrix<f64>| {
            for &(p, x) in entries {
                for &(q, y) in entries {
                    tiles.add(p, q, x * y, part);
                }
            }
        };
        let mut slips = Vec::with_capacity(lift.joints());
        for (joint, (_, part)) in lift.motion.joints.iter().zip(parts) {
            let Part {
                corners,
                parallel,
                slip,
            } = part.expect("each is done");
            add(&joint[0], &corners[0]);
            add(&joint[1], &corners[1]);
            add(&joint[2], &parallel);
            slips.push(slip);
        }
        let mut power = of_rate(4 * lift.joints());
        power.gemm(scale, &one, &one.transpose(), 1.0);
        add(&lift.motion.power, &power);
        Self {
            lift,
            conditions,
            transposed,
            weights,
            scale,
            one,
            slips,
            tiles: tiles.factor(REGULAR[0], REGULAR[1], held),
            held,
        }
    }

    /// The system times unknowns.
    fn times(&self, x: &Columns) -> Columns {
        let mut products = self.conditions * self.lift.motion.rates(x);
        products.component_mul_assign(&self.weights);
        let mut out = self.lift.motion.of_rates(&(self.transposed * products));
        let power = self.lift.power();
        let scale = self.scale * (self.one.tr_mul(&x.velocities) * &power)[(0, 0)];
        out.velocities += &self.one * power.transpose() * scale;
        out.add(self.held, x);
        out
    }

    /// Solves by the factors alone.
    fn solve_once(&self, right: &Columns) -> Columns {
        let mut velocities = right.velocities.clone();
        let mut slips = right.slips.clone();
        for ((j, slip), joint) in self.slips.iter().enumerate().zip(&self.lift.motion.joints) {
            let mut own = slips.columns(j, 1).clone_owned();
            slip.factor.solve_lower_triangular_mut(&mut own);
            slip.factor.tr_solve_lower_triangular_mut(&mut own);
            let pulled = &slip.backward * &own;
            for &(k, value) in &joint[2] {
                velocities.column_mut(k).axpy(value, &pulled.column(0), 1.0);
            }
            slips.set_column(j, &own.column(0));
        }
        let (free, motions) = velocities.shape();
        let long = DMatrix::from_column_slice(free * motions, 1, velocities.as_slice());
        let solved = self.tiles.solve(&long);
        let velocities = DMatrix::from_column_slice(free, motions, solved.as_slice());
        for ((j, slip), joint) in self.slips.iter().enumerate().zip(&self.lift.motion.joints) {
            let mut slid = DMatrix::zeros(free, 1);
            for &(k, value) in &joint[2] {
                slid.column_mut(0).axpy(value, &velocities.column(k), 1.0);
            }
            let mut own = &slip.backward * slid;
            slip.factor.solve_lower_triangular_mut(&mut own);
            slip.factor.tr_solve_lower_triangular_mut(&mut own);
            slips.column_mut(j).axpy(1.0, &own.column(0), 1.0);
        }
        Columns { velocities, slips }
    }

    /// Solves to a residual of this share of the right side, or as far as rounding lets it.
    pub(super) fn solve(&self, right: &Columns, share: f64) -> Columns {
        let mut x = self.solve_once(right);
        let mut residual = right.clone();
        residual.add(-1.0, &self.times(&x));
        let enough = share * right.largest();
        let mut best = (residual.largest(), x.clone());
        let mut direction = self.solve_once(&residual);
        let mut rho = residual.dot(&direction);
        for _ in 0..STEPS {
            if best.0 <= enough || !rho.is_finite() || rho <= 0.0 {
                break;
            }
            let image = self.times(&direction);
            let curvature = direction.dot(&image);
            if curvature <= 0.0 || !curvature.is_finite() {
                break;
            }
            x.add(rho / curvature, &direction);
            residual.add(-rho / curvature, &image);
            if residual.largest() < best.0 {
                best = (residual.largest(), x.clone());
            }
            let preconditioned = self.solve_once(&residual);
            let next = residual.dot(&preconditioned);
            let mut turned = preconditioned;
            turned.add(next / rho, &direction);
            direction = turned;
            rho = next;
        }
        best.1
    }
}
