//! What the λ that governs allows: against what a case demands, as an acceleration, and as a tilt of the
//! ground.

use super::governing::Governing;
use crate::judge::Basis;
use crate::number::{above, below, short};

impl Governing<'_> {
    /// How many times the demanded λ the shown one is, never rounded up; of an upper bound never rounded
    /// down.
    pub(super) fn against_demand(&self) -> Option<String> {
        let (of, demand) = (self.conclusion, self.demand?);
        let times = without_noise(of.collapse_known()?) / demand;
        let written = format!("the demand of {}", short(demand, 5));
        Some(match of.basis {
            Basis::UpperBound => format!("That is at most {} times {written}.", above(times, 2)),
            _ if of.basis != Basis::LowestState || !of.is_explained() => {
                format!("That would be {} times {written}.", below(times, 2))
            }
            _ if times < 1.0 => {
                format!(
                    "That falls short of {written}: it is only {} times the demand.",
                    below(times, 2)
                )
            }
            _ => format!("That is {} times {written}.", below(times, 2)),
        })
    }

    /// The λ as an acceleration and as a tilt of the ground, rounded to the safe side of the digits that
    /// are shown: of a verified state that nothing speaks against, and of an upper bound.
    pub(super) fn in_use(&self) -> Option<String> {
        let of = self.conclusion;
        // Only where the push is a tilt of the ground.
        self.terms.as_ref()?.tilt?;
        let lambda = without_noise(of.collapse_known()?);
        let tilt = lambda.atan().to_degrees();
        Some(match of.basis {
            Basis::UpperBound => {
                let g = above(lambda, decimals(lambda, 3));
                let tilt = above(tilt, decimals(tilt, 1));
                format!(
                    "It collapses at {g} g, or where the ground tilts by {tilt}°, at the latest."
                )
            }
            _ if of.basis != Basis::LowestState || !of.is_explained() => return None,
            _ if lambda < SHOWN_AS_0 => "It may fall without a push.".to_owned(),
            _ => {
                let g = below(lambda, decimals(lambda, 3));
                let tilt = below(tilt, decimals(tilt, 1));
                format!("It may be shaken with up to {g} g, or the ground tilt by {tilt}°.")
            }
        })
    }
}

/// λ below which five decimals, those that are shown of it, are zeros.
const SHOWN_AS_0: f64 = 5e-6;

/// λ without the noise of a solver, by which 0.2 may be 0.19999999: to five decimals, or two more than are
/// allowed for. Of a small λ five would be too rough to lie on the safe side.
fn without_noise(lambda: f64) -> f64 {
    let unit = 10f64.powi(decimals(lambda, 3) as i32 + 2);
    (unit * lambda).round() / unit
}

/// Decimals for a value: so many, and more where else fewer than two digits would be left of it. No λ has
/// more than seven.
fn decimals(value: f64, least: usize) -> usize {
    match value > 0.0 {
        true => least.max((1.0 - value.log10().floor()).clamp(0.0, 7.0) as usize),
        false => least,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn two_digits_are_left_and_nothing_asks_for_more_than_seven() {
        let of = |value| decimals(value, 3);
        assert_eq!(
            [0.5, 0.02, 0.0085, 0.00053, 0.000006].map(of),
            [3, 3, 4, 5, 7]
        );
        assert_eq!(
            [0.0, -0.1, f64::NAN, 1e-300, f64::INFINITY].map(of),
            [3, 3, 3, 7, 3]
        );
    }

    /// 0.000526 is 0.00053 to five decimals: what is allowed may not be that.
    #[test]
    fn noise_goes_and_a_small_multiplier_stays() {
        let shown = |lambda: f64| {
            let lambda = without_noise(lambda);
            let decimals = decimals(lambda, 3);
            [below(lambda, decimals), above(lambda, decimals)]
        };
        assert_eq!(shown(0.199_999_99), ["0.200", "0.200"]);
        assert_eq!(shown(0.638_977), ["0.638", "0.639"]);
        assert_eq!(shown(0.000_526), ["0.00052", "0.00053"]);
        assert_eq!(shown(0.000_534), ["0.00053", "0.00054"]);
    }
}
