//! What is to be said about an answer, as data. `Display` makes the sentence, and nothing else does:
//! a program that needs a figure reads the field.

use serde::{Deserialize, Serialize};

mod auto;
mod bound;
mod closed_form;
mod judged;
mod limit;
mod outside;
mod pushover;
mod reaction;
mod search;
mod sequential;
mod side;

use std::fmt;

pub use auto::{AutoFact, Uniqueness};
pub(crate) use bound::floor_words;
pub use bound::{BoundFact, Budget};
pub use closed_form::{InapplicableForm, Invalid};
pub use judged::JudgedFact;
pub use limit::{LimitFact, SolverEnding};
pub use outside::{ProgramEnding, ProgramFailure};
pub use pushover::PushoverFact;
pub use reaction::ReactionFact;
pub(crate) use reaction::reaction_floor;
pub use search::{Coverage, SearchEnding, SearchFacts, SearchFailure, SearchStart, StartEnding};
pub use sequential::{SequentialEnding, SequentialFacts};
pub use side::SideFact;

/// Makes [`Fact`] from its families: it holds one of them, is said in its words, and made from it.
macro_rules! facts {
    ($( $(#[doc = $doc:literal])+ $Family:ident($Held:ty), )+) => {
        /// One thing that is to be said about an answer.
        #[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
        pub enum Fact {
            /// What the judge refuted, in the words that a file kept of it.
            KeptRefutation(String),
            $( $(#[doc = $doc])+ $Family($Held), )+
        }

        impl fmt::Display for Fact {
            fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                match self {
                    Fact::KeptRefutation(words) => words.fmt(f),
                    $(Fact::$Family(fact) => fact.fmt(f),)+
                }
            }
        }

        $(impl From<$Held> for Fact {
            fn from(held: $Held) -> Self {
                Fact::$Family(held)
            }
        })+
    };
}

facts! {
    /// Free words: those of an outside program, or of a panic.
    Words(String),
    /// Why the closed form does not apply.
    ClosedForm(InapplicableForm),
    /// What a limit analysis proves, or fails to.
    Limit(LimitFact),
    /// How the starts of a search for collapse states ended.
    Search(SearchFacts),
    /// How the sequential method ended.
    Sequential(SequentialFacts),
    /// What the pushover ends with.
    Pushover(PushoverFact),
    /// What `auto` concludes from the other methods.
    Auto(AutoFact),
    /// What a lifted program proves.
    Bound(BoundFact),
    /// What the judge finds.
    Judged(JudgedFact),
    /// Which side of a wall that is pushed both ways the answer is about.
    Side(SideFact),
    /// What is to be said of a support that moves.
    Reaction(ReactionFact),
    /// Why an outside program gave no answer.
    Program(ProgramFailure),
}

impl Fact {
    /// Whether the fact introduces the facts after it, like a heading: a colon follows it.
    fn introduces_next(&self) -> bool {
        matches!(
            self,
            Fact::Auto(AutoFact::SettledByAssociative | AutoFact::NoState { .. })
                | Fact::Pushover(PushoverFact::Without(_))
                | Fact::Side(SideFact::Unanswered(_) | SideFact::For(_) | SideFact::Either)
        )
    }
}

impl From<&str> for Fact {
    fn from(words: &str) -> Self {
        Fact::Words(words.to_owned())
    }
}

/// Facts as one text, parted by semicolons; empty where there is nothing to say.
pub(crate) fn sentence(facts: &[Fact]) -> String {
    let mut text = String::new();
    let mut separator = "";
    for fact in facts {
        let words = fact.to_string();
        if words.is_empty() {
            continue;
        }
        text.push_str(separator);
        text.push_str(&words);
        separator = if fact.introduces_next() { ": " } else { "; " };
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::Push;

    #[test]
    fn facts_are_parted_by_semicolons_and_headings_by_colons() {
        let heading = Fact::Side(SideFact::Unanswered(Push::Left));
        let facts = [heading, "one".into(), "".into(), "two".into()];
        assert_eq!(
            sentence(&facts),
            "there is no answer when pushed to the left: one; two"
        );
        assert_eq!(
            sentence(&facts[..1]),
            "there is no answer when pushed to the left"
        );
        assert_eq!(sentence(&[]), "");
    }
}
