//! Bad input: every complaint names the file and the line, shows the offending text, and says what
//! to write instead.

use std::fs;
use std::path::Path;

use trilith::case::{Case, collect, find};

const GOOD: &str = "\
title = \"a wall\"
unit = { length = 4.0, height = 1.75, weight = 1.0 }
courses = [\"h11h\", \"111\"]
friction = 0.65

[[references]]
method = \"associative\"
quantity = \"lambda\"
value = 0.6
tolerance = 0.001
source = \"nowhere\"
kind = \"independent\"
";

/// Changes the good case, reads it from a file, and looks for `file:line:`, the offending text and
/// the help in the complaint.
#[track_caller]
fn refused(from: &str, to: &str, line: usize, offending: &str, help: &str) {
    assert!(GOOD.contains(from), "{from:?} is not in the good case");
    refused_bytes(GOOD.replacen(from, to, 1).as_bytes(), line, offending, help);
}

#[track_caller]
fn refused_bytes(bytes: &[u8], line: usize, offending: &str, help: &str) {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("bad.toml");
    fs::write(&path, bytes).unwrap();
    let shown = find(path.to_str().unwrap()).unwrap_err().to_string();
    assert!(shown.starts_with("error: "), "{shown}");
    assert!(
        shown.contains(&format!("{}:{line}:", path.display())),
        "no line {line} in\n{shown}"
    );
    assert!(
        underlined(&shown).contains(offending),
        "{offending:?} is not underlined in\n{shown}"
    );
    let helps = shown.split("= help: ").nth(1).unwrap_or_default();
    assert!(helps.contains(help), "no help {help:?} in\n{shown}");
}

/// The source text above the carets.
fn underlined(shown: &str) -> String {
    let lines: Vec<&str> = shown.lines().collect();
    let carets = lines
        .iter()
        .position(|line| line.contains('^'))
        .unwrap_or(0);
    let from = lines[carets].find('^').unwrap_or(0);
    let count = lines[carets].matches('^').count();
    lines[carets.saturating_sub(1)]
        .chars()
        .skip(from)
        .take(count)
        .collect()
}

#[test]
fn the_good_case_is_good() {
    let case = Case::read("good.toml", GOOD.as_bytes()).unwrap();
    assert_eq!((case.name.as_str(), case.references.len()), ("good", 1));
}

#[test]
fn unknown_key() {
    refused(
        "friction",
        "frction",
        4,
        "frction",
        "did you mean `friction`?",
    );
    refused("title", "colour", 1, "colour", "the keys here are `title`");
}

#[test]
fn missing_friction() {
    refused(
        "friction = 0.65\n",
        "",
        1,
        "title = \"a wall\"",
        "add `friction = 0.65`",
    );
}

#[test]
fn missing_key_of_a_table() {
    refused(
        ", height = 1.75",
        "",
        2,
        "{ length = 4.0, weight = 1.0 }",
        "add `height = 1.75`",
    );
    refused(
        "tolerance = 0.001\n",
        "",
        6,
        "[[references]]",
        "add `tolerance = ",
    );
}

#[test]
fn duplicate_key() {
    refused(
        "friction = 0.65",
        "friction = 0.65\nfriction = 0.7",
        5,
        "friction",
        "remove one",
    );
}

#[test]
fn unknown_course_letter() {
    refused(
        "h11h",
        "h1x1h",
        3,
        "x",
        "write `1` for a unit, `h` for half a unit",
    );
}

#[test]
fn zero_count() {
    refused("h11h", "h1*0h", 3, "0", "a count of 1 or more");
}

#[test]
fn absurd_count() {
    refused(
        "h11h",
        "h1*123456789h",
        3,
        "123456789",
        "a count up to 10000",
    );
    let list = "[\"h11h\", \"111\"]";
    let huge = "[\"1*10000\", \"1*10000\"]\nrepeat = 6";
    refused(list, huge, 4, "6", "fewer or shorter courses");
}

#[test]
fn empty_courses() {
    refused("[\"h11h\", \"111\"]", "[]", 3, "[]", "from bottom to top");
    refused("\"h11h\"", "\"\"", 3, "\"\"", "write `1` for a unit");
    refused("\"h11h\"", "\"gg\"", 3, "\"gg\"", "put a unit `1`");
}

#[test]
fn bond_without_units() {
    let list = "[\"h11h\", \"111\"]";
    refused(
        list,
        "6\nbond = \"running\"",
        4,
        "\"running\"",
        "`units = 5`",
    );
    refused(
        list,
        "6",
        3,
        "6",
        "add `bond = \"running\"` and `units = 5`",
    );
}

#[test]
fn numbers_out_of_range() {
    refused("0.65", "-0.65", 4, "-0.65", "from 0 to 1e12");
    refused("0.65", "nan", 4, "nan", "from 0 to 1e12");
    refused("0.65", "inf", 4, "inf", "from 0 to 1e12");
    refused("4.0", "-inf", 2, "-inf", "from 1e-12 to 1e12");
    refused("1.75", "0", 2, "0", "from 1e-12 to 1e12");
    refused("0.001", "-0.001", 10, "-0.001", "from 1e-12 to 1e12");
}

#[test]
fn wrong_type() {
    refused("0.65", "true", 4, "true", "write a number, such as `0.65`");
    refused("0.65", "\"0.65\"", 4, "\"0.65\"", "without quotes: `0.65`");
    refused("\"a wall\"", "3", 1, "3", "put it in quotes: `\"3\"`");
    refused("[\"h11h\", \"111\"]", "6.5", 3, "6.5", "write `courses = [");
}

#[test]
fn decimal_comma() {
    refused("0.65", "0,65", 4, "0,65", "write a decimal point: `0.65`");
    refused("1.75", "1,75", 2, "1,75", "write a decimal point: `1.75`");
}

#[test]
fn unknown_word() {
    refused(
        "\"associative\"",
        "\"asociative\"",
        7,
        "\"asociative\"",
        "`method = \"associative\"`",
    );
    refused(
        "\"associative\"",
        "\"my guess\"",
        7,
        "\"my guess\"",
        "`macro-block`, `associative`",
    );
    refused(
        "\"lambda\"",
        "\"mu\"",
        8,
        "\"mu\"",
        "`lambda`, `lower`, `upper`",
    );
    let push = "friction = 0.65\npush = \"rigth\"";
    refused(
        "friction = 0.65",
        push,
        5,
        "\"rigth\"",
        "`push = \"right\"`",
    );
}

#[test]
fn not_toml() {
    refused("friction = 0.65", "just words", 4, "", "`key = value`");
    refused(
        "friction = 0.65",
        "push = right",
        4,
        "right",
        "put words in quotes: `\"right\"`",
    );
}

#[test]
fn not_utf8() {
    let mut bytes = GOOD.as_bytes().to_vec();
    let wall = GOOD.find("0.65").unwrap();
    bytes[wall] = 0xE9;
    refused_bytes(&bytes, 4, "\u{fffd}", "save the file as UTF-8");
    let shown = Case::read("a.toml", &bytes).unwrap_err().to_string();
    assert!(shown.contains("line 4, byte 12 is 0xe9"), "{shown}");
}

#[test]
fn missing_file_and_unknown_name() {
    let shown = find("no/such/wall.toml").unwrap_err().to_string();
    assert!(
        shown.contains("there is no file or folder no/such/wall.toml"),
        "{shown}"
    );
    assert!(shown.contains("help: check the path"), "{shown}");
    let shown = find("papr-1").unwrap_err().to_string();
    assert!(shown.contains("there is no case named `papr-1`"), "{shown}");
    assert!(
        shown.contains("did you mean the case `paper-1`?"),
        "{shown}"
    );
    let shown = find("cathedral").unwrap_err().to_string();
    assert!(
        shown.contains("one of `paper-1`, `paper-2`, `paper-3`"),
        "{shown}"
    );
}

#[test]
fn a_file_name_that_cannot_name_a_case() {
    let shown = Case::read("my wall@2.toml", GOOD.as_bytes()).unwrap_err();
    assert!(
        shown
            .to_string()
            .contains("rename the file to `my-wall-2.toml`")
    );
}

#[test]
fn folder_without_cases_and_file_of_another_kind() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("notes.txt"), "").unwrap();
    let shown = find(folder.path().to_str().unwrap())
        .unwrap_err()
        .to_string();
    assert!(shown.contains("there is no case in the folder"), "{shown}");
    assert!(shown.contains("trilith new NAME"), "{shown}");
    let notes = folder.path().join("notes.txt");
    let shown = find(notes.to_str().unwrap()).unwrap_err().to_string();
    assert!(shown.contains("does not end in `.toml`"), "{shown}");
}

