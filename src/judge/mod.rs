//! The judge: recomputes every residual from forces and mechanism, outside the methods, and says
//! what holds between methods and against published values.

mod both;
mod check;
mod claims;
mod conclude;
mod conclusion;
mod cross_check;
mod heard;
mod judgement;
mod outside;
mod proof;
mod reaction;
mod references;
mod sentence;

pub use crate::mechanics::Recomputed;
pub(crate) use both::{governing, of_wall};
pub use check::{Check, Verdict};
pub(crate) use conclude::conclude;
pub use conclusion::{Basis, Conclusion, Difference, Doubt, Explanation, Floor};
pub(crate) use cross_check::{cross_check, open_never_raises};
pub use heard::LowerState;
pub use judgement::Judgement;
pub use proof::judge;
pub(crate) use references::{Computed, compare, comparisons, computed, reference_checks};

#[cfg(test)]
mod tests;
