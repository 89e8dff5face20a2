//! Certificates of a lower bound of non-associative collapse, and their proof by sparse products.
//!
//! A collapse state without dilatancy pairs forces s = (1, λ, n1, n2, t …) with a motion k = (u, g⁺),
//! where g⁺ ≥ 0 and g⁻ = g⁺ − slip ≥ 0 are the forward and the backward part of each joint's slip.
//! Where the push does work, the motion is scaled so that this work f_L·u is 1. Then every product of
//!
//! ```text
//! a force condition  n1, n2, μN + t, μN − t, 1, λ − a, b − λ ≥ 0    (a ≤ λ ≤ b)
//! and a rate         opening 1, opening 2, g⁺, g⁻, f_L·u ≥ 0
//! ```
//!
//! is not negative, and zero where a corner force meets its own opening, μN + t its own g⁺, μN − t
//! its own g⁻. Further rates are what each slip falls short of its bounds: with g⁺ = max(slip, 0), the
//! other joints of a closed chain limit it (`slips.rs`); a certificate says how long its chains are. Forces are in equilibrium, E s = 0. A
//! certificate of a slice [a, b] gives multipliers m, not negative but for those of the zero products,
//! and ν of any sign, such that for all s and k
//!
//! ```text
//! λ·(f_L·u) − σ·(1·f_L·u) = Σ m · (force condition × rate) + Σ ν · (E s)·k + ⟨R, s kᵀ⟩
//! ```
//!
//! with R small. For a collapse state in the slice the left side is λ − σ and the first two sums
//! are at least zero, so λ ≥ σ + ⟨R, s kᵀ⟩. With σ above b no state has its λ in the slice at all:
//! that is a Farkas proof.
//!
//! A slice without an upper end begins at 0 and has −σ ((1 + 2 λ) f_L·u + f_D·u) on the left side. As friction
//! takes the work of all loads, f_D·u + λ f_L·u = Σ μN |slip|, that is −σ ((1 + λ) f_L·u + Σ μN |slip|). A
//! positive σ proves that there is no collapse state but for motions against the push: neither one in which the
//! push does work nor one in which it does none and the weight does.
//!
//! A slice may assume that one factor of a zero product is zero: a corner without pressure or one that does not
//! open. Then all its products are zero and their multipliers have any sign; every collapse state meets that
//! assumption or the one about the other factor, so that two slices, one with each, prove it of all states. The
//! one that assumes a zero slip covers every state without that slip. The one that assumes its friction force
//! to be zero need only cover the others: they slip in that direction, so that the slip in the other one is
//! zero too. The products are those of a first-level reformulation-linearisation (Sherali and Adams, SIAM J.
//! Discrete Math. 3 (1990) 411-430) of a linear program with complementarity constraints; nothing is ever asked
//! of a solver here.
//!
//! The slips' bounds hold but for the rounding of their shares, which is part of R.
//!
//! What rounding leaves, R, is computed in twice the working precision. It is bounded over
//! everything that s and k can be:
//!  - forces by one motion v that opens every joint by more than μ times its slip. By virtual work
//!    Σ n·opening + t·slip = −f_D·v − λ f_L·v, so that Σ ε N is no more than that, ε being what each
//!    joint opens beyond μ|slip|. Scenes that lock have no such motion and no certificate. Without an upper end
//!    both sides are over 1 + λ, which bounds what forces at rest and λ times the live load can be;
//!  - velocities by the rates along a chain of joints from a support; that of supports that move, which
//!    is one for all of them, by the power of their live load, which is 1. Where the multiplier of
//!    1 × rate is at least what R needs of that rate, R is absorbed, however fast the motion. Where it
//!    is not, the bound holds for motions whose openings and slips add up to no more than a printed
//!    cap (total weight, height and f_L·u scaled to 1).
//!
//! The conditions are those that the program computes from the scene in double precision.

mod conditions;
mod encoding;
mod forces;
mod proof;
mod rounding;
mod slips;
mod sum;
mod tree;
mod types;

pub(crate) use conditions::{Conditions, Entry, Unknown};
pub use proof::prove;
pub(crate) use proof::{Prover, scene_fingerprint};
pub(crate) use tree::{SliceProof, together};
pub use types::{Assumption, Certificate, Factor, LongestWay, Proved, Refusal, Slice};
pub(crate) use types::{Zeros, left_side};
