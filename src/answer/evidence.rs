//! What an answer rests on: every set of forces and every mechanism beside the multiplier that it
//! belongs to.

use std::sync::Arc;

use serde::{Deserialize, Serialize};

use super::bracket::Bracket;
use super::observed::Observed;
use super::self_check::SelfCheck;
use super::standing::Standing;
use crate::certificate::Certificate;
use crate::mechanics::{
    Ceiling, CollapseState, Crack, ForceState, JointForce, Mechanism, VELOCITY_THRESHOLDS,
    crack_slope,
};
use crate::scene::Scene;

/// What an answer proves or has seen. Whoever reads it matches every kind, so that a further one does
/// not compile until each reader knows it.
#[derive(Clone, Debug, Default, Serialize, Deserialize)]
pub enum Evidence {
    /// None: there is no answer, or the judge refuted what was put forward.
    #[default]
    Nothing,
    /// The range of a closed form, which assumes its crack.
    ClosedForm {
        /// The range.
        bracket: Bracket,
        /// The crack that it assumes.
        crack: Crack,
    },
    /// A number without a proof, and what may come along with it.
    Number {
        /// The number, or a range.
        bracket: Bracket,
        /// Error that is stated for it, relative to λ.
        stated_error: Option<f64>,
        /// Forces at the lower end.
        forces: Option<ForceState>,
        /// Velocities at the lower end; with the forces they may be a collapse state.
        mechanism: Option<Mechanism>,
    },
    /// What is put forward as a collapse state, or as a number that the judge may find to be one.
    State {
        /// Forces and velocities.
        state: CollapseState,
        /// Error that is stated for λ, relative to it.
        stated_error: Option<f64>,
    },
    /// Bounds of λ_A, the multiplier of associative friction.
    Bounds {
        /// Forces that are admissible.
        below: ForceState,
        /// A mechanism that is, and its multiplier.
        above: Ceiling,
    },
    /// Collapse states without dilatancy.
    States {
        /// One or more, lowest λ first.
        states: Vec<CollapseState>,
    },
    /// A collapse state, and what no collapse multiplier exceeds.
    Enclosed {
        /// The state.
        state: CollapseState,
        /// A mechanism with dilatancy, and the multiplier that it proves to be an upper bound.
        ceiling: Ceiling,
    },
    /// A collapse state, and what none lies below.
    Bounded {
        /// The lower bound; `None` where nothing is claimed.
        lower: Option<f64>,
        /// What proves it. It is large, and files of results leave it out.
        #[serde(skip)]
        certificate: Option<Arc<Certificate>>,
        /// The lowest state.
        state: CollapseState,
    },
    /// What was seen, as in an experiment: nothing is proved.
    Observed(Observed),
    /// A mechanism that moves under the dead load alone.
    Falls {
        /// The mechanism.
        mechanism: Mechanism,
    },
    /// Forces that carry every multiplier λ ≥ 0: those at rest and λ times the ray.
    Stands {
        /// What it says of friction without dilatancy.
        standing: Standing,
        /// Forces at λ = 0.
        at_rest: Vec<JointForce>,
        /// Forces that balance the live load for λ = 1 and nothing else.
        ray: Vec<JointForce>,
    },
}

impl From<Observed> for Evidence {
    fn from(observed: Observed) -> Self {
        Evidence::Observed(observed)
    }
}

impl Evidence {
    /// The multiplier, where there is one to vouch for: lower end first.
    pub fn bracket(&self) -> Option<Bracket> {
        let bracket = |lower: f64, upper: f64| Some(Bracket { lower, upper });
        match self {
            Evidence::ClosedForm { bracket, .. } | Evidence::Number { bracket, .. } => {
                Some(*bracket)
            }
            Evidence::State { state, .. } => Some(Bracket::point(state.lambda)),
            // Ends of an estimate may cross.
            Evidence::Bounds { below, above, .. } => bracket(
                below.lambda.min(above.lambda),
                above.lambda.max(below.lambda),
            ),
            Evidence::States { states, .. } => {
                bracket(states.first()?.lambda, states.last()?.lambda)
            }
            Evidence::Enclosed { state, ceiling, .. } => bracket(state.lambda, ceiling.lambda),
            Evidence::Bounded { lower, state, .. } => bracket((*lower)?, state.lambda),
            Evidence::Observed(observed) => observed.bracket,
            Evidence::Nothing | Evidence::Falls { .. } | Evidence::Stands { .. } => None,
        }
    }

