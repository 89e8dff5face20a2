//! Sweeps are named by their files.

use crate::case::Complaint;

pub(super) fn stem(path: &str) -> &str {
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
    let title = if path.ends_with(".toml") {
        format!("{path}: a sweep is named by its file, and `{name}` is not a plain word")
    } else {
        format!("{path} is not a sweep: its name does not end in `.toml`")
    };
    Err(Complaint::new(title)
        .help("use letters, digits, `-`, `_` and `.`, and let the name end in `.sweep.toml`"))
}
