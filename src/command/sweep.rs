//! `trilith sweep` and `trilith merge`.

use std::collections::BTreeMap;
use std::fmt::Write;
use std::path::{Path, PathBuf};

use crate::answer::Status;
use crate::judge::{Check, Verdict};
use crate::number::number;
use crate::run::{Keeps, Row, Task, marked, run_rows};
use crate::study::sweep::{self, MOST_SHARDS, Shard, Sweep, SweepTable, sweep_picture};
use crate::text::{ended, grid, numbers, words};
use clap::Args;
use indexmap::IndexMap;

use super::output;
use super::plan::externals;
use super::screen::{layout, print, print_lines};
use super::slurm;
use super::solve::run_study;
use super::stop::{self, Stop};

/// What a sweep file looks like, below the help.
pub(super) const FORMAT: &str = r#"A sweep file names a case and says what varies in it:

  title = "Friction under an overburden"
  case = "paper-1"         # a name, a path beside this file, a list of these,
                           # or a table [case]
  head_joints = "both"     # instead of what the case says: contact, open, both
  methods = ["associative", "interval"]      # where this is left out, all

  [settings]               # those of `trilith run --help`
  starts = 4

  [[vary]]                 # a key of the case's file: values, or a range
  overburden = { from = 0, to = 10, count = 21 }
                           # spacing = "logarithmic" may be added

  [[vary]]                 # tables multiply; keys of one table vary together
  friction = [0.4, 0.65]
  "unit.length" = [3.0, 4.0]      # a key within a table stands in quotes;
                                  # "settings.starts" is one too, and items
                                  # of a list are counted from 1, as in
                                  # "joints.1.friction", "live.weight.2"

`aspect` varies the length of the unit over its height, at constant height.
`refine = [1, 2]` cuts each unit of a bond into n by n: the wall keeps its size
and has more courses.

Finished points go to a journal, so that the same command goes on where it was
stopped. At the end sweep.csv holds every point in order, times.csv says what
each took, and sweep.svg has plots where not too much varies."#;

#[derive(Args)]
pub(super) struct SweepArguments {
    /// A sweep file, or the name of a built-in sweep; `trilith list` names them. With --vary, a case.
    #[arg(value_name = "FILE")]
    pub file: String,
    /// Vary a key of this case, without a sweep file: a range, as friction=0.4:0.8:5, which is five values
    /// from 0.4 to 0.8, or values, as friction=0.4,0.65. Given more than once, it makes a grid. A setting is
    /// a key too, as settings.starts=4, and head_joints=open says which head joints run.
    #[arg(long, value_name = "KEY=VALUES", conflicts_with_all = ["shard", "slurm"])]
    vary: Vec<String>,
    /// Run only these methods, with --vary; in a sweep file, `methods` names them.
    #[arg(long, value_name = "NAME", num_args = 1.., value_delimiter = ',', requires = "vary")]
    method: Vec<String>,
    /// Folder of the results and of the journal [default: target/sweeps/NAME].
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
    /// Run only the K-th of N parts, for `trilith merge`.
    #[arg(long, value_name = "K/N")]
    shard: Option<Shard>,
    /// Print a script that runs N parts as a Slurm job array and then merges them.
    #[arg(long, value_name = "N", conflicts_with = "shard",
          value_parser = clap::value_parser!(u64).range(1..=MOST_SHARDS as u64))]
    slurm: Option<u64>,
    /// Also run programs of your own: a .toml file that names them, or NAME=COMMAND.
    #[arg(long, value_name = "FILE.toml|NAME=COMMAND")]
    external: Vec<String>,
}

#[derive(Args)]
pub(super) struct MergeArguments {
    /// The sweep whose parts have run.
    #[arg(value_name = "FILE")]
    file: String,
    /// The folder that the parts were written into [default: target/sweeps/NAME].
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
    /// The programs of your own that the shards ran.
    #[arg(long, value_name = "FILE.toml|NAME=COMMAND")]
    external: Vec<String>,
}

fn found(sweep: Sweep, out: Option<&Path>, external: &[String]) -> Result<(Sweep, PathBuf), Stop> {
    let sweep = sweep.with_programs(externals(external)?);
    let folder = match out {
        Some(folder) => folder.to_owned(),
        None => Path::new("target/sweeps").join(&sweep.name),
    };
    Ok((sweep, folder))
}

pub(super) fn sweep(arguments: &SweepArguments) -> Result<u8, Stop> {
    let SweepArguments {
        file,
        vary,
        out,
        external,
        ..
    } = arguments;
    let sweep = match vary.is_empty() {
        true => Sweep::find(file)?,
        false => Sweep::of_case(file, vary, &arguments.method)?,
    };
    let (sweep, folder) = found(sweep, out.as_deref(), external)?;
    if let Some(shards) = arguments.slurm {
        print(&slurm::script(
            file,
            &sweep.name,
            &folder,
            external,
            shards,
        )?)?;
        return Ok(0);
    }
    let (tasks, journal) = match arguments.shard {
        None => (sweep.tasks(), "sweep.journal".to_owned()),
        Some(shard) => (shard.deal(sweep.tasks()), shard.journal()),
    };
    let journal = output::journal(&folder, &journal, Keeps::Numbers)?;
    output::tell_known(&journal, &tasks);
    run_study(
        &journal,
        |progress| run_rows(&tasks, Some(&journal), progress),
        |rows, why| match (arguments.shard, why) {
            (None, why) => hand_out(&sweep, &tasks, in_order(&tasks, rows), why, &folder),
            // The journal has them.
            (Some(_), Some(_)) => Ok(0),
            (Some(shard), None) => {
                let written = shard.write(&folder, &rows);
                let path = written.map_err(|error| Stop::not_written("the sweep", error))?;
                print_lines(&format!(
                    "shard {shard} of {}: {} points in {}\n",
                    sweep.name,
                    rows.len(),
                    path.display()
                ))?;
                Ok(stop::status(failed(&rows)))
            }
        },
    )
}

