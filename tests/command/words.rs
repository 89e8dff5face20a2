//! What the program says to what people type.

use std::path::Path;
use std::process::{Command, Output};

fn trilith(folder: &Path, arguments: &[&str]) -> Output {
    let mut program = Command::new(env!("CARGO_BIN_EXE_trilith"));
    let output = program.args(arguments).current_dir(folder).output();
    output.expect("the program runs")
}

fn said(output: &Output) -> (String, String) {
    let text = |bytes: &[u8]| String::from_utf8(bytes.to_vec()).expect("it is text");
    (text(&output.stdout), text(&output.stderr))
}

#[test]
fn names_of_new_cases_are_taken_or_refused_in_words() {
    let folder = tempfile::tempdir().unwrap();
    for name in ["", "a/", ".toml"] {
        let output = trilith(folder.path(), &["new", name]);
        assert_eq!(output.status.code(), Some(2), "{name}");
        assert!(said(&output).1.contains("is no name for a case"), "{name}");
    }
    assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 0);
    let (out, _) = said(&trilith(folder.path(), &["new", "--", "-x"]));
    assert_eq!(out, "wrote -x.toml; next: trilith run ./-x.toml\n");
    let output = trilith(folder.path(), &["show", "./-x.toml"]);
    assert!(output.status.success());
}

#[test]
fn both_settings_of_head_joints_run_where_that_is_said() {
    let folder = tempfile::tempdir().unwrap();
    let run = ["run", "stack", "oppenheim-7", "--head-joints", "both"];
    let output = trilith(
        folder.path(),
        &[&run[..], &["--method", "associative", "--format", "csv"]].concat(),
    );
    let (out, _) = said(&output);
    let names: Vec<&str> = out
        .lines()
        .skip(1)
        .filter_map(|l| l.split(',').next())
        .collect();
    assert_eq!(names, ["stack", "stack@open", "oppenheim-7"]);
}

#[test]
fn titles_cannot_steer_the_terminal_and_units_are_doubted() {
    let folder = tempfile::tempdir().unwrap();
    let text = "title = \"a\\u001b[31mb\"\nfriction = 33\n[arch]\nmean_radius = 10\nthickness = 1.5\n\
                embrace = 3.14159\nvoussoirs = 9\n";
    std::fs::write(folder.path().join("a.toml"), text).unwrap();
    let (out, err) = said(&trilith(folder.path(), &["show", "a.toml"]));
    assert!(
        out.contains("a\\u{1b}[31mb") && !out.contains('\u{1b}'),
        "{out}"
    );
    assert!(
        err.contains("warning: a coefficient of friction of 33: is this an angle?"),
        "{err}"
    );
    assert!(err.contains("write `0.649` for 33 degrees"), "{err}");
    assert!(
        err.contains("an embrace of 3.14159 degrees: is this in radians?"),
        "{err}"
    );
}

#[test]
fn drawings_are_imported_run_and_exported() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let output = trilith(folder, &["export", "paper-1", "--dxf", "wall.dxf"]);
    assert!(output.status.success(), "{}", said(&output).1);
    let output = trilith(folder, &["run", "wall.dxf", "--method", "associative"]);
    assert_eq!(output.status.code(), Some(2));
    assert!(said(&output).1.contains("says nothing about friction"));
    let run = [
        "run",
        "wall.dxf",
        "--friction",
        "0.65",
        "--method",
        "associative",
        "--format",
        "csv",
    ];
    let (out, err) = said(&trilith(folder, &run));
    assert!(
        out.contains("wall,associative,verified,0.6428"),
        "{out}\n{err}"
    );
    // Without friction it is to be filled in, and until then nothing runs.
    let (out, _) = said(&trilith(folder, &["import", "wall.dxf", "-o", "mine.toml"]));
    assert!(
        out.contains("next: fill in `friction` in mine.toml"),
        "{out}"
    );
    let output = trilith(folder, &["run", "mine.toml"]);
    assert!(said(&output).1.contains("missing key `friction`"));
    let text = std::fs::read_to_string(folder.join("mine.toml")).unwrap();
    std::fs::write(
        folder.join("mine.toml"),
        text.replace("# friction", "friction"),
    )
    .unwrap();
    let run = [
        "run",
        "mine.toml",
        "--method",
        "associative",
        "--format",
        "csv",
    ];
    let (out, err) = said(&trilith(folder, &run));
    assert!(
        out.contains("mine,associative,verified,0.6428"),
        "{out}\n{err}"
    );
    // Nothing is overwritten.
    let output = trilith(folder, &["import", "wall.dxf", "-o", "mine.toml"]);
    assert_eq!(output.status.code(), Some(2));
    let (out, _) = said(&trilith(folder, &["convert", "paper-1", "--to", "blocks"]));
    assert!(
        out.starts_with("wrote paper-1-blocks.toml and paper-1-blocks.csv"),
        "{out}"
    );
}

