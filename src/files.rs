//! Files written whole or not at all, and read only where they are files of a size that can be.

use std::fs::{self, File};
use std::io::{self, Read, Write};
use std::path::{Path, PathBuf};

use tempfile::NamedTempFile;

/// Writes through a temporary file beside the target and renames it into place, so that a reader
/// never sees half a file and a failure leaves the old one.
///
/// # Errors
/// Any error of the file system.
pub fn write_whole(path: &Path, contents: impl AsRef<[u8]>) -> io::Result<()> {
    staged(path, contents.as_ref())?.persist(path)?;
    Ok(())
}

/// As [`write_whole`], for files that belong together: none is replaced before there is room for all
/// of them.
///
/// # Errors
/// The file that cannot be written, and why.
pub fn write_together(files: &[(PathBuf, String)]) -> Result<(), (PathBuf, io::Error)> {
    let mut temporary = Vec::new();
    for (path, text) in files {
        temporary.push(staged(path, text.as_bytes()).map_err(|error| (path.clone(), error))?);
    }
    if let Some((path, _)) = files.iter().find(|(path, _)| path.is_dir()) {
        return Err((path.clone(), io::Error::other("a folder has its name")));
    }
    for ((path, _), file) in files.iter().zip(temporary) {
        file.persist(path)
            .map_err(|error| (path.clone(), error.error))?;
    }
    Ok(())
}

/// Makes a folder where there is none, and tells whether files can be written into it.
///
/// # Errors
/// Why they cannot: a file in its place, no permission, no room.
pub fn test_folder(folder: &Path) -> io::Result<()> {
    if folder.exists() && !folder.is_dir() {
        return Err(io::Error::other("it is a file, not a folder"));
    }
    staged(&folder.join("results"), &[b' '; 1 << 12]).map(drop)
}

/// Contents in a temporary file beside its target, which goes where nobody persists it.
fn staged(path: &Path, contents: &[u8]) -> io::Result<NamedTempFile> {
    let folder = match path.parent() {
        Some(parent) if !parent.as_os_str().is_empty() => parent,
        _ => Path::new("."),
    };
    fs::create_dir_all(folder)?;
    let mut file = tempfile::Builder::new()
        .prefix(".trilith-")
        .tempfile_in(folder)?;
    file.write_all(contents)?;
    // A temporary file is private to its owner; a result is not.
    #[cfg(unix)]
    {
        use std::os::unix::fs::PermissionsExt;
        file.as_file()
            .set_permissions(fs::Permissions::from_mode(0o644))?;
    }
    Ok(file)
}

/// What kind of file is read, and with that how large it may be: reading takes up to thirty times
/// the file's size in memory.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Input {
    /// A case, a sweep, a list of programs: what a person writes.
    Toml,
    /// Corners of blocks, points of a sweep.
    Table,
    /// An accepted record.
    Record,
    /// Rows of a shard, which this program wrote.
    Rows,
    /// A certificate of a lower bound, which this program wrote.
    Certificate,
}

impl Input {
    /// Most bytes.
    pub fn limit(self) -> u64 {
        match self {
            Input::Toml | Input::Record => 16 << 20,
            Input::Table | Input::Certificate => 64 << 20,
            Input::Rows => 1 << 30,
        }
    }
}

/// The bytes of a file. What is no file (a folder, a fifo, a device) is not opened, and nothing of a
/// file beyond the limit is read.
///
/// # Errors
/// What is wrong, in words that may follow `cannot read PATH:`.
pub fn read_input(path: &Path, input: Input) -> io::Result<Vec<u8>> {
    let about = fs::metadata(path)?;
    if !about.is_file() {
        return Err(io::Error::other(format!(
            "it is {}, not a file",
            kind(&about)
        )));
    }
    if about.len() > input.limit() {
        return Err(too_large(about.len(), input));
    }
    read_at_most(File::open(path)?, input)
}

/// The bytes of standard input, of which nothing beyond the limit is read.
///
/// # Errors
/// As [`read_input`].
pub fn read_stdin(input: Input) -> io::Result<Vec<u8>> {
    read_at_most(io::stdin().lock(), input)
}

/// All bytes of what may grow while it is read, or does not know its size.
fn read_at_most(source: impl Read, input: Input) -> io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    source.take(input.limit() + 1).read_to_end(&mut bytes)?;
    match bytes.len() as u64 {
        length if length > input.limit() => Err(too_large(length, input)),
        _ => Ok(bytes),
    }
}

fn too_large(bytes: u64, input: Input) -> io::Error {
    let (size, most) = (bytes.div_ceil(1 << 20), input.limit() >> 20);
    let words = format!("it has {size} MiB, and no more than {most} MiB are read");
    io::Error::new(io::ErrorKind::FileTooLarge, words)
}

/// What something is that is no file.
fn kind(about: &fs::Metadata) -> &'static str {
    if about.is_dir() {
        return "a folder";
    }
    #[cfg(unix)]
    {
        use std::os::unix::fs::FileTypeExt;
        let kind = about.file_type();
        if kind.is_fifo() {
            return "a pipe";
        }
        if kind.is_socket() {
            return "a socket";
        }
    }
    "a device"
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn files_that_belong_together_come_together() {
        let folder = tempfile::tempdir().unwrap();
        let path = |name: &str| folder.path().join(name);
        fs::create_dir(path("b")).unwrap();
        let files = ["a", "b/c"].map(|name| (path(name), "text".to_owned()));
        write_together(&files).unwrap();
        assert_eq!(fs::read_to_string(path("a")).unwrap(), "text");
        // A file in the place of the second one's folder: the first stays as it was.
        let files = [path("a"), path("a/c")].map(|path| (path, "new".to_owned()));
        let (refused, _) = write_together(&files).unwrap_err();
        assert_eq!(refused, path("a/c"));
        assert_eq!(fs::read_to_string(path("a")).unwrap(), "text");
        // A folder in the place of the second file: the same.
        let files = [path("a"), path("b")].map(|path| (path, "new".to_owned()));
        let (refused, _) = write_together(&files).unwrap_err();
        assert_eq!(refused, path("b"));
        assert_eq!(fs::read_to_string(path("a")).unwrap(), "text");
        assert!(test_folder(&path("a")).is_err() && test_folder(&path("d/e")).is_ok());
        let left: Vec<_> = fs::read_dir(folder.path()).unwrap().flatten().collect();
        assert_eq!(left.len(), 3, "{left:?}");
    }
}
