//! Sweeps through the program itself: interrupted, dealt out in shards, and refused.

use std::fs;
use std::path::Path;
use std::process::{Child, Command, Output, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};

/// Quick methods on a small wall.
const SMALL: &str = r#"
title = "A small sweep"
methods = ["macro-block", "associative", "interval"]

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
    let verified = "\"status\":\"Verified\"";
    let stands = "\"status\":\"Stands\"";
    let id = "{\"id\":\"";
    let at = rows.lines().position(|line| line.contains(verified));
    let damaged = format!("line {} is not as it was written", at.unwrap() + 1);
    for (changed, told) in [
        (
            summed_again(&rows.replacen(verified, stands, 1)),
            "disagree",
        ),
        (
            summed_again(&rows.replacen(id, &format!("{id}0"), 1)),
            "which is not in this sweep",
        ),
        (rows.replacen(verified, stands, 1), &damaged),
    ] {
        fs::write(&first, changed).expect("it can be written");
        let second = folder.join("dealt/shard-1-of-1.rows");
        fs::write(&second, &rows).expect("it can be written");
        let refused = trilith(folder, &merge);
        assert_eq!(refused.status.code(), Some(2));
        let shown = text(&refused.stderr);
        assert!(shown.contains(told), "{shown}");
    }
}

/// Lines of rows, each with the sum of its text in front: FNV-1a of 128 bits, the length first.
fn summed_again(rows: &str) -> String {
    let line = |line: &str| {
        let text = line.split_once(' ').expect("a sum and a row").1;
        let length = (text.len() as u64).to_le_bytes();
        let bytes = length.iter().copied().chain(text.bytes());
        let sum = bytes.fold(
            0x6c62_272e_07bb_0142_62b8_2175_6295_c58d_u128,
            |sum, byte| {
                (sum ^ u128::from(byte)).wrapping_mul(0x0000_0000_0100_0000_0000_0000_0000_013b)
            },
        );
        format!("{sum:032x} {text}\n")
    };
    rows.lines().map(line).collect()
}

#[test]
fn a_changed_sweep_repeats_only_what_has_changed() {
    let folder = folder_with(&SMALL.replace(", \"interval\"", ""));
    let folder = folder.path();
    let arguments = ["sweep", "small.sweep.toml"];
    done(trilith(folder, &arguments));
    let sweep = read(folder, "small.sweep.toml");
    let more = sweep.replace("[0.4, 0.65]", "[0.65, 0.7]");
    fs::write(folder.join("small.sweep.toml"), more).expect("it can be written");
    let again = trilith(folder, &arguments);
    let told = text(&again.stderr);
    assert!(told.contains("20 of 40 results are finished"), "{told}");
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
        &[
            "sweep",
            "small.sweep.toml",
            "--slurm=8",
            "--external=it=echo 'a b'",
        ],
    );
    let script = text(&output.stdout);
    // What is quoted stays one word of the shell.
    let word = r" --external 'it=echo '\''a b'\'''";
    assert_eq!(script.matches(word).count(), 2, "{script}");
    assert!(!script.contains('@'), "{script}");
    for part in [
        "--array=1-8",
        "--shard \"$SLURM_ARRAY_TASK_ID/8\"",
        "--dependency=\"afterok:",
        "small.sweep.toml' --out '",
    ] {
        assert!(script.contains(part), "{part} is not in\n{script}");
    }
}

