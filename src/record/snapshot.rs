//! Records of a user's own walls as insta snapshots, so that `cargo insta review` works on them.

use std::io;
use std::path::{Path, PathBuf};

use insta::Snapshot;
use similar::TextDiff;

use crate::files::{Input, read_input, write_whole};

/// How a record differs from the accepted one.
#[derive(Clone, Debug, PartialEq)]
pub struct Difference {
    /// "new" or "changed".
    pub word: &'static str,
    /// The file that was written.
    pub path: PathBuf,
    /// Lines of the accepted record behind `-`, and of this one behind `+`; empty where it is new.
    pub lines: String,
}

/// Compares `record` with `NAME.snap` in a folder. Where they differ, or there is none yet, writes
/// `NAME.snap.new` for `cargo insta review`, or NAME.snap itself where it is to `accept` what is there;
/// where they agree, removes a stale one.
///
/// # Errors
/// Errors of the file system, and a snapshot file that cannot be read as one.
pub fn compare(
    folder: &Path,
    name: &str,
    record: &str,
    accept: bool,
) -> io::Result<Option<Difference>> {
    let accepted = folder.join(format!("{name}.snap"));
    let pending = folder.join(format!("{name}.snap.new"));
    let mut lines = String::new();
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
        let contents = contents.map_or(String::new(), |text| text.to_string());
        if contents.trim_end() == record.trim_end() {
            remove(&pending)?;
            return Ok(None);
        }
        let [old, new] = [&contents, record].map(|text| format!("{}\n", text.trim_end()));
        let compared = TextDiff::from_lines(&old, &new);
        lines = compared.unified_diff().context_radius(0).to_string();
    }
    let source = serde_json::Value::from(format!("trilith: {name}"));
    let path = if accept { accepted } else { pending.clone() };
    write_whole(&path, format!("---\nsource: {source}\n---\n{record}"))?;
    if accept {
        remove(&pending)?;
    }
    let word = if known { "changed" } else { "new" };
    Ok(Some(Difference { word, path, lines }))
}

/// Removes a file that may be there.
fn remove(path: &Path) -> io::Result<()> {
    match std::fs::remove_file(path) {
        Err(error) if error.kind() != io::ErrorKind::NotFound => Err(error),
        _ => Ok(()),
    }
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
        let compare = |text: &str, accept| compare(path, "wall", text, accept).unwrap();
        let new = compare(text, false).expect("there was none");
        assert_eq!((new.word, new.path), ("new", pending.clone()));
        // What `cargo insta accept` does.
        std::fs::rename(&pending, path.join("wall.snap")).unwrap();
        assert_eq!(compare(text, false), None);
        let another = "wall: mine\n\n  another line\n";
        let changed = compare(another, false).expect("it differs");
        assert_eq!((changed.word, changed.path), ("changed", pending.clone()));
        assert_eq!(changed.lines, "@@ -3 +3 @@\n-  a line\n+  another line\n");
        assert_eq!(compare(text, false), None);
        assert!(!pending.exists());
        compare(another, false).expect("it differs");
        let taken = compare(another, true).expect("it differs");
        assert!(taken.path.ends_with("wall.snap") && !pending.exists());
        assert_eq!(compare(another, false), None);
        let others = |cases: &[&str]| records_beside(path, cases).unwrap();
        assert_eq!(others(&["wall"]), []);
        assert_eq!(others(&["tower"])[0].0, "wall");
    }
}