    /// Whether the lower and the upper end are bounds rather than multipliers of a state, or numbers.
    pub fn bounds(&self) -> [bool; 2] {
        match self {
            Evidence::Bounds { .. } => [true, true],
            Evidence::Enclosed { .. } => [false, true],
            Evidence::Bounded { .. } => [true, false],
            Evidence::Nothing
            | Evidence::ClosedForm { .. }
            | Evidence::Number { .. }
            | Evidence::State { .. }
            | Evidence::States { .. }
            | Evidence::Observed(_)
            | Evidence::Falls { .. }
            | Evidence::Stands { .. } => [false, false],
        }
    }

    /// The least multiplier at which the evidence has a collapse: that of the lowest state, of what
    /// bounds λ_A alone the upper end, else the lower end.
    pub fn collapse_known(&self) -> Option<f64> {
        match self {
            Evidence::Bounds { .. } => Some(self.bracket()?.upper),
            Evidence::States { .. }
            | Evidence::State { .. }
            | Evidence::Enclosed { .. }
            | Evidence::Bounded { .. } => Some(self.states().first()?.lambda),
            Evidence::ClosedForm { .. } | Evidence::Number { .. } | Evidence::Observed(_) => {
                Some(self.bracket()?.lower)
            }
            Evidence::Nothing | Evidence::Falls { .. } | Evidence::Stands { .. } => None,
        }
    }

    /// The crack in the scene that it is about, where there is one: of a mechanism at the thresholds for
    /// velocities, else what the evidence says itself.
    pub fn crack(&self, scene: &Scene) -> Option<Crack> {
        match self {
            Evidence::ClosedForm { crack, .. } => Some(*crack),
            Evidence::Observed(observed) => observed.crack,
            Evidence::Number { .. }
            | Evidence::State { .. }
            | Evidence::Bounds { .. }
            | Evidence::States { .. }
            | Evidence::Enclosed { .. }
            | Evidence::Bounded { .. } => {
                crack_slope(scene, self.mechanism()?, VELOCITY_THRESHOLDS)
            }
            Evidence::Nothing | Evidence::Falls { .. } | Evidence::Stands { .. } => None,
        }
    }

    /// Error that the method states for its bracket, relative to λ; `None` where it states none.
    pub fn stated_error(&self) -> Option<f64> {
        match self {
            Evidence::Number { stated_error, .. }
            | Evidence::State { stated_error, .. }
            | Evidence::Observed(Observed { stated_error, .. }) => *stated_error,
            Evidence::Nothing
            | Evidence::ClosedForm { .. }
            | Evidence::Bounds { .. }
            | Evidence::States { .. }
            | Evidence::Enclosed { .. }
            | Evidence::Bounded { .. }
            | Evidence::Falls { .. }
            | Evidence::Stands { .. } => None,
        }
    }

    /// How the blocks move, as drawings show it: of several collapse states the lowest, of a scene
    /// that falls under the dead load alone.
    pub fn mechanism(&self) -> Option<&Mechanism> {
        let mechanism = match self {
            Evidence::Number { mechanism, .. } | Evidence::Observed(Observed { mechanism, .. }) => {
                mechanism.as_ref()
            }
            Evidence::Bounds { above, .. } => Some(&above.mechanism),
            Evidence::States { .. }
            | Evidence::State { .. }
            | Evidence::Enclosed { .. }
            | Evidence::Bounded { .. } => Some(&self.states().first()?.mechanism),
            Evidence::Falls { mechanism } => Some(mechanism),
            Evidence::Nothing | Evidence::ClosedForm { .. } | Evidence::Stands { .. } => None,
        };
        mechanism.filter(|mechanism| !mechanism.motions.is_empty())
    }

