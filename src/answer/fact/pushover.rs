//! Facts of the pushover.

use serde::{Deserialize, Serialize};
use thiserror::Error;

use super::super::bracket::Bracket;
use super::super::self_check::{SelfCheck, Variation};
use crate::number::{number, short};

/// What a pushover ends with, or why it has no answer.
#[derive(Clone, Debug, Error, PartialEq, Serialize, Deserialize)]
#[allow(missing_docs, reason = "the sentence of each says it")]
pub enum PushoverFact {
    #[error(
        "this is the load at which a joint first slips by {slip:e} course heights, not the \
         collapse load"
    )]
    FirstSlip {
        /// Slip that counts, in course heights.
        slip: f64,
    },
    #[error(
        "the substeps are longer or the contacts softer than those that the stated error was \
         measured with"
    )]
    Uncalibrated,
    /// A check that every answer needs, or one that a user asked for, with its figures.
    #[error("{0}")]
    Checked(SelfCheck),
    /// A self-check takes the number away.
    #[error("a self-check failed: {0}")]
    SelfCheckFailed(SelfCheck),
    /// A repetition under `verify` takes the number away.
    #[error("a check of `verify` failed: {0}")]
    VerificationFailed(SelfCheck),
    #[error("the scene has no blocks")]
    NoBlocks,
    #[error("no block has a weight")]
    NoWeight,
    /// Weights of blocks that act on each other differ by more than can be judged.
    #[error(
        "{heavy} is {ratio:.1e} times as heavy as {light}, and beyond {most:.0e} the engine cannot \
         tell whether the lighter one rests"
    )]
    UnequalWeights {
        light: String,
        heavy: String,
        ratio: f64,
        /// The largest that is answered.
        most: f64,
    },
    #[error(
        "more than {most} joints lie within a course height of each other, and the engine cannot \
         tell more apart"
    )]
    Crowded { most: usize },
    #[error("the contacts are stiffer than the substep can hold")]
    TooStiff,
    #[error(
        "under its own weight alone a block moved by more than {distance} course heights within t \
         = {time:.0} √(H_c/g) and did not slow down"
    )]
    Fell {
        /// Displacement that it exceeded, in course heights.
        distance: f64,
        /// Time within which it did, in √(H_c/g).
        time: f64,
    },
    /// The scene fell under its weight alone, but stands with a push against the live load, or with
    /// shorter substeps: its multiplier is too near to 0 to tell.
    #[error(
        "λ is nearer to 0 than {resolution}, which is too near to tell whether the scene falls \
         under its own weight"
    )]
    NearZero {
        /// What λ is told to be below.
        resolution: f64,
    },
    #[error("under its own weight alone the scene did not come to rest within t = {time} √(H_c/g)")]
    NotSettled {
        /// Time that it had, in √(H_c/g).
        time: f64,
    },
    #[error("the pushover used up the time steps allowed; the last load at rest was λ = {}", short(*.lambda, 6))]
    OutOfSteps {
        /// Last multiplier at rest.
        lambda: f64,
    },
    #[error("the scene still stands at λ = {}, and nothing larger is tried", short(*.lambda, 6))]
    StillStands {
        /// Last multiplier at rest.
        lambda: f64,
    },
    #[error(
        "at λ = {} the scene neither rests nor collapses within the time allowed",
        short(*.lambda, 6)
    )]
    Unclear { lambda: f64 },
    #[error(
        "it was not run: with head joints in contact pushovers take long on {blocks} blocks; the setting \
         `long-ranges` runs them"
    )]
    RangeNotRun { blocks: usize },
    #[error(
        "it was not finished, because shorter substeps take long; so far they gave {}; the setting \
         `long-ranges` runs all",
        all_printed(.so_far)
    )]
    RangeUnfinished {
        /// The brackets of those that were run, from the longest substep to the shortest.
        so_far: Vec<Bracket>,
    },
    #[error("the scene cannot be mirrored, which a range needs")]
    NoMirror,
    #[error(
        "this is a range over the scene and its mirror image, because with head joints in contact the \
         collapse load is not unique"
    )]
    Range,
    #[error(
        "collapse states are verified from {} to {}, and this is what was seen of them, not their \
         range",
        number(.states.lower, 5),
        number(.states.upper, 5)
    )]
    OfSeveral {
        /// From the lowest to the highest.
        states: Bracket,
    },
    /// No collapse state is reached: the scene falls from where it no longer stays, as contacts with friction may.
    #[error(
        "it falls in a jump: at its onset up to {} % of the work of the push has gone into motion, and at a \
         collapse state none does, so that it may fall below the lowest of these",
        short(100.0 * .part, 1)
    )]
    Jumps {
        /// Part of the work of the push, the larger one of the last two levels.
        part: f64,
    },
    /// Blocks slide away before the scene collapses, and levels do not agree on where it does.
    #[error(
        "blocks slide away before the scene collapses: this is the load at which the first of them leaves its place"
    )]
    SlidesFirst,
    #[error(
        "one length of the substep alone gave an answer, {}, and a second one is needed to measure \
         its error",
        printed(.bracket)
    )]
    OneLevel { bracket: Bracket },
    #[error(
        "shorter and shorter substeps do not agree on one multiplier; they gave {}",
        all_printed(.brackets)
    )]
    LevelsDisagree {
        /// Their brackets, from the longest substep to the shortest.
        brackets: Vec<Bracket>,
    },
    /// One variation of a range has no answer, for the reasons after this one.
    #[error("{0}")]
    Without(Variation),
}

/// A bracket with the decimals of tables.
fn printed(Bracket { lower, upper }: &Bracket) -> String {
    format!("{}-{}", number(*lower, 5), number(*upper, 5))
}

/// Brackets, parted by commas.
fn all_printed(brackets: &[Bracket]) -> String {
    let brackets: Vec<String> = brackets.iter().map(printed).collect();
    brackets.join(", ")
}
