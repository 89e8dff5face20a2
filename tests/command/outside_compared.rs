//! Outside programs are compared like our own methods: in `run`, `check` and `sweep`, with each other
//! and with references.
#![cfg(unix)]

use std::fs;
use std::path::Path;
use std::process::{Command, Output};

use serde_json::{Value, json};

const CASE: &str = "paper-1";

fn trilith(folder: &Path, arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_trilith"))
        .current_dir(folder)
        .args(arguments)
        .output()
        .unwrap()
}

fn rows(output: &Output) -> Vec<Value> {
    let error = String::from_utf8_lossy(&output.stderr);
    serde_json::from_slice(&output.stdout).unwrap_or_else(|e| panic!("{e}: {error}"))
}

/// Four programs: 5 % above λ_A, a negative number, a state at a λ below the lowest verified one that
/// is not its own, and the interval's own state. As arguments of the command line.
fn planted(folder: &Path) -> Vec<String> {
    let arguments = [
        "run",
        CASE,
        "--method",
        "interval",
        "--head-joints",
        "contact",
        "--states",
        "--format",
        "json",
        "--starts",
        "2",
    ];
    let rows = rows(&trilith(folder, &arguments));
    let right = rows[0]["sides"][0]["answers"][0].clone();
    let mut wrong = right.clone();
    wrong["lambda"] = json!(0.9 * right["lambda"].as_f64().unwrap());
    let answers = [
        (
            "above",
            json!({"kind": "estimate", "lambda": 1.05 * 0.642859}),
        ),
        ("negative", json!({"kind": "estimate", "lambda": -0.1})),
        ("false", wrong),
        ("right", right),
    ];
    let programs = answers.iter().map(|(name, answer)| {
        fs::write(folder.join(format!("{name}.json")), answer.to_string()).unwrap();
        format!("--external={name}=cat {name}.json")
    });
    programs.collect()
}

const VERDICTS: [(&str, &str); 4] = [
    ("above", "VIOLATED"),
    ("negative", "VIOLATED"),
    ("false", "VIOLATED"),
    ("right", "holds"),
];

#[test]
fn planted_programs_are_found_out_by_run_and_check() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let programs = planted(folder);
    let programs: Vec<&str> = programs.iter().map(String::as_str).collect();
    let own = [
        "--method",
        "associative,sequential,interval",
        "--head-joints",
        "contact",
        "--starts",
        "2",
    ];
    let arguments = [&["run", CASE, "--format", "json"], &own[..], &programs].concat();
    let output = trilith(folder, &arguments);
    assert_eq!(output.status.code(), Some(1));
    let by_run = rows(&output);
    let arguments = [&["check", CASE, "--out", "out"], &own[..], &programs].concat();
    let output = trilith(folder, &arguments);
    assert_eq!(output.status.code(), Some(1));
    let by_check = fs::read(folder.join("out/results.json")).unwrap();
    let by_check: Vec<Value> = serde_json::from_slice(&by_check).unwrap();
    let text = String::from_utf8_lossy(&output.stdout);
    assert!(text.contains("3 violated, 1 failed"), "{text}");
    for rows in [by_run, by_check] {
        for (name, verdict) in VERDICTS {
            let row = rows.iter().find(|row| row["method"] == name).unwrap();
            assert_eq!(row["verdict"], verdict, "{name}: {row}");
        }
        // Our own are none the worse for it.
        for row in rows.iter().filter(|row| row["method"] == "interval") {
            assert_eq!(row["verdict"], "holds", "{row}");
        }
    }
    let right = programs[3];
    let output = trilith(folder, &[&["run", CASE], &own[..], &[right]].concat());
    assert_eq!(output.status.code(), Some(0));
}

const SWEEP: &str = r#"
case = "paper-1"
head_joints = "contact"
methods = ["associative", "interval"]
settings = { starts = 2 }
[[vary]]
overburden = [0.0, 0.0001]
"#;

