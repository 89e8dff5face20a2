//! Finding sweeps: files, and the ones inside the binary.

use std::path::Path;

use super::Sweep;
use crate::case::{Complaint, listed, nearest};

macro_rules! embed {
    ($($path:literal,)*) => {
        [$(($path, include_str!(concat!(env!("CARGO_MANIFEST_DIR"), "/", $path)))),*]
    };
}

/// Path from the top of the repository, and text.
const EMBEDDED: [(&str, &str); 8] = embed![
    "cases/sweeps/fig-6.sweep.toml",
    "cases/sweeps/fig-7.sweep.toml",
    "cases/sweeps/study-bond.sweep.toml",
    "cases/sweeps/study-courses.sweep.toml",
    "cases/sweeps/study-friction.sweep.toml",
    "cases/sweeps/study-overlap.sweep.toml",
    "cases/sweeps/study-unit-aspect.sweep.toml",
    "cases/sweeps/study-wall-aspect.sweep.toml",
];

/// The embedded sweeps as (path from the top of the repository, text).
pub fn embedded() -> impl Iterator<Item = (&'static str, &'static str)> {
    EMBEDDED.into_iter()
}

impl Sweep {
    /// The sweep that an argument names: a file, or an embedded sweep such as `fig-7`. What exists
    /// as a path wins over a name.
    ///
    /// # Errors
    /// Where there is none, and what is wrong with its file.
    pub fn find(argument: &str) -> Result<Self, Complaint> {
        let path = Path::new(argument);
        if path.is_file() {
            let bytes = std::fs::read(path).map_err(|error| {
                Complaint::new(format!("cannot read {argument}: {error}"))
                    .help("check the path and its permissions")
            })?;
            return Self::read(argument, &bytes);
        }
        let known = embedded().find(|(path, _)| stem(path) == stem(argument));
        match known {
            Some((path, text)) => Self::read(path, text.as_bytes()),
            None => Err(unknown(argument)),
        }
    }
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

fn stem(path: &str) -> &str {
    let file = path.rsplit(['/', '\\']).next().unwrap_or(path);
    let file = file.strip_suffix(".toml").unwrap_or(file);
    file.strip_suffix(".sweep").unwrap_or(file)
}

/// The name of a sweep, which goes into the names of files.
pub(super) fn sweep_name(path: &str) -> Result<String, Complaint> {
    let name = stem(path);
    let plain = |c: char| c.is_alphanumeric() || "-_.".contains(c);
    if path.ends_with(".toml") && !name.is_empty() && name.chars().all(plain) {
        return Ok(name.to_owned());
    }
    let title = format!("{path}: a sweep is named by its file, and `{name}` is not a plain word");
    let title = match path.ends_with(".toml") {
        true => title,
        false => format!("{path} is not a sweep: its name does not end in `.toml`"),
    };
    Err(Complaint::new(title)
        .help("use letters, digits, `-`, `_` and `.`, and let the name end in `.sweep.toml`"))
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
        names.sort();
        let paths: Vec<String> = names.iter().map(|n| format!("cases/sweeps/{n}")).collect();
        let known: Vec<&str> = embedded().map(|(path, _)| path).collect();
        assert_eq!(known, paths, "add the new sweep to EMBEDDED");
        for path in known {
            let sweep = Sweep::find(path).unwrap_or_else(|complaint| panic!("{complaint}"));
            assert!(!sweep.tasks().is_empty() && !sweep.source.is_empty());
        }
    }
}
