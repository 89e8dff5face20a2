//! `trilith atlas`.

use std::path::PathBuf;

use clap::Args;
use trilith::method::methods;
use trilith::study::atlas::{self, CellVerdict};

use super::chart::{keeping_rows, write};
use super::plan::externals;
use super::stop::{REFUTED, Stop, print};

#[derive(Args)]
pub(super) struct AtlasArguments {
    /// All cells instead of the small atlas that the tests run; takes minutes.
    #[arg(long)]
    large: bool,
    /// Also run programs of your own: a .toml file that names them, or NAME=COMMAND.
    #[arg(long, value_name = "FILE.toml|NAME=COMMAND")]
    external: Vec<String>,
    /// Folder for atlas.csv and a picture a grid.
    #[arg(long, value_name = "DIR")]
    out: PathBuf,
}

pub(super) fn atlas(arguments: &AtlasArguments) -> Result<u8, Stop> {
    let externals = externals(&arguments.external)?;
    let methods = [methods().as_slice(), &externals].concat();
    let grids = atlas::grids(arguments.large);
    let cells = keeping_rows(&arguments.out, |progress| {
        atlas::run(&grids, &methods, progress)
    });
    let broken = |e| Stop::bad_input(format!("error: cannot write CSV: {e}"));
    let mut files = vec![("atlas.csv".to_owned(), atlas::csv(&cells).map_err(broken)?)];
    for grid in &grids {
        files.push((format!("{}.svg", grid.name), atlas::picture(grid, &cells)));
    }
    write(&arguments.out, &files)?;
    print(&atlas::table(&grids, &cells))?;
    let wrong = cells.iter().any(|cell| cell.verdict == CellVerdict::Wrong);
    Ok(if wrong { REFUTED } else { 0 })
}
