//! `trilith chart`.

use std::path::{Path, PathBuf};
use std::sync::Mutex;

use clap::Args;
use trilith::run::{Progress, Row, Task};

use trilith::files::write_whole;
use trilith::study::chart;
use trilith::study::sweep::{sweep_csv, times_csv};

use super::interrupt;
use super::plan::HeadJointsArgument;
use super::plan::{collect, externals};
use super::progress::Bar;
use super::stop::{Stop, print};

#[derive(Args)]
pub(super) struct ChartArguments {
    /// Case files, folders of them, or names of built-in cases; none: the paper's walls and the two
    /// with openings.
    #[arg(value_name = "CASE")]
    cases: Vec<String>,
    /// Head joints instead of what the case says.
    #[arg(long)]
    head_joints: Option<HeadJointsArgument>,
    /// Also run programs of your own: a .toml file that names them, or NAME=COMMAND.
    #[arg(long, value_name = "FILE.toml|NAME=COMMAND")]
    external: Vec<String>,
    /// Folder for chart.csv, chart.svg and summary.csv.
    #[arg(long, value_name = "DIR")]
    out: PathBuf,
}

/// The walls that everything about the paper is compared on.
const WALLS: [&str; 5] = ["paper-1", "paper-2", "paper-3", "openings-3", "openings-4"];

pub(super) fn chart(arguments: &ChartArguments) -> Result<u8, Stop> {
    let cases = match arguments.cases.as_slice() {
        [] => collect(&WALLS.map(str::to_owned))?,
        named => collect(named)?,
    };
    let head_joints = arguments.head_joints.map(Into::into);
    for case in &cases {
        let measured = |&head| chart::reference(case, head).is_some();
        if !case.head_joints.iter().any(measured) {
            eprintln!(
                "{} has no reference to measure errors against: left out",
                case.name
            );
        }
    }
    let externals = externals(&arguments.external)?;
    let entries = keeping_rows(&arguments.out, |progress| {
        chart::run(&cases, head_joints, &externals, progress)
    });
    let entries = entries.map_err(|e| Stop::bad_input(format!("error: {e}")))?;
    if entries.is_empty() {
        let text = "error: nothing to draw\nhelp: name a case with a reference; `trilith show CASE` \
                    prints them";
        return Err(Stop::bad_input(text));
    }
    let summaries = chart::summaries(&entries);
    let broken = |e: csv::Error| Stop::bad_input(format!("error: cannot write CSV: {e}"));
    let files = [
        (
            "chart.csv".to_owned(),
            chart::csv(&entries).map_err(broken)?,
        ),
        (
            "summary.csv".to_owned(),
            chart::summary_csv(&summaries).map_err(broken)?,
        ),
        ("chart.svg".to_owned(), chart::picture(&entries)),
    ];
    write(&arguments.out, &files)?;
    print(&chart::summary_table(&summaries))?;
    Ok(0)
}

/// A bar that also keeps the finished rows.
struct Kept {
    bar: Bar,
    rows: Mutex<Vec<Row>>,
}

impl Progress for Kept {
    fn expected(&self, seconds: f64) {
        self.bar.expected(seconds);
    }

    fn done(&self, task: &Task, row: &Row) {
        self.bar.done(task, row);
        let mut rows = self.rows.lock().expect("no other thread panicked");
        rows.push(row.clone());
    }
}

/// Runs tasks with progress. On Ctrl-C the rows that are finished go to `finished.csv` and their
/// times to `finished-times.csv` in the folder, and standard error says so.
pub(super) fn keeping_rows<T: Send>(
    folder: &Path,
    work: impl FnOnce(&dyn Progress) -> T + Send,
) -> T {
    let kept = Kept {
        bar: Bar::new(),
        rows: Mutex::default(),
    };
    let done = interrupt::or_leave(
        || work(&kept),
        || {
            kept.bar.clear();
            let rows = kept.rows.lock().expect("no other thread panicked").clone();
            let texts = sweep_csv(&rows).and_then(|csv| Ok((csv, times_csv(&rows)?)));
            let written = match texts {
                Err(e) => Err(Stop::bad_input(format!("error: cannot write CSV: {e}"))),
                Ok((csv, times)) => {
                    let files = [("finished.csv", csv), ("finished-times.csv", times)];
                    write(folder, &files.map(|(name, text)| (name.to_owned(), text)))
                }
            };
            match written {
                Ok(()) => eprintln!(
                    "interrupted: {} finished rows written to {}",
                    rows.len(),
                    folder.join("finished.csv").display()
                ),
                Err(stop) => eprintln!("interrupted: {}", stop.text.trim_end()),
            }
        },
    );
    kept.bar.clear();
    done
}

/// Writes files into a folder.
pub(super) fn write(folder: &Path, files: &[(String, String)]) -> Result<(), Stop> {
    for (name, text) in files {
        let path = folder.join(name);
        write_whole(&path, text)
            .map_err(|e| Stop::bad_input(format!("error: cannot write {}: {e}", path.display())))?;
    }
    Ok(())
}
