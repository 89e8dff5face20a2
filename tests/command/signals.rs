//! Signals lose nothing: whatever comes whenever, every finished row is printed and written, files
//! say inside that they are partial, and the same command goes on from there.
#![cfg(unix)]

use crate::long;
use crate::share::share;

use std::fs;
use std::io::{BufRead, BufReader, Read};
use std::process::{Command, Stdio};

use crate::long::{Long, TIMELESS};

/// Each command, small, ended by each signal once a row is finished.
#[test]
fn a_signal_leaves_what_is_finished_marked_as_partial() {
    for signals in [
        &["INT"][..],
        &["TERM", "TERM"],
        &["HUP"],
        &["TERM", "INT", "HUP"],
    ] {
        for command in long::small() {
            let folder = tempfile::tempdir().unwrap();
            let ended = command.ended(folder.path(), 1, 0, signals);
            ended.assert_sound(&command, folder.path(), signals);
        }
    }
}

/// Interrupted once, killed once, then let go on: the same files as in one go, apart from times.
#[test]
fn what_is_started_again_ends_as_if_never_interrupted() {
    for command in long::small() {
        let folder = tempfile::tempdir().unwrap();
        command.ended(folder.path(), 1, 0, &["TERM"]);
        command.ended(folder.path(), 2, 0, &["KILL"]);
        command.assert_goes_on_as(folder.path(), &command.whole());
    }
}

/// Where nothing is finished nothing is written, and an outside program does not outlive us.
#[test]
fn what_has_just_begun_ends_with_its_programs() {
    let folder = tempfile::tempdir().unwrap();
    let told = folder.path().join("told");
    let slow = format!(
        "slow=sh -c 'echo $$ >{0}.new; mv {0}.new {0}; sleep 600'",
        told.display()
    );
    let command = Long::of("run", &["stack", "--external", &slow, "--method", "slow"]);
    let mut child = command.start(folder.path());
    long::wait_for(&mut child, || told.exists());
    long::send(&child, "TERM");
    let output = child.wait_with_output().unwrap();
    let said = String::from_utf8(output.stderr).unwrap();
    assert_eq!(output.status.code(), Some(143), "{said}");
    let nothing = "interrupted by SIGTERM: 0 of 1 results are finished";
    assert!(said.contains(nothing), "{said}");
    assert!(!folder.path().join("out/results.csv").exists());
    assert_eq!(command.finished(folder.path()), 0);
    let program = fs::read_to_string(&told).unwrap();
    let state = Command::new("ps")
        .args(["-o", "stat=", "-p", program.trim()])
        .output();
    let state = String::from_utf8(state.unwrap().stdout).unwrap();
    assert!(
        state.trim().is_empty() || state.starts_with('Z'),
        "{program} runs: {state}"
    );
}

/// A wall whose bound grows for long after its first proof.
const GROWS: &str = r#"
unit = { length = 4.0, height = 1.75, weight = 1.0 }
courses = ["1111", "h111h", "1111"]
friction = 1.2
"#;

/// A bound is told as it grows, and what is proved when a signal comes is kept with its certificate.
#[test]
fn what_is_proved_by_then_is_kept() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("grows.toml"), GROWS).unwrap();
    let bound = ["grows.toml", "--method", "bound", "--certificate", "proofs"];
    let lines = ["--progress", "lines"];
    let mut child = Long::of("run", &[&bound[..], &lines].concat()).start(folder.path());
    let mut error = BufReader::new(child.stderr.take().unwrap());
    let mut told = String::new();
    error.read_line(&mut told).unwrap();
    long::send(&child, "INT");
    let mut said = String::new();
    error.read_to_string(&mut said).unwrap();
    assert_eq!(child.wait().unwrap().code(), Some(130), "{told}{said}");
    let told: Vec<&str> = told.split_whitespace().collect();
    let [word, scene, push, lower, state] = told[..] else {
        panic!("{told:?}");
    };
    assert_eq!([word, scene, push], ["proved", "grows", "right"]);
    let [lower, state] = [lower, state].map(|number| number.parse::<f64>().unwrap());
    assert!(0.0 < lower && lower <= state, "{told:?}");
    assert!(
        said.contains(
            "so far, grows, pushed to the right: it is proved that no collapse state with 0 ≤ λ < 0."
        ),
        "{said}"
    );
    let file = folder.path().join("proofs/grows.right.bound");
    assert!(
        said.contains("the certificate is proofs/grows.right.bound"),
        "{said}"
    );
    assert!(file.exists());
    let check = Command::new(env!("CARGO_BIN_EXE_trilith"))
        .args(["check", "grows.toml", "--certificates", "proofs"])
        .current_dir(folder.path())
        .output()
        .unwrap();
    let checked = String::from_utf8(check.stdout).unwrap();
    assert_eq!(check.status.code(), Some(0), "{checked}");
    let proved = checked.split("λ < ").nth(1).and_then(|rest| {
        let number = rest.split_whitespace().next()?;
        number.parse::<f64>().ok()
    });
    assert!(proved.is_some_and(|at| at >= lower), "{lower}: {checked}");
}

