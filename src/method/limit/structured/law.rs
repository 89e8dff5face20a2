//! The equations of joints: two corner forces and a shear against four inequalities.
//!
//! ```text
//! s = limits − G x ≥ 0:   n1, n2, slope (n1 + n2) − t, slope (n1 + n2) + t, and their limits
//! ```
//!
//! Every inequality has a multiplier z ≥ 0. In closed form nothing cancels, however far the weights
//! z/s of the four are apart. Four joints are taken side by side, as processors add and multiply several numbers at
//! once: the arithmetic of every joint is the same whatever stands beside it.

/// A number of every joint side by side.
pub(super) type Lanes = wide::f64x4;

/// How many joints stand side by side.
pub(super) const LANES: usize = 4;

/// Forces of a joint: two corners and the shear.
pub(super) type Forces = [Lanes; 3];

/// A value for each of the inequalities.
pub(super) type Rows = [Lanes; 4];

/// What joints admit.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Law {
    slope: Lanes,
    /// Zero for inequalities that do not count.
    pub(super) limits: Rows,
    /// Mask of the forces that are variables. A joint that carries no shear at all leaves no room for a point inside
    /// its last two inequalities: the shear is then no variable, and these do not count.
    are_variables: Forces,
    /// Mask of the inequalities that count.
    counting: Rows,
}

/// Shear capacity, in the scene's weights, that counts as none.
const SMOOTH: f64 = 1e-13;

impl Law {
    /// The law of the lanes in which there `are` joints.
    pub(super) fn new(slope: Lanes, limits: Rows, are: [bool; LANES]) -> Self {
        let (slopes, capacity) = (slope.to_array(), (limits[2] + limits[3]).to_array());
        let is_smooth =
            |lane: usize| slopes[lane] == 0.0 && (0.0..=SMOOTH).contains(&capacity[lane]);
        let rough = mask(std::array::from_fn(|lane| are[lane] && !is_smooth(lane)));
        let joints = mask(are);
        let counting = [joints, joints, rough, rough];
        Self {
            slope: slope & joints,
            limits: masked(limits, counting),
            are_variables: [joints, joints, rough],
            counting,
        }
    }

    /// Values of the inequalities that count; zero for the others.
    pub(super) fn counted(&self, values: Rows) -> Rows {
        masked(values, self.counting)
    }

    /// Values of the inequalities that count; `other` for the others.
    pub(super) fn counted_or(&self, values: Rows, other: f64) -> Rows {
        let other = Lanes::splat(other);
        std::array::from_fn(|k| self.counting[k].select(values[k], other))
    }

    /// Values of the forces that are variables; zero for the others.
    pub(super) fn of_variables(&self, values: Forces) -> Forces {
        masked(values, self.are_variables)
    }

    /// How many of the inequalities count.
    pub(super) fn rows(&self) -> usize {
        let rows = self
            .counting
            .iter()
            .map(|mask| mask.to_bitmask().count_ones());
        rows.sum::<u32>() as usize
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
        // What no forces reach.
        let free = self.free();
        let (mut missed, mut size) = (Lanes::ZERO, Lanes::ZERO);
        for k in 0..4 {
            missed += free[k] * rates[k];
            size += free[k] * free[k] * inverse_weights[k];
        }
        let share = missed / size;
        let [n1, n2, plus, minus] =
            std::array::from_fn(|k| rates[k] - share * free[k] * inverse_weights[k]);
        self.of_variables([-n1, -n2, Lanes::HALF * (plus - minus)])
    }

    /// The multipliers on which no forces do work: Gᵀ z = 0.
    fn free(&self) -> Rows {
        let (slope, one) = (Lanes::splat(-2.0) * self.slope, Lanes::ONE);
        [slope, slope, one, one]
    }

