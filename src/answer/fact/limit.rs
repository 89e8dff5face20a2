//! Facts of the limit analyses.

use std::fmt;

use serde::{Deserialize, Serialize};

use crate::mechanics::BlockResidual;
use crate::number::below;

/// What a limit analysis proves, or fails to.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum LimitFact {
    /// The scene falls: the mechanism is the proof.
    MovesUnpushed {
        /// Names of the blocks that come down, in the scene's order; empty where all of them do.
        first: Vec<String>,
    },
    /// The scene stands: the ray of forces is the proof.
    ForcesWithoutLimit,
    /// Neither forces nor a mechanism prove whether the scene stands under its own weight.
    OwnWeightUndecided {
        /// What the solver says of the last program, where it found no optimum.
        solver: Option<SolverEnding>,
    },
    /// The program for λ_A has no optimum, and nothing proves why.
    NoOptimum(SolverEnding),
    /// Forces or mechanism of a scene of very unequal blocks or very rough joints violate their
    /// conditions by more than a proof may.
    Unproved {
        /// Largest residual over the whole scene.
        residual: f64,
    },
    /// The same of one block, by its own forces or velocities.
    Unresolved(BlockResidual),
    /// Force state and mechanism of λ_A do not meet.
    Apart {
        /// Distance of their multipliers over the larger one.
        relative_width: f64,
    },
    /// A user asked for programs that are too loose to prove anything.
    Loose,
    /// The same, and the live load does no work on the mechanism found.
    LooseWithoutMultiplier,
    /// The interval is what was found; these are the rigorous bounds.
    FoundNoBounds {
        /// Rigorous lower bound: λ without friction, where that is proved. The upper one is λ_A.
        frictionless: Option<f64>,
    },
    /// The same, where another method of the run proves more.
    FoundAboveBound {
        /// What it proves, in words.
        proof: String,
        /// Whose it is.
        by: String,
    },
    /// The interval is what was found, although with associative friction nothing collapses.
    FoundWithoutBound,
    /// The lowest state found is at λ = 0: forces at rest are not determined, and with some of them the
    /// scene falls.
    AtRest,
    /// No state was found where with associative friction none exists, which proves nothing of
    /// friction without dilatancy.
    NoneFoundWithoutBound,
}

/// What a collapse state at λ = 0 says.
pub(crate) const AT_REST: &str =
    "it may fall without a push, as the forces of friction at rest are not determined";

impl fmt::Display for LimitFact {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            LimitFact::MovesUnpushed { first } => {
                write!(f, "a mechanism moves without any push")?;
                write_first(f, first)
            }
            LimitFact::ForcesWithoutLimit => {
                write!(f, "the joints can balance every push, however large it is")
            }
            LimitFact::OwnWeightUndecided { solver } => {
                write!(
                    f,
                    "neither forces nor a mechanism prove whether it stands under its own weight"
                )?;
                let solver = solver.as_ref();
                solver.map_or(Ok(()), |solver| write!(f, ": {solver}"))
            }
            LimitFact::NoOptimum(solver) => write!(f, "the multiplier is not proved: {solver}"),
            LimitFact::Unproved { residual } => {
                write!(f, "the proof fails: the largest residual is {residual:.1e}")
            }
            LimitFact::Unresolved(blocks) => write!(f, "the proof fails at one block: {blocks}"),
            LimitFact::Apart { relative_width } => {
                write!(
                    f,
                    "the multipliers of the force state and of the mechanism are {relative_width:.1e} apart"
                )
            }
            LimitFact::Loose => write!(f, "the programs were solved loosely, as the settings ask"),
            LimitFact::LooseWithoutMultiplier => {
                write!(
                    f,
                    "the programs were solved loosely, as the settings ask, and the mechanism found has no \
                     multiplier"
                )
            }
            LimitFact::FoundNoBounds { frictionless } => match frictionless {
                Some(lambda) => write!(
                    f,
                    "the search may have missed other collapse states; proved bounds of them all are {} and the \
                     associative multiplier",
                    below(lambda.max(0.0), 5)
                ),
                None => write!(
                    f,
                    "the search may have missed other collapse states; the proved bound of them all is the \
                     associative multiplier"
                ),
            },
            LimitFact::FoundAboveBound { proof, by } => write!(
                f,
                "the search may have missed other collapse states, but {by} proves that {proof}"
            ),
            LimitFact::FoundWithoutBound => write!(
                f,
                "the search may have missed other collapse states; with associative friction none exists"
            ),
            LimitFact::AtRest => f.write_str(AT_REST),
            LimitFact::NoneFoundWithoutBound => write!(
                f,
                "the search found no collapse state; with associative friction none exists"
            ),
        }
    }
}

/// Names that are written out at most; of more, the first ones are, and the others are counted.
const NAMED: usize = 4;

/// The blocks that move first, as the end of a sentence.
fn write_first(f: &mut fmt::Formatter<'_>, first: &[String]) -> fmt::Result {
    match first {
        [] => Ok(()),
        [one] => write!(f, ": {one} moves first"),
        [named @ .., last] if named.len() < NAMED => {
            write!(f, ": {} and {last} move first", named.join(", "))
        }
        _ => {
            let (named, others) = first.split_at(NAMED - 1);
            let others = others.len();
            write!(f, ": {} and {others} others move first", named.join(", "))
        }
    }
}

/// What the solver says of a linear program. No proof of it.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum SolverEnding {
    /// It has an optimum.
    Optimum,
    /// No force state satisfies it, for any λ.
    Infeasible,
    /// λ can grow without limit.
    Unbounded,
    /// The solver gave up; its own name for why.
    GaveUp(String),
}

impl fmt::Display for SolverEnding {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            SolverEnding::Optimum => write!(f, "the solver finds an optimum"),
            SolverEnding::Infeasible => {
                write!(f, "the solver finds no equilibrium within friction")
            }
            SolverEnding::Unbounded => write!(f, "the solver finds λ without limit"),
            SolverEnding::GaveUp(why) => write!(f, "the solver gave up: {why}"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_rounding_below_zero_is_written_as_zero() {
        let found = LimitFact::FoundNoBounds {
            frictionless: Some(-1e-12),
        };
        let text = found.to_string();
        assert_eq!(
            text,
            "the search may have missed other collapse states; proved bounds of them all are 0.00000 and the \
             associative multiplier"
        );
    }
}
