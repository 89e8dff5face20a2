//! What a method answers. It holds no time, so no time can reach a snapshot.

use std::sync::Arc;

use serde::{Deserialize, Serialize};

use super::bracket::Bracket;
use super::claim::Claim;
use super::fact::{self, Fact, JudgedFact, SearchFacts};
use super::recording::Recording;
use super::self_check::SelfCheck;
use super::status::Status;
use super::work::Work;
use crate::certificate::Certificate;
use crate::mechanics::{CollapseState, Crack, JointForce, Mechanism};

/// The answer of one method for one scene.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Outcome {
    /// What the answer is worth; the judge may lower it.
    pub status: Status,
    /// What forces and mechanism are to prove.
    pub claim: Claim,
    /// The multiplier, where there is one to vouch for.
    pub bracket: Option<Bracket>,
    /// Error that the method states for its bracket, relative to λ; `None` where it states none.
    pub stated_error: Option<f64>,
    /// Crack slope of a closed form (no mechanism behind it) or of the mechanism.
    pub crack: Option<Crack>,
    /// Velocities of every block at collapse; with the status `falls`, under the dead load alone.
    pub mechanism: Option<Mechanism>,
    /// Forces of every joint at the multiplier `bracket.lower`, with the claim [`Claim::Bounded`] at
    /// `bracket.upper`; with the status `stands`, at λ = 0.
    pub forces: Option<Vec<JointForce>>,
    /// With the status `stands`: forces within friction that balance the live load for λ = 1 and
    /// nothing else, so that `forces` + λ · `ray` is a state for every λ ≥ 0.
    pub ray: Option<Vec<JointForce>>,
    /// With the claim [`Claim::Enclosed`]: a mechanism with dilatancy, whose multiplier bounds every
    /// collapse multiplier from above.
    pub ceiling: Option<Mechanism>,
    /// With the claim [`Claim::Bounded`]: what proves the lower bound. It is large, and files of
    /// results leave it out.
    #[serde(skip)]
    pub certificate: Option<Arc<Certificate>>,
    /// Every collapse state that the answer rests on, lowest λ first; only the interval has them.
    pub states: Vec<CollapseState>,
    /// On request, the motion that follows the collapse.
    pub recording: Option<Recording>,
    /// Effort.
    pub work: Work,
    /// Self-checks that ran, with their figures.
    pub checks: Vec<SelfCheck>,
    /// Why this status, and what is to be known of the answer; may be empty when all went as hoped.
    pub facts: Vec<Fact>,
}

impl Outcome {
    /// An answer without a number, and why there is none.
    pub fn without_number(status: Status, fact: impl Into<Fact>) -> Self {
        Self {
            facts: vec![fact.into()],
            ..Self::of(status)
        }
    }

    /// An answer that is nothing but its status, to be filled in.
    pub fn of(status: Status) -> Self {
        Self {
            status,
            claim: Claim::default(),
            bracket: None,
            stated_error: None,
            crack: None,
            mechanism: None,
            forces: None,
            ray: None,
            ceiling: None,
            certificate: None,
            states: Vec::new(),
            recording: None,
            work: Work::default(),
            checks: Vec::new(),
            facts: Vec::new(),
        }
    }

    /// The facts as one text; empty where there is nothing to say.
    pub fn reason(&self) -> String {
        fact::sentence(&self.facts)
    }

    /// The same without what a search counts, which may differ between machines.
    pub fn settled_reason(&self) -> String {
        let settled = |fact: &&Fact| !matches!(fact, Fact::Search(_));
        let facts: Vec<Fact> = self.facts.iter().filter(settled).cloned().collect();
        fact::sentence(&facts)
    }

    /// Whether the judge found that forces and mechanism do not prove what they are put forward as.
    pub fn is_refuted(&self) -> bool {
        let refuted = |fact: &Fact| {
            matches!(
                fact,
                Fact::Judged(
                    JudgedFact::Refuted(_)
                        | JudgedFact::Uncertified(_)
                        | JudgedFact::NothingToProve
                ) | Fact::KeptRefutation(_)
            )
        };
        self.facts.iter().any(refuted)
    }

    /// How the starts of a search for collapse states ended, where there was one.
    pub fn search(&self) -> Option<&SearchFacts> {
        self.facts.iter().find_map(|fact| match fact {
            Fact::Search(search) => Some(search),
            _ => None,
        })
    }
}
