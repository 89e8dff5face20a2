//! Sums of products in twice the working precision, with a bound on what they still round away.

/// A running sum `high + low` of products, and the sum of their magnitudes.
///
/// Additions are Knuth's exact ones, products those of Dekker and Veltkamp by a fused
/// multiplication: each step loses less than 2⁻¹⁰⁴ of what has been added so far (Ogita, Rump and
/// Oishi, SIAM J. Sci. Comput. 26 (2005) 1955-1988, Dot2).
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Sum {
    high: f64,
    low: f64,
    magnitude: f64,
}

/// What one step may lose of the magnitudes added so far: 2⁻⁵³ squared, times 16 so that the few
/// roundings of a step and of the bound itself are covered.
const LOST: f64 = 16.0 * (f64::EPSILON / 2.0) * (f64::EPSILON / 2.0);

/// A sum of two numbers and what rounding took from it, exactly.
fn two_sum(a: f64, b: f64) -> (f64, f64) {
    let sum = a + b;
    let from_b = sum - a;
    (sum, (a - (sum - from_b)) + (b - from_b))
}

impl Sum {
    /// Adds a number.
    pub(super) fn add(&mut self, value: f64) {
        let (high, error) = two_sum(self.high, value);
        self.high = high;
        self.low += error;
        self.magnitude += value.abs();
    }

    /// Adds the product of two numbers.
    pub(super) fn add_product(&mut self, a: f64, b: f64) {
        let product = a * b;
        let error = a.mul_add(b, -product);
        let (high, rounded) = two_sum(self.high, product);
        self.high = high;
        self.low += rounded + error;
        self.magnitude += product.abs();
    }

    /// Adds a multiple of another sum.
    pub(super) fn add_multiple(&mut self, factor: f64, of: Sum) {
        let before = self.magnitude;
        self.add_product(factor, of.high);
        self.add_product(factor, of.low);
        self.magnitude = before + factor.abs() * of.magnitude;
    }

    /// The largest magnitude that the exact sum can have, given that no more than `steps` were added.
    pub(super) fn largest(&self, steps: f64) -> f64 {
        let rounded = steps * (LOST * self.magnitude + f64::MIN_POSITIVE);
        // What remains is one rounding or two.
        ((self.high + self.low).abs() + rounded) * (1.0 + 4.0 * f64::EPSILON)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_cancels_is_still_there() {
        let mut sum = Sum::default();
        sum.add_product(1e8 + 1.0, 1e8 - 1.0);
        sum.add_product(-1e8, 1e8);
        assert_eq!(sum.high + sum.low, -1.0);
        let mut twice = Sum::default();
        twice.add_multiple(2.0, sum);
        twice.add(2.0);
        assert!(twice.largest(10.0) < 1e-13, "{twice:?}");
        assert!(twice.largest(10.0) > 0.0);
    }
}
