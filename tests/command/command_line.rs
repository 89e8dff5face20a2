//! The contracts that scripts rely on: exit status, columns, where things are printed.

use std::fs;
use std::path::Path;
use std::process::{Command, Output};

fn trilith(folder: &Path, arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_trilith"))
        .current_dir(folder)
        .args(arguments)
        .output()
        .expect("the program starts")
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8(bytes.to_vec()).expect("output is UTF-8")
}

#[test]
fn csv_begins_with_the_agreed_columns() {
    let folder = tempfile::tempdir().unwrap();
    let arguments = [
        "run",
        "paper-1",
        "--method",
        "macro-block",
        "associative",
        "--format",
        "csv",
    ];
    let output = trilith(folder.path(), &arguments);
    assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
    let out = text(&output.stdout);
    let mut lines = out.lines();
    let heading = lines.next().unwrap();
    let agreed = "case,method,status,lower,upper,tan_beta,c,e,residual,seconds,reason";
    assert!(heading.starts_with(agreed), "{heading}");
    let columns: Vec<&str> = heading.split(',').collect();
    let unique: std::collections::BTreeSet<&str> = columns.iter().copied().collect();
    assert_eq!(unique.len(), columns.len(), "{heading}");
    let names: Vec<(&str, &str)> = lines
        .map(|line| {
            let mut fields = line.split(',');
            (fields.next().unwrap(), fields.next().unwrap())
        })
        .collect();
    assert_eq!(
        names,
        [
            ("paper-1", "macro-block"),
            ("paper-1@open", "macro-block"),
            ("paper-1", "associative"),
            ("paper-1@open", "associative")
        ]
    );
}

#[test]
fn json_carries_numbers_and_null() {
    let folder = tempfile::tempdir().unwrap();
    let arguments = [
        "run",
        "sliding-block",
        "--method",
        "macro-block",
        "associative",
        "--format",
        "json",
    ];
    let output = trilith(folder.path(), &arguments);
    assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
    let rows: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!(rows[0]["status"], "not-applicable");
    assert_eq!(rows[0]["lower"], serde_json::Value::Null);
    assert!((rows[1]["lower"].as_f64().unwrap() - 0.3).abs() < 1e-6);
}

#[test]
fn a_template_runs_and_is_not_overwritten() {
    let folder = tempfile::tempdir().unwrap();
    let made = trilith(folder.path(), &["new", "mine"]);
    assert_eq!(made.status.code(), Some(0), "{}", text(&made.stderr));
    let ran = trilith(
        folder.path(),
        &[
            "run",
            "mine.toml",
            "--method",
            "associative",
            "--out",
            "results",
        ],
    );
    assert_eq!(ran.status.code(), Some(0), "{}", text(&ran.stderr));
    for file in ["results.csv", "results.json", "mine.txt"] {
        assert!(folder.path().join("results").join(file).exists(), "{file}");
    }
    let again = trilith(folder.path(), &["new", "mine"]);
    assert_eq!(again.status.code(), Some(2));
    assert!(text(&again.stderr).contains("is there already"));
}

#[test]
fn every_kind_of_case_has_a_template_that_runs() {
    let folder = tempfile::tempdir().unwrap();
    for (kind, shown) in [
        ("wall", "4 courses of units 4 x 1.75"),
        (
            "blocks",
            "edges touch within 1e-6 of the smaller block's extent",
        ),
        ("arch", "an arch of mean radius 10, thickness 1.5"),
    ] {
        let made = trilith(folder.path(), &["new", kind, "--kind", kind]);
        assert_eq!(made.status.code(), Some(0), "{}", text(&made.stderr));
        let file = format!("{kind}.toml");
        let show = trilith(folder.path(), &["show", &file]);
        assert!(text(&show.stdout).contains(shown), "{}", text(&show.stdout));
        let ran = trilith(folder.path(), &["run", &file, "--method", "associative"]);
        assert_eq!(ran.status.code(), Some(0), "{}", text(&ran.stderr));
    }
}

