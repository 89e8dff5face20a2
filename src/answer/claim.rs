//! What an answer is put forward as.

use serde::{Deserialize, Serialize};

/// What an answer's forces and mechanism are put forward as; the judge proves that and nothing else.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub enum Claim {
    /// A collapse state without dilatancy: forces and mechanism satisfy every condition together.
    #[default]
    CollapseState,
    /// Bounds of λ_A: `forces` are admissible at `bracket.lower`, `mechanism` by associative
    /// friction, and its own multiplier is no larger than `bracket.upper`.
    Associative,
    /// A collapse state at `bracket.lower`, and `ceiling` as in `Associative` for `bracket.upper`.
    Enclosed,
    /// A certificate that no collapse state lies below `bracket.lower`, and a collapse state at
    /// `bracket.upper`.
    Bounded,
    /// Something seen, not proved, as in an experiment.
    Observed,
}

impl Claim {
    /// Every claim.
    pub const ALL: [Claim; 5] = [
        Claim::CollapseState,
        Claim::Associative,
        Claim::Enclosed,
        Claim::Bounded,
        Claim::Observed,
    ];

    /// The word in journals.
    pub fn name(self) -> &'static str {
        match self {
            Claim::CollapseState => "collapse-state",
            Claim::Associative => "associative",
            Claim::Enclosed => "enclosed",
            Claim::Bounded => "bounded",
            Claim::Observed => "observed",
        }
    }
}
