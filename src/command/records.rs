//! Records of a user's cases: changed ones, new ones, and those whose case is gone.

use std::path::Path;

use crate::case;
use crate::record::{RecordChange, compare as compare_record, record, records_beside};
use crate::run::CaseResult;

use super::screen::tell;
use super::stop::Stop;

/// Whether any record differs from the accepted one, or the case of one is gone; `prune` removes
/// these. `arguments` name the cases.
pub(super) fn compare(
    folder: &Path,
    results: &[CaseResult],
    arguments: &[String],
    prune: bool,
) -> Result<bool, Stop> {
    let failed = |error: std::io::Error| Stop::bad_input(format!("error: {error}"));
    let mut changed = false;
    for result in results {
        let compared = compare_record(folder, &result.case.name, &record(result));
        let (word, path) = match compared.map_err(failed)? {
            RecordChange::Same => continue,
            RecordChange::New(path) => ("new", path),
            RecordChange::Changed(path) => ("changed", path),
        };
        let path = path.display();
        tell!("the record {path} is {word}; `cargo insta review` shows it");
        changed = true;
    }
    let names: Vec<&str> = results.iter().map(|r| r.case.name.as_str()).collect();
    for (name, path) in records_beside(folder, &names).map_err(failed)? {
        if !is_gone(&name, arguments) {
            continue;
        }
        let shown = path.display();
        if prune {
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