#[test]
fn a_csv_is_read_beside_its_case_and_its_mistakes_are_named_there() {
    let folder = tempfile::tempdir().unwrap();
    let inner = folder.path().join("inner");
    std::fs::create_dir(&inner).unwrap();
    let put = |name: &str, content: &str| std::fs::write(inner.join(name), content).unwrap();
    let case = "friction = 0.3\n[blocks]\ncsv = \"b.csv\"\nsupports = [\"g\"]\n";
    put("pier.toml", case);
    let csv = "block,x,y\ng,-1,-1\ng,3,-1\ng,3,0\ng,-1,0\nA,0,0\nA,2,0\nA,2,1\nA,0,1\n";
    put("b.csv", csv);
    // From another folder: the CSV is looked for beside the case.
    let ran = trilith(
        folder.path(),
        &["run", "inner/pier.toml", "--method", "associative"],
    );
    assert_eq!(ran.status.code(), Some(0), "{}", text(&ran.stderr));
    assert!(
        text(&ran.stdout).contains("0.30000"),
        "{}",
        text(&ran.stdout)
    );
    put("b.csv", &csv.replace("A,2,1", "A,two,1"));
    let ran = trilith(folder.path(), &["run", "inner/pier.toml"]);
    assert_eq!(ran.status.code(), Some(2));
    assert!(
        text(&ran.stderr).contains("inner/b.csv:8:3"),
        "{}",
        text(&ran.stderr)
    );
    assert!(text(&ran.stderr).contains("`two` is not a number"));
}

#[test]
fn records_of_a_users_wall_are_compared_and_reviewed() {
    let folder = tempfile::tempdir().unwrap();
    assert!(trilith(folder.path(), &["new", "mine"]).status.success());
    let run = [
        "run",
        "mine.toml",
        "--method",
        "associative",
        "--record",
        "snapshots",
    ];
    let first = trilith(folder.path(), &run);
    assert_eq!(first.status.code(), Some(1));
    assert!(text(&first.stderr).starts_with("the record snapshots/mine.snap.new is new"));
    let snapshots = folder.path().join("snapshots");
    fs::rename(snapshots.join("mine.snap.new"), snapshots.join("mine.snap")).unwrap();
    assert_eq!(trilith(folder.path(), &run).status.code(), Some(0));
    let file = folder.path().join("mine.toml");
    let wall = fs::read_to_string(&file).unwrap();
    let friction = wall
        .lines()
        .find(|line| line.starts_with("friction"))
        .unwrap();
    fs::write(&file, wall.replace(friction, "friction = 0.2")).unwrap();
    let changed = trilith(folder.path(), &run);
    assert_eq!(changed.status.code(), Some(1));
    assert!(text(&changed.stderr).starts_with("the record snapshots/mine.snap.new is changed"));
    assert!(snapshots.join("mine.snap.new").exists());
}

#[test]
fn a_record_whose_case_is_gone_is_named_and_pruned() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let records = folder.join("records");
    let run = |cases: &str, more: &[&str]| {
        let run = [
            "run",
            cases,
            "--method",
            "associative",
            "--record",
            "records",
        ];
        let output = trilith(folder, &[&run, more].concat());
        (output.status.code(), text(&output.stderr))
    };
    for name in ["walls/one", "walls/two"] {
        assert!(trilith(folder, &["new", name]).status.success());
    }
    assert_eq!(run("walls", &[]).0, Some(1));
    for name in ["one", "two"] {
        let [new, accepted] = ["snap.new", "snap"].map(|end| records.join(format!("{name}.{end}")));
        fs::rename(new, accepted).unwrap();
    }
    assert_eq!(run("walls", &[]), (Some(0), String::new()));
    // What is there and did not run is not gone.
    assert_eq!(run("walls/one.toml", &[]), (Some(0), String::new()));
    fs::remove_file(folder.join("walls/two.toml")).unwrap();
    let gone = "the case of records/two.snap is gone; `--prune` removes the record\n";
    for cases in ["walls", "walls/one.toml"] {
        assert_eq!(run(cases, &[]), (Some(1), gone.to_owned()));
    }
    assert!(records.join("two.snap").exists());
    let (status, said) = run("walls", &["--prune"]);
    assert_eq!(status, Some(0), "{said}");
    assert!(said.starts_with("records/two.snap was removed"), "{said}");
    assert!(records.join("one.snap").exists() && !records.join("two.snap").exists());
    assert_eq!(run("walls", &[]), (Some(0), String::new()));
}

#[test]
fn a_violated_reference_exits_with_1() {
    let folder = tempfile::tempdir().unwrap();
    let wall = "title = \"t\"\nsource = \"s\"\nunit = { length = 4.0, height = 1.75, weight = 1.0 }\n\
                courses = [\"1\"]\nfriction = 0.3\n\n[[references]]\nmethod = \"associative\"\n\
                quantity = \"lambda\"\nvalue = 0.31\ntolerance = 1e-3\nsource = \"wrong\"\n\
                kind = \"analytic\"\n";
    fs::write(folder.path().join("wrong.toml"), wall).unwrap();
    let output = trilith(
        folder.path(),
        &["run", "wrong.toml", "--method", "associative"],
    );
    assert_eq!(output.status.code(), Some(1), "{}", text(&output.stderr));
    assert!(text(&output.stdout).contains("VIOLATED"));
}

