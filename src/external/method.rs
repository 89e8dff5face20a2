//! An outside program as a method.

use std::time::Duration;

use super::outside::External;
use super::{process, reading, scene};
use crate::answer::{Outcome, ProgramFailure, Status};
use crate::method::{Method, Settings};
use crate::scene::Scene;

impl Method for External {
    fn name(&self) -> &str {
        &self.name
    }

    fn determined_by(&self) -> Vec<String> {
        self.texts()
    }

    fn solve(&self, scene: &Scene, settings: &Settings) -> Outcome {
        self.solve_timed(scene, settings).0
    }

    /// CPU time of the program and of those children that it waited for.
    fn solve_timed(&self, scene: &Scene, _settings: &Settings) -> (Outcome, Option<Duration>) {
        let (outcome, cpu) = match ask(self, scene) {
            Ok((outcome, cpu)) => (outcome, Some(cpu)),
            Err(failure) => (Err(failure), None),
        };
        let failed = |failure| Outcome::without_number(Status::Failed, failure);
        (outcome.unwrap_or_else(failed), cpu)
    }
}

type TimedAnswer = (Result<Outcome, ProgramFailure>, Duration);

/// What the program answers, and its CPU time; an error where it did not run.
fn ask(program: &External, scene: &Scene) -> Result<TimedAnswer, ProgramFailure> {
    let text = scene::export(scene).map_err(|error| ProgramFailure::NotWritten {
        error: error.to_string(),
    })?;
    let finished = process::run(program, text)?;
    let outcome = finished
        .output
        .and_then(|output| reading::outcome(scene, &output));
    Ok((outcome, finished.cpu))
}
