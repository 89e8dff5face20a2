//! Finding cases: the ones inside the binary, files, and folders of files.

use std::collections::HashSet;
use std::fs;
use std::path::{Path, PathBuf};

use super::complaint::{Complaint, listed, nearest, shorten};
use super::embedded::{BESIDE, EMBEDDED};
use super::{Case, case_name};

/// Number of the paper's walls at the head of [`EMBEDDED`].
const PAPER: usize = 3;

/// A case that was found and not yet read.
#[derive(Clone, Debug)]
pub(crate) struct Found {
    /// As the user would write it.
    pub path: String,
    /// What tells one file from another; `None` for an embedded case.
    pub identity: Option<PathBuf>,
    /// The text.
    pub bytes: Vec<u8>,
}

/// The embedded cases as (path from the top of the repository, text).
pub fn embedded() -> impl Iterator<Item = (&'static str, &'static str)> {
    EMBEDDED.into_iter()
}

/// The three walls of the paper's Table 1.
pub fn paper() -> Vec<Case> {
    first(PAPER)
}

/// Every embedded case.
pub fn library() -> Vec<Case> {
    first(EMBEDDED.len())
}

fn first(count: usize) -> Vec<Case> {
    let read = |(path, text): (&str, &str)| {
        read_embedded(path, text.as_bytes()).expect("a test reads every embedded case")
    };
    embedded().take(count).map(read).collect()
}

