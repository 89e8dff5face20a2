//! The equations of one joint: two corner forces and a shear against four inequalities.
//!
//! ```text
//! s = limits − G x ≥ 0:   n1, n2, slope (n1 + n2) − t, slope (n1 + n2) + t, and their limits
//! ```
//!
//! Every inequality has a multiplier z ≥ 0. In closed form nothing cancels, however far the weights
//! z/s of the four are apart.

/// Forces of a joint: two corners and the shear.
pub(super) type Forces = [f64; 3];

/// A value for each of the inequalities.
pub(super) type Rows = [f64; 4];

/// What a joint admits.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Law {
    pub(super) slope: f64,
    pub(super) limits: Rows,
    /// Whether the joint carries no shear at all, so that its last two inequalities leave no room
    /// for a point inside: the shear is then no variable.
    pub(super) is_smooth: bool,
}

/// Shear capacity, in the scene's weights, that counts as none.
const SMOOTH: f64 = 1e-13;

impl Law {
    pub(super) fn new(slope: f64, limits: Rows) -> Self {
        let capacity = limits[2] + limits[3];
        Self {
            slope,
            limits,
            is_smooth: slope == 0.0 && (0.0..=SMOOTH).contains(&capacity),
        }
    }

    /// How many of the inequalities count.
    pub(super) fn rows(&self) -> usize {
        if self.is_smooth { 2 } else { 4 }
    }

    /// G x.
    pub(super) fn rates(&self, [n1, n2, t]: Forces) -> Rows {
        let friction = self.slope * (n1 + n2);
        [-n1, -n2, t - friction, -t - friction]
    }

    /// Gᵀ z.
    pub(super) fn flow(&self, z: Rows) -> Forces {
        let dilation = self.slope * (z[2] + z[3]);
        [-z[0] - dilation, -z[1] - dilation, z[2] - z[3]]
    }

    /// x with G x nearest to `rates`, each row counted by its weight.
    pub(super) fn forces_of_rates(&self, rates: Rows, inverse_weights: Rows) -> Forces {
        if self.is_smooth {
            return [-rates[0], -rates[1], 0.0];
        }
        // What no forces reach.
        let free = self.free();
        let (mut missed, mut size) = (0.0, 0.0);
        for k in 0..4 {
            missed += free[k] * rates[k];
            size += free[k] * free[k] * inverse_weights[k];
        }
        let share = missed / size;
        let [n1, n2, plus, minus] =
            std::array::from_fn(|k| rates[k] - share * free[k] * inverse_weights[k]);
        [-n1, -n2, 0.5 * (plus - minus)]
    }

    /// The multipliers on which no forces do work: Gᵀ z = 0.
    fn free(&self) -> Rows {
        [-2.0 * self.slope, -2.0 * self.slope, 1.0, 1.0]
    }

    /// z with Gᵀ z = `flow` that is nearest to a `reference`, each row counted by 1/weight. The flow
    /// is met to the last digit, whatever the weights: what is lost, complementarity loses.
    pub(super) fn multipliers(&self, flow: Forces, reference: Rows, inverse_weights: Rows) -> Rows {
        if self.is_smooth {
            return [-flow[0], -flow[1], 0.0, 0.0];
        }
        let half = 0.5 * flow[2];
        let some = [-flow[0], -flow[1], half, -half];
        let free = self.free();
        let (mut moment, mut size) = (0.0, 0.0);
        for k in 0..4 {
            moment += free[k] * (reference[k] - some[k]) * inverse_weights[k];
            size += free[k] * free[k] * inverse_weights[k];
        }
        let share = moment / size;
        std::array::from_fn(|k| some[k] + share * free[k])
    }
}

/// The inverse of H = Gᵀ W G.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Inverse {
    /// Corner forces by corner forces: 11, 12, 22.
    corners: [f64; 3],
    /// Shear that goes with either corner force.
    along: f64,
    /// The shear's own part.
    shear: f64,
    /// What is left of 22 once the first corner is eliminated.
    second: f64,
}

impl Inverse {
    /// From one over the weights.
    pub(super) fn new(law: &Law, inverse_weights: Rows) -> Self {
        let [first, second, plus, minus] = inverse_weights;
        if law.is_smooth {
            return Self {
                corners: [first, 0.0, second],
                second,
                ..Self::default()
            };
        }
        let sum = 1.0 / (plus + minus);
        // Friction couples the corners, once the shear is eliminated.
        let coupling = 4.0 * law.slope * law.slope * sum;
        let share = 1.0 / (1.0 + coupling * (first + second));
        let after_second = 1.0 + coupling * second;
        Self {
            corners: [
                first * after_second * share,
                -coupling * first * second * share,
                second * (1.0 + coupling * first) * share,
            ],
            along: law.slope * (minus - plus) * sum,
            shear: plus * minus * sum,
            second: second / after_second,
        }
    }

