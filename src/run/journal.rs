//! The journal of long work: a line a finished row, so that nothing finished is ever repeated.

use std::collections::BTreeMap;
use std::fs::{File, OpenOptions, TryLockError};
use std::io::{self, Read, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};
use std::sync::Mutex;

use super::kept::{Keeps, read_line};
use super::row::Row;
use crate::case::Complaint;

/// Rows that are finished, on disk. One process at a time: the file stays locked, and the lock ends
/// with the process, however that ends.
pub struct Journal {
    path: PathBuf,
    keeps: Keeps,
    file: Mutex<File>,
    rows: BTreeMap<String, Row>,
    damaged: usize,
}

impl Journal {
    /// Opens a journal, or begins one. A last line that was being written when the program ended is
    /// dropped, as is any line whose text is not the one that was written: its row is run again.
    ///
    /// # Errors
    /// Where another process writes it, where it says two things about one row, and any error of the
    /// file system.
    pub fn open(path: &Path, keeps: Keeps) -> Result<Self, Complaint> {
        let failed = |error: io::Error| {
            Complaint::new(format!(
                "cannot use the journal {}: {error}",
                path.display()
            ))
            .help("check the folder and its permissions")
        };
        if let Some(folder) = path.parent() {
            std::fs::create_dir_all(folder).map_err(failed)?;
        }
        if path.exists() && !path.is_file() {
            return Err(failed(io::Error::other("it is no file")));
        }
        let mut options = OpenOptions::new();
        let options = options.read(true).write(true).create(true).truncate(false);
        let mut file = options.open(path).map_err(failed)?;
        match file.try_lock() {
            Ok(()) => {}
            Err(TryLockError::WouldBlock) => {
                let title = format!("another process writes {}", path.display());
                return Err(
                    Complaint::new(title).help("wait until it ends, or name another folder")
                );
            }
            Err(TryLockError::Error(error)) => return Err(failed(error)),
        }
        let mut bytes = Vec::new();
        file.read_to_end(&mut bytes).map_err(failed)?;
        let whole = bytes.iter().rposition(|&byte| byte == b'\n');
        let whole = whole.map_or(0, |newline| newline + 1);
        file.set_len(whole as u64).map_err(failed)?;
        file.seek(SeekFrom::End(0)).map_err(failed)?;
        let lines = bytes[..whole].split(|&byte| byte == b'\n');
        let lines = lines.filter(|line| !line.is_empty()).map(read_line);
        let (rows, damaged): (Vec<Option<Row>>, Vec<_>) = lines.partition(Option::is_some);
        Ok(Self {
            rows: by_id(rows.into_iter().flatten(), path)?,
            damaged: damaged.len(),
            path: path.to_owned(),
            keeps,
            file: Mutex::new(file),
        })
    }

    /// The row of a task that was finished before the journal was opened.
    pub fn get(&self, id: &str) -> Option<&Row> {
        self.rows.get(id)
    }

    /// Adds a finished row: on disk when this returns, safe from the end of the process.
    ///
    /// # Errors
    /// Any error of the file system.
    pub fn append(&self, row: &Row) -> io::Result<()> {
        let Some(line) = self.keeps.line(row)? else {
            return Ok(());
        };
        let mut file = self.file.lock().expect("no other thread panicked");
        // One write a line, without a buffer: no line is torn but by the end of the machine.
        file.write_all(line.as_bytes())
    }

    /// Removes the file: everything is handed out.
    ///
    /// # Errors
    /// Any error of the file system.
    pub fn remove(self) -> io::Result<()> {
        std::fs::remove_file(&self.path)
    }

    /// Lines that were not what had been written, and do not count.
    pub fn damaged(&self) -> usize {
        self.damaged
    }

    /// How much of a row it holds.
    pub fn keeps(&self) -> Keeps {
        self.keeps
    }

    /// The file.
    pub fn path(&self) -> &Path {
        &self.path
    }
}

/// Rows by id; a row said twice counts once.
fn by_id(rows: impl Iterator<Item = Row>, path: &Path) -> Result<BTreeMap<String, Row>, Complaint> {
    let mut known: BTreeMap<String, Row> = BTreeMap::new();
    for row in rows {
        if let Some(other) = known.get(&row.id)
            && !other.agrees(&row)
        {
            let title = format!(
                "{} says two things about the row {} ({} {})",
                path.display(),
                row.id,
                row.case,
                row.method
            );
            return Err(Complaint::new(title).help("remove the file: its rows are run again"));
        }
        known.insert(row.id.clone(), row);
    }
    Ok(known)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::case;
    use crate::method::{METHODS, Settings};
    use crate::run::answer;
    use crate::scene::HeadJoints;

    #[test]
    fn a_journal_has_one_writer_and_says_one_thing() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("deep/journal.jsonl");
        let open = || Journal::open(&path, Keeps::Numbers);
        let sides = case::find("sliding-block").unwrap()[0].sides(HeadJoints::Contact);
        let mut row = answer(&sides, METHODS[0].method, Settings::default());
        let journal = open().unwrap();
        let refused = open().err().unwrap();
        assert!(refused.title().contains("another process"), "{refused}");
        journal.append(&row).unwrap();
        journal.append(&row).unwrap();
        drop(journal);
        let journal = open().expect("the same row twice");
        row.method = "accounting".to_owned();
        journal.append(&row).unwrap();
        drop(journal);
        let refused = open().err().unwrap();
        assert!(refused.title().contains("says two things"), "{refused}");
    }
}
