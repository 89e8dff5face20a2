//! Finding sweeps: files, and the ones inside the binary.

use std::path::Path;

use super::plan::{Sweep, stem};
use crate::case::{Complaint, listed, locate, nearest, quoted};
use crate::files::{Input, read_input};

/// Path from the top of the repository, and text, of all sweeps below `cases/`.
const SWEEPS: &[(&str, &str)] = include!(concat!(env!("OUT_DIR"), "/embedded_sweeps.rs"));

/// The embedded sweeps as (path from the top of the repository, text).
pub fn embedded() -> impl Iterator<Item = (&'static str, &'static str)> {
    SWEEPS.iter().copied()
}

impl Sweep {
    /// The sweep that an argument names: a file, or an embedded sweep such as `fig-7`. What exists
    /// as a path wins over a name.
    ///
    /// # Errors
    /// Where there is none, and what is wrong with its file.
    pub fn find(argument: &str) -> Result<Self, Complaint> {
        let path = Path::new(argument);
        if path.exists() && !path.is_dir() {
            let bytes = read_input(path, Input::Toml).map_err(|error| {
                Complaint::new(format!("cannot read {argument}: {error}"))
                    .help("check the path and its permissions")
            })?;
            let is_sweep = |table: &toml::Table| table.contains_key("case");
            let table = toml::from_str(&String::from_utf8_lossy(&bytes));
            if !argument.ends_with(".sweep.toml") && table.is_ok_and(|table| !is_sweep(&table)) {
                return Err(a_case(argument));
            }
            return Self::read(argument, &bytes);
        }
        let known = embedded().find(|(path, _)| stem(path) == stem(argument));
        match known {
            Some((path, text)) => Self::read(path, text.as_bytes()),
            None if locate(argument).is_ok() => Err(a_case(argument)),
            None => Err(unknown(argument)),
        }
    }
}

/// What is said of a case where a sweep belongs.
fn a_case(argument: &str) -> Complaint {
    Complaint::new(format!("{argument} is a case and not a sweep")).help(format!(
        "write `trilith sweep {argument} --vary friction=0.4:0.8:5`, or a file that ends in `.sweep.toml` \
         with `case = {}` and what varies under `[[vary]]`",
        quoted(argument)
    ))
}

fn unknown(argument: &str) -> Complaint {
    let names = || embedded().map(|(path, _)| stem(path));
    let help = match nearest(stem(argument), names()) {
        Some(near) => format!("did you mean `{near}`?"),
        None => format!(
            "name a file that ends in `.sweep.toml`, or one of {}",
            listed(names())
        ),
    };
    Complaint::new(format!("there is no sweep {argument}")).help(help)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_sweep_file_is_embedded_and_can_be_read() {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("cases/sweeps");
        let files = std::fs::read_dir(folder).expect("the folder is there");
        let names = files.map(|file| file.expect("it can be listed").file_name());
        let mut names: Vec<String> = names.map(|n| n.to_string_lossy().into_owned()).collect();
        names.retain(|name| !name.starts_with('.'));
        names.sort();
        let paths: Vec<String> = names.iter().map(|n| format!("cases/sweeps/{n}")).collect();
        let mut known: Vec<&str> = embedded().map(|(path, _)| path).collect();
        known.sort_unstable();
        assert_eq!(known, paths);
        for path in known {
            let sweep = Sweep::find(path).unwrap_or_else(|complaint| panic!("{complaint}"));
            assert!(!sweep.tasks().is_empty() && !sweep.source.is_empty());
        }
    }
}