/// A wall of ten courses with a door, a lintel and one line more.
fn wall_with_a_door(line: &str, course: &str) -> String {
    format!(
        "unit = {{ length = 0.4, height = 0.2, weight = 1.0 }}\npieces = {{ L = {{ units = 3 }} }}\n\
         courses = [\n\"111gg111\",\n\"h11hggh11h\",\n\"111gg111\",\n\"11hLh11\",\n\"{course}\"\n]\n\
         friction = 0.65\n{line}\n"
    )
}

#[test]
fn a_course_with_a_piece_too_few_is_warned_of() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("garden.toml");
    let warned = |text: String| {
        std::fs::write(&file, text).unwrap();
        let output = trilith(folder.path(), &["show", "garden.toml"]);
        assert!(output.status.success());
        said(&output).1
    };
    let short = warned(wall_with_a_door("", "h1*6h"));
    assert!(
        short.contains("course 5 is 7 units long, and all others are 8")
            && short.contains("garden.toml:8"),
        "{short}"
    );
    for course in ["h1*7h", "1*7g"] {
        assert_eq!(warned(wall_with_a_door("", course)), "", "{course}");
    }
    // Walls that step back have more courses of another length than one.
    let steps = "unit = { length = 4, height = 2, weight = 1 }\nfriction = 0.6\n\
                 courses = [\"111\", \"111\", \"11\", \"1\"]\n";
    assert_eq!(warned(steps.to_owned()), "");
}

#[test]
fn no_case_of_the_library_is_warned_of() {
    for case in trilith::case::library() {
        assert!(case.warnings.is_empty(), "{}", case.name);
    }
}

#[test]
fn who_looks_for_an_opening_or_a_file_is_told_where_it_is() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("garden.toml");
    std::fs::write(&file, wall_with_a_door("lintel = 3", "h1*7h")).unwrap();
    let (_, complaint) = said(&trilith(folder.path(), &["show", "garden.toml"]));
    assert!(
        complaint.contains("pieces = { L = { units = 3 } }"),
        "{complaint}"
    );
    let (_, complaint) = said(&trilith(folder.path(), &["show", "garden"]));
    assert!(
        complaint.contains("did you mean the file `garden.toml`?"),
        "{complaint}"
    );
}

/// A lower bound that is proved takes the place of the sentence that none is known.
#[test]
fn what_the_search_may_have_missed_is_said_beside_a_proof() {
    let folder = tempfile::tempdir().unwrap();
    let interval = |methods: &str| {
        let (out, _) = said(&trilith(
            folder.path(),
            &["run", "stack", "--method", methods],
        ));
        let lines = out.split("  interval, contact: ").nth(1);
        let line = lines.expect("it says something").split(".\n").next();
        line.expect("it ends")
            .split_whitespace()
            .collect::<Vec<_>>()
            .join(" ")
    };
    assert!(interval("interval").contains("no lower bound is proved"));
    assert_eq!(
        interval("interval,bound"),
        "the search may have missed other collapse states, but bound proves that no collapse state with \
         0 ≤ λ < 0.39999 exists in which the push does work"
    );
}

