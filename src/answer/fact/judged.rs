//! Facts that the judge finds.

use std::fmt;

use serde::{Deserialize, Serialize};

use super::super::status::Status;
use crate::certificate::Refusal;
use crate::mechanics::{BlockResidual, VERIFIED_BLOCK};
use crate::mechanics::{CollapseResidual, StaticResidual};
use crate::number::number;

/// What the judge finds.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub enum JudgedFact {
    /// Forces and mechanism are a collapse state, although the method claims none.
    CollapseState,
    /// What forces and mechanism would have to prove, they do not; nothing was claimed.
    NoProof(Residuals),
    /// What the method claims to prove, forces and mechanism do not.
    Refuted(Residuals),
    /// Over the whole scene the proof holds, and at one block it does not: its own forces or
    /// velocities are too small beside the others' to be resolved.
    Unresolved(BlockResidual),
    /// A lower bound has no certificate that proves it.
    Uncertified(Refusal),
    /// The method claims a proof and hands over no forces or no mechanism.
    NothingToProve,
    /// The scene falls, and its open head joints carry nothing of it.
    OpenHeadJoints {
        /// How many there are.
        count: usize,
    },
    /// The method claims `falls` or `stands` and hands over nothing that proves it.
    NoCertificate(Status),
}

/// The residuals that a proof was judged by.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub enum Residuals {
    /// Of a collapse state.
    State {
        /// Violations by the forces.
        statics: StaticResidual,
        /// Violations by forces and mechanism together.
        collapse: CollapseResidual,
    },
    /// Of bounds.
    Bounds {
        /// Violations by the forces.
        statics: StaticResidual,
        /// Violations by forces and mechanism together, where the lower bound is a collapse state.
        collapse: Option<CollapseResidual>,
        /// The upper bound; `None` where there is no mechanism for it.
        ceiling: Option<CeilingSlack>,
    },
    /// Of one block, over its own forces or velocities.
    Block(BlockResidual),
    /// The largest of several states, or of a certificate.
    Largest(f64),
}

/// What a mechanism has to show as an upper bound.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct CeilingSlack {
    /// Its violation of the associative flow rule.
    pub flow_rule: f64,
    /// Its own multiplier, which the upper end of the bracket must not undercut.
    pub multiplier: f64,
}

impl Residuals {
    /// Which condition a collapse state violates most.
    fn worst(statics: &StaticResidual, collapse: &CollapseResidual) -> &'static str {
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
        worst.expect("the list is not empty").1
    }
}

impl fmt::Display for JudgedFact {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            JudgedFact::CollapseState => {
                write!(f, "the judge confirms that it is a collapse state")
            }
            JudgedFact::NoProof(Residuals::State { statics, collapse }) => {
                let worst = Residuals::worst(statics, collapse);
                write!(
                    f,
                    "it is not proved to be a collapse state, because {worst}"
                )
            }
            JudgedFact::NoProof(residuals) => write!(f, "it is not proved: {residuals}"),
            JudgedFact::Refuted(residuals) => write!(f, "the judge refutes it: {residuals}"),
            JudgedFact::Unresolved(residual) => {
                write!(f, "the proof fails at one block: {residual}")
            }
            JudgedFact::Uncertified(refusal) => write!(f, "the judge refutes it: {refusal}"),
            JudgedFact::NothingToProve => {
                write!(
                    f,
                    "the method claims a proof and hands over no forces or no mechanism"
                )
            }
            JudgedFact::OpenHeadJoints { count: 1 } => write!(
                f,
                "the scene has one open head joint, which carries nothing; if it touches in the real wall, that \
                 may stand"
            ),
            JudgedFact::OpenHeadJoints { count } => write!(
                f,
                "the scene has {count} open head joints, which carry nothing; if they touch in the real wall, \
                 that may stand"
            ),
            JudgedFact::NoCertificate(status) => {
                write!(
                    f,
                    "the method claims that the scene {} and hands over no proof",
                    status.name()
                )
            }
        }
    }
}

impl fmt::Display for Residuals {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Residuals::State { statics, collapse } => {
                write!(f, "the residuals are {statics}, {collapse}")
            }
            Residuals::Bounds {
                statics,
                collapse,
                ceiling,
            } => {
                write!(f, "the residuals are {statics}, ")?;
                if let Some(collapse) = collapse {
                    write!(f, "{collapse}, ")?;
                }
                match ceiling {
                    Some(ceiling) => ceiling.fmt(f),
                    None => write!(f, "and no mechanism gives an upper bound"),
                }
            }
            Residuals::Block(residual) => residual.fmt(f),
            Residuals::Largest(residual) => write!(f, "the largest residual is {residual:.1e}"),
        }
    }
}

impl fmt::Display for BlockResidual {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "block {} violates its conditions by {:.1e} of its own forces or velocities, and at most \
             {VERIFIED_BLOCK:.0e} is allowed",
            self.block + 1,
            self.value
        )
    }
}

impl fmt::Display for CeilingSlack {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "and the mechanism violates the flow rule by {:.1e} and gives the multiplier {}",
            self.flow_rule,
            number(self.multiplier, 6)
        )
    }
}
