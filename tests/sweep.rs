//! Sweeps through the program itself: interrupted, dealt out in shards, and refused.

use std::fs;
use std::path::Path;
use std::process::{Child, Command, Output, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};

/// Quick methods on a small wall; the interval also starts from its neighbours' states.
const SMALL: &str = r#"
title = "A small sweep"
methods = ["macro-block", "associative", "interval"]
neighbours = "overburden"

[case]
unit = { length = 4.0, height = 1.75, weight = 1.0 }
bond = "running"
courses = 4
units = 4
friction = 0.65
head_joints = "both"

[[vary]]
friction = [0.4, 0.65]

[[vary]]
overburden = { from = 0, to = 4, count = 5 }
"#;

const POINTS: usize = 2 * 5 * 3 * 2;

fn command(folder: &Path, arguments: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_trilith"));
    command.current_dir(folder).args(arguments);
    command.stdout(Stdio::piped()).stderr(Stdio::piped());
    command
}

fn trilith(folder: &Path, arguments: &[&str]) -> Output {
    command(folder, arguments)
        .output()
        .expect("the program starts")
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8(bytes.to_vec()).expect("output is UTF-8")
}

fn done(output: Output) {
    assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
}

fn folder_with(sweep: &str) -> tempfile::TempDir {
    let folder = tempfile::tempdir().expect("a folder for the test");
    fs::write(folder.path().join("small.sweep.toml"), sweep).expect("the sweep is written");
    folder
}

fn read(folder: &Path, file: &str) -> String {
    fs::read_to_string(folder.join(file)).unwrap_or_else(|error| panic!("{file}: {error}"))
}

/// Lines of a file that may not be there yet.
fn lines(path: &Path) -> usize {
    let bytes = fs::read(path).unwrap_or_default();
    bytes.iter().filter(|&&byte| byte == b'\n').count()
}

/// Kills the process once its journal has so many lines, and a little later.
fn kill_after(mut child: Child, journal: &Path, rows: usize, later: Duration) {
    let began = Instant::now();
    while lines(journal) < rows && began.elapsed() < Duration::from_secs(60) {
        if child.try_wait().expect("it is a child").is_some() {
            return;
        }
        sleep(Duration::from_millis(1));
    }
    sleep(later);
    // SIGKILL on Unix: nothing of the program runs after it.
    child.kill().expect("it can be killed");
    child.wait().expect("it has ended");
}

#[test]
fn killed_at_ten_moments_a_sweep_ends_as_if_never_interrupted() {
    let folder = folder_with(SMALL);
    let folder = folder.path();
    done(trilith(
        folder,
        &["sweep", "small.sweep.toml", "--out", "whole"],
    ));
    let whole = read(folder, "whole/sweep.csv");
    assert_eq!(whole.lines().count(), 1 + POINTS);
    let arguments = ["sweep", "small.sweep.toml", "--out", "killed"];
    let journal = folder.join("killed/sweep.journal");
    // The first ones while the plan is still being made; then ever later, between and in rows.
    for moment in 0_u32..10 {
        let child = command(folder, &arguments)
            .spawn()
            .expect("the program starts");
        let rows = (moment as usize).saturating_sub(2) * POINTS / 9;
        let later = Duration::from_micros(u64::from(moment.wrapping_mul(2_654_435_761) % 9_000));
        kill_after(child, &journal, rows, later);
        assert!(!folder.join("killed/sweep.csv").exists() || lines(&journal) == POINTS);
    }
    done(trilith(folder, &arguments));
    assert_eq!(read(folder, "killed/sweep.csv"), whole);
    // Nothing that was finished was repeated.
    let journal = read(folder, "killed/sweep.journal");
    let mut ids: Vec<&str> = journal
        .lines()
        .filter_map(|line| line.split('"').nth(3))
        .collect();
    assert_eq!(ids.len(), POINTS);
    ids.sort_unstable();
    ids.dedup();
    assert_eq!(ids.len(), POINTS);
}

