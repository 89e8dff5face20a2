//! The name of a case: that of its file.

use std::path::Path;

use super::complaint::Complaint;

/// What a case that comes from standard input is called in complaints.
pub(super) const STDIN: &str = "<stdin>";

/// The file's stem. It goes into tables, file names and `NAME@open`, so it is held to plain words.
pub(super) fn case_name(path: &str) -> Result<String, Complaint> {
    if path == STDIN {
        return Ok("stdin".to_owned());
    }
    let stem = Path::new(path).file_stem().unwrap_or_default();
    let stem = stem.to_string_lossy();
    let renamed = plain(&stem);
    if !stem.is_empty() && stem == renamed {
        return Ok(renamed);
    }
    let title = format!("{path}: a case is named by its file, and `{stem}` is not a plain word");
    Err(Complaint::new(title).help(format!(
        "use letters, digits, `-`, `_` and `.`: rename the file to `{renamed}.toml`"
    )))
}

/// A word with a `-` for every letter that has no place in a name.
pub(crate) fn plain(word: &str) -> String {
    let plain = |c: char| match c {
        c if c.is_alphanumeric() || "-_.".contains(c) => c,
        _ => '-',
    };
    word.chars().map(plain).collect()
}
