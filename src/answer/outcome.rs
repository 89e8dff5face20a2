//! What a method answers. It holds no time, so no time can reach a snapshot.

use serde::{Deserialize, Serialize};

use super::bracket::Bracket;
use super::evidence::Evidence;
use super::fact::{BoundFact, Fact, JudgedFact, SearchFacts, sentence};
use super::status::Status;
use super::work::Work;
use crate::certificate::Proved;

/// The answer of one method for one scene.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Outcome {
    /// What the answer is worth; the judge may lower it.
    pub status: Status,
    /// What it rests on.
    pub evidence: Evidence,
    /// Effort.
    pub work: Work,
    /// Why this status, and what is to be known of the answer; may be empty when all went as hoped.
    pub facts: Vec<Fact>,
}

impl Outcome {
    /// An answer without a number, and why there is none.
    pub fn without_number(status: Status, fact: impl Into<Fact>) -> Self {
        Self::of(status).because(fact)
    }

    /// An answer that is nothing but its status, to be filled in.
    pub fn of(status: Status) -> Self {
        Self {
            status,
            evidence: Evidence::Nothing,
            work: Work::default(),
            facts: Vec::new(),
        }
    }

    /// An answer that rests on this.
    pub fn with(status: Status, evidence: impl Into<Evidence>) -> Self {
        Self {
            evidence: evidence.into(),
            ..Self::of(status)
        }
    }

    /// The same, with a further fact.
    pub fn because(mut self, fact: impl Into<Fact>) -> Self {
        self.facts.push(fact.into());
        self
    }

    /// The same, after this effort.
    pub fn after(self, work: Work) -> Self {
        Self { work, ..self }
    }

    /// The multiplier, where there is one to vouch for.
    pub fn bracket(&self) -> Option<Bracket> {
        self.evidence.bracket()
    }

    /// The facts as one text; empty where there is nothing to say.
    pub fn reason(&self) -> String {
        sentence(&self.facts)
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

    /// What a lower bound proves, where there is one.
    pub(crate) fn proved(&self) -> Option<&Proved> {
        self.facts.iter().find_map(|fact| match fact {
            Fact::Bound(BoundFact::Proved(proved)) => Some(proved),
            _ => None,
        })
    }

    /// How the starts of a search for collapse states ended, where there was one.
    pub fn search(&self) -> Option<&SearchFacts> {
        self.facts.iter().find_map(|fact| match fact {
            Fact::Search(search) => Some(search),
            _ => None,
        })
    }
}
