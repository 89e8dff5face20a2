//! What the judge computed of one answer.

use serde::{Deserialize, Serialize};

use crate::answer::Status;
use crate::mechanics::{CollapseResidual, StaticResidual};

/// What the judge says of an answer.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Judgement {
    /// What the answer is worth.
    pub status: Status,
    /// What was recomputed, in the order of the evidence; empty where there is nothing to vouch for.
    pub residuals: Vec<Recomputed>,
}

impl Judgement {
    /// The largest residual; `None` where there is none.
    pub fn residual(&self) -> Option<f64> {
        largest(&self.residuals)
    }
}

/// The largest of these residuals; `None` where there are none.
pub(crate) fn largest(residuals: &[Recomputed]) -> Option<f64> {
    residuals.iter().map(Recomputed::largest).reduce(f64::max)
}

/// The residuals of one thing that an answer puts forward, scaled to total weight, height and live
/// power 1.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub enum Recomputed {
    /// Of forces at a multiplier.
    Forces {
        /// The multiplier.
        lambda: f64,
        /// Violations by the forces.
        statics: StaticResidual,
    },
    /// Of a collapse state.
    State {
        /// Its multiplier.
        lambda: f64,
        /// Violations by the forces.
        statics: StaticResidual,
        /// Violations by forces and velocities together.
        collapse: CollapseResidual,
    },
    /// Of a mechanism with dilatancy that proves an upper bound.
    Ceiling {
        /// The mechanism's own multiplier.
        lambda: f64,
        /// Violation of the flow rule.
        flow_rule: f64,
        /// Whether the multiplier lies where the answer says.
        bounds: bool,
    },
    /// Of a mechanism under the dead load alone.
    Falling {
        /// Violation of the flow rule.
        flow_rule: f64,
    },
    /// Of forces that carry the live load for λ = 1 and nothing else.
    Ray {
        /// Violations by the ray.
        statics: StaticResidual,
    },
}

impl Recomputed {
    /// The largest; infinite where a mechanism does not bound what it is said to.
    pub fn largest(&self) -> f64 {
        match self {
            Recomputed::Forces { statics, .. } | Recomputed::Ray { statics } => statics.largest(),
            Recomputed::State {
                statics, collapse, ..
            } => statics.largest().max(collapse.largest()),
            Recomputed::Ceiling { bounds: false, .. } => f64::INFINITY,
            Recomputed::Ceiling { flow_rule, .. } | Recomputed::Falling { flow_rule } => *flow_rule,
        }
    }
}
