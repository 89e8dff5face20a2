//! Where an interior point stands, and how far it can go.

use nalgebra::DMatrix;

/// An iterate, or a step between two: lifted unknowns, their products with multipliers, and the scale
/// condition with its own.
pub(super) struct Point {
    pub(super) unknowns: DMatrix<f64>,
    pub(super) products: DMatrix<f64>,
    pub(super) multipliers: DMatrix<f64>,
    pub(super) scale: [f64; 2],
}

/// How far the unknowns and the multipliers go along a step.
pub(super) type Lengths = [f64; 2];

impl Point {
    /// Goes along a step.
    pub(super) fn advance(&mut self, step: &Point, [primal, dual]: Lengths) {
        self.unknowns += &step.unknowns * primal;
        self.products += &step.products * primal;
        self.multipliers += &step.multipliers * dual;
        self.scale[0] += primal * step.scale[0];
        self.scale[1] += dual * step.scale[1];
    }

    /// Sum of product times multiplier behind a step, but of those that are zero.
    pub(super) fn sum_behind(&self, step: &Point, lengths: Lengths, is_zero: &[bool]) -> f64 {
        let [primal, dual] = lengths;
        let mut sum =
            (self.scale[0] + primal * step.scale[0]) * (self.scale[1] + dual * step.scale[1]);
        for (k, is_zero) in is_zero.iter().enumerate() {
            if !is_zero {
                sum += (self.products[k] + primal * step.products[k])
                    * (self.multipliers[k] + dual * step.multipliers[k]);
            }
        }
        sum
    }

    /// The longest ones, up to `most`, that make none of these negative but of those that are zero.
    pub(super) fn lengths(&self, step: &Point, is_zero: &[bool], most: f64) -> Lengths {
        let longest = |values: &DMatrix<f64>, by: &DMatrix<f64>, scale: usize| {
            let to_zero = |value: f64, by: f64| if by < 0.0 { value / -by } else { f64::INFINITY };
            let pairs = values.iter().zip(by).zip(is_zero);
            pairs
                .filter(|(_, is_zero)| !**is_zero)
                .map(|((value, by), _)| to_zero(*value, *by))
                .fold(to_zero(self.scale[scale], step.scale[scale]), f64::min)
                .min(most)
        };
        [
            longest(&self.products, &step.products, 0),
            longest(&self.multipliers, &step.multipliers, 1),
        ]
    }
}
