//! How a command ends: text on standard output, or why it stops and with which exit status.

/// Exit status of a result that failed, a published value violated, a record that changed.
pub(super) const REFUTED: u8 = 1;

/// Exit status of bad input and usage, which is also clap's.
pub(super) const BAD_INPUT: u8 = 2;

/// Why a command stops, printed to standard error.
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
}
