//! All mistakes of a case in one go, a case from standard input, and weights that are left out.

use std::io::Write;
use std::path::Path;
use std::process::{Command, Output, Stdio};

/// Runs the program in a folder with this standard input.
fn fed(folder: &Path, arguments: &[&str], input: &str) -> Output {
    let mut child = Command::new(env!("CARGO_BIN_EXE_trilith"))
        .args(arguments)
        .current_dir(folder)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .expect("the program starts");
    let mut stdin = child.stdin.take().expect("it is piped");
    stdin.write_all(input.as_bytes()).expect("it is read");
    drop(stdin);
    child.wait_with_output().expect("it ends")
}

fn text(bytes: &[u8]) -> &str {
    std::str::from_utf8(bytes).expect("it is text")
}

/// Titles of the complaints about a case, each with its line.
#[track_caller]
fn complaints(case: &str) -> Vec<(String, usize)> {
    let folder = tempfile::tempdir().unwrap();
    let output = fed(folder.path(), &["show", "-"], case);
    assert_eq!(output.status.code(), Some(2), "{case}");
    let said = text(&output.stderr);
    let lines: Vec<&str> = said.lines().collect();
    let titles = lines.windows(2).filter_map(|pair| {
        let title = pair[0].strip_prefix("error: ")?;
        let place = pair[1].trim().strip_prefix("--> <stdin>:")?;
        Some((title.to_owned(), place.split(':').next()?.parse().ok()?))
    });
    let titles: Vec<_> = titles.collect();
    assert_eq!(titles.len(), said.matches("error: ").count(), "{said}");
    titles
}

const WALL: &str = "\
title = \"a wall\"
unit = { length = 4.0, height = 1.75, weight = 1.0 }
courses = [\"h1*1h\", \"11\"]
repeat = 2
friction = 0.65
head_joints = \"both\"
push = \"right\"

[[references]]
method = \"associative\"
head_joints = \"open\"
quantity = \"lambda\"
value = 0.6
tolerance = 1e-3
source = \"nowhere\"
kind = \"independent\"
";

/// Mistakes that do not come of one another: a line of the wall, what is written instead, and the
/// complaint.
const MISTAKES: [(&str, &str, &str); 14] = [
    ("title", "titel", "unknown key `titel`"),
    ("length = 4.0", "lenght = 4.0", "unknown key `lenght`"),
    ("height = 1.75", "height = -1.75", "`height` is negative"),
    ("weight = 1.0", "wieght = 1.0", "unknown key `wieght`"),
    ("repeat = 2", "repeat = 0", "`repeat` is out of range"),
    (
        "friction = 0.65",
        "friction = inf",
        "`friction` is not a finite number",
    ),
    ("\"both\"", "\"bth\"", "unknown head_joints `bth`"),
    ("\"right\"", "\"rigt\"", "unknown push `rigt`"),
    (
        "\"associative\"",
        "\"associatve\"",
        "unknown method `associatve`",
    ),
    ("\"lambda\"", "\"lamda\"", "unknown quantity `lamda`"),
    (
        "value = 0.6",
        "value = \"0.6\"",
        "expected a number, found a text in quotes",
    ),
    ("1e-3", "-1e-3", "`tolerance` is negative"),
    (
        "\"independent\"",
        "\"independnt\"",
        "unknown kind `independnt`",
    ),
    (
        "push =",
        "mortar = 3\npush =",
        "cohesion of joints is not modelled",
    ),
];

/// Every single one, every pair and all of them: each is told at its line, and nothing else is.
#[test]
fn all_mistakes_are_told_at_once_and_nothing_that_follows_from_them() {
    let all: Vec<usize> = (0..MISTAKES.len()).collect();
    let pairs = all.iter().flat_map(|&a| (0..a).map(move |b| vec![b, a]));
    for chosen in pairs
        .chain(all.iter().map(|&one| vec![one]))
        .chain([all.clone()])
    {
        let mut case = WALL.to_owned();
        for &mistake in &chosen {
            let (sound, written, _) = MISTAKES[mistake];
            assert!(case.contains(sound), "{sound}");
            case = case.replacen(sound, written, 1);
        }
        let expected = |&mistake: &usize| {
            let (_, written, title) = MISTAKES[mistake];
            let at = case.find(written).expect("it was put there");
            (title.to_owned(), 1 + case[..at].matches('\n').count())
        };
        let mut expected: Vec<_> = chosen.iter().map(expected).collect();
        let mut told = complaints(&case);
        told.sort();
        expected.sort();
        assert_eq!(told, expected, "{case}");
    }
}

/// What is missing because of a slip is not told, and what cannot be read on ends the list.
#[test]
fn what_follows_from_a_mistake_is_left_out() {
    let titles = |case: &str| -> Vec<String> {
        complaints(case)
            .into_iter()
            .map(|(title, _)| title)
            .collect()
    };
    let angle = WALL.replace("friction = 0.65", "friction_angle = 33");
    assert_eq!(titles(&angle), ["unknown key `friction_angle`"]);
    let word = WALL.replace("0.65", "abc").replace("4.0", "4,0");
    assert_eq!(
        titles(&word),
        [
            "a number with a decimal comma",
            "not TOML: string values must be quoted, expected literal string"
        ]
    );
    let empty = WALL
        .replace("\"11\"", "\"gg\"")
        .replace("\"rigt\"", "\"right\"");
    assert_eq!(titles(&empty).len(), 1);
    let many: String = (0..60).map(|key| format!("strange{key} = 1\n")).collect();
    assert_eq!(titles(&format!("{many}{WALL}")).len(), 20);
}

#[test]
fn a_case_comes_from_standard_input() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let run = ["run", "-", "--method", "associative", "--format", "csv"];
    let output = fed(folder, &run, WALL);
    assert!(text(&output.stdout).contains("\nstdin,associative,verified,"));
    for arguments in [
        &["check", "-", "--method", "associative"][..],
        &["draw", "-", "--method", "associative", "-o", "-"],
        &["show", "-"],
        &["export", "-", "--head-joints", "open"],
        &["convert", "-", "--to", "blocks", "-o", "blocks.toml"],
    ] {
        let output = fed(folder, arguments, WALL.split("[[").next().unwrap());
        let said = text(&output.stderr);
        assert_eq!(output.status.code(), Some(0), "{arguments:?}: {said}");
        let written = arguments[0] == "convert" && folder.join("blocks.toml").exists();
        assert!(written || !output.stdout.is_empty(), "{arguments:?}");
    }
    // A file that it names lies in the folder that the program works in.
    let output = fed(
        folder,
        &["show", "-"],
        &std::fs::read_to_string(folder.join("blocks.toml")).unwrap(),
    );
    assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
    let output = fed(folder, &["run", "-"], "");
    assert_eq!(output.status.code(), Some(2));
    assert!(text(&output.stderr).contains("missing key"), "{output:?}");
}

