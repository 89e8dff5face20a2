//! An outside program, as it is named to trilith.

use std::path::PathBuf;
use std::time::Duration;

/// A program that answers scenes.
#[derive(Clone, Debug, PartialEq)]
pub struct External {
    /// Its name in tables.
    pub name: String,
    /// Program and arguments.
    pub command: Vec<String>,
    /// Where it runs; the current folder where there is none.
    pub folder: Option<PathBuf>,
    /// Time by the clock on the wall after which it is stopped.
    pub limit: Duration,
}

/// Time limit of a program that states none.
pub(super) const DEFAULT_LIMIT: Duration = Duration::from_secs(60);
