//! Screens of 80 and 120 columns: nothing is wider, and the numbers are those of the CSV.

use std::fs;
use std::path::Path;
use std::process::{Command, Output};

use unicode_width::UnicodeWidthStr;

const WIDTHS: [usize; 2] = [80, 120];

fn trilith(folder: &Path, arguments: &[&str]) -> Output {
    let mut program = Command::new(env!("CARGO_BIN_EXE_trilith"));
    let output = program.args(arguments).current_dir(folder).output();
    output.expect("the program runs")
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8(bytes.to_vec()).expect("it is text")
}

/// What a command prints on a screen of this width: to standard output, and to standard error.
fn screen(width: usize, arguments: &[&str]) -> (String, String) {
    let folder = tempfile::tempdir().unwrap();
    let width = width.to_string();
    let output = trilith(folder.path(), &[arguments, &["--width", &width]].concat());
    (text(&output.stdout), text(&output.stderr))
}

#[track_caller]
fn assert_fits(screen: &str, width: usize) {
    assert!(!screen.trim().is_empty());
    for line in screen.lines() {
        assert!(line.width() <= width, "{} columns: {line}", line.width());
    }
}

const RUN: [&str; 7] = [
    "run",
    "paper-1",
    "--starts",
    "2",
    "--method",
    "macro-block,associative,sequential,interval",
    "--head-joints=both",
];

/// The cells of the lines of answers: method, joints, and what follows.
fn answers(screen: &str) -> Vec<Vec<String>> {
    let lines = screen
        .lines()
        .skip_while(|line| !line.starts_with("method"));
    let lines = lines.skip(1).take_while(|line| !line.starts_with(' '));
    let cells = |line: &str| {
        let cells = line.split("  ").map(str::trim).filter(|c| !c.is_empty());
        cells.map(str::to_owned).collect()
    };
    lines.map(cells).collect()
}

/// A number of the CSV with as many decimals as the screen shows.
fn rounded(number: &str, shown: &str) -> String {
    let decimals = shown.split_once('.').map_or(0, |(_, digits)| digits.len());
    format!("{:.decimals$}", number.parse::<f64>().unwrap())
}

#[test]
fn a_run_fits_and_its_numbers_are_those_of_the_csv() {
    let folder = tempfile::tempdir().unwrap();
    let csv = trilith(folder.path(), &[&RUN[..], &["--format", "csv"]].concat());
    let csv = text(&csv.stdout);
    let mut reader = csv::Reader::from_reader(csv.as_bytes());
    let headings = reader.headers().unwrap().clone();
    let rows: Vec<csv::StringRecord> = reader.records().map(Result::unwrap).collect();
    let cell = |row: &csv::StringRecord, name: &str| {
        let at = headings.iter().position(|heading| heading == name).unwrap();
        row[at].to_owned()
    };
    for width in WIDTHS {
        let (screen, complaints) = screen(width, &RUN);
        assert_eq!(complaints, "");
        assert_fits(&screen, width);
        let lines = answers(&screen);
        assert_eq!(lines.len(), rows.len(), "{screen}");
        for (line, row) in lines.iter().zip(&rows) {
            assert_eq!(line[0], cell(row, "method"));
            let open = cell(row, "case").ends_with("@open");
            assert_eq!(line[1], if open { "open" } else { "contact" });
            let ends: Vec<&str> = line[2].split(" - ").collect();
            assert_eq!(rounded(&cell(row, "lower"), ends[0]), ends[0]);
            let upper = ends[ends.len() - 1];
            assert_eq!(rounded(&cell(row, "upper"), upper), upper);
            for name in ["status", "verdict"] {
                assert!(line.contains(&cell(row, name)), "{name}: {line:?}");
            }
        }
        let closing = "\nanswer\n  contact   λ = ";
        assert!(screen.contains(closing) && screen.contains("the ground tilt by"));
        assert_eq!(screen.contains("tan β"), width == 120, "{screen}");
    }
    // Lines of any length: the table of the record.
    let wide = trilith(folder.path(), &[&RUN[..], &["--wide"]].concat());
    let piped = trilith(folder.path(), &RUN);
    assert_eq!(wide.stdout, piped.stdout);
    assert!(text(&wide.stdout).contains("tan beta"));
}