#[test]
fn bad_input_exits_with_2_names_the_line_and_leaves_nothing() {
    let folder = tempfile::tempdir().unwrap();
    let wall = "title = \"t\"\nsource = \"s\"\nunit = { length = 4.0, height = 1.75, weight = 1.0 }\n\
                courses = [\"1x1\"]\nfriction = 0.3\n";
    fs::write(folder.path().join("bad.toml"), wall).unwrap();
    let output = trilith(folder.path(), &["run", "bad.toml", "--out", "results"]);
    assert_eq!(output.status.code(), Some(2));
    assert!(output.stdout.is_empty());
    let complaint = text(&output.stderr);
    assert!(complaint.contains("bad.toml:4"), "{complaint}");
    assert!(!folder.path().join("results").exists());
    for arguments in [
        &["run", "no-such-case"][..],
        &["run", "--method", "guess"],
        &["walk"],
    ] {
        let output = trilith(folder.path(), arguments);
        assert_eq!(output.status.code(), Some(2), "{arguments:?}");
        assert!(!output.stderr.is_empty() && output.stdout.is_empty());
    }
}

#[test]
fn list_and_show_name_the_built_in_cases() {
    let folder = tempfile::tempdir().unwrap();
    let list = text(&trilith(folder.path(), &["list"]).stdout);
    for name in ["paper-1", "paper-2", "paper-3", "macro-block", "pushover"] {
        assert!(list.contains(name), "{name} is not in\n{list}");
    }
    let show = text(&trilith(folder.path(), &["show", "paper-3"]).stdout);
    assert!(show.contains("1176 blocks, 3409 joints"), "{show}");
    let show = text(&trilith(folder.path(), &["show", "stack", "--pushover"]).stdout);
    for line in ["substep ", "contact frequency", "stated error", "√(H_c/g)"] {
        assert!(show.contains(line), "{line} is not in\n{show}");
    }
}

#[test]
fn a_recording_is_in_the_json_on_request() {
    let folder = tempfile::tempdir().unwrap();
    let run = [
        "run",
        "sliding-block",
        "--method",
        "pushover",
        "--format",
        "json",
    ];
    let rows = |arguments: &[&str]| -> serde_json::Value {
        serde_json::from_slice(&trilith(folder.path(), arguments).stdout).unwrap()
    };
    assert!(rows(&run)[0].get("recording").is_none());
    let rows = rows(&[&run[..], &["--recording"]].concat());
    let recording = &rows[0]["recording"];
    assert!(recording["interval"].as_f64().unwrap() > 0.0);
    let frames = recording["frames"].as_array().unwrap();
    assert!(frames.len() >= 10, "{} frames", frames.len());
    // The push is to the right: the block slides there and does not turn.
    let last = frames.last().unwrap()[0].as_array().unwrap();
    assert!(last[0].as_f64().unwrap() > 0.5 && last[2].as_f64().unwrap().abs() < 1e-3);
}

#[test]
fn a_program_runs_whichever_of_our_own_methods_run_beside_it() {
    let folder = tempfile::tempdir().unwrap();
    let arguments = [
        "run",
        "sliding-block",
        "--method",
        "associative",
        "--external",
        "silent=true",
        "--format",
        "csv",
    ];
    let output = trilith(folder.path(), &arguments);
    // It says nothing, which is a row and no answer.
    assert_eq!(output.status.code(), Some(1), "{}", text(&output.stderr));
    let out = text(&output.stdout);
    let rows: Vec<&str> = out.lines().skip(1).collect();
    assert!(rows[0].starts_with("sliding-block,associative,verified"));
    assert!(rows[1].starts_with("sliding-block,silent,failed"), "{out}");
}

#[test]
fn a_drawing_is_not_written_into_a_file_of_another_kind() {
    let folder = tempfile::tempdir().unwrap();
    for name in ["wall.jpg", "wall"] {
        let output = trilith(folder.path(), &["draw", "sliding-block", "-o", name]);
        assert_eq!(output.status.code(), Some(2));
        assert!(text(&output.stderr).contains("does not end in `.svg`"));
        assert!(!folder.path().join(name).exists());
    }
    let output = trilith(folder.path(), &["draw", "sliding-block", "-o", "wall.png"]);
    let said = text(&output.stderr);
    if cfg!(feature = "print") {
        assert_eq!(output.status.code(), Some(0), "{said}");
    } else {
        assert_eq!(output.status.code(), Some(2));
        assert!(said.contains("--features print"), "{said}");
    }
    let output = trilith(folder.path(), &["draw", "sliding-block", "-o", "-"]);
    assert_eq!(output.status.code(), Some(0));
    assert!(text(&output.stdout).starts_with("<svg"));
}
