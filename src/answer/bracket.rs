//! Lower and upper value of a multiplier.

/// Relative width up to which two proved ends count as one number.
const VERIFIED_WIDTH: f64 = 1e-6;

/// Lower and upper value of a collapse multiplier; what each means is the method's to say.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bracket {
    /// Lower value.
    pub lower: f64,
    /// Upper value.
    pub upper: f64,
}

impl Bracket {
    /// Both ends at one value.
    pub fn point(lambda: f64) -> Self {
        Self {
            lower: lambda,
            upper: lambda,
        }
    }

    /// Width relative to max(|λ|, 1e-3).
    pub fn relative_width(&self) -> f64 {
        (self.upper - self.lower) / self.upper.abs().max(1e-3)
    }

    /// Whether both ends are one number, for an answer with both ends proved: NaN is none, nor are
    /// ends that cross by more than rounding.
    pub fn is_one_number(&self) -> bool {
        (-1e-9..=VERIFIED_WIDTH).contains(&self.relative_width())
    }

    /// Largest distance of either end from a reference, relative to max(|reference|, 1e-3).
    pub fn error(&self, reference: f64) -> f64 {
        let distance = |end: f64| (end - reference).abs();
        distance(self.lower).max(distance(self.upper)) / reference.abs().max(1e-3)
    }
}