#[test]
fn the_weight_of_a_unit_may_be_left_out_where_nothing_else_is_a_force() {
    let folder = tempfile::tempdir().unwrap();
    let run = |case: &str| {
        let run = ["run", "-", "--method", "associative", "--format", "json"];
        fed(folder.path(), &run, case)
    };
    let lambda = |output: &Output| -> (f64, serde_json::Value) {
        let rows: serde_json::Value = serde_json::from_slice(&output.stdout).expect("JSON");
        let unit = rows[0]["conclusion"]["unit_of_force"].clone();
        (rows[0]["lower"].as_f64().expect("a number"), unit)
    };
    let without = |case: &str| case.replace(", weight = 1.0", "");
    for wall in [WALL.to_owned(), format!("overburden = 0.5\n{WALL}")] {
        let heavy = wall.replace("weight = 1.0", "weight = 37.5");
        let (heavy, unit) = lambda(&run(&heavy));
        assert_eq!(unit, serde_json::Value::Null);
        let (none, unit) = lambda(&run(&without(&wall)));
        assert!((heavy - none).abs() < 1e-9 * heavy, "{heavy} {none}");
        assert_eq!(unit, "weight of a unit");
    }
    let shown = run(&without(WALL));
    let line = text(&shown.stdout);
    assert!(line.contains("times the weight of a unit") || line.contains("unit_of_force"));
    let bare = without(WALL);
    for (more, what) in [
        (
            "[[load]]\nblock = \"course 1 piece 1\"\nlive = [1.0, 0.0]\n",
            "a load",
        ),
        (
            "[[block]]\ncourse = 1\npiece = 1\nweight = 3\n",
            "the weight of a block",
        ),
        (
            "[[move]]\nunits = \"1\"\ndirection = [0.0, -1.0]\nmoves = \"away\"\n",
            "the reaction",
        ),
        (
            "[pieces]\nL = { units = 2, weight = 3 }\n",
            "the weight of a piece",
        ),
    ] {
        let output = run(&format!("{bare}{more}"));
        let said = text(&output.stderr);
        assert_eq!(output.status.code(), Some(2), "{more}: {said}");
        assert!(said.contains("missing key `weight`"), "{said}");
        assert!(
            said.contains("add `weight = 1.0`, that of one unit"),
            "{said}"
        );
        assert!(said.contains(what), "{said}");
    }
}

