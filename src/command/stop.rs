//! How a command ends: text on standard output, or why it stops and with which exit status.

use std::fmt::Display;

use crate::case::Complaint;

/// Exit status of a result that failed, a published value violated, a record that changed.
const REFUTED: u8 = 1;

/// Exit status of bad input and usage, which is also clap's.
const BAD_INPUT: u8 = 2;

pub(super) struct Stop {
    pub(super) text: String,
    pub(super) status: u8,
}

impl Stop {
    pub(super) fn bad_input(text: impl Into<String>) -> Self {
        Self {
            text: text.into(),
            status: BAD_INPUT,
        }
    }

    /// A file, or what is to be in it, that cannot be written.
    pub(super) fn not_written(what: impl Display, error: impl Display) -> Self {
        Self::bad_input(format!("error: cannot write {what}: {error}"))
    }
}

impl From<Complaint> for Stop {
    fn from(complaint: Complaint) -> Self {
        Self::bad_input(complaint.to_string())
    }
}

pub(super) fn status(refuted: bool) -> u8 {
    if refuted { REFUTED } else { 0 }
}
