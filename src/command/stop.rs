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

/// Prints to standard output; a closed pipe ends the program quietly, as `head` expects.
pub(super) fn print(text: &str) -> Result<(), Stop> {
    use std::io::Write;
    let mut out = std::io::stdout().lock();
    match out.write_all(text.as_bytes()).and_then(|()| out.flush()) {
        Err(e) if e.kind() != std::io::ErrorKind::BrokenPipe => {
            Err(Stop::bad_input(format!("error: cannot write results: {e}")))
        }
        _ => Ok(()),
    }
}
