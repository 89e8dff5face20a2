//! An interior point that knows the structure of the limit analysis: Mehrotra's predictor and
//! corrector (SIAM J. Optimization 2 (1992) 575-601) over forces in 3 × 3 blocks, so that each step
//! factorises a matrix with three unknowns a block.
//!
//! It answers or it gives up; it never says that a program has no optimum. What it answers is tested
//! here as Clarabel tests its own answers, and by blocks. Like Clarabel it ends in the middle of the
//! optimal face.

mod factor;
mod interior_point;
mod joint;
mod law;
mod measure;
mod newton;
mod point;
mod problem;
mod start;
mod substitution;
mod symbolic;

pub(super) use point::InteriorPoint;
pub(super) use problem::Problem;