#[test]
fn every_mistake_in_a_sweep_gets_its_line_and_a_way_out() {
    let top = "case = \"paper-1\"\nmethods = [\"associative\"]\n";
    let vary = |lines: &str| format!("{top}\n[[vary]]\n{lines}\n");
    for (line, file, title, help) in [
        (
            1,
            "methods = []".into(),
            "a sweep without a case",
            "add `case = \"paper-1\"`",
        ),
        (
            1,
            "case = \"paper-9\"".into(),
            "no case named `paper-9`",
            "did you mean the case `paper-1`?",
        ),
        (
            1,
            "case = 3".into(),
            "expected a case",
            "a list of cases, or a table `[case]`",
        ),
        (
            1,
            "case = [\"paper-1\", \"paper-1\"]".into(),
            "comes twice",
            "name each case once",
        ),
        (
            1,
            "case = \"a.sweep.toml\"".into(),
            "a sweep and not a case",
            "`trilith sweep ",
        ),
        (
            1,
            "case = paper-1".into(),
            "must be quoted",
            "put words in quotes: `\"paper-1\"`",
        ),
        (
            2,
            top.replace("asso", "aso"),
            "no method named `asociative`",
            "did you mean `associative`?",
        ),
        (
            2,
            top.replace("[\"associative\"]", "[]"),
            "without methods",
            "drop `methods`",
        ),
        (
            2,
            top.replace("[\"associative\"]", "\"all\""),
            "a list of words",
            "write `methods = [",
        ),
        (
            3,
            format!("{top}head_joints = \"opn\""),
            "unknown head_joints",
            "`contact`, `open`, `both`",
        ),
        (
            3,
            format!("{top}overburden = [1, 2]"),
            "unknown key",
            "put `overburden = [...]` under `[[vary]]`",
        ),
        (
            4,
            format!("{top}[settings]\nstarts = 10001"),
            "`starts` is `10001`",
            "a whole number from 0",
        ),
        (
            4,
            format!("{top}[settings]\nstrats = 1"),
            "no setting `strats`",
            "settings are starts, ",
        ),
        (
            3,
            format!("{top}[vary]\nfriction = [0.5]"),
            "expected a sequence",
            "write `[[vary]]`, with two",
        ),
        (
            5,
            vary("overbuden = [0, 1]"),
            "unknown key `overbuden`",
            "did you mean `overburden`?",
        ),
        (
            5,
            vary("overburden = [0, -1]"),
            "`overburden` is negative",
            "a number from 0 to",
        ),
        (
            5,
            vary("friction = [nan]"),
            "not a finite number",
            "write a number",
        ),
        (
            5,
            vary("unit.length = [4.0]"),
            "unknown key `length`",
            "`\"unit.length\" = ",
        ),
        (
            5,
            vary("\"units.length\" = [4.0]"),
            "no table `units`",
            "vary a key of the case",
        ),
        (
            5,
            vary("\"courses.9\" = [\"11\"]"),
            "`courses` has no item 9",
            "vary a key of the case",
        ),
        (
            5,
            vary("title = [\"a\"]"),
            "says nothing about the wall",
            "vary a key of the case",
        ),
        (
            5,
            vary("head_joints = [\"open\"]"),
            "a column of its own",
            "`head_joints = \"both\"`",
        ),
        (
            5,
            vary("refine = [2]"),
            "the case has no bond",
            "`bond = \"running\"`",
        ),
        (
            5,
            vary("\"settings.starts\" = [10001]"),
            "`starts` is `10001`",
            "from 0 to",
        ),
        (
            5,
            vary("friction = 0.5"),
            "a list of values or a range",
            "write `[0.4, 0.5]`, or `{ from",
        ),
        (
            5,
            vary("friction = []"),
            "through no value",
            "at least one value",
        ),
        (
            5,
            vary("friction = [1, 1.0]"),
            "runs through 1 twice",
            "write each value once",
        ),
        (
            5,
            vary("friction = [[1]]"),
            "expected a number, a word",
            "write one value",
        ),
        (
            8,
            vary("friction = [1]\n\n[[vary]]\nfriction = [2]"),
            "varies twice",
            "remove one of the two",
        ),
        (
            6,
            vary("push = [\"left\"]\nfriction = [1, 2]"),
            "has 2 values and `push` has 1",
            "put `[[vary]]` between",
        ),
        (
            5,
            vary("friction = { from = 0, to = 1, count = 1 }"),
            "`count` is out of range",
            "from 2 to",
        ),
        (
            5,
            vary("friction = { from = 0, count = 4 }"),
            "an incomplete range",
            "`{ from = 0, to = 10, count = 40 }`",
        ),
        (
            5,
            vary("friction = { form = 0, to = 1, count = 4 }"),
            "unknown key `form`",
            "did you mean `from`?",
        ),
        (
            5,
            vary("friction = { from = 0,5, to = 1, count = 4 }"),
            "a decimal comma",
            "`0.5`",
        ),
        (
            5,
            vary("friction = { from = \"a\", to = 1, count = 4 }"),
            "no usable number",
            "such as `0.65`",
        ),
        (
            5,
            vary("friction = { from = 0, to = 1, count = 4, spacing = \"log\" }"),
            "unknown spacing",
            "logarithmic",
        ),
        (
            5,
            vary("friction = { from = 0, to = 1, count = 4, spacing = \"logarithmic\" }"),
            "through zero",
            "positive",
        ),
        (
            2,
            "methods = [\"interval\"]\n[case]\nfriction = 0.5".into(),
            "missing key `unit`",
            "add `unit = {",
        ),
    ] {
        let folder = folder_with(&file);
        fs::write(folder.path().join("a.sweep.toml"), top).expect("it can be written");
        let output = trilith(folder.path(), &["sweep", "small.sweep.toml"]);
        let shown = text(&output.stderr);
        assert_eq!(output.status.code(), Some(2), "{shown}");
        assert!(output.stdout.is_empty() && !folder.path().join("target").exists());
        let place = format!("small.sweep.toml:{line}:");
        for part in [place.as_str(), title, help] {
            assert!(shown.contains(part), "`{part}` is not in\n{shown}");
        }
    }
}

