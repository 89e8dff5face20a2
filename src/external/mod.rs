//! External methods: any program that reads a scene as JSON on standard input and writes its answer
//! as JSON on standard output, in the same tables and charts as the methods here.
//!
//! A program that crashes, hangs, floods its output or answers nonsense is a row like any other,
//! `failed` with the reason. One that hands over forces and velocities is judged like any other:
//! it can earn `verified`, and can be refuted.

mod answer;
mod list;
mod process;
mod scene;

use std::path::PathBuf;
use std::time::Duration;

use crate::answer::{Outcome, Status};
use crate::method::{Method, Settings};
use crate::scene::Scene;

pub use answer::{AnswerFile, Kind};
pub use list::{NAME_LENGTH, parse, read};
pub use scene::{SceneFile, export};

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
pub const DEFAULT_LIMIT: Duration = Duration::from_secs(60);

impl Method for External {
    fn name(&self) -> &str {
        &self.name
    }

    fn solve(&self, scene: &Scene, settings: &Settings) -> Outcome {
        self.solve_timed(scene, settings).0
    }

    /// CPU time of the program and of those children that it waited for.
    fn solve_timed(&self, scene: &Scene, _settings: &Settings) -> (Outcome, Option<Duration>) {
        let failed = |reason: String| Outcome::without_number(Status::Failed, reason);
        let text = match export(scene) {
            Ok(text) => text,
            Err(error) => {
                return (
                    failed(format!("the scene cannot be written: {error}")),
                    None,
                );
            }
        };
        match process::run(self, text) {
            Err(reason) => (failed(reason), None),
            Ok(ended) => {
                let outcome = match ended.output {
                    Ok(output) => answer::outcome(scene, &output),
                    Err(reason) => Err(reason),
                };
                (outcome.unwrap_or_else(failed), Some(ended.cpu))
            }
        }
    }
}

/// JSON schema of the scene that a program reads.
pub fn scene_schema() -> schemars::Schema {
    schemars::schema_for!(SceneFile)
}

/// JSON schema of the answer that a program writes.
pub fn answer_schema() -> schemars::Schema {
    schemars::schema_for!(AnswerFile)
}