#[test]
fn a_folder_is_read_sorted_without_hidden_files_and_each_file_once() {
    let folder = tempfile::tempdir().unwrap();
    let put = |path: &str, text: &str| {
        let path = folder.path().join(path);
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        fs::write(path, text).unwrap();
    };
    put("b.toml", GOOD);
    put("a/c.toml", GOOD);
    put(".hidden/d.toml", "broken");
    put(".e.toml", "broken");
    loop_back(folder.path());
    let top = folder.path().to_str().unwrap().to_owned();
    let one = folder.path().join("b.toml").to_str().unwrap().to_owned();
    let cases = collect(&[top, one]).unwrap();
    let names: Vec<&str> = cases.iter().map(|case| case.name.as_str()).collect();
    assert_eq!(names, ["c", "b"]);
}

/// A symbolic link from `a/up` to the top.
fn loop_back(top: &Path) {
    #[cfg(unix)]
    std::os::unix::fs::symlink(top, top.join("a/up")).unwrap();
    #[cfg(not(unix))]
    let _ = top;
}

#[test]
fn every_broken_file_and_every_name_used_twice_is_reported() {
    let folder = tempfile::tempdir().unwrap();
    for (path, text) in [
        ("one/a.toml", "friction = 0,65"),
        ("one/b.toml", "frction = 1"),
        ("one/c.toml", GOOD),
        ("two/c.toml", GOOD),
    ] {
        let path = folder.path().join(path);
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        fs::write(path, text).unwrap();
    }
    let arguments = [
        folder.path().to_str().unwrap().to_owned(),
        "nowhere".to_owned(),
    ];
    let complaints = collect(&arguments).unwrap_err();
    assert_eq!(complaints.len(), 4);
    let shown: Vec<String> = complaints.iter().map(ToString::to_string).collect();
    let all = shown.join("\n\n");
    for part in [
        "a.toml:1:12",
        "b.toml:1:1",
        "named `nowhere`",
        "two cases are named `c`",
    ] {
        assert!(all.contains(part), "no {part:?} in\n{all}");
    }
    assert!(
        all.contains("one/c.toml and ") && all.contains("two/c.toml"),
        "{all}"
    );
}
