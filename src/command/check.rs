//! `trilith check`.

use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering};

use crate::case::{self, Case};
use crate::report;
use crate::run::{CaseResult, Partial, Stored, stored, strays};
use clap::Args;

use super::plan::PlanArguments;
use super::run::{KeptArguments, refuted};
use super::screen::{layout, print, print_lines};
use super::solve::solve;
use super::stop::{Stop, status};

#[derive(Args)]
pub(super) struct CheckArguments {
    /// Case files, folders of them, or names of built-in cases; where none is named, the whole library.
    #[arg(value_name = "CASE")]
    cases: Vec<String>,
    #[command(flatten)]
    plan: PlanArguments,
    #[command(flatten)]
    kept: KeptArguments,
    /// Verify the stored certificates of the cases in this folder, without a solver [default:
    /// cases/certificates, where there is one].
    #[arg(long, value_name = "DIR")]
    certificates: Option<PathBuf>,
    /// Also put the scene and the forces and velocities of every answer into results.json, in the formats
    /// of outside programs (`trilith schema`).
    #[arg(long, requires = "out")]
    states: bool,
}

pub(super) fn check(arguments: &CheckArguments) -> Result<u8, Stop> {
    let (cases, plan) = arguments.plan.read(&arguments.cases, case::library)?;
    arguments.kept.test()?;
    let stored_in = stored_in(arguments)?;
    let refused = AtomicBool::new(false);
    // Whoever names cases and a folder says that their certificates are there.
    let all = arguments.certificates.is_some() && !arguments.cases.is_empty();
    print(&report::library_heading(layout()))?;
    let show = |result: &CaseResult| {
        print(&report::library_case(result, layout()))?;
        for stored in stored_in
            .iter()
            .flat_map(|folder| stored(result, folder, all))
        {
            if stored.verdict.is_err() {
                refused.store(true, Ordering::SeqCst);
            }
            print_lines(&format!("{stored}\n"))?;
        }
        Ok(())
    };
    for stray in strays_in(stored_in.as_deref(), &cases)? {
        refused.store(true, Ordering::SeqCst);
        print_lines(&format!("{stray}\n"))?;
    }
    let kept = arguments.kept.journal("check.journal");
    let results = solve(&cases, &plan, kept, show, |results, partial| {
        hand_out(arguments, results, partial)
    })?;
    Ok(status(refuted(&results) || refused.load(Ordering::SeqCst)))
}

fn hand_out(
    arguments: &CheckArguments,
    results: &[CaseResult],
    partial: Option<&Partial>,
) -> Result<(), Stop> {
    let said = partial.map_or(String::new(), |partial| format!("\n{partial}\n"));
    let printed = print(&format!(
        "{said}{}",
        report::library_closing(results, layout())
    ));
    arguments.kept.write(results, arguments.states, partial)?;
    printed
}

/// The certificates in the folder that are of no case that is checked or built in.
fn strays_in(folder: Option<&Path>, cases: &[Case]) -> Result<Vec<Stored>, Stop> {
    let Some(folder) = folder else {
        return Ok(Vec::new());
    };
    let known = [cases.to_vec(), case::library()].concat();
    strays(&known, folder).map_err(|error| {
        let folder = folder.display();
        Stop::bad_input(format!(
            "error: cannot read {folder}: {error}\nhelp: name a folder that can be read"
        ))
    })
}

/// Where certificates lie unless a user says otherwise.
const CERTIFICATES: &str = "cases/certificates";

fn stored_in(arguments: &CheckArguments) -> Result<Option<PathBuf>, Stop> {
    match &arguments.certificates {
        Some(folder) if folder.is_dir() => Ok(Some(folder.clone())),
        Some(folder) => Err(Stop::bad_input(format!(
            "error: there is no folder {}\nhelp: `run --method bound --certificate DIR` writes \
             certificates into one",
            folder.display()
        ))),
        None => Ok(Some(PathBuf::from(CERTIFICATES)).filter(|folder| folder.is_dir())),
    }
}
