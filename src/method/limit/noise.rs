//! Deterministic pseudo-random numbers.

/// A fixed sequence of numbers in [0, 1) (xorshift, Marsaglia 2003).
pub(super) struct Noise(u64);

impl Noise {
    /// The sequence of that number; every one is the same in every run.
    pub(super) fn new(sequence: usize) -> Self {
        // Any odd constant would do.
        Self((sequence as u64 + 1).wrapping_mul(0x9E37_79B9_7F4A_7C15))
    }

    pub(super) fn uniform(&mut self) -> f64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 11) as f64 / (1u64 << 53) as f64
    }

    /// A number between two others.
    pub(super) fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.uniform()
    }
}
