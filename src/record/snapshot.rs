//! Records of a user's own walls as insta snapshots, so that `cargo insta review` works on them.

use std::io;
use std::path::{Path, PathBuf};

use insta::Snapshot;

use crate::files::{Input, read_input, write_whole};

/// Compares `record` with `NAME.snap` in a folder. Where they differ, or there is none yet, writes
/// `NAME.snap.new` for `cargo insta review` and returns it behind "new" or "changed"; where they agree,
/// removes a stale one.
///
/// # Errors
/// Errors of the file system, and a snapshot file that cannot be read as one.
pub fn compare(
    folder: &Path,
    name: &str,
    record: &str,
) -> io::Result<Option<(&'static str, PathBuf)>> {
    let accepted = folder.join(format!("{name}.snap"));
    let pending = folder.join(format!("{name}.snap.new"));
    let known = accepted.exists();
    if known {
        let failed = |error: io::Error| {
            let text = format!("cannot read {}: {error}", accepted.display());
            io::Error::new(error.kind(), text)
        };
        // The reader of snapshots opens whatever it is given, of any size.
        read_input(&accepted, Input::Record).map_err(failed)?;
        let snapshot = Snapshot::from_file(&accepted).map_err(|e| {
            let text = format!("{} is not a snapshot: {e}", accepted.display());
            io::Error::new(io::ErrorKind::InvalidData, text)
        })?;
        let contents = snapshot.contents().as_text();
        if contents.is_some_and(|text| text.to_string().trim_end() == record.trim_end()) {
            if pending.exists() {
                std::fs::remove_file(&pending)?;
            }
            return Ok(None);
        }
    }
    let source = serde_json::Value::from(format!("trilith: {name}"));
    write_whole(&pending, format!("---\nsource: {source}\n---\n{record}"))?;
    let word = if known { "changed" } else { "new" };
    Ok(Some((word, pending)))
}

/// The snapshots in a folder, accepted and new ones, whose case is none of these: by the names of
/// their cases, sorted.
///
/// # Errors
/// Where the folder cannot be read.
pub fn records_beside(folder: &Path, cases: &[&str]) -> io::Result<Vec<(String, PathBuf)>> {
    let mut others = Vec::new();
    for entry in std::fs::read_dir(folder)? {
        let path = entry?.path();
        let name = path.file_name().and_then(|name| name.to_str());
        let name = name.map(|name| name.strip_suffix(".new").unwrap_or(name));
        let Some(case) = name.and_then(|name| name.strip_suffix(".snap")) else {
            continue;
        };
        if !cases.contains(&case) {
            others.push((case.to_owned(), path));
        }
    }
    others.sort();
    Ok(others)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_record_is_new_then_same_then_changed() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path();
        let pending = path.join("wall.snap.new");
        let text = "wall: mine\n\n  a line\n";
        let new = compare(path, "wall", text).unwrap();
        assert_eq!(new, Some(("new", pending.clone())));
        // What `cargo insta accept` does.
        std::fs::rename(&pending, path.join("wall.snap")).unwrap();
        assert_eq!(compare(path, "wall", text).unwrap(), None);
        let changed = compare(path, "wall", "wall: mine\n\n  another line\n").unwrap();
        assert_eq!(changed, Some(("changed", pending.clone())));
        assert_eq!(compare(path, "wall", text).unwrap(), None);
        assert!(!pending.exists());
        let others = |cases: &[&str]| records_beside(path, cases).unwrap();
        assert_eq!(others(&["wall"]), []);
        assert_eq!(others(&["tower"])[0].0, "wall");
    }
}