    /// z with Gᵀ z = `flow` that is nearest to a `reference`, each row counted by 1/weight. The flow
    /// is met to the last digit, whatever the weights: what is lost, complementarity loses.
    pub(super) fn multipliers(&self, flow: Forces, reference: Rows, inverse_weights: Rows) -> Rows {
        let half = Lanes::HALF * flow[2];
        let some = [-flow[0], -flow[1], half, -half];
        let free = self.free();
        let (mut moment, mut size) = (Lanes::ZERO, Lanes::ZERO);
        for k in 0..4 {
            moment += free[k] * (reference[k] - some[k]) * inverse_weights[k];
            size += free[k] * free[k] * inverse_weights[k];
        }
        let share = moment / size;
        self.counted(std::array::from_fn(|k| some[k] + share * free[k]))
    }

    /// The inverse of H = Gᵀ W G, from one over the weights.
    pub(super) fn inverse(&self, inverse_weights: Rows) -> Inverse {
        let [first, second, plus, minus] = inverse_weights;
        let one = Lanes::ONE;
        let sum = one / (plus + minus);
        // Friction couples the corners, once the shear is eliminated.
        let coupling = Lanes::splat(4.0) * self.slope * self.slope * sum;
        let after_second = one + coupling * second;
        let share = one / (one + coupling * (first + second));
        let left = second / after_second;
        let [corner, left, shear] =
            self.of_variables([first * after_second * share, left, plus * minus * sum]);
        Inverse {
            diagonal: [corner, left, shear],
            second: -coupling * left,
            along: self.slope * (minus - plus) * sum,
        }
    }
}

/// All bits of the lanes that are meant.
fn mask(are: [bool; LANES]) -> Lanes {
    let bits = |is: bool| if is { f64::from_bits(u64::MAX) } else { 0.0 };
    Lanes::new(are.map(bits))
}

/// Values under a mask, zero elsewhere.
fn masked<const N: usize>(values: [Lanes; N], mask: [Lanes; N]) -> [Lanes; N] {
    std::array::from_fn(|k| values[k] & mask[k])
}

/// The sum of lanes, joint by joint.
pub(super) fn sum<const N: usize>(values: [Lanes; N]) -> Lanes {
    values
        .into_iter()
        .fold(Lanes::ZERO, |sum, value| sum + value)
}

/// The sum over all lanes, one after the other.
pub(super) fn total(lanes: Lanes) -> f64 {
    lanes.as_array().iter().sum()
}

/// The inverse of H = Gᵀ W G as L D Lᵀ, L with ones on the diagonal.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Inverse {
    /// D.
    diagonal: Forces,
    /// Force of the second corner that goes with that of the first.
    second: Lanes,
    /// Shear that goes with either corner force.
    along: Lanes,
}

impl Inverse {
    /// H⁻¹ times a vector.
    pub(super) fn apply(&self, [a, b, t]: Forces) -> Forces {
        let [first, left, shear] = self.diagonal;
        let (a, b) = (a + self.along * t, b + self.along * t);
        let n1 = first * (a + self.second * b);
        let n2 = left * b + self.second * n1;
        [n1, n2, shear * t + self.along * (n1 + n2)]
    }

    /// `wrench` L, row by row.
    pub(super) fn lower(&self, wrench: &[Lanes; 9]) -> [Lanes; 9] {
        let mut out = *wrench;
        for row in 0..3 {
            let [n1, n2, t] = [0, 1, 2].map(|k| wrench[3 * row + k]);
            out[3 * row + 1] = n2 + self.along * t;
            out[3 * row] = n1 + self.second * n2 + self.along * (t + self.second * t);
        }
        out
    }

