//! An interior point that knows the structure of the limit analysis: Mehrotra's predictor and
//! corrector (SIAM J. Optimization 2 (1992) 575-601) over forces in 3 × 3 blocks, so that each step
//! factorises a matrix with three unknowns a block.
//!
//! It answers or it gives up; it never says that a program has no optimum. What it answers is tested
//! here as Clarabel tests its own answers, and by blocks. Like Clarabel it ends in the middle of the
//! optimal face.
//!
//! Joints stand four side by side, and the factor is compiled for AVX2 as well: the search on paper-3 takes a quarter
//! less time so. Fewer passes over the joints, reciprocals for divisions, rows in multiples of four and fronts of
//! other sizes were no faster (measured).
//!
//! Two ways to need fewer iterations were measured and left out. Warm starts from the last program of
//! a search, shifted back to the central path, save 7 to 20 % of the iterations. Up to three more
//! corrections for every factor (Gondzio, Computational Optimization and Applications 6 (1996)
//! 137-156) save 7 to 47 %, but each one solves as often as a step does: on 33 to 1,176 blocks the
//! time stays much the same, on 4,656 in contact it falls by 8 to 19 %.

mod factor;
mod front;
mod interior_point;
mod joint;
mod law;
mod measure;
mod newton;
mod point;
mod start;
mod substitution;
mod symbolic;

pub(super) use point::InteriorPoint;
