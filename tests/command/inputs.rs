//! Files that are too large to be read, and what is no file: refused at once, with the size and the
//! limit, before memory is spent.
#![cfg(unix)]

use std::fs::{self, File};
use std::path::Path;
use std::process::{Command, Output};

/// Runs the program with 1 GB of addresses, which no file of this test would fit into.
fn trilith(folder: &Path, arguments: &str) -> Output {
    let program = env!("CARGO_BIN_EXE_trilith");
    let script = format!("ulimit -v 1000000; exec {program} {arguments}");
    let mut shell = Command::new("sh");
    // Each thread has addresses of its own.
    let shell = shell.env("RAYON_NUM_THREADS", "1").current_dir(folder);
    shell
        .args(["-c", &script])
        .output()
        .expect("there is a shell")
}

#[track_caller]
fn assert_refused(folder: &Path, arguments: &str, why: &str) {
    let output = trilith(folder, arguments);
    let said = String::from_utf8(output.stderr).unwrap();
    assert_eq!(output.status.code(), Some(2), "{arguments}: {said}");
    assert!(said.starts_with("error: "), "{arguments}: {said}");
    assert!(said.contains(why), "{arguments}: {said}");
    assert!(output.stdout.is_empty(), "{arguments}");
}

/// Refusals of files so named where cases, sweeps and programs are read (`toml`), and of `corners.csv`
/// where corners and points are (`csv`).
#[track_caller]
fn assert_readers_refuse(folder: &Path, name: &str, toml: &str, csv: &str) {
    assert_refused(folder, &format!("run {name}.toml"), toml);
    assert_refused(folder, &format!("sweep {name}.sweep.toml"), toml);
    assert_refused(folder, &format!("run stack --external {name}.toml"), toml);
    assert_refused(folder, "run beside.toml", csv);
    assert_refused(folder, "report stack --sweep corners.csv --out out", csv);
}

/// Sparse: it takes no room on the disk.
fn large(path: &Path, bytes: u64) {
    File::create(path).unwrap().set_len(bytes).unwrap();
}

const BESIDE: &str = "friction = 0.5\n[blocks]\ncsv = \"corners.csv\"\nsupports = [\"ground\"]\n";

#[test]
fn files_beyond_the_limits_are_refused() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    large(&folder.join("large.toml"), 500_000_000);
    large(&folder.join("large.sweep.toml"), 500_000_000);
    large(&folder.join("corners.csv"), 1_500_000_000);
    fs::write(folder.join("beside.toml"), BESIDE).unwrap();
    let toml = "it has 477 MiB, and no more than 16 MiB are read";
    let csv = "it has 1431 MiB, and no more than 64 MiB are read";
    assert_refused(folder, "check large.toml", toml);
    assert_refused(folder, "show large.toml", toml);
    assert_readers_refuse(folder, "large", toml, csv);
    fs::create_dir(folder.join("records")).unwrap();
    large(&folder.join("records/stack.snap"), 500_000_000);
    let output = trilith(folder, "run stack --method associative --record records");
    let said = String::from_utf8(output.stderr).unwrap();
    assert!(said.contains("stack.snap") && said.contains(toml), "{said}");
    assert_eq!(output.status.code(), Some(2));
}

#[test]
fn what_is_no_file_is_refused_and_does_not_hang() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    fs::write(folder.join("beside.toml"), BESIDE).unwrap();
    for name in ["pipe.toml", "pipe.sweep.toml", "corners.csv"] {
        let made = Command::new("mkfifo").arg(folder.join(name)).status();
        assert!(made.expect("there is a mkfifo").success());
    }
    let pipe = "it is a pipe, not a file";
    assert_readers_refuse(folder, "pipe", pipe, pipe);
    // In a folder of cases too.
    assert_refused(folder, "run .", pipe);
    std::os::unix::fs::symlink("/dev/zero", folder.join("zero.toml")).unwrap();
    assert_refused(folder, "run zero.toml", "it is a device, not a file");
    fs::create_dir(folder.join("folder.toml")).unwrap();
    assert_refused(
        folder,
        "run stack --external folder.toml",
        "it is a folder, not a file",
    );
    assert_refused(folder, "run folder.toml", "there is no case in the folder");
    // A pipe in the place of a journal.
    fs::create_dir(folder.join("out")).unwrap();
    let journal = folder.join("out/run.journal");
    let made = Command::new("mkfifo").arg(journal).status();
    assert!(made.expect("there is a mkfifo").success());
    assert_refused(
        folder,
        "run stack --method associative --out out",
        "it is no file",
    );
}