/// In one run, in shards, and resumed: the same bytes, and the same verdicts.
#[test]
fn planted_programs_are_found_out_by_sweeps() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let programs = planted(folder);
    let programs: Vec<&str> = programs.iter().map(String::as_str).collect();
    fs::write(folder.join("a.sweep.toml"), SWEEP).unwrap();
    let sweep = |arguments: &[&str]| {
        let output = trilith(folder, &[arguments, &programs].concat());
        (
            output.status.code(),
            String::from_utf8_lossy(&output.stdout).into_owned(),
        )
    };
    let (code, text) = sweep(&["sweep", "a.sweep.toml", "--out", "one"]);
    assert_eq!(code, Some(1));
    assert!(text.contains("VIOLATED"), "{text}");
    let csv = fs::read_to_string(folder.join("one/sweep.csv")).unwrap();
    let mut lines = csv.lines().filter(|line| !line.is_empty());
    assert!(lines.next().unwrap().ends_with(",verdict"));
    let lines: Vec<&str> = lines.collect();
    assert_eq!(lines.len(), 2 * 6);
    for (name, verdict) in VERDICTS {
        let is_of = |line: &&&str| line.split(',').nth(1) == Some(name);
        let first = lines.iter().find(is_of).unwrap();
        assert!(first.ends_with(&format!(",{verdict}")), "{first}");
    }
    sweep(&["sweep", "a.sweep.toml", "--out", "one"]);
    assert_eq!(
        csv,
        fs::read_to_string(folder.join("one/sweep.csv")).unwrap()
    );
    for shard in ["1/2", "2/2"] {
        sweep(&["sweep", "a.sweep.toml", "--out", "parts", "--shard", shard]);
    }
    let (code, _) = sweep(&["merge", "a.sweep.toml", "--out", "parts"]);
    assert_eq!(code, Some(1));
    assert_eq!(
        csv,
        fs::read_to_string(folder.join("parts/sweep.csv")).unwrap()
    );
    // A program whose file changes is asked again.
    fs::write(
        folder.join("above.json"),
        r#"{"kind": "estimate", "lambda": 0.6}"#,
    )
    .unwrap();
    sweep(&["sweep", "a.sweep.toml", "--out", "one"]);
    assert_ne!(
        csv,
        fs::read_to_string(folder.join("one/sweep.csv")).unwrap()
    );
}

const BLOCK: &str = r#"
courses = ["1"]
unit = { length = 1.0, height = 2.0, weight = 1.0 }
friction = 0.65
[[references]]
method = "METHOD"
quantity = "lambda"
value = 0.5
tolerance = 0.001
source = "b/h"
kind = "analytic"
"#;

/// A reference may be about a program, which is given or not; a slip in a method's name is found.
#[test]
fn references_of_programs_are_compared_where_they_run() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    fs::write(folder.join("block.toml"), BLOCK.replace("METHOD", "mylp")).unwrap();
    let run = |arguments: &[&str]| {
        let output = trilith(
            folder,
            &[&["run", "block.toml", "--method", "associative"], arguments].concat(),
        );
        let texts = [output.stdout, output.stderr].concat();
        (
            output.status.code(),
            String::from_utf8_lossy(&texts).into_owned(),
        )
    };
    let (code, text) = run(&[]);
    assert_eq!(code, Some(0), "{text}");
    assert!(
        text.contains("not compared") && text.contains("external methods: `mylp=COMMAND`"),
        "{text}"
    );
    let says = |lambda: f64| {
        format!(r#"--external=mylp=echo '{{"kind": "estimate", "lambda": {lambda}}}'"#)
    };
    let (code, text) = run(&[&says(0.5)]);
    assert_eq!(code, Some(0), "{text}");
    assert!(!text.contains("not compared"), "{text}");
    let (code, text) = run(&[&says(0.4)]);
    assert_eq!(code, Some(1), "{text}");
    // A program of nearly that name.
    let (code, text) = run(&[&says(0.5).replace("mylp=", "mylq=")]);
    assert_eq!(code, Some(0), "{text}");
    assert!(text.contains("did the case mean `mylq`?"), "{text}");
    for (method, expected) in [
        ("asociative", "did you mean"),
        ("my program", "letters, digits"),
    ] {
        fs::write(folder.join("block.toml"), BLOCK.replace("METHOD", method)).unwrap();
        let (code, text) = run(&[]);
        assert_eq!(code, Some(2), "{text}");
        assert!(
            text.contains(expected) && text.contains("block.toml:"),
            "{text}"
        );
    }
}

/// The sequential method above λ_A by its own c0, and nothing to be relative to at λ = 0.
#[test]
fn what_a_method_states_about_itself_is_no_violation() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let wall = |friction: f64| {
        format!(
            "courses = [\"h11h\", \"111\", \"h11h\"]\nfriction = {friction:?}\nhead_joints = \
             \"both\"\nunit = {{ length = 4.0, height = 1.75, weight = 1.0 }}\n"
        )
    };
    fs::write(folder.join("smooth.toml"), wall(0.0)).unwrap();
    fs::write(folder.join("rough.toml"), wall(0.65)).unwrap();
    for arguments in [
        vec!["run", "smooth.toml"],
        vec!["run", "rough.toml", "--set", "c0=1e-3"],
        vec!["run", "rough.toml", "--set", "c0=1e-2"],
    ] {
        let own = [
            "--method",
            "associative,sequential,interval",
            "--starts",
            "2",
        ];
        let output = trilith(folder, &[&arguments, &own[..]].concat());
        let text = String::from_utf8_lossy(&output.stdout);
        assert_eq!(output.status.code(), Some(0), "{arguments:?}: {text}");
        assert!(
            text.contains("which comes from the shear c0"),
            "{arguments:?}: {text}"
        );
    }
}