/// Of a small wall that no push collapses, although its joints need friction to carry it, that is proved and kept as a
/// certificate; of a larger one the answer says which method may prove it.
#[test]
fn that_a_wall_stands_is_proved_and_kept() {
    let folder = tempfile::tempdir().unwrap();
    let run = |arguments: &[&str]| {
        let (out, _) = said(&trilith(folder.path(), arguments));
        out.split_whitespace().collect::<Vec<_>>().join(" ")
    };
    let wall = "unit = { length = 4.0, height = 1.5, weight = 1.0 }\ncourses = [\"11\", \"h1h\", \"11\"]\n\
                friction = 0.83\nlive = { weight = [1, -2] }\n";
    std::fs::write(folder.path().join("pressed.toml"), wall).unwrap();
    let courses = "\"111\", \"h11h\", \"111\", \"h11h\", \"111\"";
    let larger = wall.replace("\"11\", \"h1h\", \"11\"", courses);
    std::fs::write(folder.path().join("larger.toml"), larger).unwrap();
    let out = run(&["run", "larger.toml", "--method", "interval"]);
    assert!(
        out.contains("which does not prove that none exists: the method `bound` may."),
        "{out}"
    );
    let proving = [
        "run",
        "pressed.toml",
        "--method",
        "interval",
        "--certificate",
        ".",
    ];
    let out = run(&proving);
    assert!(
        out.contains(
            "It stands, however hard it is pushed (head joints in contact). That is proved."
        ),
        "{out}"
    );
    let check = [
        "check",
        "pressed.toml",
        "--method",
        "associative",
        "--certificates",
        ".",
    ];
    let out = run(&check);
    let proved = "certificate pressed.right.bound: it is proved that no collapse state with λ ≥ 0 exists, but for \
                  motions against the push";
    assert!(out.contains(proved), "{out}");
    // With less friction it slides: the certificate is of another wall.
    std::fs::write(
        folder.path().join("pressed.toml"),
        wall.replace("0.83", "0.3"),
    )
    .unwrap();
    let out = run(&check);
    assert!(
        out.contains("pressed.right.bound: REFUSED: it is about another scene"),
        "{out}"
    );
}

/// A joint that a case names is what the case says: friction and head joints follow, `show` and
/// `convert` too, and one that does not exist is refused.
#[test]
fn a_case_names_its_joints() {
    let folder = tempfile::tempdir().unwrap();
    let case = |joint: &str| {
        let text = format!(
            "friction = {{ bed = 0.6, head = 0.2, base = 0.7 }}\nhead_joints = \"open\"\n[blocks]\n\
             [[support]]\nname = \"ground\"\ncorners = [[-5, -1], [9, -1], [9, 0], [-5, 0]]\n\
             [[block]]\nname = \"a\"\ncorners = [[0, 0], [1, 0], [1, 1], [0, 1]]\n\
             [[block]]\nname = \"b\"\ncorners = [[1, 0], [2, 0], [2, 1], [1, 1]]\n\
             [[block]]\nname = \"c\"\ncorners = [[0, 1], [1, 1], [1, 2], [0, 2]]\n{joint}"
        );
        std::fs::write(folder.path().join("named.toml"), text).unwrap();
        said(&trilith(folder.path(), &["show", "named.toml"]))
    };
    let joint = |one: &str, other: &str, class: &str| {
        format!("[[joint]]\nbetween = [\"{one}\", \"{other}\"]\nclass = \"{class}\"\n")
    };
    let (shown, _) = case("");
    assert!(shown.contains("head joints: a | b\n"), "{shown}");
    let (shown, _) = case(&joint("b", "a", "bed"));
    assert!(shown.contains("steep bed joints: a | b\n"), "{shown}");
    assert!(!shown.contains("\nhead joints"), "{shown}");
    for (joint, complaint) in [
        (joint("b", "c", "head"), "`b` and `c` share no joint"),
        (joint("a", "d", "head"), "unknown block `d`"),
        (joint("a", "b", "perpend"), "unknown class `perpend`"),
        (
            joint("a", "b", "bed") + &joint("b", "a", "head"),
            "is named twice",
        ),
    ] {
        let (_, said) = case(&joint);
        assert!(said.contains(complaint), "{said}");
    }
}
