//! Certificates in files: which belong to a result, and what they prove of its scenes.

use std::collections::HashSet;
use std::path::Path;
use std::{fmt, fs, io};

use super::results::CaseResult;
use super::row::{Row, scene_name};
use crate::answer::{Evidence, Outcome, Status, magnitude};
use crate::case::Case;
use crate::certificate::{Certificate, Proved, prove};
use crate::files::{Input, read_input};
use crate::mechanics::CollapseState;
use crate::number::number;
use crate::scene::{HeadJoints, Push, Scene};

/// What one stored certificate is worth.
#[derive(Clone, Debug, PartialEq)]
pub struct Stored {
    pub file: String,
    /// What it proves, or in words why it is refused.
    pub verdict: Result<Proved, String>,
}

impl fmt::Display for Stored {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match &self.verdict {
            Ok(proved) => write!(f, "certificate {}: {proved}", self.file),
            Err(why) => write!(f, "certificate {}: REFUSED: {why}", self.file),
        }
    }
}

/// Name of the file with the certificate of a scene.
pub(super) fn file_name(case: &str, head_joints: HeadJoints, push: Push) -> String {
    let scene = scene_name(case, head_joints);
    format!("{scene}.{}.bound", push.name())
}

/// The certificates of a result's answers, as files: names and bytes.
pub fn certificates(result: &CaseResult) -> Vec<(String, Vec<u8>)> {
    let mut files = Vec::new();
    for row in &result.rows {
        for (push, outcome) in row.sides() {
            let certificate = outcome.evidence.certificate();
            if let Some(certificate) = certificate.filter(|_| is_proved(outcome)) {
                let name = file_name(&row.case, row.head_joints, push);
                files.push((name, certificate.to_bytes()));
            }
        }
    }
    files
}

fn is_proved(outcome: &Outcome) -> bool {
    matches!(
        outcome.status,
        Status::Verified | Status::Bracketed | Status::Stands
    )
}

/// Names of the certificates that the repository has of the library.
const CERTIFIED: &[&str] = include!(concat!(env!("OUT_DIR"), "/certified.rs"));

/// What the certificates in a folder prove of a result's scenes, each by sparse products and without
/// a solver. One that a verified state of the same scene contradicts is refused too, and so is one that
/// is not there: of every scene where `all` are to be, else of those that the repository has one of.
pub fn stored(result: &CaseResult, folder: &Path, all: bool) -> Vec<Stored> {
    let mut found = Vec::new();
    for (head_joints, sides) in &result.scenes {
        for scene in sides {
            let file = file_name(&result.case.name, *head_joints, scene.push());
            let path = folder.join(&file);
            if path.exists() {
                let verdict = verdict(result, *head_joints, scene, &path);
                found.push(Stored { file, verdict });
            } else if all || CERTIFIED.contains(&file.as_str()) {
                let verdict = Err("it is missing".to_owned());
                found.push(Stored { file, verdict });
            }
        }
    }
    found
}

/// The files in a folder that are certificates of no scene of these cases.
///
/// # Errors
/// Where the folder cannot be read.
pub fn strays(cases: &[Case], folder: &Path) -> io::Result<Vec<Stored>> {
    let of_case = |case: &Case| -> Vec<String> {
        let settings = [HeadJoints::Contact, HeadJoints::Open].into_iter();
        let scenes = settings.flat_map(|head| case.pushes.iter().map(move |&push| (head, push)));
        scenes
            .map(|(head, push)| file_name(&case.name, head, push))
            .collect()
    };
    let known: HashSet<String> = cases.iter().flat_map(of_case).collect();
    let mut strays = Vec::new();
    for entry in fs::read_dir(folder)? {
        let file = entry?.file_name().to_string_lossy().into_owned();
        if !known.contains(&file) {
            let verdict = Err("it is of no scene of a case that is checked or built in".to_owned());
            strays.push(Stored { file, verdict });
        }
    }
    strays.sort_by(|a, b| a.file.cmp(&b.file));
    Ok(strays)
}

/// The verified collapse states of a search for one side of the push.
fn verified(row: &Row, push: Push) -> &[CollapseState] {
    let outcome = row
        .side(push)
        .filter(|outcome| outcome.status == Status::Verified);
    match outcome.map(|outcome| &outcome.evidence) {
        Some(Evidence::States { states, .. }) => states,
        _ => &[],
    }
}

fn verdict(
    result: &CaseResult,
    head_joints: HeadJoints,
    scene: &Scene,
    path: &Path,
) -> Result<Proved, String> {
    let bytes = read_input(path, Input::Certificate);
    let bytes = bytes.map_err(|error| format!("cannot read it: {error}"))?;
    let certificate = Certificate::from_bytes(&bytes).map_err(|why| why.to_string())?;
    let proved = prove(scene, &certificate).map_err(|why| why.to_string())?;
    let rows = result.rows.iter();
    let of_scene = rows.filter(|row| row.head_joints == head_joints);
    let states = of_scene.flat_map(|row| {
        let states = verified(row, scene.push()).iter();
        states.map(move |state| (row, state.lambda))
    });
    let margin = |lambda: f64| 1e-6 * magnitude(lambda, scene.multiplier_unit());
    let mut below = states.filter(|(_, lambda)| *lambda + margin(*lambda) < proved.lower);
    match below.next() {
        None => Ok(proved),
        Some((row, lambda)) => {
            let range = match proved.lower.is_finite() {
                true => format!("below {}", number(proved.lower, 6)),
                false => "at any λ ≥ 0".to_owned(),
            };
            let (method, lambda) = (&row.method, number(lambda, 6));
            Err(format!(
                "it proves that no state is {range}, and {method} verifies one at {lambda}"
            ))
        }
    }
}
