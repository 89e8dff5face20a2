//! Facts of outside programs.

use std::borrow::Cow;

use serde::{Deserialize, Serialize};

/// Why an outside program gave no answer.
#[derive(Clone, Debug, PartialEq, thiserror::Error, Serialize, Deserialize)]
#[allow(missing_docs, reason = "the sentence of each says it")]
pub enum ProgramFailure {
    #[error("the program has no command")]
    NoCommand,
    #[error("cannot start `{program}`: {error}")]
    NotStarted { program: String, error: String },
    #[error("the program cannot be waited for: {error}")]
    NotWaitedFor { error: String },
    /// The system has no process groups, so that children could not be stopped.
    #[error("external methods need a system with process groups")]
    NoProcessGroups,
    /// It ended, or had to be stopped, without an answer.
    #[error("{ending}{}", after_colon(.messages))]
    Ended {
        ending: ProgramEnding,
        /// First and last line that it wrote to standard error; empty where there is none.
        messages: String,
    },
    #[error("the program wrote nothing to standard output")]
    NoOutput,
    #[error(
        "its output is no answer, which is a number or JSON such as {{\"lambda\": 0.5}}: {error}; it begins \
         with `{begins}`"
    )]
    NotAnAnswer { error: String, begins: String },
    #[error("an answer of this kind needs {keys}")]
    MissingKeys {
        /// Which, and what else may be meant.
        keys: Cow<'static, str>,
    },
    /// An upper end or a stated error beside a proof, which has its own.
    #[error("`upper` and `stated_error` go with the kind `estimate` only")]
    UpperOfAProof,
    #[error("`stated_error` {error} is no relative error: write a number from 0 to 1")]
    NoRelativeError { error: f64 },
    #[error("`lambda` {lower} is above `upper` {upper}")]
    EndsCross { lower: f64, upper: f64 },
    #[error("`{key}` has {entries} entries, the scene has {expected} {of}")]
    WrongLength {
        key: Cow<'static, str>,
        entries: usize,
        expected: usize,
        /// What there is one entry of for each.
        of: Cow<'static, str>,
    },
}

fn after_colon(messages: &str) -> String {
    if messages.is_empty() {
        String::new()
    } else {
        format!(": {messages}")
    }
}

/// How an outside program ended that gave no answer.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error, Serialize, Deserialize)]
#[allow(missing_docs, reason = "the sentence of each says it")]
pub enum ProgramEnding {
    #[error("the program was stopped after its time limit of {seconds} s")]
    TimeLimit { seconds: f64 },
    #[error("the program was ended by signal {0}")]
    Signal(i32),
    #[error("the program ended with exit status {0}")]
    ExitStatus(i32),
    #[error("the program ended without an exit status")]
    NoExitStatus,
    #[error("the program wrote more than {mebibytes} MiB")]
    TooMuchOutput { mebibytes: u64 },
}
