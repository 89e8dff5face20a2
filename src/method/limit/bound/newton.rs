//! The linear system of the interior point: Σ weight · (force condition × rate)², factored.
//!
//! It is made of tiles, one row an unknown of the motion, and each rate adds to those where its unknowns
//! meet; the power, which couples all of them, is their border. Conjugate gradients on the whole system take
//! what rounding leaves.

use nalgebra::DMatrix;

use super::bordered::Bordered;
use super::factor::Tiles;
use super::products::Products;
use crate::method::at_once::each;

/// The system for given weights.
pub(super) struct Newton<'a> {
    products: &'a Products<'a>,
    weights: &'a DMatrix<f64>,
    /// Weight of the scale condition 1 − (row of 1)·power.
    scale: f64,
    factor: Bordered<'a>,
    /// What holds the unknowns.
    held: f64,
}

impl<'a> Newton<'a> {
    /// Assembles and factors.
    pub(super) fn new(
        products: &'a Products<'a>,
        weights: &'a DMatrix<f64>,
        scale: f64,
        held: f64,
    ) -> Self {
        // Of the scale condition, what belongs to the power; conjugate gradients take its part of the dead load.
        let of_scale = &products.scale;
        let rates = products.face.motion.rows.iter().enumerate();
        let rates = rates.filter(|(_, row)| !row.is_empty());
        let mut parts: Vec<_> = rates.map(|(rate, row)| (rate, row, None)).collect();
        each(&mut parts, &|(rate, _, part)| {
            let mut scaled = products.transposed.clone();
            for (mut column, weight) in scaled.column_iter_mut().zip(&weights.column(*rate)) {
                column *= *weight;
            }
            let mut sum = &scaled * &products.conditions;
            if *rate == products.face.motion.power {
                sum.gemm(scale, of_scale, &of_scale.transpose(), 1.0);
            }
            *part = Some(sum);
        });
        let motion = &products.face.motion;
        let coupling = parts
            .iter_mut()
            .find(|(rate, ..)| motion.couples_all(*rate));
        let coupling = coupling.and_then(|(.., part)| part.take());
        let parts: Vec<_> = (parts.iter())
            .filter_map(|(_, row, part)| Some((row.as_slice(), part.as_ref()?)))
            .collect();
        let tiles = Tiles::sum(&products.face.pattern, of_scale.len(), &parts);
        let regular = products.parameters().regular;
        Self {
            products,
            weights,
            scale,
            factor: Bordered::new(tiles, &products.power, coupling, regular, held),
            held,
        }
    }

    /// The system times unknowns.
    fn times(&self, x: &DMatrix<f64>) -> DMatrix<f64> {
        let mut products = self.products.of(x);
        products.component_mul_assign(self.weights);
        let mut out = self.products.transposed(&products);
        out += self.products.scale_row() * (self.scale * self.products.work(x));
        out += x * self.held;
        out
    }

    /// Solves to this residual, or to this share of the right side, or as far as rounding lets it; also the share
    /// that is left.
    pub(super) fn solve(
        &self,
        right: &DMatrix<f64>,
        [residual, share]: [f64; 2],
    ) -> (DMatrix<f64>, f64) {
        let enough = residual.max(share * right.amax());
        let own = self.products.parameters();
        let mut x = self.factor.solve(right);
        let mut residual = right - self.times(&x);
        let mut best = (residual.amax(), x.clone());
        let mut halved = (best.0, 0);
        let mut last: Option<(DMatrix<f64>, f64)> = None;
        for step in 0..own.gradients {
            if best.0 < 0.5 * halved.0 {
                halved = (best.0, step);
            }
            if best.0 <= enough || step - halved.1 >= own.to_halve {
                break;
            }
            let mut direction = self.factor.solve(&residual);
            let rho = residual.dot(&direction);
            if !rho.is_finite() || rho <= 0.0 {
                break;
            }
            if let Some((before, last_rho)) = last {
                direction += before * (rho / last_rho);
            }
            let image = self.times(&direction);
            let curvature = direction.dot(&image);
            if curvature <= 0.0 || !curvature.is_finite() {
                break;
            }
            x += &direction * (rho / curvature);
            residual -= image * (rho / curvature);
            if residual.amax() < best.0 {
                best = (residual.amax(), x.clone());
            }
            last = Some((direction, rho));
        }
        (best.1, best.0 / right.amax().max(f64::MIN_POSITIVE))
    }
}
