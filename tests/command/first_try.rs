//! What a first try meets: help that fits a screen, near misses, and sweeps without a file.

use std::fs;
use std::path::Path;
use std::process::{Command, Output};

fn trilith(folder: &Path, arguments: &[&str]) -> Output {
    let mut program = Command::new(env!("CARGO_BIN_EXE_trilith"));
    let output = program.args(arguments).current_dir(folder).output();
    output.expect("the program runs")
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8(bytes.to_vec()).expect("it is text")
}

/// Headings of a help, in their order.
fn headings(help: &str) -> Vec<&str> {
    let own = |line: &&str| !line.starts_with(' ') && line.ends_with(':');
    help.lines().filter(own).collect()
}

#[test]
fn help_comes_in_groups_with_results_first_and_the_short_one_fits_two_screens() {
    let folder = tempfile::tempdir().unwrap();
    for (command, most) in [("run", 60), ("check", 60), ("draw", 60), ("report", 60)] {
        let short = text(&trilith(folder.path(), &[command, "-h"]).stdout);
        let lines = short.lines().count();
        assert!(lines <= most, "{command} -h has {lines} lines");
        let long = text(&trilith(folder.path(), &[command, "--help"]).stdout);
        assert!(long.lines().count() > 2 * lines, "{command}");
        for help in [&short, &long] {
            let own = headings(help);
            assert_eq!(
                own[..3],
                ["Arguments:", "Results:", "What runs:"],
                "{command}"
            );
            let results = help.split("\nResults:\n").nth(1).expect("it is there");
            let results = results.split("\nWhat runs:\n").next().expect("it is there");
            assert!(results.contains(if command == "draw" {
                "--output"
            } else {
                "--out <"
            }));
            let drawings = help.split("\nDrawings (.dxf)").nth(1).expect("it is there");
            let drawings = drawings
                .split("\nScreen and help:")
                .next()
                .expect("it is there");
            assert!(
                !drawings.contains("--out") && !drawings.contains("--format"),
                "{help}"
            );
        }
    }
}

#[test]
fn a_near_miss_of_a_command_is_suggested() {
    let folder = tempfile::tempdir().unwrap();
    for (slip, meant) in [
        ("runn", "run"),
        ("rn", "run"),
        ("draaw", "draw"),
        ("chek", "check"),
        ("swep", "sweep"),
        ("shw", "show"),
        ("lst", "list"),
        ("exprt", "export"),
        ("nwe", "new"),
    ] {
        let output = trilith(folder.path(), &[slip, "paper-1"]);
        assert_eq!(output.status.code(), Some(2));
        let said = text(&output.stderr);
        assert!(said.contains(&format!("'{meant}'")), "{slip}: {said}");
    }
    let said = text(&trilith(folder.path(), &["xylophone"]).stderr);
    assert!(!said.contains("similar"), "{said}");
}

#[test]
fn a_case_is_swept_without_a_file() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let vary = ["sweep", "stack", "--method", "associative", "--out", "out"];
    let vary = [
        &vary[..],
        &["--vary", "friction=0.2:0.4:3", "--vary", "push=right,left"],
    ]
    .concat();
    let output = trilith(folder, &vary);
    assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
    let given = fs::read_to_string(folder.join("out/sweep.csv")).unwrap();
    // The same as a file says it.
    let file = "case = \"stack\"\nmethods = [\"associative\"]\n[[vary]]\n\
                friction = { from = 0.2, to = 0.4, count = 3 }\n[[vary]]\npush = [\"right\", \"left\"]\n";
    fs::write(folder.join("same.sweep.toml"), file).unwrap();
    let output = trilith(folder, &["sweep", "same.sweep.toml", "--out", "same"]);
    assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
    assert_eq!(
        fs::read_to_string(folder.join("same/sweep.csv")).unwrap(),
        given
    );
    assert_eq!(given.lines().count(), 7, "{given}");

    // A setting is set for all points, and one kind of head joints runs.
    let one = "sweep paper-1 --method interval --out one --vary friction=0.5,0.6";
    let one: Vec<&str> = one.split(' ').collect();
    let one = [
        &one[..],
        &["--vary", "settings.starts=2", "--vary", "head_joints=open"],
    ]
    .concat();
    let output = trilith(folder, &one);
    assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
    let rows = fs::read_to_string(folder.join("one/sweep.csv")).unwrap();
    assert_eq!(rows.lines().count(), 3, "{rows}");
    assert_eq!(rows.matches("paper-1@open,").count(), 2, "{rows}");

    fs::write(
        folder.join("mine.toml"),
        "friction = 0.5\nunit = { length = 2, height = 1 }\n\
              courses = [\"11\", \"h1h\"]\n",
    )
    .unwrap();
    for (arguments, words) in [
        (
            &["sweep", "mine.toml"][..],
            "mine.toml is a case and not a sweep",
        ),
        (
            &["sweep", "paper-1"],
            "write `trilith sweep paper-1 --vary friction=0.4:0.8:5`",
        ),
        (
            &["sweep", "mine.toml", "--vary", "friction"],
            "write `KEY=FROM:TO:COUNT`",
        ),
        (
            &["sweep", "mine.toml", "--vary", "friction=1:2"],
            "write `KEY=FROM:TO:COUNT`",
        ),
        (
            &["sweep", "mine.toml", "--vary", "friction=1,,2"],
            "write `KEY=FROM:TO:COUNT`",
        ),
        (
            &["sweep", "mine.toml", "--vary", "friction=1:2:inf"],
            "write `KEY=FROM:TO:COUNT`",
        ),
        (
            &["sweep", "mine.toml", "--vary", "frction=1,2"],
            "did you mean `friction`?",
        ),
        (
            &[
                "sweep",
                "mine.toml",
                "--vary",
                "friction=1,2",
                "--method",
                "guess",
            ],
            "methods are",
        ),
        (
            &["sweep", "mien.toml", "--vary", "friction=1,2"],
            "there is no file or folder mien.toml",
        ),
        (
            &["sweep", "same.sweep.toml", "--vary", "friction=1,2"],
            "is a sweep and not a case",
        ),
        (
            &["sweep", "mine.toml", "--vary", "head_joints=shut"],
            "the words for `head_joints` are",
        ),
        (&["sweep", "mine.toml", "--method", "associative"], "--vary"),
    ] {
        let output = trilith(folder, arguments);
        let said = text(&output.stderr);
        assert_eq!(output.status.code(), Some(2), "{arguments:?}: {said}");
        assert!(said.contains(words), "{arguments:?}: {said}");
    }
}