    /// Forces of every joint, and the multiplier that they belong to: of several collapse states the
    /// lowest, of a scene that stands those at rest.
    pub fn forces(&self) -> Option<(f64, &[JointForce])> {
        let (lambda, forces) = match self {
            Evidence::Number { forces, .. } => {
                let forces = forces.as_ref()?;
                (forces.lambda, &forces.forces)
            }
            Evidence::Bounds { below, .. } => (below.lambda, &below.forces),
            Evidence::States { .. }
            | Evidence::State { .. }
            | Evidence::Enclosed { .. }
            | Evidence::Bounded { .. } => {
                let state = self.states().first()?;
                (state.lambda, &state.forces)
            }
            Evidence::Stands { at_rest, .. } => (0.0, at_rest),
            Evidence::Nothing
            | Evidence::ClosedForm { .. }
            | Evidence::Observed(_)
            | Evidence::Falls { .. } => return None,
        };
        (!forces.is_empty()).then_some((lambda, forces))
    }

    /// What is put forward as collapse states, lowest λ first.
    pub fn states(&self) -> &[CollapseState] {
        match self {
            Evidence::States { states, .. } => states,
            Evidence::State { state, .. }
            | Evidence::Enclosed { state, .. }
            | Evidence::Bounded { state, .. } => std::slice::from_ref(state),
            Evidence::Nothing
            | Evidence::ClosedForm { .. }
            | Evidence::Number { .. }
            | Evidence::Bounds { .. }
            | Evidence::Observed(_)
            | Evidence::Falls { .. }
            | Evidence::Stands { .. } => &[],
        }
    }

    /// Whether it is of a scene that stands with associative friction, and nothing is proved without dilatancy.
    pub fn stands_by_friction(&self) -> bool {
        matches!(
            self,
            Evidence::Stands {
                standing: Standing::Associative,
                ..
            }
        )
    }

    /// What was seen, where it is that.
    pub fn observed(&self) -> Option<&Observed> {
        match self {
            Evidence::Observed(observed) => Some(observed),
            _ => None,
        }
    }

    /// The same, to be changed; where nothing was seen, nothing yet.
    pub(crate) fn into_observed(self) -> Observed {
        match self {
            Evidence::Observed(observed) => observed,
            _ => Observed::default(),
        }
    }

    /// What proves a lower bound, or that there is no collapse state, where there is one.
    pub fn certificate(&self) -> Option<&Certificate> {
        match self {
            Evidence::Bounded { certificate, .. }
            | Evidence::Stands {
                standing: Standing::Certified { certificate },
                ..
            } => certificate.as_deref(),
            _ => None,
        }
    }

    /// Self-checks that ran.
    pub fn checks(&self) -> &[SelfCheck] {
        self.observed().map_or(&[], |observed| &observed.checks)
    }

    /// Relative motion, as a fraction of the scene's largest corner velocity, below which two blocks
    /// move alike and a joint neither slides nor opens. It is larger for what was observed, whose
    /// displacements include the compression of contacts.
    pub(crate) fn still(&self) -> f64 {
        match self.observed() {
            Some(_) => 1e-2,
            None => 1e-4,
        }
    }

    /// Without the lists of forces and motions, which files of many rows do without.
    pub(crate) fn thinned(mut self) -> Self {
        let state = |state: &mut CollapseState| {
            state.forces.clear();
            state.mechanism.motions.clear();
        };
        match &mut self {
            Evidence::Number {
                forces, mechanism, ..
            } => (*forces, *mechanism) = (None, None),
            Evidence::State { state: of, .. } | Evidence::Bounded { state: of, .. } => {
                state(of);
            }
            Evidence::Bounds { below, above, .. } => {
                below.forces.clear();
                above.mechanism.motions.clear();
            }
            Evidence::States { states, .. } => states.iter_mut().for_each(state),
            Evidence::Enclosed {
                state: of, ceiling, ..
            } => {
                state(of);
                ceiling.mechanism.motions.clear();
            }
            Evidence::Observed(observed) => {
                observed.mechanism = None;
                observed.recording = None;
                observed.checks.clear();
            }
            Evidence::Falls { mechanism } => mechanism.motions.clear(),
            Evidence::Stands { at_rest, ray, .. } => {
                at_rest.clear();
                ray.clear();
            }
            Evidence::Nothing | Evidence::ClosedForm { .. } => {}
        }
        self
    }
}
