//! A case that was found and not yet read.

use std::path::{Path, PathBuf};
use std::sync::OnceLock;

use super::embedded::embedded_file;
use crate::case::complaint::Complaint;
use crate::case::model::Case;
use crate::case::name::STDIN;
use crate::files::{Input, read_input, read_stdin};

/// The text of a case, and where it comes from.
#[derive(Clone, Debug)]
pub(crate) struct UnreadCase {
    /// As the user would write it.
    pub path: String,
    /// The file itself, which tells one from another; `None` for an embedded case.
    pub file: Option<PathBuf>,
    pub bytes: Vec<u8>,
}

impl UnreadCase {
    pub fn embedded((path, text): (&str, &str)) -> Self {
        Self {
            path: path.to_owned(),
            file: None,
            bytes: text.as_bytes().to_vec(),
        }
    }

    /// The case in a file.
    ///
    /// # Errors
    /// Where the file cannot be read.
    pub fn in_file(path: &Path) -> Result<Self, Complaint> {
        let shown = path.display().to_string();
        let failed = |error: std::io::Error| {
            Complaint::new(format!("cannot read {shown}: {error}"))
                .help("check the path and its permissions")
        };
        let bytes = read_input(path, Input::Toml).map_err(failed)?;
        let file = Some(path.canonicalize().map_err(failed)?);
        Ok(Self {
            path: shown,
            file,
            bytes,
        })
    }

    /// The case that standard input holds, which is read once however often it is asked for. Files that
    /// it names lie in the folder that the program works in.
    ///
    /// # Errors
    /// Where it cannot be read.
    pub fn in_stdin() -> Result<Self, Complaint> {
        static BYTES: OnceLock<Result<Vec<u8>, String>> = OnceLock::new();
        let read = || read_stdin(Input::Toml).map_err(|error| error.to_string());
        let bytes = BYTES.get_or_init(read).clone().map_err(|why| {
            Complaint::new(format!("cannot read {STDIN}: {why}"))
                .help("write the text of a case into it, as in `trilith run - < wall.toml`")
        })?;
        Ok(Self {
            path: STDIN.to_owned(),
            file: Some(PathBuf::from(STDIN)),
            bytes,
        })
    }

    /// Reads the case.
    ///
    /// # Errors
    /// As [`Case::read_with`].
    pub fn read(&self) -> Result<Case, Complaint> {
        self.read_closing(None)
    }

    /// Reads the case, with gaps between its blocks closed up to this width.
    ///
    /// # Errors
    /// As [`Case::read_with`].
    pub fn read_closing(&self, gap: Option<f64>) -> Result<Case, Complaint> {
        Case::read_closing(&self.path, &self.bytes, &|name| self.read_file(name), gap)
    }

    /// Bytes of the file of this name beside the case; in words why there are none.
    pub fn read_file(&self, name: &str) -> Result<Vec<u8>, String> {
        match &self.file {
            // Beside the file itself, also where a link leads to it.
            Some(file) => {
                let path = file.with_file_name(name);
                read_input(&path, Input::Table).map_err(|error| error.to_string())
            }
            None => embedded_file(&self.path, name),
        }
    }

    /// Whether both are the same file; or an embedded case and the very file that it was embedded
    /// from.
    pub fn is_same(&self, other: &UnreadCase) -> bool {
        match (&self.file, &other.file) {
            (Some(a), Some(b)) => a == b,
            (None, None) => self.path == other.path,
            _ => {
                Path::new(&self.path).file_name() == Path::new(&other.path).file_name()
                    && self.bytes == other.bytes
            }
        }
    }
}