/// The cases that an argument names: a `.toml` file, all those below a folder (hidden ones left
/// out), or an embedded case. What exists as a path wins over a name.
///
/// # Errors
/// The first complaint about the argument or about a file it names.
pub fn find(argument: &str) -> Result<Vec<Case>, Complaint> {
    look(argument)?.iter().map(Found::read).collect()
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
    let mut found: Vec<Found> = Vec::new();
    for argument in arguments {
        match look(argument) {
            Ok(more) => {
                for one in more {
                    if !found.iter().any(|other| same(&one, other)) {
                        found.push(one);
                    }
                }
            }
            Err(complaint) => complaints.push(complaint),
        }
    }
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

impl Found {
    /// Reads the case.
    pub fn read(&self) -> Result<Case, Complaint> {
        let beside = |name: &str| self.beside(name);
        Case::read_beside(&self.path, &self.bytes, &beside)
    }

    /// Bytes of the file of this name beside the case; in words why there are none.
    pub fn beside(&self, name: &str) -> Result<Vec<u8>, String> {
        match &self.identity {
            // Beside the file itself, also where a link leads to it.
            Some(file) => fs::read(file.with_file_name(name)).map_err(|error| error.to_string()),
            None => beside_embedded(&self.path, name),
        }
    }
}

fn read_embedded(path: &str, bytes: &[u8]) -> Result<Case, Complaint> {
    Case::read_beside(path, bytes, &|name| beside_embedded(path, name))
}

fn beside_embedded(path: &str, name: &str) -> Result<Vec<u8>, String> {
    let wanted = Path::new(path).with_file_name(name);
    let found = BESIDE.iter().find(|(path, _)| Path::new(path) == wanted);
    let text = found.map(|(_, text)| text.as_bytes().to_vec());
    text.ok_or_else(|| "it is not built in".to_owned())
}

/// The same file; or an embedded case and the very file that it was embedded from.
fn same(one: &Found, other: &Found) -> bool {
    match (&one.identity, &other.identity) {
        (Some(a), Some(b)) => a == b,
        (None, None) => one.path == other.path,
        _ => {
            Path::new(&one.path).file_name() == Path::new(&other.path).file_name()
                && one.bytes == other.bytes
        }
    }
}

fn two_of_a_name(name: &str, first: &str, second: &str) -> Complaint {
    Complaint::new(format!(
        "two cases are named `{name}`: {first} and {second}"
    ))
    .help("a case is named by its file: rename one, or run them one after the other")
}

/// As [`find`], but none is read yet.
pub(crate) fn look(argument: &str) -> Result<Vec<Found>, Complaint> {
    let path = Path::new(argument);
    if path.is_dir() {
        return look_below(path);
    }
    if path.exists() {
        return if is_case(path) {
            Ok(vec![load(path)?])
        } else if is_sweep(argument) {
            let title = format!("{argument} is a sweep and not a case");
            Err(Complaint::new(title).help(format!("write `trilith sweep {argument}`")))
        } else {
            let title = format!("{argument} is not a case: its name does not end in `.toml`");
            Err(Complaint::new(title).help("name a `.toml` file, a folder, or a known case"))
        };
    }
    let known = embedded().find(|(path, _)| stands_for(argument, path));
    let Some((path, text)) = known else {
        return Err(unknown(argument));
    };
    Ok(vec![Found {
        path: path.to_owned(),
        identity: None,
        bytes: text.as_bytes().to_vec(),
    }])
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

/// A sweep is a `.toml` file too, and no case.
fn is_case(path: &Path) -> bool {
    let is = |name: &str| name.ends_with(".toml") && !is_sweep(name);
    path.file_name()
        .is_some_and(|name| is(&name.to_string_lossy()))
}

fn is_sweep(name: &str) -> bool {
    name.ends_with(".sweep.toml")
}

fn load(path: &Path) -> Result<Found, Complaint> {
    let shown = path.display().to_string();
    let failed = |error: std::io::Error| {
        Complaint::new(format!("cannot read {shown}: {error}"))
            .help("check the path and its permissions")
    };
    let bytes = fs::read(path).map_err(failed)?;
    let identity = Some(path.canonicalize().map_err(failed)?);
    Ok(Found {
        path: shown,
        identity,
        bytes,
    })
}

/// Every case below a folder, sorted by path.
fn look_below(top: &Path) -> Result<Vec<Found>, Complaint> {
    let mut paths = Vec::new();
    let mut folders = vec![top.to_owned()];
    // A symbolic link may lead back up: each folder is entered once.
    let mut entered = HashSet::new();
    while let Some(folder) = folders.pop() {
        let failed = |error: std::io::Error| {
            Complaint::new(format!("cannot read {}: {error}", folder.display()))
                .help("check the folder and its permissions")
        };
        if !entered.insert(folder.canonicalize().map_err(failed)?) {
            continue;
        }
        for entry in fs::read_dir(&folder).map_err(failed)? {
            let entry = entry.map_err(failed)?;
            let path = entry.path();
            if entry.file_name().to_string_lossy().starts_with('.') {
                continue;
            }
            if path.is_dir() {
                folders.push(path);
            } else if is_case(&path) {
                paths.push(path);
            }
        }
    }
    if paths.is_empty() {
        let title = format!("there is no case in the folder {}", top.display());
        return Err(Complaint::new(title)
            .help("a case is a `.toml` file; `trilith new NAME` writes one to begin with"));
    }
    paths.sort();
    paths.iter().map(|path| load(path)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_case_file_is_embedded_and_can_be_read() {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("cases");
        let mut files: Vec<String> = look_below(&folder)
            .unwrap()
            .iter()
            .map(|found| found.path.replace('\\', "/"))
            .map(|path| path[path.find("cases/").unwrap()..].to_owned())
            .collect();
        files.sort();
        let mut paths: Vec<&str> = embedded().map(|(path, _)| path).collect();
        paths.sort_unstable();
        assert_eq!(files, paths, "add the new case to EMBEDDED");
        for (path, text) in embedded() {
            if let Err(complaint) = read_embedded(path, text.as_bytes()) {
                panic!("{complaint}");
            }
        }
    }

    #[test]
    fn every_case_says_where_it_and_its_references_come_from() {
        let cases = library();
        assert!(cases.len() >= 40, "{}", cases.len());
        let references: Vec<_> = cases.iter().flat_map(|case| &case.references).collect();
        assert!(references.len() >= 60, "{}", references.len());
        assert!(cases.iter().all(|case| !case.source.trim().is_empty()));
        assert!(references.iter().all(|r| !r.source.trim().is_empty()));
        // What this project computes is never a reference.
        assert!(references.iter().all(|r| !r.source.contains("trilith")));
    }

    #[test]
    fn every_file_beside_a_case_is_embedded() {
        let top = Path::new(env!("CARGO_MANIFEST_DIR"));
        let mut folders = vec![top.join("cases")];
        let mut found = Vec::new();
        while let Some(folder) = folders.pop() {
            for entry in fs::read_dir(folder).unwrap() {
                let path = entry.unwrap().path();
                if path.is_dir() {
                    folders.push(path);
                } else if !is_case(&path) && !is_sweep(&path.to_string_lossy()) {
                    let path = path.strip_prefix(top).unwrap().display().to_string();
                    found.push(path.replace('\\', "/"));
                }
            }
        }
        found.sort();
        assert_eq!(
            found,
            BESIDE.map(|(path, _)| path),
            "add the file to BESIDE"
        );
    }

    #[test]
    fn the_papers_walls_have_the_papers_sizes() {
        let cases = paper();
        let names: Vec<&str> = cases.iter().map(|case| case.name.as_str()).collect();
        assert_eq!(names, ["paper-1", "paper-2", "paper-3"]);
        let sizes: Vec<(usize, usize)> = cases
            .iter()
            .map(|case| case.scene(crate::scene::HeadJoints::Contact))
            .map(|scene| (scene.blocks().len(), scene.joints().len()))
            .collect();
        assert_eq!(sizes, [(33, 83), (55, 141), (1176, 3409)]);
        assert!(
            cases
                .iter()
                .all(|case| case.scene(case.head_joints[1]).regular().is_ok())
        );
    }

    #[test]
    fn openings_have_the_published_numbers_of_blocks_and_joints() {
        for (name, blocks, joints) in [("openings-3", 46, 102), ("openings-4", 55, 116)] {
            let scene = find(name).unwrap()[0].scene(crate::scene::HeadJoints::Contact);
            assert_eq!(
                (scene.blocks().len(), scene.joints().len()),
                (blocks, joints)
            );
        }
    }

    #[test]
    fn names_with_and_without_their_folder_mean_the_same() {
        let names = [
            "paper-1",
            "walls/paper-1",
            "cases/walls/paper-1",
            "paper-1.toml",
        ];
        for name in names {
            assert_eq!(look(name).unwrap()[0].path, "cases/walls/paper-1.toml");
        }
        let all = collect(&names.map(str::to_owned)).unwrap();
        assert_eq!(all.len(), 1);
        for name in ["", "/", ".toml", "alls/paper-1", "per-1"] {
            assert!(!stands_for(name, "cases/walls/paper-1.toml"), "{name}");
        }
    }
}