/// `nohup` starts a program that ignores SIGHUP, and it goes on to its end.
#[test]
fn nohup_is_honoured() {
    let folder = tempfile::tempdir().unwrap();
    let command = &long::small()[0];
    let mut nohup = command.begun_by("nohup", folder.path());
    let mut child = nohup.stdin(Stdio::null()).spawn().unwrap();
    long::wait_for(&mut child, || command.finished(folder.path()) >= 1);
    for _ in 0..5 {
        long::send(&child, "HUP");
    }
    let output = child.wait_with_output().unwrap();
    assert_eq!(
        output.status.code(),
        Some(0),
        "{}",
        String::from_utf8_lossy(&output.stderr)
    );
    let text = fs::read_to_string(folder.path().join("out/results.csv")).unwrap();
    assert!(!text.contains("PARTIAL"), "{text}");
}

/// A digit of the journal flipped on disk is found: that row is computed again.
#[test]
fn a_flipped_digit_is_found() {
    let folder = tempfile::tempdir().unwrap();
    let command = &long::small()[0];
    command.ended(folder.path(), 2, 0, &["KILL"]);
    let journal = command.journal(folder.path());
    let text = fs::read_to_string(&journal).unwrap();
    let at = text.find("\"lower\":0.").expect("a row has a multiplier") + "\"lower\":0.".len();
    let mut bytes = text.into_bytes();
    bytes[at] = b'0' + (bytes[at] - b'0' + 1) % 10;
    fs::write(&journal, bytes).unwrap();
    let output = command.start(folder.path()).wait_with_output().unwrap();
    let said = String::from_utf8(output.stderr).unwrap();
    assert!(said.contains("holds damaged lines: 1;"), "{said}");
    let whole = command.whole();
    for (name, timeless) in TIMELESS {
        let [here, there] = [folder.path(), whole.path()].map(|f| f.join("out").join(name));
        if there.exists() {
            assert_eq!(timeless(&here), timeless(&there), "{name}");
        }
    }
    assert!(!journal.exists(), "a journal goes with success");
}

/// Up to twenty moments a command and signal, in release, anywhere in its time or in its first two seconds.
#[test]
#[ignore = "takes minutes; .ci/run has it"]
fn many_moments_a_command_and_signal() {
    let (count, least) = (share(20), share(5));
    let mut moments = long::Moments::new(14);
    for command in long::long() {
        let duration = command.duration().min(2_000_000);
        for signals in [&["TERM", "TERM"][..], &["HUP"], &["INT"]] {
            let (mut early, mut finished) = (0, Vec::new());
            for _ in 0..count {
                let folder = tempfile::tempdir().unwrap();
                let pause = moments.below(duration);
                let ended = command.ended(folder.path(), 0, pause, signals);
                ended.assert_sound(&command, folder.path(), signals);
                early += usize::from(ended.was_early());
                finished.push(ended.finished);
            }
            let name = command.name;
            println!(
                "{name} {signals:?}: {early} of {count} ended early, rows finished {finished:?}"
            );
            // Machines differ in speed from one minute to the next.
            assert!(early >= least, "{name} {signals:?}: {early}");
            let between = finished.iter().filter(|&&rows| rows > 0).count();
            assert!(between >= least, "{name} {signals:?}: {finished:?}");
        }
    }
}

/// SIGKILL up to ten times, then to the end.
#[test]
#[ignore = "takes minutes; .ci/run has it"]
fn killed_many_times_and_started_again() {
    let mut moments = long::Moments::new(41);
    for command in long::long() {
        let folder = tempfile::tempdir().unwrap();
        let mut known = 0;
        for _ in 0..share(10) {
            let pause = moments.below(60_000);
            command.ended(folder.path(), known + 1, pause, &["KILL"]);
            let now = command.finished(folder.path());
            assert!(
                now >= known || now == 0,
                "{}: {now} after {known}",
                command.name
            );
            known = now;
        }
        command.assert_goes_on_as(folder.path(), &command.whole());
    }
}
