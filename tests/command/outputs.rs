//! Folders that cannot be written to: a message, exit status 2, nothing half-written, and what was
//! computed is printed.
#![cfg(unix)]

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use crate::skipped::skipped;

/// Every command that writes, into `out` of the folder that it runs in; what it is quick with.
const WRITES: [&[&str]; 11] = [
    &["run", "stack", "--method", "associative", "--out", "out"],
    &["run", "stack", "--method", "associative", "--resume", "out"],
    &["run", "stack", "--method", "associative", "--record", "out"],
    &["check", "stack", "--method", "associative", "--out", "out"],
    &["report", "stack", "--method", "associative", "--out", "out"],
    &["chart", "stack", "--out", "out"],
    &["atlas", "--out", "out"],
    &["sweep", "small.sweep.toml", "--out", "out"],
    &[
        "sweep",
        "small.sweep.toml",
        "--out",
        "out",
        "--shard",
        "1/2",
    ],
    &[
        "draw",
        "stack",
        "--method",
        "associative",
        "-o",
        "out/stack.svg",
    ],
    &["new", "out/wall"],
];

const SWEEP: &str = "title = \"small\"\nmethods = [\"associative\"]\ncase = \"stack\"\n[[vary]]\nfriction = [0.4, 0.5]\n";

fn trilith(folder: &Path, arguments: &[&str]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_trilith"));
    let command = command.current_dir(folder).args(arguments);
    command.output().expect("the program starts")
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8(bytes.to_vec()).expect("output is UTF-8")
}

/// A folder to run in, and what lies in its `out`.
struct Place {
    folder: tempfile::TempDir,
    mounted: bool,
}

impl Place {
    fn new() -> Self {
        let folder = tempfile::tempdir().unwrap();
        fs::write(folder.path().join("small.sweep.toml"), SWEEP).unwrap();
        let mounted = false;
        Self { folder, mounted }
    }

    /// With a file system of 1 MB as `out`, where root can mount one; says so where not.
    fn mounted() -> Option<Self> {
        let mut place = Self::new();
        fs::create_dir(place.out()).unwrap();
        place.mounted = mount(&["-t", "tmpfs", "-o", "size=1m", "tmpfs"], &place.out());
        if !place.mounted {
            skipped("a file system of 1 MB cannot be mounted here; root can");
        }
        place.mounted.then_some(place)
    }

    fn out(&self) -> PathBuf {
        self.folder.path().join("out")
    }

    /// Leaves so many bytes of the file system.
    fn fill_but(&self, room: usize) {
        let filler = self.out().join("filler");
        // Pages of 4096 bytes; the rest is refused.
        let _ = fs::write(&filler, vec![b'x'; 1 << 20]);
        let length = fs::metadata(&filler).unwrap().len();
        let file = fs::File::options().write(true).open(&filler).unwrap();
        file.set_len(length.saturating_sub(room as u64)).unwrap();
    }

    /// Names and sizes of what lies in `out`; the file itself where it is one.
    fn contents(&self) -> BTreeMap<String, u64> {
        let mut contents = BTreeMap::new();
        let mut folders = vec![self.out()];
        while let Some(folder) = folders.pop() {
            let Ok(entries) = fs::read_dir(&folder) else {
                let length = fs::metadata(&folder).unwrap().len();
                contents.insert("out".to_owned(), length);
                continue;
            };
            for entry in entries.map(Result::unwrap) {
                let about = entry.metadata().unwrap();
                if about.is_dir() {
                    folders.push(entry.path());
                } else {
                    contents.insert(entry.path().display().to_string(), about.len());
                }
            }
        }
        contents
    }

    /// Refused before the work, with the name of the folder, and nothing left.
    fn assert_refused(&self, arguments: &[&str], why: &str) {
        let before = self.contents();
        let output = trilith(self.folder.path(), arguments);
        let said = text(&output.stderr);
        assert_eq!(output.status.code(), Some(2), "{arguments:?}: {said}");
        assert!(
            said.starts_with("error: cannot write"),
            "{arguments:?}: {said}"
        );
        assert!(
            said.contains("out") && said.contains(why),
            "{arguments:?}: {said}"
        );
        assert_eq!(text(&output.stdout), "", "{arguments:?}");
        assert_eq!(self.contents(), before, "{arguments:?}");
    }
}

impl Drop for Place {
    fn drop(&mut self) {
        if self.mounted {
            let _ = Command::new("umount").arg(self.out()).status();
        }
    }
}

