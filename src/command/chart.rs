//! `trilith chart`.

use std::path::{Path, PathBuf};

use crate::run::{Keeps, Row, marked};
use crate::study::chart::{self, Chart};
use clap::Args;

use super::output;
use super::plan::{HeadJointsArgument, collect, externals};
use super::screen::{layout, print, tell};
use super::solve::run_study;
use super::stop::Stop;

#[derive(Args)]
pub(super) struct ChartArguments {
    /// Case files, folders of them, or names of built-in cases; where none is named, the walls of the paper
    /// and two with openings.
    #[arg(value_name = "CASE")]
    cases: Vec<String>,
    /// What head joints carry, instead of what the case says.
    #[arg(long)]
    head_joints: Option<HeadJointsArgument>,
    /// Also run programs of your own: a .toml file that names them, or NAME=COMMAND.
    #[arg(long, value_name = "FILE.toml|NAME=COMMAND")]
    external: Vec<String>,
    /// Folder for chart.csv, chart.svg and summary.csv, and for the journal with which the same
    /// command goes on where it was stopped.
    #[arg(long, value_name = "DIR")]
    out: PathBuf,
}

/// The walls that everything about the paper is compared on.
const WALLS: [&str; 5] = ["paper-1", "paper-2", "paper-3", "openings-3", "openings-4"];

pub(super) fn chart(arguments: &ChartArguments) -> Result<u8, Stop> {
    let mut cases = match arguments.cases.as_slice() {
        [] => collect(&WALLS.map(str::to_owned))?,
        named => collect(named)?,
    };
    if let Some(head_joints) = arguments.head_joints {
        head_joints.set(&mut cases);
    }
    let head_joints = arguments.head_joints.and_then(HeadJointsArgument::one);
    for case in &cases {
        let measured = |&head| chart::reference(case, head).is_some();
        if !case.head_joints.iter().any(measured) {
            let name = &case.name;
            tell!("{name} has no reference to measure errors against: left out");
        }
    }
    let externals = externals(&arguments.external)?;
    let chart = Chart::new(&cases, head_joints, &externals);
    if chart.count() == 0 {
        let text = "error: nothing to draw\nhelp: name a case with a reference; `trilith show CASE` \
                    prints them";
        return Err(Stop::bad_input(text));
    }
    let journal = output::journal(&arguments.out, "chart.journal", Keeps::Numbers)?;
    run_study(
        &journal,
        |progress| chart.run(Some(&journal), progress),
        |rows, why| hand_out(&chart, &rows, why, &arguments.out),
    )?;
    output::finish(journal);
    Ok(0)
}

/// Prints the summary and writes the table, the summary and the picture.
fn hand_out(chart: &Chart, rows: &[Row], why: Option<&str>, folder: &Path) -> Result<(), Stop> {
    let entries = chart.measurements(rows);
    let partial = output::partial(why, entries.len(), chart.count());
    let partial = partial.as_ref();
    let summaries = chart::summaries(&entries);
    let files = [
        ("chart.csv", chart::csv(&entries)),
        ("summary.csv", chart::summary_csv(&summaries)),
    ];
    let files = files.map(|(name, text)| (name.to_owned(), marked(text, partial)));
    let mut files = Vec::from(files);
    if !entries.is_empty() {
        let picture = chart::picture(&entries, partial);
        files.push(("chart.svg".to_owned(), picture));
    }
    let table = chart::summary_table(&summaries, layout());
    let printed = print(&(output::said(partial) + &table));
    output::write(folder, files)?;
    printed
}
