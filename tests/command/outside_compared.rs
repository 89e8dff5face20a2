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