#[test]
fn four_shards_of_two_processes_at_a_time_merge_to_the_same_bytes() {
    let folder = folder_with(SMALL);
    let folder = folder.path();
    done(trilith(
        folder,
        &["sweep", "small.sweep.toml", "--out", "whole"],
    ));
    let shard = |k: usize| {
        let shard = format!("{k}/4");
        let arguments = ["sweep", "small.sweep.toml", "--out", "dealt", "--shard"];
        let mut command = command(folder, &arguments);
        let command = command.arg(shard);
        command.spawn().expect("the program starts")
    };
    let merge = ["merge", "small.sweep.toml", "--out", "dealt"];
    let missing = trilith(folder, &merge);
    assert_eq!(missing.status.code(), Some(2));
    for pair in [[1, 2], [3, 4]] {
        for child in pair.map(shard) {
            done(child.wait_with_output().expect("it has ended"));
        }
        if pair == [1, 2] {
            let missing = trilith(folder, &merge);
            assert_eq!(missing.status.code(), Some(2));
            let told = text(&missing.stderr);
            assert!(told.contains("30 of 60 points are missing"), "{told}");
            assert!(told.contains("run the shards 3/4, 4/4 again"), "{told}");
        }
    }
    done(trilith(folder, &merge));
    let whole = read(folder, "whole/sweep.csv");
    assert_eq!(read(folder, "dealt/sweep.csv"), whole);
    let times = |folder_name| lines(&folder.join(folder_name).join("times.csv"));
    assert_eq!(times("dealt"), times("whole"));

    // Rows that disagree, of another sweep, or damaged.
    let first = folder.join("dealt/shard-1-of-4.rows");
    let rows = fs::read_to_string(&first).expect("the shard has written it");
    for (from, to, told) in [
        (
            "\"status\":\"verified\"",
            "\"status\":\"stands\"",
            "disagree",
        ),
        ("{\"id\":\"", "{\"id\":\"0", "which is not in this sweep"),
        ("{\"id\"", "\"id\"", "line 1 is no row of a sweep"),
    ] {
        fs::write(&first, rows.replacen(from, to, 1)).expect("it can be written");
        let second = folder.join("dealt/shard-1-of-1.rows");
        fs::write(&second, &rows).expect("it can be written");
        let refused = trilith(folder, &merge);
        assert_eq!(refused.status.code(), Some(2));
        let shown = text(&refused.stderr);
        assert!(shown.contains(told), "{shown}");
    }
}

#[test]
fn a_changed_sweep_repeats_only_what_has_changed() {
    let folder = folder_with(
        &SMALL
            .replace(", \"interval\"", "")
            .replace("neighbours", "#"),
    );
    let folder = folder.path();
    let arguments = ["sweep", "small.sweep.toml"];
    done(trilith(folder, &arguments));
    let sweep = read(folder, "small.sweep.toml");
    let more = sweep.replace("[0.4, 0.65]", "[0.65, 0.7]");
    fs::write(folder.join("small.sweep.toml"), more).expect("it can be written");
    let again = trilith(folder, &arguments);
    let told = text(&again.stderr);
    assert!(told.contains("20 of 40 points are finished"), "{told}");
    let out = text(&again.stdout);
    assert!(out.contains("target/sweeps/small/sweep.csv"), "{out}");
    // Another unit makes every wall another one.
    let other = sweep.replace("length = 4.0", "length = 4.5");
    fs::write(folder.join("small.sweep.toml"), other).expect("it can be written");
    let told = text(&trilith(folder, &arguments).stderr);
    assert!(!told.contains("finished already"), "{told}");
}

#[test]
fn a_script_for_slurm_names_every_shard_and_a_merge_that_waits() {
    let folder = folder_with(SMALL);
    let output = trilith(
        folder.path(),
        &["sweep", "small.sweep.toml", "--slurm", "8"],
    );
    let script = text(&output.stdout);
    for part in [
        "--array=1-8",
        "--shard \"$SLURM_ARRAY_TASK_ID/8\"",
        "--dependency=\"afterok:",
        "small.sweep.toml' --out '",
    ] {
        assert!(script.contains(part), "{part} is not in\n{script}");
    }
}