/// λ over it stands in the line that comes first, in JSON, in CSV and in the table.
#[test]
fn a_demand_gives_lambda_over_it() {
    let folder = tempfile::tempdir().unwrap();
    let wall = WALL.split("[[").next().unwrap();
    let run = |demand: &str, methods: &str, more: &[&str]| {
        let run = ["run", "-", "--method", methods];
        let case = wall.replace("push =", &format!("demand = {demand}\npush ="));
        let output = fed(folder.path(), &[&run, more].concat(), &case);
        assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
        text(&output.stdout).to_owned()
    };
    let json = run("0.25", "interval", &["--format", "json"]);
    let rows: serde_json::Value = serde_json::from_str(&json).expect("JSON");
    let short = &rows[0]["in_short"];
    let lambda = short["lambda"].as_f64().expect("a number");
    assert_eq!(short["demand"], 0.25);
    let times = short["over_demand"].as_f64().expect("a number");
    assert!((times - lambda / 0.25).abs() < 1e-8, "{times} {lambda}");
    for row in rows.as_array().expect("a list") {
        let (lower, over) = (row["lower"].as_f64(), row["over_demand"].as_f64());
        let [lower, over] = [lower, over].map(|number| number.expect("a number"));
        assert!((over - lower / 0.25).abs() < 1e-8, "{row}");
    }
    // Never rounded up.
    let floor = |demand: f64| {
        format!(
            "{:.2}",
            (100.0 * (1e5 * lambda).round() / 1e5 / demand).floor() / 100.0
        )
    };
    let table = run("0.25", "interval", &[]);
    assert!(
        table.contains(&format!(
            "That is {} times the demand of 0.25.",
            floor(0.25)
        )),
        "{table}"
    );
    assert!(table.contains("/ demand"), "{table}");
    let csv = run("0.25", "interval", &["--format", "csv"]);
    assert!(
        csv.lines().next().unwrap().ends_with(",over_demand"),
        "{csv}"
    );
    let weak = run("1.5", "interval", &[]);
    let words = format!(
        "That falls short of the demand of 1.5: it is only {} times the demand.",
        floor(1.5)
    );
    assert!(weak.contains(&words), "{weak}");
    assert!(run("0.25", "associative", &[]).contains("That is at most "));
}

#[test]
fn a_demand_is_a_positive_number_and_asks_for_a_push() {
    let with = |demand: &str| WALL.replace("push =", &format!("demand = {demand}\npush ="));
    for (written, title) in [
        ("0", "`demand` is zero"),
        ("-1", "`demand` is negative"),
        ("\"0.25\"", "expected a number, found a text in quotes"),
    ] {
        assert_eq!(complaints(&with(written)), [(title.to_owned(), 7)]);
    }
    let moving = "[[move]]\nunits = \"1\"\ndirection = [0.0, -1.0]\nmoves = \"away\"\n";
    let case = with("0.25").replace("[[references]]", &format!("{moving}[[references]]"));
    let told = complaints(&case);
    assert!(
        told.iter()
            .any(|(title, _)| title == "a demand, and a support that moves"),
        "{told:?}"
    );
}

/// A list is not told what belongs into another key's list.
#[test]
fn a_list_in_place_of_a_table_is_told_what_to_write() {
    let unit = "{ length = 4.0, height = 1.75, weight = 1.0 }";
    let case = WALL.replace(unit, "[4.0, 1.75]");
    let title = "expected a table of the unit's size, found a list".to_owned();
    assert_eq!(complaints(&case), [(title, 2)]);
    let folder = tempfile::tempdir().unwrap();
    let said = fed(folder.path(), &["show", "-"], &case).stderr;
    let help = format!("help: write `unit = {unit}`");
    assert!(text(&said).contains(&help), "{}", text(&said));
}

/// Texts in which a few bytes are others, have gone or come twice: read without a panic, complaints in
/// the order of their lines, and none of them twice.
#[test]
fn whatever_is_written_is_read_or_complained_of_once() {
    let templates = [
        WALL,
        include_str!("../../cases/examples/portal.toml"),
        include_str!("../../cases/limits/point-load-top.toml"),
    ];
    let mut seed = 34_u64;
    let mut random = |below: usize| {
        seed = seed
            .wrapping_mul(6364136223846793005)
            .wrapping_add(1442695040888963407);
        (seed >> 33) as usize % below
    };
    let others: Vec<char> = "[]{}\"'=,.#-0x1e\n \u{e9}".chars().collect();
    let mut several = 0;
    for round in 0..600 {
        let mut text: Vec<char> = templates[round % templates.len()].chars().collect();
        for _ in 0..1 + random(4) {
            let at = random(text.len());
            match random(3) {
                0 => text[at] = others[random(others.len())],
                1 => drop(text.remove(at)),
                _ => text.insert(at, text[at]),
            }
        }
        let text: String = text.into_iter().collect();
        let Err(complaint) = trilith::case::Case::read("a.toml", text.as_bytes()) else {
            continue;
        };
        let shown = complaint.to_string();
        let parts: Vec<&str> = shown.split("\n\n").collect();
        several += usize::from(parts.len() > 1);
        for (place, part) in parts.iter().enumerate() {
            assert!(part.starts_with("error: "), "{text}\n{shown}");
            assert!(!parts[..place].contains(part), "{text}\n{shown}");
        }
    }
    assert!(several > 30, "{several}");
}