/// A number far below a verified state does not simply hold, and stands in plain words; a number or
/// `{"lambda": 0.5}` alone is an estimate.
#[test]
fn a_bare_number_is_an_estimate_and_is_held_against_the_lowest_state() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("answer.json"), "{\"lambda\": 0.5}").unwrap();
    let run = [
        "run",
        "overburden-1",
        "--method",
        "associative",
        "interval",
        "--head-joints",
        "open",
        "--starts",
        "2",
        "--format",
        "json",
        "--external=bare=echo 0.5",
        "--external=object=cat answer.json",
        "--external=words=echo hello",
        "--external=nothing=echo {}",
    ];
    let found = rows(&trilith(folder.path(), &run));
    let row = |method: &str| found.iter().find(|row| row["method"] == method).unwrap();
    let lowest = row("interval")["lower"].as_f64().unwrap();
    assert!(lowest > 0.52, "{lowest}");
    for method in ["bare", "object"] {
        let row = row(method);
        assert_eq!(
            (&row["status"], &row["lower"]),
            (&json!("estimate"), &json!(0.5))
        );
        assert_eq!(row["verdict"], "marked", "{row}");
    }
    for (method, words) in [
        (
            "words",
            "its output is no answer, which is a number or JSON such as {\"lambda\": 0.5}",
        ),
        ("nothing", "needs `lambda`"),
    ] {
        let row = row(method);
        assert_eq!(row["status"], "failed");
        assert!(row["reason"].as_str().unwrap().contains(words), "{row}");
    }
    let table = trilith(
        folder.path(),
        &[&run[..9], &["--external=bare=echo 0.5"]].concat(),
    );
    let table = String::from_utf8(table.stdout).unwrap();
    let below = 100.0 * (lowest - 0.5) / lowest;
    let words =
        format!("bare is not above associative, and {below:.1} % below the lowest verified state");
    assert!(table.contains(&words), "{words}: {table}");
}

/// The row of `auto` is undecided where the multiplier is not unique, and the answer says so of the
/// state that it verifies.
#[test]
fn what_auto_leaves_undecided_stands_beside_its_verified_state() {
    let folder = tempfile::tempdir().unwrap();
    let run = [
        "run",
        "overburden-1",
        "--method",
        "auto",
        "--head-joints",
        "contact",
        "--format",
        "json",
    ];
    let found = rows(&trilith(folder.path(), &run));
    assert_eq!(found[0]["status"], "undecided");
    let line = found[0]["conclusion"]["line"].as_str().unwrap();
    let words = "is verified: it is the lowest collapse state found (auto, which is undecided about how far \
                 other states reach)";
    assert!(line.contains(words), "{line}");
}

/// A verdict beside an error is of the reference that the error is of, or names another.
#[test]
fn a_deviation_from_another_reference_is_named_in_the_row() {
    let folder = tempfile::tempdir().unwrap();
    let output = trilith(
        folder.path(),
        &["run", "griffith-12", "--method", "associative"],
    );
    let table = String::from_utf8(output.stdout).unwrap();
    let row = table
        .lines()
        .find(|line| line.starts_with("associative"))
        .unwrap();
    assert!(
        row.contains(" 0.03 ") && row.ends_with("deviates from 0.138 p"),
        "{row}"
    );
    let heading = table
        .lines()
        .find(|line| line.starts_with("method"))
        .unwrap();
    assert_eq!(heading.matches("reference").count(), 1, "{heading}");
}

#[test]
fn a_sweep_in_which_nothing_varies_says_where_its_ranges_are_drawn() {
    let folder = tempfile::tempdir().unwrap();
    let sweep = "case = [\"stack\", \"block-both\"]\nmethods = [\"associative\"]\n";
    fs::write(folder.path().join("flat.sweep.toml"), sweep).unwrap();
    let output = trilith(folder.path(), &["sweep", "flat.sweep.toml"]);
    let out = String::from_utf8(output.stdout).unwrap();
    let words =
        "no plot: nothing varies; `trilith report CASE... --out DIR` draws the ranges of its cases";
    assert!(out.contains(words), "{out}");
}
