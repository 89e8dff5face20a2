//! `trilith list`, `trilith new`.

use clap::ValueEnum;
use std::path::Path;

use crate::case::{self, Case, Template};
use crate::files::write_whole;
use crate::method::METHODS;
use crate::study::sweep::{self, Sweep};
use crate::text::{GridColumn, grid, words};

use super::screen::{layout, print, print_lines};
use super::stop::Stop;

#[derive(Clone, Copy, ValueEnum)]
pub(super) enum KindArgument {
    /// A coursed wall.
    Wall,
    /// Blocks of any shape.
    Blocks,
    /// A circular voussoir arch.
    Arch,
}

/// Columns of the lists of cases and of sweeps: where there is no room, the files go.
const NAMED: [GridColumn; 3] = [words("name"), words("file").spare(1), words("title")];

pub(super) fn list() -> Result<u8, Stop> {
    let cases = case::embedded()
        .zip(case::library())
        .map(|((path, _), case)| [case.name, path.to_owned(), case.title].to_vec());
    let mut sweeps = Vec::new();
    for (path, _) in sweep::embedded() {
        let sweep = Sweep::find(path)?;
        sweeps.push(vec![sweep.name, path.to_owned(), sweep.title]);
    }
    let methods = METHODS.iter().map(|entry| {
        let by_default = if entry.by_default { "yes" } else { "" };
        [entry.name(), by_default, entry.summary]
            .map(str::to_owned)
            .to_vec()
    });
    let table = |columns: &[GridColumn], rows: &[Vec<String>]| grid(layout(), 2, columns, rows);
    print(&format!(
        "cases built in:\n{}\nsweeps built in:\n{}\nmethods:\n{}",
        table(&NAMED, &cases.collect::<Vec<_>>()),
        table(&NAMED, &sweeps),
        table(
            &[words("name"), words("by default"), words("what it is")],
            &methods.collect::<Vec<_>>()
        ),
    ))?;
    Ok(0)
}

/// A file as a shell takes it for a command's argument, and the command for a file.
pub(super) fn quoted(file: &str) -> String {
    let file = match file.strip_prefix('-') {
        Some(_) => format!("./{file}"),
        None => file.to_owned(),
    };
    shlex::try_quote(&file).map_or(file.clone(), |quoted| quoted.into_owned())
}

pub(super) fn new(name: &str, kind: KindArgument) -> Result<u8, Stop> {
    let template = match kind {
        KindArgument::Wall => Template::Wall,
        KindArgument::Blocks => Template::Blocks,
        KindArgument::Arch => Template::Arch,
    };
    let named = Path::new(name.strip_suffix(".toml").unwrap_or(name)).file_name();
    if named.is_none() || name.ends_with(['/', '\\']) {
        return Err(Stop::bad_input(format!(
            "error: `{name}` is no name for a case\nhelp: write `trilith new mywall`, or a path that ends in \
             `.toml`"
        )));
    }
    let file = if name.ends_with(".toml") {
        name.to_owned()
    } else {
        format!("{name}.toml")
    };
    let path = Path::new(&file);
    let stem = path.file_stem().map(|s| s.to_string_lossy().into_owned());
    let Some(stem) = stem.filter(|s| !s.is_empty()) else {
        let text = format!("error: `{name}` is no name for a case");
        return Err(Stop::bad_input(text));
    };
    if path.exists() {
        let text =
            format!("error: {file} is there already\nhelp: choose another name, or remove it");
        return Err(Stop::bad_input(text));
    }
    let text = template.text(&stem);
    // A name that `run` would refuse is refused here.
    Case::read(&file, text.as_bytes())?;
    write_whole(path, &text).map_err(|e| Stop::not_written(&file, e))?;
    let quoted = quoted(&file);
    print_lines(&format!("wrote {file}; next: trilith run {quoted}\n"))?;
    Ok(0)
}
