//! `trilith run`.

use std::path::{Path, PathBuf};

use crate::answer::Status;
use crate::case;
use crate::judge::Verdict;
use crate::record::{self, Difference};
use crate::report;
use crate::run::{CaseResult, Partial, marked};
use clap::{Args, ValueEnum};

use super::output;
use super::plan::PlanArguments;
use super::screen::{layout, print, tell};
use super::solve::{Keeping, solve};
use super::stop::{Stop, status};

/// Where the help has what comes of a run.
pub(super) const RESULTS: &str = "Results";

#[derive(Args)]
#[command(next_help_heading = RESULTS)]
pub(super) struct RunArguments {
    /// Case files, folders of them, names of built-in cases, or `-` for a case in standard input; where
    /// none is named, the three walls of the paper.
    #[arg(value_name = "CASE", help_heading = None)]
    cases: Vec<String>,
    /// How results are printed.
    #[arg(long, default_value = "table")]
    format: Format,
    #[command(flatten)]
    kept: KeptArguments,
    /// Also put the scene and the forces and velocities of every answer into the JSON, in the formats of
    /// outside programs (`trilith schema`).
    #[arg(long, hide_short_help = true)]
    states: bool,
    /// Compare records with the .snap files in this folder; where one differs, say in which lines, write
    /// a .snap.new file beside it and end with exit status 1.
    #[arg(long, value_name = "DIR")]
    record: Option<PathBuf>,
    /// Take records that are new or changed for those to compare with from now on.
    #[arg(long, requires = "record", hide_short_help = true)]
    accept: bool,
    /// Remove the .snap files of cases that are gone.
    #[arg(long, requires = "record", hide_short_help = true)]
    prune: bool,
    #[command(flatten)]
    plan: PlanArguments,
}

#[derive(Clone, Copy, ValueEnum)]
pub(super) enum Format {
    Table,
    Csv,
    Json,
}

/// Where results are kept.
#[derive(Args)]
pub(super) struct KeptArguments {
    /// Also write results.csv, results.json and one record a case into this folder.
    #[arg(long, value_name = "DIR")]
    pub(super) out: Option<PathBuf>,
    /// Keep finished results in a journal in this folder, and go on from there [default: the folder of
    /// --out].
    #[arg(long, value_name = "DIR", hide_short_help = true)]
    resume: Option<PathBuf>,
    /// Write the certificates of lower bounds, and that scenes stand, into this folder, one file a scene
    /// and direction of the push: CASE.right.bound, CASE@open.left.bound. Ending the run early (Ctrl-C)
    /// keeps what is proved by then.
    #[arg(long, value_name = "DIR", hide_short_help = true)]
    certificate: Option<PathBuf>,
}

impl KeptArguments {
    /// Tells before the work whether the folders can be written into.
    pub(super) fn test(&self) -> Result<(), Stop> {
        let mut folders = [&self.out, &self.certificate].into_iter().flatten();
        folders.try_for_each(|folder| output::test(folder))
    }

    pub(super) fn keeping(&self, journal: &'static str) -> Keeping<'_> {
        let folder = self.resume.as_deref().or(self.out.as_deref());
        Keeping {
            journal: folder.map(|folder| (folder, journal)),
            certificates: self.certificate.as_deref(),
        }
    }

    /// Prints what is left to print, and writes the files that were asked for.
    pub(super) fn hand_out(
        &self,
        text: &str,
        results: &[CaseResult],
        states: bool,
        partial: Option<&Partial>,
    ) -> Result<(), Stop> {
        let printed = print(text);
        if let Some(folder) = &self.out {
            output::write(folder, files(results, states, partial))?;
        }
        if let Some(folder) = &self.certificate {
            output::write_certificates(folder, results)?;
        }
        printed
    }
}

pub(super) fn run(arguments: &RunArguments) -> Result<u8, Stop> {
    if arguments.states && arguments.kept.out.is_none() && !matches!(arguments.format, Format::Json)
    {
        let text = "error: --states goes into JSON, and none is written\nhelp: add `--format json`, \
                    or `--out DIR`";
        return Err(Stop::bad_input(text));
    }
    let (cases, plan) = arguments.plan.read(&arguments.cases, case::paper)?;
    arguments.kept.test()?;
    if let Some(folder) = &arguments.record {
        output::test(folder)?;
    }
    let format = arguments.format;
    print(&format.heading())?;
    let show = |result: &CaseResult| print(&format.case(result));
    let keeping = arguments.kept.keeping("run.journal");
    let results = solve(&cases, &plan, keeping, show, |results, partial| {
        let text = format.closing(results, arguments.states, partial);
        arguments
            .kept
            .hand_out(&text, results, arguments.states, partial)
    })?;
    let changed = match &arguments.record {
        Some(folder) => compare(folder, &results, arguments)?,
        None => false,
    };
    Ok(status(changed || refuted(&results)))
}

/// Each case is printed as soon as those before it are; a JSON document only as a whole.
impl Format {
    /// What is printed before the first case.
    pub(super) fn heading(self) -> String {
        match self {
            Format::Csv => report::csv(&[]),
            Format::Table | Format::Json => String::new(),
        }
    }

