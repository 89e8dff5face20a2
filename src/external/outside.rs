//! An outside program as a method.

use std::path::PathBuf;
use std::time::Duration;

use super::process::{self, External};
use super::{reading, scene};
use crate::answer::{Outcome, Status};
use crate::fingerprint::Fingerprint;
use crate::method::{Method, Settings, Watch};
use crate::scene::Scene;

/// Largest file whose text counts, in bytes.
const LARGEST_FILE: u64 = 64 << 20;

impl Method for External {
    fn name(&self) -> &str {
        &self.name
    }

    /// The command, and the text of every file that it names. What those files use in turn is the
    /// user's to know.
    fn determined_by(&self) -> Vec<String> {
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

    fn solve(&self, scene: &Scene, settings: &Settings) -> Outcome {
        self.solve_watched(scene, settings, &()).0
    }

    /// CPU time of the program and of those children that it waited for.
    fn solve_watched(
        &self,
        scene: &Scene,
        _settings: &Settings,
        _watch: &dyn Watch,
    ) -> (Outcome, Option<Duration>) {
        let failed = |failure| Outcome::without_number(Status::Failed, failure);
        match process::run(self, scene::export(scene)) {
            Ok(finished) => {
                let outcome = finished
                    .output
                    .and_then(|output| reading::outcome(scene, &output));
                (outcome.unwrap_or_else(failed), Some(finished.cpu))
            }
            Err(failure) => (failed(failure), None),
        }
    }
}