fn mount(options: &[&str], on: &Path) -> bool {
    let mut mount = Command::new("mount");
    let output = mount.args(options).arg(on).output();
    output.is_ok_and(|output| output.status.success())
}

#[test]
fn a_file_in_the_folders_place_is_refused() {
    for arguments in WRITES {
        let place = Place::new();
        fs::write(place.out(), "mine").unwrap();
        let why = if arguments[0] == "new" {
            ""
        } else {
            "it is a file, not a folder"
        };
        place.assert_refused(arguments, why);
    }
}

/// Root may write where permissions forbid it, but not to a file system that is read-only.
#[test]
fn a_read_only_folder_is_refused() {
    for arguments in WRITES {
        let Some(place) = Place::mounted() else {
            return;
        };
        assert!(mount(&["-o", "remount,ro"], &place.out()));
        place.assert_refused(arguments, "Read-only file system");
    }
    // A merge reads the folder before it writes into it.
    let Some(place) = Place::mounted() else {
        return;
    };
    let sweep = ["small.sweep.toml", "--out", "out"];
    let whole = [&["sweep"], &sweep[..], &["--shard", "1/1"]].concat();
    assert!(trilith(place.folder.path(), &whole).status.success());
    assert!(mount(&["-o", "remount,ro"], &place.out()));
    place.assert_refused(&[&["merge"], &sweep[..]].concat(), "Read-only file system");
}

#[test]
fn a_full_disk_is_refused() {
    for arguments in WRITES {
        let Some(place) = Place::mounted() else {
            return;
        };
        place.fill_but(0);
        place.assert_refused(arguments, "No space left");
    }
}

/// Room for the trial and for little else: the disk is full only after the work. What was computed is
/// printed, and of the results no file is there, as they belong together.
#[test]
fn a_disk_that_fills_up_costs_files_and_no_results() {
    for (arguments, printed) in [
        (
            &[
                "run",
                "paper-1",
                "--method",
                "associative",
                "--out",
                "out",
                "--states",
                "--format",
                "json",
            ][..],
            "\"case\"",
        ),
        (
            &[
                "run", "paper-1", "--method", "interval", "--out", "out", "--states",
            ],
            "0.63898",
        ),
        (
            &[
                "check", "paper-1", "--method", "interval", "--out", "out", "--states",
            ],
            "0.63898",
        ),
        (
            &[
                "report",
                "paper-1",
                "--method",
                "associative",
                "--out",
                "out",
            ],
            "",
        ),
        (&["chart", "stack", "--out", "out"], "interval"),
        (&["atlas", "--out", "out"], "cells"),
        (&["sweep", "small.sweep.toml", "--out", "out"], "lowest λ"),
    ] {
        let Some(place) = Place::mounted() else {
            return;
        };
        // The journal of a sweep of two points is shorter than a page.
        let room = if arguments[0] == "sweep" {
            8 << 10
        } else {
            24 << 10
        };
        place.fill_but(room);
        let output = trilith(place.folder.path(), arguments);
        let said = text(&output.stderr);
        assert_eq!(output.status.code(), Some(2), "{arguments:?}: {said}");
        assert!(said.contains("No space left"), "{arguments:?}: {said}");
        let out = text(&output.stdout);
        assert!(out.contains(printed), "{arguments:?}: {out}\n{said}");
        let left: Vec<String> = place.contents().into_keys().collect();
        let ours = |path: &&String| !path.ends_with("filler");
        let left: Vec<&String> = left.iter().filter(ours).collect();
        assert!(
            left.iter().all(|path| path.ends_with(".journal")),
            "{arguments:?}: {left:?}"
        );
    }
}

/// Standard output on a full disk: a message, and the files are written all the same.
#[test]
fn a_full_standard_output_costs_no_files() {
    let place = Place::new();
    let full = fs::File::options().write(true).open("/dev/full");
    let Ok(full) = full else {
        skipped("there is no /dev/full here");
        return;
    };
    let mut command = Command::new(env!("CARGO_BIN_EXE_trilith"));
    let command = command.current_dir(place.folder.path()).args(WRITES[0]);
    let output = command.stdout(full).output().unwrap();
    let said = text(&output.stderr);
    assert_eq!(output.status.code(), Some(2), "{said}");
    assert!(
        said.contains("cannot write results: No space left"),
        "{said}"
    );
    assert!(place.out().join("results.csv").exists());
}