/// Rows that came in any order, in that of their tasks.
fn in_order(tasks: &[Task], rows: Vec<Row>) -> Vec<Row> {
    let known = rows.into_iter().map(|row| (row.id.clone(), row));
    let mut known: BTreeMap<String, Row> = known.collect();
    let rows = tasks.iter().filter_map(|task| known.remove(task.id()));
    rows.collect()
}

pub(super) fn merge(arguments: &MergeArguments) -> Result<u8, Stop> {
    let MergeArguments {
        file,
        out,
        external,
    } = arguments;
    let (sweep, folder) = found(Sweep::find(file)?, out.as_deref(), external)?;
    let tasks = sweep.tasks();
    let rows = sweep::merge(&tasks, &folder)?;
    output::test(&folder)?;
    hand_out(&sweep, &tasks, rows, None, &folder)
}

/// Prints what is in a sweep and writes its files.
fn hand_out(
    sweep: &Sweep,
    tasks: &[Task],
    mut rows: Vec<Row>,
    why: Option<&str>,
    folder: &Path,
) -> Result<u8, Stop> {
    let partial = output::partial(why, rows.len(), tasks.len());
    let partial = partial.as_ref();
    let checks = sweep::compare(tasks, &mut rows);
    let rows = &rows;
    let path = folder.join("sweep.csv");
    let table = SweepTable::of(&sweep.name, rows, partial);
    let said = output::said(partial);
    let picture = sweep_picture(&table);
    let drawn = picture.as_ref().err();
    let ranges = match table.variables().is_empty() {
        true => "; `trilith report CASE... --out DIR` draws the ranges of its cases",
        false => "",
    };
    let drawn = drawn.map_or(String::new(), |why| format!("{why}{ranges}\n"));
    let printed = print(&format!(
        "{said}{}: {}\n{}{}{drawn}{} points in {}\n",
        sweep.name,
        sweep.title,
        summary(rows),
        compared(&checks),
        rows.len(),
        path.display()
    ));
    let files = [
        ("times.csv", sweep::times_csv(rows)),
        ("sweep.csv", table.csv()),
    ];
    let files = files.map(|(name, text)| (name.to_owned(), marked(text, partial)));
    let picture = picture.map(|svg| ("sweep.svg".to_owned(), svg));
    let files = files.into_iter().chain(picture.ok()).collect();
    output::write(folder, files)?;
    printed?;
    let mut checks = checks.iter();
    let violated = checks.any(|(_, check)| check.verdict == Verdict::Violated);
    Ok(stop::status(violated || failed(rows)))
}

const SHOWN: usize = 10;

/// What the methods say about each other: the worst first, the rest as counts.
fn compared(checks: &[(String, Check)]) -> String {
    let mut text = String::new();
    for verdict in [Verdict::Violated, Verdict::Marked] {
        let of_verdict = checks.iter().filter(|(_, check)| check.verdict == verdict);
        let of_verdict: Vec<_> = of_verdict.collect();
        for (wall, check) in of_verdict.iter().take(SHOWN) {
            let words = format!("{wall}: {}", ended(&check.text));
            let lead = format!("{:<9} ", verdict.name());
            text.push_str(&layout().paragraph(&lead, crate::report::of_verdict(verdict), &words));
        }
        if let Some(more) = of_verdict.len().checked_sub(SHOWN).filter(|&more| more > 0) {
            let _ = writeln!(text, "{:<9} and {more} more", verdict.name());
        }
    }
    text
}

fn failed(rows: &[Row]) -> bool {
    rows.iter().any(|row| row.status() == Status::Failed)
}

/// A line a case and method: how far λ goes over all points, and how many points ended how.
fn summary(rows: &[Row]) -> String {
    let mut groups: IndexMap<(String, &str), Vec<&Row>> = IndexMap::new();
    for row in rows {
        groups
            .entry((row.scene_name(), &row.method))
            .or_default()
            .push(row);
    }
    let shown = |value: Option<f64>| value.map_or("-".to_owned(), |v| number(v, 5));
    let line = |((case, method), own): ((String, &str), Vec<&Row>)| {
        let brackets = || own.iter().filter_map(|row| row.bracket());
        let lowest = brackets().map(|ends| ends.lower).reduce(f64::min);
        let highest = brackets().map(|ends| ends.upper).reduce(f64::max);
        let ended = Status::ALL.iter().filter_map(|status| {
            let count = own.iter().filter(|row| row.status() == *status).count();
            (count > 0).then(|| format!("{count} {}", status.name()))
        });
        let ended = ended.collect::<Vec<_>>().join(", ");
        vec![
            case,
            method.to_owned(),
            shown(lowest),
            shown(highest),
            ended,
        ]
    };
    let lines: Vec<Vec<String>> = groups.into_iter().map(line).collect();
    let columns = [
        words("case"),
        words("method"),
        numbers("lowest λ"),
        numbers("highest λ"),
        words("points"),
    ];
    grid(layout(), 0, &columns, &lines)
}
