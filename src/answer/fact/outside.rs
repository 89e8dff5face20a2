//! Facts of outside programs.

use std::borrow::Cow;

use serde::{Deserialize, Serialize};

/// Why an outside program gave no answer.
#[derive(Clone, Debug, PartialEq, thiserror::Error, Serialize, Deserialize)]
pub enum ProgramFailure {
    /// No program is named.
    #[error("the program has no command")]
    NoCommand,
    /// The program does not start.
    #[error("cannot start `{program}`: {error}")]
    NotStarted {
        /// The program.
        program: String,
        /// The system's error.
        error: String,
    },
    /// The system does not say when it ends.
    #[error("the program cannot be waited for: {error}")]
    NotWaitedFor {
        /// The system's error.
        error: String,
    },
    /// The system has no process groups, so that children could not be stopped.
    #[error("external methods need a system with process groups")]
    NoProcessGroups,
    /// It ended, or had to be stopped, without an answer.
    #[error("{ending}{}", after_colon(.messages))]
    Ended {
        /// How.
        ending: ProgramEnding,
        /// First and last line that it wrote to standard error; empty where there is none.
        messages: String,
    },
    /// It wrote nothing.
    #[error("the program wrote nothing to standard output")]
    NoOutput,
    /// What it wrote is not an answer.
    #[error(
        "its output is no answer, which is a number or JSON such as {{\"lambda\": 0.5}}: {error}; it begins \
         with `{begins}`"
    )]
    NotAnAnswer {
        /// The reader's error.
        error: String,
        /// The first characters.
        begins: String,
    },
    /// The answer lacks keys that its kind needs.
    #[error("an answer of this kind needs {keys}")]
    MissingKeys {
        /// Which, and what else may be meant.
        keys: Cow<'static, str>,
    },
    /// An upper end or a stated error beside a proof, which has its own.
    #[error("`upper` and `stated_error` go with the kind `estimate` only")]
    UpperOfAProof,
    /// A stated error that is negative or above 1.
    #[error("`stated_error` {error} is no relative error: write a number from 0 to 1")]
    NoRelativeError {
        /// The number.
        error: f64,
    },
    /// The ends of the bracket are the wrong way round.
    #[error("`lambda` {lower} is above `upper` {upper}")]
    EndsCross {
        /// The lower end.
        lower: f64,
        /// The upper end.
        upper: f64,
    },
    /// A list that does not fit the scene.
    #[error("`{key}` has {entries} entries, the scene has {expected} {of}")]
    WrongLength {
        /// The list.
        key: Cow<'static, str>,
        /// Its length.
        entries: usize,
        /// The length that it should have.
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
pub enum ProgramEnding {
    /// It was stopped at its time limit.
    #[error("the program was stopped after its time limit of {seconds} s")]
    TimeLimit {
        /// The limit, seconds.
        seconds: f64,
    },
    /// By a signal of this number.
    #[error("the program was ended by signal {0}")]
    Signal(i32),
    /// With an exit status other than 0.
    #[error("the program ended with exit status {0}")]
    ExitStatus(i32),
    /// Without an exit status.
    #[error("the program ended without an exit status")]
    NoExitStatus,
    /// Its output is longer than what is kept.
    #[error("the program wrote more than {mebibytes} MiB")]
    TooMuchOutput {
        /// What is kept, MiB.
        mebibytes: u64,
    },
}
