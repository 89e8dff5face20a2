//! The residuals of what an answer puts forward.

use serde::{Deserialize, Serialize};

use super::residual::{CollapseResidual, StaticResidual};
use crate::number::number;

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

    fn words(&self) -> String {
        match self {
            Recomputed::Forces { statics, .. } | Recomputed::Ray { statics } => statics.to_string(),
            Recomputed::State {
                statics, collapse, ..
            } => format!("{statics}, {collapse}"),
            Recomputed::Ceiling {
                lambda, flow_rule, ..
            } => {
                let lambda = number(*lambda, 6);
                format!(
                    "and the mechanism violates the flow rule by {flow_rule:.1e} and gives the multiplier \
                     {lambda}"
                )
            }
            Recomputed::Falling { flow_rule } => format!("flow rule {flow_rule:.1e}"),
        }
    }
}

/// The largest of these residuals; `None` where there are none.
pub fn largest(residuals: &[Recomputed]) -> Option<f64> {
    residuals.iter().map(Recomputed::largest).reduce(f64::max)
}

/// The residuals of a proof in words: all of a state or of two bounds, else the largest.
pub fn residual_words(residuals: &[Recomputed]) -> String {
    match residuals {
        [state @ Recomputed::State { .. }] => format!("the residuals are {}", state.words()),
        [below, above @ Recomputed::Ceiling { .. }] => {
            format!("the residuals are {}, {}", below.words(), above.words())
        }
        _ => {
            let largest = largest(residuals).unwrap_or(0.0);
            format!("the largest residual is {largest:.1e}")
        }
    }
}
