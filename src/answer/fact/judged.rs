//! Facts that the judge finds.

use serde::{Deserialize, Serialize};
use thiserror::Error;

use super::super::status::Status;
use crate::certificate::Refusal;
use crate::mechanics::{BlockResidual, Recomputed, residual_words};

/// What the judge finds.
#[derive(Clone, Debug, Error, PartialEq, Serialize, Deserialize)]
#[allow(missing_docs, reason = "the sentence of each says it")]
pub enum JudgedFact {
    /// Forces and mechanism are a collapse state, although the method claims none.
    #[error("the judge confirms that it is a collapse state")]
    CollapseState,
    /// What forces and mechanism would have to prove, they do not; nothing was claimed.
    #[error("it is not proved{}", unproved(.0))]
    NoProof(Vec<Recomputed>),
    /// The same of one block, by its own forces or velocities.
    #[error("it is not proved: {0}")]
    NoProofOfBlock(BlockResidual),
    /// What the method claims to prove, forces and mechanism do not.
    #[error("the judge refutes it: {}", residual_words(.0))]
    Refuted(Vec<Recomputed>),
    /// Over the whole scene the proof holds, and at one block it does not: its own forces or
    /// velocities are too small beside the others' to be resolved.
    #[error("the proof fails at one block: {0}")]
    Unresolved(BlockResidual),
    /// A lower bound has no certificate that proves it.
    #[error("the judge refutes it: {0}")]
    Uncertified(Refusal),
    #[error("the method claims a proof and hands over no forces or no mechanism")]
    NothingToProve,
    #[error(
        "the scene has {} in the real wall, that may stand",
        match .count {
            1 => "one open head joint, which carries nothing; if it touches".to_owned(),
            _ => format!("{count} open head joints, which carry nothing; if they touch"),
        }
    )]
    OpenHeadJoints { count: usize },
    /// The method claims `falls` or `stands` and hands over nothing that proves it.
    #[error("the method claims that the scene {} and hands over no proof", .0.name())]
    NoCertificate(Status),
}

/// What forces and mechanism do not prove, as the end of a sentence: of a collapse state which
/// condition it violates most.
fn unproved(residuals: &[Recomputed]) -> String {
    let [
        Recomputed::State {
            statics, collapse, ..
        },
    ] = residuals
    else {
        return format!(": {}", residual_words(residuals));
    };
    let named = [
        (statics.equilibrium, "equilibrium is violated"),
        (statics.tension, "a joint is in tension"),
        (statics.friction, "friction exceeds μN"),
        (collapse.penetration, "blocks interpenetrate"),
        (collapse.open_contact, "an opening joint carries a force"),
        (
            collapse.idle_friction,
            "a slipping joint carries less than μN",
        ),
        (collapse.gap, "many small violations add up"),
    ];
    let worst = named.iter().max_by(|a, b| a.0.total_cmp(&b.0));
    let worst = worst.expect("the list is not empty").1;
    format!(" to be a collapse state, because {worst}")
}
