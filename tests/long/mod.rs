//! Commands that run long enough to be ended, the moments at which they are, and what must be left.

use std::fs;
use std::os::unix::process::ExitStatusExt;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Output, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};

/// A command with `--out out`, run in a folder of its own.
pub struct Long {
    /// The subcommand.
    pub name: &'static str,
    arguments: Vec<String>,
    /// Its table, and whether that ends up with a row a line of the journal.
    table: &'static str,
    row_a_line: bool,
}

impl Long {
    pub fn of(name: &'static str, arguments: &[&str]) -> Self {
        let (table, row_a_line) = match name {
            "chart" => ("chart.csv", false),
            "atlas" => ("atlas.csv", true),
            "sweep" => ("sweep.csv", true),
            _ => ("results.csv", true),
        };
        Self {
            name,
            arguments: arguments.iter().map(|&word| word.to_owned()).collect(),
            table,
            row_a_line,
        }
    }

    /// The command behind another program, such as `nohup`.
    pub fn begun_by(&self, program: &str, folder: &Path) -> Command {
        fs::write(folder.join("small.sweep.toml"), SWEEP).unwrap();
        let mut command = Command::new(program);
        // Whoever runs the tests may ignore SIGHUP, which the program would inherit; GNU's env does not.
        if program == "env" && cfg!(target_os = "linux") {
            command.arg("--default-signal=HUP,INT,TERM");
        }
        command.arg(env!("CARGO_BIN_EXE_trilith"));
        command
            .arg(self.name)
            .args(&self.arguments)
            .args(["--out", "out"]);
        command.current_dir(folder);
        // One row after the other, so that there is something between them.
        command.env("RAYON_NUM_THREADS", "1");
        command.stdout(Stdio::piped()).stderr(Stdio::piped());
        command
    }

    /// Begins the command with the signals as a shell's foreground has them, also where the tests
    /// run in the background.
    pub fn start(&self, folder: &Path) -> Child {
        let mut env = self.begun_by("env", folder);
        env.spawn().expect("the program starts")
    }

    /// The journal.
    pub fn journal(&self, folder: &Path) -> PathBuf {
        folder.join(format!("out/{}.journal", self.name))
    }

    /// Rows in the journal; none once it is gone.
    pub fn finished(&self, folder: &Path) -> usize {
        let bytes = fs::read(self.journal(folder)).unwrap_or_default();
        bytes.iter().filter(|&&byte| byte == b'\n').count()
    }

    /// Ends the command by signals, one at once after the other, when so many more rows are finished
    /// and so many microseconds later; or lets it end before.
    pub fn ended(&self, folder: &Path, rows: usize, micros: usize, signals: &[&str]) -> Ended {
        let mut child = self.start(folder);
        let wanted = || self.finished(folder) >= rows;
        wait_for(&mut child, wanted);
        // Not to wait for anything, but to choose a moment within a row.
        sleep(Duration::from_micros(micros as u64));
        let finished = self.finished(folder);
        signals.iter().for_each(|signal| send(&child, signal));
        let output = child.wait_with_output().expect("it ends");
        Ended { finished, output }
    }

    /// Microseconds that the command takes, of which moments are chosen.
    pub fn duration(&self) -> usize {
        let began = Instant::now();
        self.whole();
        began.elapsed().as_micros() as usize
    }

    /// The folder of a run that nothing interrupts.
    pub fn whole(&self) -> tempfile::TempDir {
        let folder = tempfile::tempdir().unwrap();
        let output = self.start(folder.path()).wait_with_output().unwrap();
        assert!(
            output.status.code().is_some_and(|code| code < 2),
            "{output:?}"
        );
        folder
    }

