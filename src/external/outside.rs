//! An outside program, as it is named to trilith.

use std::path::PathBuf;
use std::time::Duration;

use crate::fingerprint::Fingerprint;

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

/// Largest file whose text counts, in bytes.
const LARGEST_FILE: u64 = 64 << 20;

impl External {
    /// What determines its answer beyond the scene: the command, and the text of every file that it
    /// names. What those files use in turn is the user's to know.
    pub(super) fn texts(&self) -> Vec<String> {
        let mut texts = vec![format!("{:?}", self.command)];
        for word in &self.command {
            let path = match &self.folder {
                Some(folder) => folder.join(word),
                None => PathBuf::from(word),
            };
            let kept = std::fs::metadata(&path)
                .is_ok_and(|about| about.is_file() && about.len() <= LARGEST_FILE);
            if kept && let Ok(bytes) = std::fs::read(path) {
                let mut text = Fingerprint::new();
                text.add(&bytes);
                texts.push(text.hex());
            }
        }
        texts
    }
}
