//! Facts of the limit analyses.

use serde::{Deserialize, Serialize};
use thiserror::Error;

use crate::mechanics::BlockResidual;
use crate::number::below;

/// What a limit analysis proves, or fails to.
#[derive(Clone, Debug, Error, PartialEq, Serialize, Deserialize)]
#[allow(missing_docs, reason = "the sentence of each says it")]
pub enum LimitFact {
    /// The scene falls: the mechanism is the proof.
    #[error("a mechanism moves without any push{}", moves_first(.first))]
    MovesUnpushed {
        /// Names of the blocks that come down, in the scene's order; empty where all of them do.
        first: Vec<String>,
    },
    /// The scene stands: the ray of forces is the proof.
    #[error("the joints can balance every push, however large it is")]
    ForcesWithoutLimit,
    #[error(
        "neither forces nor a mechanism prove whether it stands under its own weight{}",
        .solver.as_ref().map_or_else(String::new, |solver| format!(": {solver}"))
    )]
    OwnWeightUndecided {
        /// What the solver says of the last program, where it found no optimum.
        solver: Option<SolverEnding>,
    },
    /// The program for λ_A has no optimum, and nothing proves why.
    #[error("the multiplier is not proved: {0}")]
    NoOptimum(SolverEnding),
    /// Forces or mechanism of a scene of very unequal blocks or very rough joints violate their
    /// conditions by more than a proof may.
    #[error("the proof fails: the largest residual is {residual:.1e}")]
    Unproved {
        /// Largest residual over the whole scene.
        residual: f64,
    },
    /// The same of one block, by its own forces or velocities.
    #[error("the proof fails at one block: {0}")]
    Unresolved(BlockResidual),
    /// Force state and mechanism of λ_A do not meet.
    #[error(
        "the multipliers of the force state and of the mechanism are {relative_width:.1e} apart"
    )]
    Apart {
        /// Distance of their multipliers over the larger one.
        relative_width: f64,
    },
    /// A user asked for programs that are too loose to prove anything.
    #[error("the programs were solved loosely, as the settings ask")]
    Loose,
    /// The same, and the live load does no work on the mechanism found.
    #[error("{}, and the mechanism found has no multiplier", LimitFact::Loose)]
    LooseWithoutMultiplier,
    /// The interval is what was found; these are the rigorous bounds.
    #[error(
        "{MAY_HAVE_MISSED}{}",
        match .frictionless {
            Some(lambda) if *lambda >= 1e-5 => format!(", but none lies below {}", below(*lambda, 5)),
            _ => ": no lower bound is proved".to_owned(),
        }
    )]
    FoundNoBounds {
        /// Rigorous lower bound: λ without friction, where that is proved. The upper one is λ_A.
        frictionless: Option<f64>,
    },
    /// The same, where another method of the run proves more.
    #[error("{MAY_HAVE_MISSED}, but {by} proves that {proof}")]
    FoundAboveBound {
        /// What it proves, in words.
        proof: String,
        by: String,
    },
    /// The interval is what was found, although with associative friction nothing collapses.
    #[error("{MAY_HAVE_MISSED}; with associative friction none exists")]
    FoundWithoutBound,
    /// The lowest state found is at λ = 0: forces at rest are not determined, and with some of them the
    /// scene falls.
    #[error("it may fall without a push, as the forces of friction at rest are not determined")]
    AtRest,
    /// No state was found where with associative friction none exists, which proves nothing of
    /// friction without dilatancy.
    #[error("the search found no collapse state; with associative friction none exists")]
    NoneFoundWithoutBound,
}

/// What holds of every search.
const MAY_HAVE_MISSED: &str = "the search may have missed other collapse states";

/// Names that are written out at most; of more, the first ones are, and the others are counted.
const NAMED: usize = 4;

/// The blocks that move first, as the end of a sentence.
fn moves_first(first: &[String]) -> String {
    match first {
        [] => String::new(),
        [one] => format!(": {one} moves first"),
        [named @ .., last] if named.len() < NAMED => {
            format!(": {} and {last} move first", named.join(", "))
        }
        _ => {
            let (named, others) = first.split_at(NAMED - 1);
            let others = others.len();
            format!(": {} and {others} others move first", named.join(", "))
        }
    }
}

/// What the solver says of a linear program. No proof of it.
#[derive(Clone, Debug, Error, PartialEq, Eq, Serialize, Deserialize)]
pub enum SolverEnding {
    #[error("the solver finds an optimum")]
    Optimum,
    /// No force state satisfies it, for any λ.
    #[error("the solver finds no equilibrium within friction")]
    Infeasible,
    /// λ can grow without limit.
    #[error("the solver finds λ without limit")]
    Unbounded,
    /// The solver gave up; its own name for why.
    #[error("the solver gave up: {0}")]
    GaveUp(String),
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_bound_at_zero_is_none() {
        let said = |frictionless| LimitFact::FoundNoBounds { frictionless }.to_string();
        for nothing in [Some(-1e-12), Some(1e-12), None] {
            assert!(said(nothing).ends_with("no lower bound is proved"));
        }
        assert!(said(Some(0.25)).ends_with("none lies below 0.25000"));
    }
}