#[test]
fn checks_and_lists_fit() {
    let check = ["check", "stack", "block-both", "--method", "associative"];
    let show = ["show", "paper-3", "--pushover"];
    let stored = concat!(env!("CARGO_MANIFEST_DIR"), "/cases/certificates");
    let certified = [&check[..], &["--certificates", stored]].concat();
    for width in WIDTHS {
        for command in [&check[..], &certified, &show, &["list"]] {
            assert_fits(&screen(width, command).0, width);
        }
    }
    let (narrow, _) = screen(80, &check);
    for word in ["methods\n", "1 cases, ", "2 cases, ", "computed"] {
        assert_eq!(narrow.contains(word), word != "1 cases, ", "{narrow}");
    }
}

#[test]
fn sweeps_fit() {
    let folder = tempfile::tempdir().unwrap();
    let sweep = "title = \"small\"\nmethods = [\"associative\", \"macro-block\"]\ncase = \"paper-1\"\n\
                 [[vary]]\nfriction = [0.4, 0.5, 0.6]\n";
    fs::write(folder.path().join("small.sweep.toml"), sweep).unwrap();
    for width in WIDTHS {
        let width_text = width.to_string();
        let run = [
            "sweep",
            "small.sweep.toml",
            "--out",
            "out",
            "--width",
            &width_text,
        ];
        assert_fits(&text(&trilith(folder.path(), &run).stdout), width);
    }
}

/// The commands that the help names.
fn commands() -> Vec<String> {
    let (help, _) = screen(80, &["--help"]);
    let lines = help.lines().skip_while(|line| *line != "Commands:").skip(1);
    let lines = lines.take_while(|line| !line.is_empty());
    let named = lines.filter(|line| line.starts_with("  ") && !line.starts_with("   "));
    let names = named.filter_map(|line| line.split_whitespace().next());
    names.map(str::to_owned).collect()
}

#[test]
fn the_help_of_every_command_fits() {
    let folder = tempfile::tempdir().unwrap();
    let commands = commands();
    assert!(commands.len() >= 15, "{commands:?}");
    assert_fits(&text(&trilith(folder.path(), &["--help"]).stdout), 80);
    for command in commands.iter().filter(|command| *command != "help") {
        for help in ["-h", "--help"] {
            let help = text(&trilith(folder.path(), &[command, help]).stdout);
            assert_fits(&help, 80);
        }
    }
}

#[test]
fn complaints_fit() {
    let folder = tempfile::tempdir().unwrap();
    let long = "a wall of many words ".repeat(12);
    let case = format!("title = \"{long}\" friction = 1\n");
    fs::write(folder.path().join("bad.toml"), case).unwrap();
    fs::write(folder.path().join("key.toml"), "frction = 0.5\n").unwrap();
    let commands = [
        &["run", "bad.toml"][..],
        &["run", "key.toml"],
        &["run", "paper-1", "--method", "no-such-method"],
        &[
            "run",
            "no-such-case-among-those-that-are-built-in-or-in-this-folder",
        ],
        &["run", "paper-1", "--friction", "0.5"],
        &["run", "paper-1", "--states"],
    ];
    for width in WIDTHS {
        for command in commands {
            let width_text = width.to_string();
            let output = trilith(
                folder.path(),
                &[command, &["--width", &width_text]].concat(),
            );
            assert_eq!(output.status.code(), Some(2), "{command:?}");
            assert_fits(&text(&output.stderr), width);
        }
    }
}

/// A text without the codes that colour it.
fn plain(text: &str) -> String {
    let mut parts = text.split('\u{1b}');
    let mut plain = parts.next().unwrap_or_default().to_owned();
    for part in parts {
        plain.push_str(part.split_once('m').map_or("", |(_, rest)| rest));
    }
    plain
}

#[test]
fn colours_change_nothing_else_and_are_for_terminals_alone() {
    let folder = tempfile::tempdir().unwrap();
    let run = ["run", "stack", "--method", "associative", "--width", "80"];
    let printed =
        |color: &[&str]| text(&trilith(folder.path(), &[&run[..], color].concat()).stdout);
    let (never, always) = (
        printed(&["--color", "never"]),
        printed(&["--color", "always"]),
    );
    assert!(always.contains("\u{1b}[32mholds\u{1b}[0m"), "{always:?}");
    assert_eq!(plain(&always), never);
    assert_eq!(printed(&[]), never, "a pipe has no colours");
    let refused = trilith(folder.path(), &["run", "none-such", "--color", "always"]);
    let refused = text(&refused.stderr);
    assert!(refused.contains("\u{1b}[31merror:"), "{refused:?}");
}

