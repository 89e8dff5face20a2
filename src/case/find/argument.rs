//! The cases that arguments name.

use std::path::Path;

use super::embedded::embedded;
use super::folder::{cases_below, is_case, is_sweep};
use super::library::paper;
use super::unread::UnreadCase;
use crate::case::complaint::{Complaint, shorten};
use crate::case::model::Case;
use crate::case::name::case_name;
use crate::case::suggestion::{listed, nearest};

/// The cases that an argument names: a `.toml` file, all those below a folder (hidden ones left
/// out), `-` for the one in standard input, or an embedded case. What exists as a path wins over a name.
///
/// # Errors
/// The first complaint about the argument or about a file it names.
pub fn find(argument: &str) -> Result<Vec<Case>, Complaint> {
    locate(argument)?.iter().map(UnreadCase::read).collect()
}

/// All cases that a run's arguments name; none named: the paper's. A file named twice counts once.
///
/// # Errors
/// Every complaint, not only the first; also two cases of the same name.
pub fn collect(arguments: &[String]) -> Result<Vec<Case>, Vec<Complaint>> {
    if arguments.is_empty() {
        return Ok(paper());
    }
    let mut complaints = Vec::new();
    let found = locate_all(arguments, &mut complaints);
    let mut cases = Vec::new();
    let mut paths: Vec<(String, &str)> = Vec::new();
    for one in &found {
        if let Ok(name) = case_name(&one.path) {
            if let Some((_, first)) = paths.iter().find(|(other, _)| *other == name) {
                complaints.push(two_of_a_name(&name, first, &one.path));
                continue;
            }
            paths.push((name, &one.path));
        }
        match one.read() {
            Ok(case) => cases.push(case),
            Err(complaint) => complaints.push(complaint),
        }
    }
    if complaints.is_empty() {
        Ok(cases)
    } else {
        Err(complaints)
    }
}

/// What [`locate`] finds for all arguments, each file once.
fn locate_all(arguments: &[String], complaints: &mut Vec<Complaint>) -> Vec<UnreadCase> {
    let mut found: Vec<UnreadCase> = Vec::new();
    for argument in arguments {
        match locate(argument) {
            Err(complaint) => complaints.push(complaint),
            Ok(more) => {
                for one in more {
                    if !found.iter().any(|other| one.is_same(other)) {
                        found.push(one);
                    }
                }
            }
        }
    }
    found
}

fn two_of_a_name(name: &str, first: &str, second: &str) -> Complaint {
    Complaint::new(format!(
        "two cases are named `{name}`: {first} and {second}"
    ))
    .help("a case is named by its file: rename one, or run them one after the other")
}

/// As [`find`], but none is read yet.
pub(crate) fn locate(argument: &str) -> Result<Vec<UnreadCase>, Complaint> {
    if argument == "-" {
        return Ok(vec![UnreadCase::in_stdin()?]);
    }
    let path = Path::new(argument);
    if path.is_dir() {
        return cases_below(path);
    }
    if path.exists() {
        return if is_case(path) {
            Ok(vec![UnreadCase::in_file(path)?])
        } else if is_sweep(argument) {
            let title = format!("{argument} is a sweep and not a case");
            Err(Complaint::new(title).help(format!("write `trilith sweep {argument}`")))
        } else {
            let title = format!("{argument} is not a case: its name does not end in `.toml`");
            Err(Complaint::new(title).help("name a `.toml` file, a folder, or a known case"))
        };
    }
    match embedded().find(|(path, _)| stands_for(argument, path)) {
        Some(case) => Ok(vec![UnreadCase::embedded(case)]),
        None => Err(unknown(argument)),
    }
}

/// `paper-1`, `walls/paper-1` and `cases/walls/paper-1` stand for `cases/walls/paper-1.toml`, each
/// with or without `.toml`.
fn stands_for(argument: &str, path: &str) -> bool {
    let argument = Path::new(argument.strip_suffix(".toml").unwrap_or(argument));
    argument.components().next().is_some() && Path::new(path).with_extension("").ends_with(argument)
}

fn unknown(argument: &str) -> Complaint {
    let shown = shorten(argument, 200);
    let names = || embedded().map(|(path, _)| stem(path));
    let near = nearest(stem(argument), names());
    let a_path = argument.ends_with(".toml") || argument.contains(['/', '\\']);
    let complaint = if a_path {
        Complaint::new(format!("there is no file or folder {shown}"))
    } else {
        Complaint::new(format!("there is no case named `{shown}`"))
    };
    let file = format!("{argument}.toml");
    if !a_path && Path::new(&file).is_file() {
        return complaint.help(format!("did you mean the file `{}`?", shorten(&file, 200)));
    }
    complaint.help(match near {
        Some(near) => format!("did you mean the case `{near}`?"),
        None if a_path => "check the path; `trilith new NAME` writes a case to begin with".into(),
        None => format!(
            "name a `.toml` file, a folder, or one of {}",
            listed(names())
        ),
    })
}

fn stem(path: &str) -> &str {
    let file = path.rsplit(['/', '\\']).next().unwrap_or(path);
    file.strip_suffix(".toml").unwrap_or(file)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_with_and_without_their_folder_mean_the_same() {
        let names = [
            "paper-1",
            "walls/paper-1",
            "cases/walls/paper-1",
            "paper-1.toml",
        ];
        for name in names {
            assert_eq!(locate(name).unwrap()[0].path, "cases/walls/paper-1.toml");
        }
        let all = collect(&names.map(str::to_owned)).unwrap();
        assert_eq!(all.len(), 1);
        for name in ["", "/", ".toml", "alls/paper-1", "per-1"] {
            assert!(!stands_for(name, "cases/walls/paper-1.toml"), "{name}");
        }
    }
}
