//! Files written whole or not at all.

use std::io::{self, Write};
use std::path::Path;

/// Writes through a temporary file beside the target and renames it into place, so that a reader
/// never sees half a file and a failure leaves the old one.
///
/// # Errors
/// Any error of the file system.
pub fn write_whole(path: &Path, text: &str) -> io::Result<()> {
    let folder = match path.parent() {
        Some(parent) if !parent.as_os_str().is_empty() => parent,
        _ => Path::new("."),
    };
    std::fs::create_dir_all(folder)?;
    let mut file = tempfile::Builder::new()
        .prefix(".trilith-")
        .tempfile_in(folder)?;
    file.write_all(text.as_bytes())?;
    // A temporary file is private to its owner; a result is not.
    #[cfg(unix)]
    {
        use std::os::unix::fs::PermissionsExt;
        file.as_file()
            .set_permissions(std::fs::Permissions::from_mode(0o644))?;
    }
    file.persist(path)?;
    Ok(())
}