    /// Runs to the end what was ended, and holds its files against those of one go.
    pub fn assert_goes_on_as(&self, folder: &Path, whole: &tempfile::TempDir) {
        let output = self.start(folder).wait_with_output().unwrap();
        let said = String::from_utf8_lossy(&output.stderr);
        assert!(output.status.code().is_some_and(|code| code < 2), "{said}");
        let mut compared = 0;
        for entry in fs::read_dir(whole.path().join("out")).unwrap() {
            let name = entry.unwrap().file_name().into_string().unwrap();
            let known = TIMELESS.iter().find(|(known, _)| *known == name);
            let there = whole.path().join("out").join(&name);
            let here = folder.join("out").join(&name);
            let timeless = known.map_or(text as fn(&Path) -> String, |(_, timeless)| *timeless);
            assert_eq!(timeless(&here), timeless(&there), "{} {name}", self.name);
            compared += 1;
        }
        assert!(compared > 1, "{}", self.name);
        assert_eq!(self.journal(folder).exists(), self.name == "sweep");
    }
}

/// How a command ended.
pub struct Ended {
    /// Rows that it had finished before it was told to.
    pub finished: usize,
    output: Output,
}

impl Ended {
    /// Whether it ended before its work was done.
    pub fn was_early(&self) -> bool {
        self.status().is_none_or(|code| code > 127)
    }

    /// The exit status as a shell has it: a signal that comes before the program has even begun ends
    /// it without a word.
    fn status(&self) -> Option<i32> {
        let status = self.output.status;
        status.code().or(status.signal().map(|signal| 128 + signal))
    }

    /// Every row that was finished is in the table, which says that it is partial, as does what was
    /// printed; or all is there.
    pub fn assert_sound(&self, command: &Long, folder: &Path, signals: &[&str]) {
        let said = String::from_utf8_lossy(&self.output.stderr);
        let printed = String::from_utf8_lossy(&self.output.stdout);
        let what = format!(
            "{} {signals:?} after {}: {said}",
            command.name, self.finished
        );
        let table = folder.join("out").join(command.table);
        let text = fs::read_to_string(&table).unwrap_or_default();
        let status = self.status();
        if !self.was_early() {
            assert!(status.is_some_and(|code| code < 2), "{status:?} {what}");
            assert!(!text.is_empty() && !text.contains("PARTIAL"), "{what}");
            return;
        }
        let expected = signals.iter().map(|signal| match *signal {
            "HUP" => 129,
            "INT" => 130,
            _ => 143,
        });
        assert!(
            expected.into_iter().any(|code| status == Some(code)),
            "{status:?} {what}"
        );
        if self.finished == 0 && text.is_empty() {
            return;
        }
        assert!(!text.is_empty(), "no {}; {what}", command.table);
        let lines = text.lines().count();
        let mark = text.lines().last().unwrap_or_default();
        // All may have been finished by then.
        if mark.contains("PARTIAL") {
            assert!(
                mark.starts_with("\"# PARTIAL: interrupted by SIG"),
                "{mark}"
            );
            assert!(printed.contains("PARTIAL"), "{what}");
            for file in ["results.json", "report.html", "chart.svg"] {
                let path = folder.join("out").join(file);
                assert!(!path.exists() || fs::read_to_string(path).unwrap().contains("PARTIAL"));
            }
        }
        let rows = lines - 1 - usize::from(mark.contains("PARTIAL"));
        let needed = if command.row_a_line { self.finished } else { 1 };
        assert!(rows >= needed, "{rows} rows of {needed}; {what}");
    }
}

/// Waits until `reached`, or until the program has ended, a minute at most.
pub fn wait_for(child: &mut Child, reached: impl Fn() -> bool) {
    for _ in 0..60_000 {
        if reached() || child.try_wait().expect("it is a child").is_some() {
            return;
        }
        sleep(Duration::from_millis(1));
    }
    panic!("nothing happened for a minute");
}

/// Sends a signal of this name.
pub fn send(child: &Child, signal: &str) {
    // It may have ended by now.
    let _ = Command::new("kill")
        .args([format!("-{signal}"), child.id().to_string()])
        .stderr(Stdio::null())
        .status()
        .expect("there is a kill");
}

