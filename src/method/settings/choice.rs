//! Settings that are one of a few words.

use clap::ValueEnum;

/// How accurate the pushover has to be; everything else about it follows. The error is of either end
/// of its bracket against the limit, relative to λ.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Accuracy {
    /// An error of about 1 % of λ, and of 2 % above 30 courses.
    Coarse,
    /// An error of about 0.2 % of λ, and of 0.4 % above 30 courses.
    Normal,
    /// An error of about 0.05 % of λ, and of 0.2 % above 30 courses.
    Fine,
}

/// What a pushover calls collapse.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Collapse {
    /// Blocks run away and do not slow down.
    Runaway,
    /// A joint has slipped by a thousandth of the course height, though it may come to rest.
    FirstSlip,
}

/// What solves the linear programs.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Engine {
    /// An interior point that knows the structure of joints and blocks; Clarabel where it gives up.
    Structured,
    /// Clarabel, which solves any cone program.
    Clarabel,
}