/// The λ that governs stands first on the screen, with its head joints and its side, and it is that of the
/// JSON: the smallest over both settings and both sides.
#[test]
fn what_governs_stands_first() {
    let folder = tempfile::tempdir().unwrap();
    let names = [
        "paper-1",
        "openings-3",
        "buttress",
        "battered-wall",
        "gable",
        "portal",
        "triangle-both",
        "slope-both",
        "trilith",
        "oppenheim-7",
    ];
    let methods = ["--starts", "1", "--method", "associative,interval"];
    let run = |further: &[&str]| {
        let all = [&["run"][..], &names, &methods, further].concat();
        text(&trilith(folder.path(), &all).stdout)
    };
    let rows: Vec<serde_json::Value> = serde_json::from_str(&run(&["--format", "json"])).unwrap();
    for width in ["80", "120"] {
        let shown = run(&["--width", width]);
        let mut seen = 0;
        for name in names {
            let begin = format!("{name}: ");
            let mut cases = shown.split("\n\n").filter(|case| case.starts_with(&begin));
            let case = cases.next().expect("the case is there");
            let (first, _) = case.split_once("method ").expect("a table follows");
            let words: Vec<&str> = first.split_whitespace().collect();
            let of_case = |row: &&serde_json::Value| {
                let row = row["case"].as_str().unwrap();
                row == name || row.strip_suffix("@open") == Some(name)
            };
            let in_short = &rows.iter().find(of_case).unwrap()["in_short"];
            let said = in_short["text"].as_str().unwrap();
            let said: Vec<&str> = said.split_whitespace().collect();
            assert!(words.ends_with(&said), "{words:?}\n{said:?}");
            let states = rows
                .iter()
                .filter(of_case)
                .filter(|row| row["method"] == "interval");
            let least = states.filter_map(|row| row["lower"].as_f64());
            let least = least.fold(f64::INFINITY, f64::min);
            let lambda = in_short["lambda"].as_f64().unwrap();
            // Where settings differ by rounding alone, the first of them governs.
            assert!(
                (lambda - least).abs() <= 1e-8 * least,
                "{name}: {lambda} and {least}"
            );
            assert!(said.contains(&format!("{lambda:.5}").as_str()), "{said:?}");
            seen += 1;
        }
        assert_eq!(seen, names.len());
    }
    let pages = [
        &["report"][..],
        &names,
        &methods,
        &["--page", "--out", "pages"],
    ]
    .concat();
    trilith(folder.path(), &pages);
    let pages = fs::read_to_string(folder.path().join("pages/page.html")).unwrap();
    let pages: Vec<&str> = pages.split("<section class=\"case\"").skip(1).collect();
    assert_eq!(pages.len(), names.len());
    for (name, page) in names.iter().zip(pages) {
        let drawing =
            text(&trilith(folder.path(), &["draw", name, "--starts", "1", "-o", "-"]).stdout);
        let in_short = &rows
            .iter()
            .find(|row| row["case"].as_str().unwrap().starts_with(name))
            .unwrap()["in_short"];
        let of = |key: &str| in_short[key].as_str().unwrap();
        let lambda = format!("{:.5}", in_short["lambda"].as_f64().unwrap());
        let (said, _) = of("text").split_once(". ").unwrap();
        assert!(
            page.contains(said) && page.contains("<svg"),
            "{name}: {said}"
        );
        // The first drawing is that of the answer.
        let first = &page[page.find("<svg").unwrap()..page.find("</svg>").unwrap()];
        for svg in [drawing.as_str(), first] {
            assert!(svg.contains(&lambda), "{name}: {lambda} in {svg}");
            if said.contains("head joints") {
                let joints = format!(
                    "head joints {}",
                    of("head_joints").replace("contact", "in contact")
                );
                assert!(svg.contains(&joints), "{name}: {joints} in {svg}");
            }
            if !said.contains("either side") {
                let push = format!("pushed to the {}", of("push"));
                assert!(svg.contains(&push), "{name}: {push} in {svg}");
            }
        }
    }
}
