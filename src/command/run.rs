//! `trilith run`.

use std::path::Path;
use std::time::Duration;

use indicatif::{ProgressBar, ProgressStyle};
use trilith::case::{self, Case};
use trilith::judge::Verdict;
use trilith::method::{METHODS, Method, Settings, Status};
use trilith::record::record;
use trilith::report::{self, Comparison};
use trilith::run::{CaseResult, Plan};

use super::{CollapseArgument, Format, REFUTED, RunArguments, Stop, print};

pub(super) fn run(arguments: &RunArguments) -> Result<u8, Stop> {
    let (methods, misplaced) = methods(&arguments.method)?;
    let mut cases = read(&[arguments.cases.as_slice(), &misplaced].concat())?;
    if matches!(arguments.collapse, CollapseArgument::FirstSlip) {
        // References of the pushover are of the collapse, which is not what it was asked for.
        for case in &mut cases {
            case.references
                .retain(|reference| reference.method != "pushover");
        }
    }
    let plan = Plan {
        methods,
        settings: Settings {
            starts: arguments.starts as usize,
            accuracy: arguments.accuracy.into(),
            verify: arguments.verify,
            long_ranges: arguments.long_ranges,
            collapse: arguments.collapse.into(),
            ..Settings::default()
        },
        head_joints: arguments.head_joints.map(Into::into),
    };
    let bar = progress_bar(plan.runs(&cases) as u64);
    let results = trilith::run::run(&cases, &plan, |case, method| {
        bar.set_message(format!("{case} {method}"));
        bar.inc(1);
    });
    bar.finish_and_clear();
    let text = match arguments.format {
        Format::Table => report::table(&results),
        Format::Csv => csv(&results)?,
        Format::Json => json(&results)?,
    };
    if let Some(folder) = &arguments.out {
        write(folder, &results)?;
    }
    print(&text)?;
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

fn read(arguments: &[String]) -> Result<Vec<Case>, Stop> {
    case::collect(arguments).map_err(|complaints| {
        let texts: Vec<String> = complaints.iter().map(ToString::to_string).collect();
        Stop::bad_input(texts.join("\n\n"))
    })
}

/// The methods of these names in the list's own order, each once; all of them without a name. What
/// names no method but a case, as in `--method associative paper-1`, is handed back.
fn methods(names: &[String]) -> Result<(Vec<&'static dyn Method>, Vec<String>), Stop> {
    let known = |name: &str| METHODS.iter().any(|method| method.name() == name);
    let (names, others): (Vec<String>, Vec<String>) =
        names.iter().cloned().partition(|name| known(name));
    if let Some(other) = others.iter().find(|other| case::find(other).is_err()) {
        let list = METHODS.map(|method| method.name()).join(", ");
        let text = format!("error: there is no method named `{other}`\nhelp: methods are {list}");
        return Err(Stop::bad_input(text));
    }
    let wanted =
        |method: &&dyn Method| names.is_empty() || names.iter().any(|n| n == method.name());
    Ok((METHODS.into_iter().filter(wanted).collect(), others))
}

/// Progress on standard error, only where that is a terminal.
fn progress_bar(runs: u64) -> ProgressBar {
    let bar = ProgressBar::new(runs);
    let style = ProgressStyle::with_template("{bar:30} {pos}/{len} {elapsed} (left: {eta}) {msg}");
    bar.set_style(style.expect("the template is valid"));
    bar.enable_steady_tick(Duration::from_millis(200));
    bar
}

fn csv(results: &[CaseResult]) -> Result<String, Stop> {
    report::csv(results).map_err(|e| Stop::bad_input(format!("error: cannot write CSV: {e}")))
}

fn json(results: &[CaseResult]) -> Result<String, Stop> {
    report::json(results).map_err(|e| Stop::bad_input(format!("error: cannot write JSON: {e}")))
}

fn write(folder: &Path, results: &[CaseResult]) -> Result<(), Stop> {
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
        report::write_whole(&path, &text)
            .map_err(|e| Stop::bad_input(format!("error: cannot write {}: {e}", path.display())))?;
    }
    Ok(())
}

/// Whether any record differs from the accepted one.
fn compare(folder: &Path, results: &[CaseResult]) -> Result<bool, Stop> {
    let mut changed = false;
    for result in results {
        let compared = report::compare(folder, &result.case.name, &record(result));
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

fn refuted(results: &[CaseResult]) -> bool {
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn methods_keep_their_order_and_come_once() {
        let names = ["sequential", "paper-1", "macro-block", "sequential"].map(str::to_owned);
        let (found, cases) = methods(&names).unwrap_or_default();
        let found: Vec<&str> = found.iter().map(|m| m.name()).collect();
        assert_eq!(found, ["macro-block", "sequential"]);
        assert_eq!(cases, ["paper-1"]);
        assert!(methods(&["guess".to_owned()]).is_err());
    }
}