/// Moments that a seed determines: a linear congruence (Knuth's MMIX).
pub struct Moments(u64);

impl Moments {
    pub fn new(seed: u64) -> Self {
        println!("seed {seed}");
        Self(seed)
    }

    pub fn below(&mut self, end: usize) -> usize {
        self.0 = self
            .0
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) as usize % end.max(1)
    }
}

const SWEEP: &str = r#"
title = "A small sweep"
methods = ["associative", "interval"]
case = "stack"
[[vary]]
friction = { from = 0.4, to = 0.8, count = 24 }
"#;

/// Every command that is long, on scenes of a few blocks.
pub fn small() -> Vec<Long> {
    let methods = ["--method", "associative", "interval", "pushover"];
    let cases = ["stack", "oppenheim-7", "column-2"];
    let with = |more: &[&'static str]| [more, &methods].concat();
    vec![
        Long::of("run", &with(&cases)),
        Long::of("check", &with(&cases)),
        Long::of("report", &with(&cases[..2])),
        Long::of("sweep", &["small.sweep.toml"]),
        Long::of("chart", &["stack"]),
    ]
}

/// The same, of many rows of a few milliseconds each, with the atlas.
pub fn long() -> Vec<Long> {
    let methods = [
        "--method",
        "associative",
        "sequential",
        "interval",
        "pushover",
    ];
    let cases = [
        "block-both",
        "block-cube-rocks",
        "block-cube-slides",
        "block-flat",
        "block-slender",
        "line-load",
        "overhang-rocks",
        "point-load-low",
        "rocking-block",
        "sliding-block",
        "slope-both",
        "slope-rocks",
        "slope-slides",
        "trapezoid-rocks",
        "triangle-left",
        "column-2",
        "column-slides",
        "column-squat-slides",
        "column-tapered",
        "stack",
        "trilith",
        "oppenheim-7",
    ];
    let all = [&cases[..], &methods].concat();
    vec![
        Long::of("run", &all),
        Long::of("check", &all),
        Long::of("report", &all),
        Long::of("sweep", &["small.sweep.toml"]),
        Long::of("chart", &["stack", "oppenheim-7"]),
        Long::of("atlas", &[]),
    ]
}

fn text(path: &Path) -> String {
    fs::read_to_string(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

type Timeless = fn(&Path) -> String;

/// The files that hold times, and what is left of each without them.
pub const TIMELESS: [(&str, Timeless); 8] = [
    ("results.csv", |path| without_columns(path, &["seconds"])),
    ("results.json", |path| without_lines(path, "\"seconds\"")),
    ("chart.csv", |path| {
        without_columns(path, &["seconds", "runs"])
    }),
    ("summary.csv", |path| without_columns(path, &["seconds"])),
    ("times.csv", |path| without_columns(path, &["seconds"])),
    // Points lie where their times are.
    ("chart.svg", |_| String::new()),
    // The page tells times in its tables; its text is in results.csv and the records.
    ("report.html", |_| String::new()),
    ("sweep.journal", |_| String::new()),
];

fn without_columns(path: &Path, names: &[&str]) -> String {
    let mut reader = csv::Reader::from_path(path).unwrap();
    let headings = reader.headers().unwrap().clone();
    let kept = |row: &csv::StringRecord| {
        let cells = headings
            .iter()
            .zip(row)
            .filter(|(name, _)| !names.contains(name));
        cells
            .map(|(_, cell)| cell.to_owned())
            .collect::<Vec<_>>()
            .join("|")
    };
    let rows = reader.records().map(|row| kept(&row.unwrap()));
    rows.collect::<Vec<_>>().join("\n")
}

fn without_lines(path: &Path, word: &str) -> String {
    let text = text(path);
    let lines = text.lines().filter(|line| !line.contains(word));
    lines.collect::<Vec<_>>().join("\n")
}
