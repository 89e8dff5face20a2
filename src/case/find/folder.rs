//! Files and folders of cases.

use std::collections::HashSet;
use std::fs;
use std::path::Path;

use super::unread::UnreadCase;
use crate::case::complaint::Complaint;

/// A sweep is a `.toml` file too, and no case.
pub(super) fn is_case(path: &Path) -> bool {
    let is = |name: &str| name.ends_with(".toml") && !is_sweep(name);
    path.file_name()
        .is_some_and(|name| is(&name.to_string_lossy()))
}

pub(super) fn is_sweep(name: &str) -> bool {
    name.ends_with(".sweep.toml")
}

/// Every case below a folder, sorted by path.
pub(super) fn cases_below(top: &Path) -> Result<Vec<UnreadCase>, Complaint> {
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
    paths.iter().map(|path| UnreadCase::in_file(path)).collect()
}
