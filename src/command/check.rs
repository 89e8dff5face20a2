//! `trilith check`.

use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering};

use crate::case::{self, Case};
use crate::report;
use crate::run::{CaseResult, Partial, Stored, stored, strays};
use clap::Args;

use super::plan::PlanArguments;
use super::run::{Format, KeptArguments, RESULTS, refuted};
use super::screen::{layout, print, print_lines, tell};
use super::solve::solve;
use super::stop::{Stop, status};

#[derive(Args)]
#[command(next_help_heading = RESULTS)]
pub(super) struct CheckArguments {
    /// Case files, folders of them, names of built-in cases, or `-` for a case in standard input; where
    /// none is named, the whole library.
    #[arg(value_name = "CASE", help_heading = None)]
    cases: Vec<String>,
    /// How results are printed; csv and json are those of `run`, and what certificates prove goes to standard
    /// error then.
    #[arg(long, default_value = "table")]
    format: Format,
    #[command(flatten)]
    kept: KeptArguments,
    /// Verify the stored certificates of the cases in this folder, without a solver [default:
    /// cases/certificates, where there is one]. Where neither a case nor a method is named, nothing else
    /// runs.
    #[arg(long, value_name = "DIR")]
    certificates: Option<PathBuf>,
    /// Also put the scene and the forces and velocities of every answer into results.json, in the formats
    /// of outside programs (`trilith schema`).
    #[arg(long, requires = "out", hide_short_help = true)]
    states: bool,
    #[command(flatten)]
    plan: PlanArguments,
}

pub(super) fn check(arguments: &CheckArguments) -> Result<u8, Stop> {
    let (cases, mut plan) = arguments.plan.read(&arguments.cases, case::library)?;
    arguments.kept.test()?;
    let stored_in = stored_in(arguments)?;
    let refused = AtomicBool::new(false);
    // Whoever names cases and a folder says that their certificates are there.
    let all = arguments.certificates.is_some() && !arguments.cases.is_empty();
    if arguments.verifies_alone() {
        plan.methods.clear();
    }
    print(&arguments.heading())?;
    let show = |result: &CaseResult| {
        print(&arguments.case(result))?;
        for stored in stored_in
            .iter()
            .flat_map(|folder| stored(result, folder, all))
        {
            if stored.verdict.is_err() {
                refused.store(true, Ordering::SeqCst);
            }
            arguments.say(&stored)?;
        }
        Ok(())
    };
    for stray in strays_in(stored_in.as_deref(), &cases)? {
        refused.store(true, Ordering::SeqCst);
        arguments.say(&stray)?;
    }
    let keeping = arguments.kept.keeping("check.journal");
    let results = solve(&cases, &plan, keeping, show, |results, partial| {
        let text = arguments.closing(results, partial);
        arguments
            .kept
            .hand_out(&text, results, arguments.states, partial)
    })?;
    Ok(status(refuted(&results) || refused.load(Ordering::SeqCst)))
}

impl CheckArguments {
    /// Whether certificates are all that is asked for.
    fn verifies_alone(&self) -> bool {
        self.certificates.is_some() && self.cases.is_empty() && !self.plan.names_methods()
    }

    fn heading(&self) -> String {
        match self.format {
            Format::Table if self.verifies_alone() => String::new(),
            Format::Table => report::library_heading(layout()),
            format => format.heading(),
        }
    }

    fn case(&self, result: &CaseResult) -> String {
        match self.format {
            Format::Table if self.verifies_alone() => String::new(),
            Format::Table => report::library_case(result, layout()),
            format => format.case(result),
        }
    }

    fn closing(&self, results: &[CaseResult], partial: Option<&Partial>) -> String {
        match self.format {
            Format::Table if self.verifies_alone() => String::new(),
            Format::Table => {
                let said = partial.map_or(String::new(), |partial| format!("\n{partial}\n"));
                said + &report::library_closing(results, layout())
            }
            format => format.closing(results, self.states, partial),
        }
    }

    /// What a certificate is worth.
    fn say(&self, stored: &Stored) -> Result<(), Stop> {
        match self.format {
            Format::Table => print_lines(&format!("{stored}\n")),
            Format::Csv | Format::Json => {
                tell!("{stored}");
                Ok(())
            }
        }
    }
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
