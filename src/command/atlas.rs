//! `trilith atlas`.

use std::path::{Path, PathBuf};

use crate::method::without_lower_bounds;
use crate::run::{Keeps, Row, marked, run_rows};
use crate::study::atlas::{self, Atlas, CellVerdict, Grid};
use clap::Args;

use super::output;
use super::plan::externals;
use super::screen::{layout, print};
use super::solve::run_study;
use super::stop::{Stop, status};

#[derive(Args)]
pub(super) struct AtlasArguments {
    /// Run all cells, which takes minutes, instead of the small atlas of the tests.
    #[arg(long)]
    large: bool,
    /// Also run programs of your own: a .toml file that names them, or NAME=COMMAND.
    #[arg(long, value_name = "FILE.toml|NAME=COMMAND")]
    external: Vec<String>,
    /// Folder for atlas.csv and one picture for each grid, and for the journal with which the same command
    /// goes on where it was stopped.
    #[arg(long, value_name = "DIR")]
    out: PathBuf,
}

pub(super) fn atlas(arguments: &AtlasArguments) -> Result<u8, Stop> {
    let externals = externals(&arguments.external)?;
    let methods = [without_lower_bounds().as_slice(), &externals].concat();
    let grids = atlas::grids(arguments.large);
    let atlas = Atlas::new(&grids, &methods);
    let journal = output::journal(&arguments.out, "atlas.journal", Keeps::Numbers)?;
    output::tell_known(&journal, atlas.tasks());
    let ended = run_study(
        &journal,
        |progress| run_rows(atlas.tasks(), Some(&journal), progress),
        |rows, why| hand_out(&atlas, &grids, &rows, why, &arguments.out),
    )?;
    output::finish(journal);
    Ok(ended)
}

/// Prints the table and writes it with the pictures.
fn hand_out(
    atlas: &Atlas,
    grids: &[Grid],
    rows: &[Row],
    why: Option<&str>,
    folder: &Path,
) -> Result<u8, Stop> {
    let cells = atlas.cells(rows);
    let partial = output::partial(why, cells.len(), atlas.tasks().len());
    let partial = partial.as_ref();
    let csv = marked(atlas::csv(&cells), partial);
    let mut files = vec![("atlas.csv".to_owned(), csv)];
    for grid in grids {
        let picture = atlas::picture(grid, &cells, partial);
        files.push((format!("{}.svg", grid.name), picture));
    }
    let said = output::said(partial);
    let printed = print(&format!("{said}{}", atlas::table(grids, &cells, layout())));
    output::write(folder, files)?;
    printed?;
    let wrong = cells.iter().any(|cell| cell.verdict == CellVerdict::Wrong);
    Ok(status(wrong))
}
