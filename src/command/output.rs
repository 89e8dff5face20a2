//! Where results go: tried before the work begins, written whole, kept in a journal meanwhile.

use std::path::{Path, PathBuf};

use crate::answer::{Evidence, Standing};
use crate::files::{test_folder, write_together, write_whole};
use crate::method::{Kind, kind};
use crate::run::{CaseResult, Journal, Keeps, Partial, Task, certificates};

use super::screen::tell;
use super::stop::Stop;

/// Tells before the work whether files can be written into a folder.
pub(super) fn test(folder: &Path) -> Result<(), Stop> {
    test_folder(folder).map_err(|error| {
        Stop::bad_input(format!(
            "error: cannot write into {}: {error}\nhelp: name a folder that can be written to, with \
             room in it; nothing was computed",
            folder.display()
        ))
    })
}

/// Writes files of these names into a folder, or none of them.
pub(super) fn write(folder: &Path, files: Vec<(String, String)>) -> Result<(), Stop> {
    let files: Vec<_> = files
        .into_iter()
        .map(|(name, text)| (folder.join(name), text))
        .collect();
    write_files(&files)
}

/// Writes files that belong together, or none of them.
pub(super) fn write_files(files: &[(PathBuf, String)]) -> Result<(), Stop> {
    write_together(files).map_err(|(path, error)| Stop::not_written(path.display(), error))
}

/// What is said of a study that ended early, where it did.
pub(super) fn partial(why: Option<&str>, finished: usize, of: usize) -> Option<Partial> {
    why.map(|why| Partial {
        why: why.to_owned(),
        finished,
        of,
    })
}

/// The line above what is printed of results that are not all there.
pub(super) fn said(partial: Option<&Partial>) -> String {
    partial.map_or(String::new(), |partial| format!("{partial}\n"))
}

/// Writes the certificates of results into a folder, each whole. Those of rows that a journal kept are
/// not there any more: standard error names them.
pub(super) fn write_certificates(folder: &Path, results: &[CaseResult]) -> Result<(), Stop> {
    for result in results {
        for (name, bytes) in certificates(result) {
            write_certificate(folder, &name, bytes)?;
        }
        for row in &result.rows {
            let has_bound = kind(&row.method) == Kind::LowerBound
                && row.bracket().is_some_and(|bracket| bracket.lower > 0.0);
            let evidence = &row.outcome.evidence;
            let is_certified = matches!(
                evidence,
                Evidence::Stands {
                    standing: Standing::Certified { .. },
                    ..
                }
            );
            if (has_bound || is_certified) && evidence.certificate().is_none() {
                tell!(
                    "there is no certificate for {}: its bound is an estimate, or a journal kept the answer \
                     without the certificate",
                    row.scene_name()
                );
            }
        }
    }
    Ok(())
}

/// Writes a certificate into a folder, whole, and returns its path.
pub(super) fn write_certificate(
    folder: &Path,
    name: &str,
    bytes: Vec<u8>,
) -> Result<PathBuf, Stop> {
    let path = folder.join(name);
    write_whole(&path, bytes).map_err(|error| Stop::not_written(path.display(), error))?;
    Ok(path)
}

/// Opens the journal of this name in a folder that can be written to, and says where it is damaged.
pub(super) fn journal(folder: &Path, name: &str, keeps: Keeps) -> Result<Journal, Stop> {
    test(folder)?;
    let journal = Journal::open(&folder.join(name), keeps)?;
    if journal.damaged() > 0 {
        tell!(
            "{} holds damaged lines: {}; what they held is computed again",
            journal.path().display(),
            journal.damaged()
        );
    }
    Ok(journal)
}

/// Says how many of the tasks the journal knows.
pub(super) fn tell_known(journal: &Journal, tasks: &[Task]) {
    let known = tasks.iter().filter(|task| journal.get(task.id()).is_some());
    let known = known.count();
    if known > 0 {
        tell!("{known} of {} results are finished already", tasks.len());
    }
}

/// Removes a journal of which everything is handed out.
pub(super) fn finish(journal: Journal) {
    let path = journal.path().to_owned();
    // The results are there; a journal that stays costs room and nothing else.
    if let Err(error) = journal.remove() {
        tell!("warning: cannot remove {}: {error}", path.display());
    }
}