    pub(super) fn case(self, result: &CaseResult) -> String {
        match self {
            Format::Table => report::case_table(result, layout()),
            Format::Csv => {
                let text = report::csv(std::slice::from_ref(result));
                let rows = text.split_once('\n').map(|(_, rows)| rows);
                rows.unwrap_or_default().to_owned()
            }
            Format::Json => String::new(),
        }
    }

    pub(super) fn closing(
        self,
        results: &[CaseResult],
        states: bool,
        partial: Option<&Partial>,
    ) -> String {
        match self {
            Format::Table => {
                let said = partial.map_or(String::new(), |partial| format!("{partial}\n\n"));
                said + &report::legend(layout(), "`--wide` shows every column.")
            }
            Format::Csv => {
                let commas = report::csv(&[]).matches(',').count();
                partial.map_or(String::new(), |partial| partial.csv_line(commas))
            }
            Format::Json => json(results, states, partial),
        }
    }
}

fn json(results: &[CaseResult], states: bool, partial: Option<&Partial>) -> String {
    match states {
        true => report::json_with_states(results, partial),
        false => report::json(results, partial),
    }
}

/// The files results.csv, results.json, with the states where those are wanted, and the records.
pub(super) fn files(
    results: &[CaseResult],
    states: bool,
    partial: Option<&Partial>,
) -> Vec<(String, String)> {
    let csv = marked(report::csv(results), partial);
    let mut files = vec![
        ("results.csv".to_owned(), csv),
        ("results.json".to_owned(), json(results, states, partial)),
    ];
    let records = results.iter();
    files.extend(records.map(|r| (format!("{}.txt", r.case.name), record::record(r))));
    files
}

/// Whether a result failed or a reference or relation is violated.
pub(super) fn refuted(results: &[CaseResult]) -> bool {
    let failed = |r: &CaseResult| r.rows.iter().any(|row| row.status() == Status::Failed);
    let violated = |r: &CaseResult| r.checks.iter().any(|c| c.verdict == Verdict::Violated);
    results
        .iter()
        .any(|result| failed(result) || violated(result))
}

/// Whether any record differs from the accepted one, or the case of one is gone; `prune` removes
/// these, and `accept` takes the others.
fn compare(folder: &Path, results: &[CaseResult], arguments: &RunArguments) -> Result<bool, Stop> {
    let RunArguments {
        cases,
        accept,
        prune,
        ..
    } = arguments;
    let failed = |error: std::io::Error| Stop::bad_input(format!("error: {error}"));
    let mut changed = false;
    for result in results {
        let record = record::record(result);
        let compared = record::compare(folder, &result.case.name, &record, *accept);
        if let Some(Difference { word, path, lines }) = compared.map_err(failed)? {
            let then = match accept {
                true => "and accepted",
                false => "`--accept` takes it, or `cargo insta review`",
            };
            tell!("the record {} is {word}; {then}", path.display());
            tell!("{}", lines.trim_end());
            changed |= !accept;
        }
    }
    let names: Vec<&str> = results.iter().map(|r| r.case.name.as_str()).collect();
    for (name, path) in record::records_beside(folder, &names).map_err(failed)? {
        if !is_gone(&name, cases) {
            continue;
        }
        let shown = path.display();
        if *prune {
            std::fs::remove_file(&path).map_err(failed)?;
            tell!("{shown} was removed, because its case is gone");
        } else {
            tell!("the case of {shown} is gone; `--prune` removes the record");
            changed = true;
        }
    }
    Ok(changed)
}

/// Whether a case that did not run is not there any more, as far as the arguments tell: it is neither
/// built in nor beside a file that they name. A folder that they name has been run as a whole.
fn is_gone(name: &str, arguments: &[String]) -> bool {
    let paths = || arguments.iter().map(Path::new).filter(|path| path.exists());
    let beside = |path: &Path| path.with_file_name(format!("{name}.toml")).exists();
    let built_in = case::embedded()
        .any(|(path, _)| Path::new(path).file_stem().is_some_and(|stem| stem == name));
    // Names of built-in cases alone say nothing about the user's own.
    paths().next().is_some() && !built_in && !paths().filter(|path| path.is_file()).any(beside)
}
