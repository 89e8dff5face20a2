//! Lower and upper value of a multiplier.

use serde::{Deserialize, Serialize};

/// Relative width up to which two proved ends count as one number.
pub const VERIFIED_WIDTH: f64 = 1e-6;

/// Share of its unit below which a multiplier is small: its digits are worth no more than those of
/// one as large.
const SMALL: f64 = 1e-3;

/// What differences from a multiplier are relative to: its size, or a thousandth of the scene's
/// `unit` of λ ([`Scene::multiplier_unit`](crate::scene::Scene::multiplier_unit)) where it is
/// smaller.
pub fn magnitude(lambda: f64, unit: f64) -> f64 {
    lambda.abs().max(SMALL * unit)
}

/// Largest difference of λ between collapse states that count as one, relative to the [`magnitude`]
/// of λ.
const SAME_MULTIPLIER: f64 = 1e-6;

/// Whether collapse states of these λ count as one, λ being in a scene's `unit`.
pub fn is_same_multiplier(lambda: f64, other: f64, unit: f64) -> bool {
    (lambda - other).abs() <= SAME_MULTIPLIER * magnitude(other, unit)
}

/// Lower and upper value of a collapse multiplier; what each means is the method's to say.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Bracket {
    /// Lower value.
    pub lower: f64,
    /// Upper value.
    pub upper: f64,
}

impl Bracket {
    /// Both ends at one value.
    pub const fn point(lambda: f64) -> Self {
        Self {
            lower: lambda,
            upper: lambda,
        }
    }

    /// What both cover.
    pub fn hull(self, other: Self) -> Self {
        Self {
            lower: self.lower.min(other.lower),
            upper: self.upper.max(other.upper),
        }
    }

    /// Distance of both ends.
    pub fn width(&self) -> f64 {
        self.upper - self.lower
    }

    /// Width relative to the [`magnitude`] of λ, in a scene with this unit of λ.
    pub fn relative_width(&self, unit: f64) -> f64 {
        self.width() / magnitude(self.upper, unit)
    }

    /// Whether both ends are one number, for an answer with both ends proved: NaN is none, nor are
    /// ends that cross by more than rounding.
    pub fn is_one_number(&self, unit: f64) -> bool {
        (-1e-9..=VERIFIED_WIDTH).contains(&self.relative_width(unit))
    }

    /// Largest distance of either end from a reference, relative to the [`magnitude`] of that, in a
    /// scene with this unit of λ.
    pub fn error(&self, reference: f64, unit: f64) -> f64 {
        let distance = |end: f64| (end - reference).abs();
        distance(self.lower).max(distance(self.upper)) / magnitude(reference, unit)
    }
}