/// Items of lists vary, counted from 1: what slides on a bed does at the bed's friction, and where weights
/// are lifted by v of the push, at μ / (1 + v μ).
#[test]
fn items_of_lists_vary() {
    let sweep = r#"
methods = ["associative"]

[case]
unit = { length = 4.0, height = 1.0, weight = 1.0 }
courses = ["11", "h1h"]
heights = [0.5, 0.5]
friction = 0.9
joints = [{ course = 2, friction = 0.5 }]
live = { weight = [1, 0] }

[[vary]]
"joints.1.friction" = [0.1, 0.2]
"heights.2" = [0.6, 0.7]

[[vary]]
"live.weight.2" = [0.0, 0.5]
"#;
    let folder = folder_with(sweep);
    done(trilith(
        folder.path(),
        &["sweep", "small.sweep.toml", "--out", "out"],
    ));
    let rows = read(folder.path(), "out/sweep.csv");
    let found: Vec<f64> = (rows.lines().skip(1))
        .map(|row| row.split(',').nth(3).unwrap().parse().unwrap())
        .collect();
    let expected = [0.1, 0.1 / 1.05, 0.2, 0.2 / 1.1];
    assert_eq!(found.len(), expected.len(), "{rows}");
    for (found, expected) in found.iter().zip(expected) {
        assert!((found - expected).abs() < 1e-6, "{rows}");
    }
}

#[test]
fn arguments_that_make_no_sense_are_refused() {
    let folder = folder_with(SMALL);
    for (arguments, told) in [
        (&["sweep", "fig-77"][..], "did you mean `fig-7`?"),
        (
            &["sweep", "small.sweep.toml", "--shard", "5/4"],
            "write K/N",
        ),
        (&["sweep", "small.sweep.toml", "--slurm", "0"], "1..=1000"),
        (
            &["merge", "small.sweep.toml"],
            "run the shards of the sweep first",
        ),
        (&["run", "small.sweep.toml"], "a sweep and not a case"),
    ] {
        let output = trilith(folder.path(), arguments);
        let shown = text(&output.stderr);
        assert_eq!(output.status.code(), Some(2), "{shown}");
        assert!(shown.contains(told), "{shown}");
    }
}

#[test]
fn the_sweep_that_the_help_shows_can_be_read() {
    let folder = tempfile::tempdir().expect("a folder for the test");
    let help = text(&trilith(folder.path(), &["sweep", "--help"]).stdout);
    let shown = help
        .split_once("what varies in it:")
        .expect("the format is shown")
        .1;
    let shown = shown
        .split_once("`aspect` varies")
        .expect("the sweep ends there")
        .0;
    // Few and quick ones of it.
    let few = shown
        .replace("count = 21", "count = 2")
        .replace("[3.0, 4.0]", "[3.0, 4.5]");
    let few = few.replace(", \"interval\"", "");
    fs::write(folder.path().join("shown.sweep.toml"), few).expect("it can be written");
    done(trilith(folder.path(), &["sweep", "shown.sweep.toml"]));
    let rows = read(folder.path(), "target/sweeps/shown/sweep.csv");
    assert_eq!(rows.lines().count(), 1 + 2 * 2 * 2, "{rows}");
}