    /// H⁻¹ times a vector.
    pub(super) fn apply(&self, [a, b, t]: Forces) -> Forces {
        let (a, b) = (a + self.along * t, b + self.along * t);
        let [c11, c12, c22] = self.corners;
        let (n1, n2) = (c11 * a + c12 * b, c12 * a + c22 * b);
        [n1, n2, self.shear * t + self.along * (n1 + n2)]
    }

    /// `wrench` R with R Rᵀ = H⁻¹.
    pub(super) fn root(&self, wrench: &[f64; 9]) -> [f64; 9] {
        let [c11, c12, _] = self.corners;
        let r11 = c11.sqrt();
        let r21 = c12 / r11;
        let r22 = self.second.sqrt();
        let (r31, r32) = (self.along * (r11 + r21), self.along * r22);
        let r33 = self.shear.sqrt();
        let mut out = [0.0; 9];
        for (out, w) in out.chunks_exact_mut(3).zip(wrench.chunks_exact(3)) {
            out[0] = w[0] * r11 + w[1] * r21 + w[2] * r31;
            out[1] = w[1] * r22 + w[2] * r32;
            out[2] = w[2] * r33;
        }
        out
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Laws and weights apart by up to 24 decades, without a pattern.
    fn samples() -> impl Iterator<Item = (Law, Rows, Forces)> {
        (0..200u32).map(|k| {
            let number = |row: u32| {
                let mixed = (k * 7 + row).wrapping_mul(2_654_435_761) >> 8;
                f64::from(mixed) / f64::from(1 << 24)
            };
            let law = Law::new(2.0 * number(0) - 0.5, [0.0, 0.0, 0.1, 0.1]);
            let weights = [1, 2, 3, 4].map(|row| 10f64.powf(24.0 * number(row) - 12.0));
            (law, weights, [5, 6, 7].map(|row| number(row) - 0.5))
        })
    }

    fn close(a: Forces, b: Forces, size: f64) {
        for (a, b) in a.iter().zip(b) {
            assert!((a - b).abs() <= 1e-13 * size, "{a} {b} {size}");
        }
    }

    #[test]
    fn the_inverse_is_its_root_squared() {
        let identity = [1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0];
        for (law, weights, forces) in samples() {
            let inverse = Inverse::new(&law, weights);
            let root = inverse.root(&identity);
            let column = |c: usize| [root[c], root[3 + c], root[6 + c]];
            let mut squared = [0.0; 3];
            for c in 0..3 {
                let share: f64 = column(c).iter().zip(forces).map(|(r, f)| r * f).sum();
                squared = std::array::from_fn(|k| squared[k] + share * column(c)[k]);
            }
            let largest = weights.into_iter().fold(0.0, f64::max);
            close(inverse.apply(forces), squared, largest);
        }
    }

    #[test]
    fn multipliers_meet_the_flow_whatever_the_weights() {
        for (law, weights, flow) in samples() {
            let multipliers = law.multipliers(flow, [0.3, -0.2, 0.1, 0.9], weights);
            let size = multipliers.iter().fold(1.0f64, |most, z| most.max(z.abs()));
            close(law.flow(multipliers), flow, size);
        }
    }

    #[test]
    fn forces_have_the_rates_that_forces_can_have() {
        for (law, weights, forces) in samples() {
            let found = law.forces_of_rates(law.rates(forces), weights);
            // What no forces reach is rounding, and shared out among the heaviest.
            close(found, forces, 10.0);
        }
    }

    #[test]
    fn a_joint_without_capacity_has_no_shear() {
        let law = Law::new(0.0, [0.0; 4]);
        assert_eq!(law.rows(), 2);
        assert_eq!(
            law.forces_of_rates([-1.0, -2.0, 5.0, 6.0], [1.0; 4]),
            [1.0, 2.0, 0.0]
        );
        let inverse = Inverse::new(&law, [2.0, 3.0, 1.0, 1.0]);
        assert_eq!(inverse.apply([1.0, 1.0, 7.0]), [2.0, 3.0, 0.0]);
        assert_eq!(Law::new(0.5, [0.0; 4]).rows(), 4);
    }
}