    /// Such a product times D.
    pub(super) fn scaled(&self, lower: &[Lanes; 9]) -> [Lanes; 9] {
        std::array::from_fn(|k| lower[k] * self.diagonal[k % 3])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Laws and weights apart by up to 24 decades, without a pattern.
    fn samples() -> impl Iterator<Item = (Law, Rows, Forces)> {
        (0..50u32).map(|k| {
            let number = |row: u32| {
                Lanes::new([0, 1, 2, 3].map(|lane| {
                    let mixed = ((4 * k + lane) * 7 + row).wrapping_mul(2_654_435_761) >> 8;
                    f64::from(mixed) / f64::from(1 << 24)
                }))
            };
            let slope = number(0) + number(0) - Lanes::HALF;
            let limits = [0.0, 0.0, 0.1, 0.1].map(Lanes::splat);
            let law = Law::new(slope, limits, [true; LANES]);
            let weight = |number: f64| 10f64.powf(24.0 * number - 12.0);
            let weights = [1, 2, 3, 4].map(|row| Lanes::new(number(row).to_array().map(weight)));
            (law, weights, [5, 6, 7].map(|row| number(row) - Lanes::HALF))
        })
    }

    fn close(a: Forces, b: Forces, size: Lanes) {
        for (a, b) in a.iter().zip(b) {
            let far = (*a - b).abs() - Lanes::splat(1e-13) * size;
            let is_close = far.to_array().iter().all(|far| *far <= 0.0);
            assert!(is_close, "{a:?} {b:?} {size:?}");
        }
    }

    #[test]
    fn the_inverse_is_what_the_matrix_gets() {
        let identity = [1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0].map(Lanes::splat);
        for (law, weights, forces) in samples() {
            let inverse = law.inverse(weights);
            let lower = inverse.lower(&identity);
            let scaled = inverse.scaled(&lower);
            let column = |of: &[Lanes; 9], c: usize| [of[c], of[3 + c], of[6 + c]];
            let mut product = Forces::default();
            for c in 0..3 {
                let lower = column(&lower, c);
                let share = sum(std::array::from_fn::<_, 3, _>(|k| lower[k] * forces[k]));
                let scaled = column(&scaled, c);
                product = std::array::from_fn(|k| product[k] + share * scaled[k]);
            }
            let largest = weights.into_iter().fold(Lanes::ZERO, Lanes::max);
            close(inverse.apply(forces), product, largest);
        }
    }

    #[test]
    fn multipliers_meet_the_flow_whatever_the_weights() {
        for (law, weights, flow) in samples() {
            let reference = [0.3, -0.2, 0.1, 0.9].map(Lanes::splat);
            let multipliers = law.multipliers(flow, reference, weights);
            let size = multipliers
                .iter()
                .fold(Lanes::ONE, |most, z| most.max(z.abs()));
            close(law.flow(multipliers), flow, size);
        }
    }

    #[test]
    fn forces_have_the_rates_that_forces_can_have() {
        for (law, weights, forces) in samples() {
            let found = law.forces_of_rates(law.rates(forces), weights);
            // What no forces reach is rounding, and shared out among the heaviest.
            close(found, forces, Lanes::splat(10.0));
        }
    }

    #[test]
    fn a_joint_without_capacity_has_no_shear() {
        let splat = |values: [f64; 4]| values.map(Lanes::splat);
        let one = |slope: f64| {
            let joints = [true, false, false, false];
            Law::new(Lanes::splat(slope), Rows::default(), joints)
        };
        let of_joint = |forces: Forces| forces.map(|lanes| lanes.to_array()[0]);
        let law = one(0.0);
        assert_eq!(law.rows(), 2);
        let weights = splat([2.0, 3.0, 1.0, 1.0]);
        let found = law.forces_of_rates(splat([-1.0, -2.0, 5.0, 6.0]), weights);
        assert_eq!(of_joint(found), [1.0, 2.0, 0.0]);
        let forces = law
            .inverse(weights)
            .apply([1.0, 1.0, 7.0].map(Lanes::splat));
        assert_eq!(of_joint(forces), [2.0, 3.0, 0.0]);
        assert_eq!(one(0.5).rows(), 4);
    }

    #[test]
    fn lanes_without_a_joint_stay_out() {
        for (law, weights, forces) in samples() {
            let law = Law::new(law.slope, law.limits, [true, true, false, true]);
            assert_eq!(law.rows(), 12);
            let of_lane = |values: &[Lanes]| values.iter().all(|v| v.to_array()[2] == 0.0);
            assert!(of_lane(&law.limits));
            assert!(of_lane(&law.multipliers(forces, Rows::default(), weights)));
            assert!(of_lane(&law.forces_of_rates(weights, weights)));
        }
    }
}
