//! `trilith check`: what it says of cases and methods, and that two runs say it in the same bytes.

use std::fs;
use std::path::Path;
use std::process::{Command, Output};

fn check(folder: &Path, arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_trilith"))
        .current_dir(folder)
        .arg("check")
        .args(arguments)
        .output()
        .expect("the program starts")
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8(bytes.to_vec()).expect("output is UTF-8")
}

/// A sliding block with the analytic value of another friction, and a deviation that is one.
const WRONG: &str = "\
unit = { length = 2.0, height = 1.0, weight = 1.0 }
courses = [\"1\"]
friction = 0.3

[[references]]
method = \"associative\"
quantity = \"lambda\"
value = 0.4
tolerance = 1e-6
source = \"sliding at another friction\"
kind = \"analytic\"

[[references]]
method = \"sequential\"
quantity = \"lambda\"
value = 0.32
tolerance = 1e-6
source = \"a misprint\"
kind = \"published\"
deviation = \"printed for another friction\"
";

#[test]
fn a_violated_value_and_a_deviation_are_listed_with_their_errors() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("wrong.toml"), WRONG).unwrap();
    let output = check(
        folder.path(),
        &["wrong.toml", "--method", "associative,sequential"],
    );
    assert_eq!(output.status.code(), Some(1));
    let out = text(&output.stdout);
    // 0.3 for 0.4 is 25 % off, for 0.32 6.25 %.
    let row = |method: &str| {
        let mut rows = out.lines().filter(|line| line.starts_with("wrong"));
        rows.find(|line| line.contains(method)).unwrap().to_owned()
    };
    assert!(row("associative").contains("25.00") && row("associative").ends_with("VIOLATED"));
    assert!(row("sequential").contains("6.25") && row("sequential").ends_with("deviates"));
    let section = |title: &str| {
        let parts: Vec<&str> = out.split("\n\n").collect();
        let found = parts.iter().find(|part| part.starts_with(title));
        found
            .unwrap_or_else(|| panic!("no {title} in\n{out}"))
            .to_string()
    };
    assert!(section("violated").contains("25.00 % off the analytic value 0.4"));
    assert!(section("known deviations").contains("printed for another friction"));
    assert!(out.ends_with("1 violated, 0 failed\n"), "{out}");
}

#[test]
fn methods_are_counted_and_two_runs_print_the_same_bytes() {
    let folder = tempfile::tempdir().unwrap();
    let arguments = ["sliding-block", "rocking-block", "stack"];
    let outputs = [(); 2].map(|()| check(folder.path(), &arguments));
    assert_eq!(outputs[0].status.code(), Some(0));
    let [out, again] = outputs.map(|output| text(&output.stdout));
    assert_eq!(out, again);
    let counts = |method: &str| -> Vec<String> {
        let (_, methods) = out.split_once("\nmethods\n").unwrap();
        let line = methods
            .lines()
            .find(|line| line.starts_with(method))
            .unwrap();
        line.split_whitespace().skip(1).map(str::to_owned).collect()
    };
    // Scenes, numbers, verified, endings, declined, undecided, failed, compared, 0.1, 1, 5 %.
    let all = ["3", "3", "3", "0", "0", "0", "0", "3", "3", "3", "3"];
    assert_eq!(counts("associative"), all);
    // The closed form declines what is no regular wall in running bond.
    assert_eq!(counts("macro-block")[..5], ["3", "0", "0", "0", "3"]);
}
