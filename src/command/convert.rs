//! `trilith convert`.

use std::path::{Path, PathBuf};

use crate::case::{self, Case};
use clap::{Args, ValueEnum};

use super::cases::quoted;
use super::output::write_files;
use super::plan::warn;
use super::screen::print_lines;
use super::stop::Stop;

#[derive(Args)]
pub(super) struct ConvertArguments {
    /// A case file, or the name of a built-in case.
    case: String,
    /// The form to write it in.
    #[arg(long)]
    to: Form,
    /// The case file to write [default: CASE-blocks.toml in this folder]; the CSV comes beside it.
    #[arg(short, long, value_name = "FILE.toml")]
    output: Option<PathBuf>,
}

#[derive(Clone, Copy, ValueEnum)]
enum Form {
    /// Explicit blocks, their corners in a CSV.
    Blocks,
}

pub(super) fn convert(arguments: &ConvertArguments) -> Result<u8, Stop> {
    let Form::Blocks = arguments.to;
    let case = one_case(&arguments.case)?;
    let default = || PathBuf::from(format!("{}-blocks.toml", case.name));
    let path = arguments.output.clone().unwrap_or_else(default);
    let csv = path.with_extension("csv");
    let files = in_files(&case, &path)?;
    write_files(&[(path.clone(), files.toml), (csv.clone(), files.csv)])?;
    let (shown, csv) = (path.display().to_string(), csv.display());
    print_lines(&format!(
        "wrote {shown} and {csv}; next: trilith run {}\n",
        quoted(&shown)
    ))?;
    Ok(0)
}

/// The one case that an argument names.
pub(super) fn one_case(argument: &str) -> Result<Case, Stop> {
    let cases = case::find(argument)?;
    warn(&cases);
    let names: Vec<&str> = cases.iter().map(|case| case.name.as_str()).collect();
    let names = names.join(", ");
    let mut cases = cases.into_iter();
    match (cases.next(), cases.next()) {
        (Some(case), None) => Ok(case),
        _ => {
            let text = format!("error: {argument} holds several cases\nhelp: name one of {names}");
            Err(Stop::bad_input(text))
        }
    }
}

/// The two files of a case, which are not there yet and can be read back.
pub(super) fn in_files(case: &Case, path: &Path) -> Result<case::BlocksFiles, Stop> {
    let csv = path.with_extension("csv");
    for path in [path, &csv] {
        if path.exists() {
            let path = path.display();
            let text = format!(
                "error: {path} is there already\nhelp: choose another name with `-o`, or remove it"
            );
            return Err(Stop::bad_input(text));
        }
    }
    let name = csv.file_name().unwrap_or_default().to_string_lossy();
    if path.extension().is_none_or(|end| end != "toml") {
        let text = format!(
            "error: a case is a `.toml` file, and {} is none\nhelp: write `-o FILE.toml`",
            path.display()
        );
        return Err(Stop::bad_input(text));
    }
    let files = case.as_blocks(&name);
    let read = |_: &str| Ok(files.csv.clone().into_bytes());
    let shown = path.display().to_string();
    Case::read_with(&shown, files.toml.as_bytes(), &read)?;
    Ok(files)
}
