//! Takes away what multipliers leave of the identity that they are to satisfy.

use nalgebra::{DMatrix, DVector};

use super::newton::Newton;
use super::products::Products;

/// The identity (aim − σ · scale) · power = Σ multiplier · product, and how its multipliers may move.
pub(super) struct Cleaner<'a> {
    pub(super) products: &'a Products<'a>,
    pub(super) aim: DVector<f64>,
    /// Whether a product, by its rows, is zero, so that its multiplier has any sign.
    pub(super) is_zero: &'a dyn Fn(usize, usize) -> bool,
    /// Multipliers move in proportion to this power of their size: 2 at an optimum, where they span many
    /// decades, and small ones are to move less.
    pub(super) exponent: i32,
}

impl Cleaner<'_> {
    /// Multipliers and σ that leave as little of the identity as double precision allows; `of_sigma`
    /// says how freely σ moves.
    pub(super) fn clean(
        &self,
        values: DMatrix<f64>,
        sigma: f64,
        of_sigma: f64,
    ) -> (DMatrix<f64>, f64) {
        let own = self.products.parameters();
        let mut now = (values, sigma);
        let mut least = (self.left(&now).amax(), now.clone());
        for _ in 0..own.cleanings {
            if least.0 <= own.clean {
                break;
            }
            let weights = self.weights(&now.0);
            let newton = Newton::new(self.products, &weights, of_sigma, 0.0);
            let before = least.0;
            for _ in 0..own.cleanings {
                let (moved, _) = newton.solve(&self.left(&now), [0.0, own.cleaned_to]);
                now.0 += self.products.of(&moved).component_mul(&weights);
                now.1 += of_sigma * self.products.work(&moved);
                self.clip(&mut now.0);
                let remaining = self.left(&now).amax();
                if remaining < least.0 {
                    least = (remaining, now.clone());
                }
            }
            if least.0 > own.cleaner * before {
                break;
            }
            now = least.1.clone();
        }
        least.1
    }

    /// What multipliers and σ leave of the identity.
    fn left(&self, (values, sigma): &(DMatrix<f64>, f64)) -> DMatrix<f64> {
        let products = self.products;
        products.left_side(&self.aim, *sigma) - products.transposed(values)
    }

    /// How freely each multiplier moves.
    fn weights(&self, values: &DMatrix<f64>) -> DMatrix<f64> {
        let largest = values.amax();
        let unmoved = self.products.parameters().unmoved * largest;
        values.map_with_location(|force, rate, value: f64| {
            if (self.is_zero)(force, rate) {
                largest.powi(self.exponent)
            } else if value < unmoved {
                0.0
            } else {
                value.powi(self.exponent)
            }
        })
    }

    /// Makes negative multipliers zero, but for those of the zero products.
    fn clip(&self, values: &mut DMatrix<f64>) {
        for rate in 0..values.ncols() {
            for force in 0..values.nrows() {
                if !(self.is_zero)(force, rate) {
                    values[(force, rate)] = values[(force, rate)].max(0.0);
                }
            }
        }
    }
}
