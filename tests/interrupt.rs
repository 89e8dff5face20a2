//! Ctrl-C leaves finished results behind and says so.
#![cfg(unix)]

use std::fs;
use std::process::{Command, Stdio};
use std::thread::sleep;
use std::time::Duration;

#[test]
fn finished_cases_outlive_an_interruption() {
    let folder = tempfile::tempdir().unwrap();
    // A block is done at once; the pushover of 1176 blocks takes far longer than the test waits.
    let child = Command::new(env!("CARGO_BIN_EXE_trilith"))
        .current_dir(folder.path())
        .args(["run", "sliding-block", "paper-3", "--out", "found"])
        .args([
            "--method",
            "associative",
            "pushover",
            "--head-joints",
            "open",
        ])
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .expect("the program starts");
    sleep(Duration::from_secs(4));
    let process = child.id().to_string();
    let sent = Command::new("kill").args(["-INT", &process]).status();
    assert!(sent.expect("there is a kill").success());
    let output = child.wait_with_output().unwrap();
    let said = String::from_utf8(output.stderr).unwrap();
    assert_eq!(output.status.code(), Some(130), "{said}");
    assert_eq!(
        said.trim(),
        "interrupted: printed and written to found: sliding-block; missing: paper-3"
    );
    assert!(
        String::from_utf8(output.stdout)
            .unwrap()
            .contains("sliding-block")
    );
    let csv = fs::read_to_string(folder.path().join("found/results.csv")).unwrap();
    assert_eq!(csv.lines().count(), 3, "{csv}");
    assert!(
        csv.lines()
            .skip(1)
            .all(|line| line.starts_with("sliding-block"))
    );
}

#[test]
fn finished_rows_of_a_chart_outlive_an_interruption() {
    let folder = tempfile::tempdir().unwrap();
    let child = Command::new(env!("CARGO_BIN_EXE_trilith"))
        .current_dir(folder.path())
        .args(["chart", "paper-1", "paper-3", "--out", "found"])
        .stdout(Stdio::null())
        .stderr(Stdio::piped())
        .spawn()
        .expect("the program starts");
    sleep(Duration::from_secs(4));
    let process = child.id().to_string();
    let sent = Command::new("kill").args(["-INT", &process]).status();
    assert!(sent.expect("there is a kill").success());
    let output = child.wait_with_output().unwrap();
    let said = String::from_utf8(output.stderr).unwrap();
    assert_eq!(output.status.code(), Some(130), "{said}");
    assert!(said.contains("finished rows written to"), "{said}");
    let csv = fs::read_to_string(folder.path().join("found/finished.csv")).unwrap();
    assert!(csv.starts_with("case,method,status,lower,upper"), "{csv}");
    assert!(!folder.path().join("found/chart.csv").exists());
}
