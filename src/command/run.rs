//! `trilith run`.

use std::path::Path;

use trilith::answer::Status;
use trilith::case;
use trilith::files::write_whole;
use trilith::judge::Verdict;
use trilith::record::{Comparison, compare as compare_record, record};
use trilith::report;
use trilith::run::CaseResult;

use super::solve::solve;
use super::{Format, REFUTED, RunArguments, Stop, print};

pub(super) fn run(arguments: &RunArguments) -> Result<u8, Stop> {
    let (cases, plan) = arguments.plan.read(&arguments.cases, case::paper)?;
    let results = solve(&cases, &plan, |complete| {
        hand_out(arguments, complete)?;
        Ok(handed_out(arguments.out.as_deref()))
    });
    hand_out(arguments, &results)?;
    let changed = match &arguments.record {
        Some(folder) => compare(folder, &results)?,
        None => false,
    };
    Ok(if changed || refuted(&results) {
        REFUTED
    } else {
        0
    })
}

/// Writes the files that were asked for, and prints.
fn hand_out(arguments: &RunArguments, results: &[CaseResult]) -> Result<(), Stop> {
    let text = match arguments.format {
        Format::Table => report::table(results),
        Format::Csv => csv(results)?,
        Format::Json => json(results)?,
    };
    if let Some(folder) = &arguments.out {
        write(folder, results)?;
    }
    print(&text)
}

/// What became of finished results, in words.
pub(super) fn handed_out(folder: Option<&Path>) -> String {
    match folder {
        Some(folder) => format!("printed and written to {}", folder.display()),
        None => "printed".to_owned(),
    }
}

fn csv(results: &[CaseResult]) -> Result<String, Stop> {
    report::csv(results).map_err(|e| Stop::bad_input(format!("error: cannot write CSV: {e}")))
}

fn json(results: &[CaseResult]) -> Result<String, Stop> {
    report::json(results).map_err(|e| Stop::bad_input(format!("error: cannot write JSON: {e}")))
}

pub(super) fn write(folder: &Path, results: &[CaseResult]) -> Result<(), Stop> {
    let mut files = vec![
        ("results.csv".to_owned(), csv(results)?),
        ("results.json".to_owned(), json(results)?),
    ];
    files.extend(
        results
            .iter()
            .map(|r| (format!("{}.txt", r.case.name), record(r))),
    );
    for (name, text) in files {
        let path = folder.join(name);
        write_whole(&path, &text)
            .map_err(|e| Stop::bad_input(format!("error: cannot write {}: {e}", path.display())))?;
    }
    Ok(())
}

/// Whether any record differs from the accepted one.
fn compare(folder: &Path, results: &[CaseResult]) -> Result<bool, Stop> {
    let mut changed = false;
    for result in results {
        let compared = compare_record(folder, &result.case.name, &record(result));
        match compared.map_err(|e| Stop::bad_input(format!("error: {e}")))? {
            Comparison::Same => {}
            Comparison::Changed(path) => {
                eprintln!(
                    "changed: {} (see it with `cargo insta review`)",
                    path.display()
                );
                changed = true;
            }
        }
    }
    Ok(changed)
}

/// Whether a result failed or a reference or relation is violated.
pub(super) fn refuted(results: &[CaseResult]) -> bool {
    let failed = |r: &CaseResult| {
        r.rows
            .iter()
            .any(|row| row.outcome.status == Status::Failed)
    };
    let violated = |r: &CaseResult| r.checks.iter().any(|c| c.verdict == Verdict::Violated);
    results
        .iter()
        .any(|result| failed(result) || violated(result))
}