/// A folder with a case and its accepted record.
fn recorded() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    let case = "friction = 0.5\nunit = { length = 2, height = 1 }\ncourses = [\"11\", \"h1h\"]\n";
    fs::write(folder.path().join("mine.toml"), case).unwrap();
    folder
}

#[test]
fn a_record_that_differs_is_shown_and_accepted_without_cargo() {
    let folder = recorded();
    let run = |more: &[&str]| {
        let run = [
            "run",
            "mine.toml",
            "--method",
            "associative",
            "--record",
            "records",
        ];
        let output = trilith(folder.path(), &[&run, more].concat());
        (output.status.code(), text(&output.stderr))
    };
    let (status, said) = run(&["--accept"]);
    assert_eq!(status, Some(0), "{said}");
    assert!(
        said.starts_with("the record records/mine.snap is new; and accepted"),
        "{said}"
    );
    assert_eq!(run(&[]), (Some(0), String::new()));
    let file = folder.path().join("mine.toml");
    let case = fs::read_to_string(&file).unwrap();
    fs::write(&file, case.replace("0.5", "0.4")).unwrap();
    let (status, said) = run(&[]);
    assert_eq!(status, Some(1), "{said}");
    let line = |sign: &str, number: &str| {
        let mut lines = said.lines().filter(|line| line.starts_with(sign));
        lines.any(|line| line.contains("associative") && line.contains(number))
    };
    assert!(
        line("-associative", "0.50000") && line("+associative", "0.40000"),
        "{said}"
    );
    assert!(said.contains("`--accept` takes it"), "{said}");
    assert_eq!(run(&["--accept"]).0, Some(0));
    let records: Vec<_> = fs::read_dir(folder.path().join("records"))
        .unwrap()
        .collect();
    assert_eq!(records.len(), 1, "{records:?}");
    assert_eq!(run(&[]), (Some(0), String::new()));
    let output = trilith(folder.path(), &["run", "mine.toml", "--accept"]);
    assert_eq!(output.status.code(), Some(2));
}

#[test]
fn check_prints_csv_and_json_for_programs() {
    let folder = tempfile::tempdir().unwrap();
    let stored = concat!(env!("CARGO_MANIFEST_DIR"), "/cases/certificates");
    let check = [
        "check",
        "stack",
        "--method",
        "associative",
        "--certificates",
        stored,
    ];
    let run = ["run", "stack", "--method", "associative"];
    for format in ["csv", "json"] {
        let [checked, ran] = [&check[..], &run]
            .map(|command| trilith(folder.path(), &[command, &["--format", format]].concat()));
        assert_eq!(checked.status.code(), Some(0), "{}", text(&checked.stderr));
        assert!(text(&checked.stderr).contains("certificate stack.right.bound: "));
        // But for the time.
        let fields = |output: &Output| text(&output.stdout).matches(',').count();
        assert_eq!(fields(&checked), fields(&ran), "{format}");
        assert!(!text(&checked.stdout).contains("certificate "));
    }
}

/// No method runs: in seconds, also unoptimised.
#[test]
fn certificates_alone_are_verified_without_the_methods() {
    let folder = tempfile::tempdir().unwrap();
    let stored = concat!(env!("CARGO_MANIFEST_DIR"), "/cases/certificates");
    let output = trilith(folder.path(), &["check", "--certificates", stored]);
    assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
    let out = text(&output.stdout);
    let files = fs::read_dir(stored).unwrap().count();
    assert_eq!(out.lines().count(), files, "{out}");
    assert!(
        out.lines().all(|line| line.starts_with("certificate ")),
        "{out}"
    );
    let empty = folder.path().join("none");
    fs::create_dir(&empty).unwrap();
    let output = trilith(folder.path(), &["check", "--certificates", "none"]);
    assert_eq!(output.status.code(), Some(1));
    assert!(text(&output.stdout).contains("REFUSED: it is missing"));
}
