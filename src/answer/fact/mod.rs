//! What is to be said about an answer, as data. `Display` makes the sentence, and nothing else does:
//! a program that needs a figure reads the field.

use std::fmt;

/// One thing that is to be said about an answer.
#[derive(Clone, Debug, PartialEq)]
pub enum Fact {
    /// Free words: those of an outside program, or of a panic.
    Words(String),
}

impl fmt::Display for Fact {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Fact::Words(words) => f.write_str(words),
        }
    }
}

impl From<String> for Fact {
    fn from(words: String) -> Self {
        Fact::Words(words)
    }
}

impl From<&str> for Fact {
    fn from(words: &str) -> Self {
        Fact::Words(words.to_owned())
    }
}

/// Facts as one text, parted by semicolons; empty where there is nothing to say.
pub(crate) fn sentence(facts: &[Fact]) -> String {
    let words = facts.iter().map(Fact::to_string);
    let words: Vec<String> = words.filter(|words| !words.is_empty()).collect();
    words.join("; ")
}
