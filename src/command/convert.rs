//! `trilith convert` and `trilith import`: cases as explicit blocks.

use std::fmt::Write;
use std::path::{Path, PathBuf};

use crate::case::{self, BlocksFiles, Case};
use clap::{Args, ValueEnum};

use super::cases::quoted;
use super::drawing::{DrawingArguments, is_drawing};
use super::output::write_files;
use super::plan::{HeadJointsArgument, warn};
use super::screen::print_lines;
use super::stop::Stop;

#[derive(Args)]
pub(super) struct ConvertArguments {
    /// A case file, the name of a built-in case, or `-` for a case in standard input.
    case: String,
    /// The form to write it in.
    #[arg(long)]
    to: Form,
    /// Close gaps between explicit blocks up to this width, in the case's unit of length: each to a line in
    /// its middle, but none wider than a tenth of the smaller block.
    #[arg(long, value_name = "WIDTH", value_parser = width)]
    gap: Option<f64>,
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
    let case = one_closed(&arguments.case, arguments.gap)?;
    let default = || PathBuf::from(format!("{}-blocks.toml", case.name));
    let path = arguments.output.clone().unwrap_or_else(default);
    write_both(&path, in_files(&case, &path)?, "")
}

/// Writes a case's files and says what to do next, `first` before it is run.
fn write_both(path: &Path, files: BlocksFiles, first: &str) -> Result<u8, Stop> {
    let csv = path.with_extension("csv");
    write_files(&[(path.to_owned(), files.toml), (csv.clone(), files.csv)])?;
    let (shown, csv) = (path.display().to_string(), csv.display());
    let run = quoted(&shown);
    print_lines(&format!(
        "wrote {shown} and {csv}; next: {first}trilith run {run}\n"
    ))?;
    Ok(0)
}

/// A width in the unit of a case, which has no name.
fn width(text: &str) -> Result<f64, String> {
    match text.parse::<f64>() {
        Ok(width) if width > 0.0 && width.is_finite() => Ok(width),
        _ => Err("write a number above 0, in the unit of length of the case".to_owned()),
    }
}

/// The one case that an argument names.
pub(super) fn one_case(argument: &str) -> Result<Case, Stop> {
    one_closed(argument, None)
}

/// The one case that an argument names, with gaps between its blocks closed up to a width.
fn one_closed(argument: &str, gap: Option<f64>) -> Result<Case, Stop> {
    let found = case::locate(argument)?;
    let [unread] = found.as_slice() else {
        let names = found.iter().map(|unread| unread.path.as_str());
        let names = names.collect::<Vec<_>>().join(", ");
        let text = format!("error: {argument} holds several cases\nhelp: name one of {names}");
        return Err(Stop::bad_input(text));
    };
    let case = unread.read_closing(gap)?;
    warn(std::slice::from_ref(&case));
    Ok(case)
}

/// The two files of a case, which are not there yet and can be read back.
fn in_files(case: &Case, path: &Path) -> Result<BlocksFiles, Stop> {
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

#[derive(Args)]
pub(super) struct ImportArguments {
    /// The drawing: a DXF in text form, of R12 or later; or the JSON of a model of COMPAS.
    #[arg(value_name = "FILE.dxf|FILE.json")]
    drawing: String,
    /// The case file to write [default: the drawing's name with `.toml`]; its CSV comes beside it.
    #[arg(short, long, value_name = "FILE.toml")]
    output: Option<PathBuf>,
    /// What head joints carry.
    #[arg(long)]
    head_joints: Option<HeadJointsArgument>,
    /// Edges that face each other are made to touch where they are within this part of the smaller
    /// block's extent, up to 0.01; 0 moves nothing [default: 0.005].
    #[arg(long, value_name = "PART")]
    tolerance: Option<f64>,
    #[command(flatten)]
    options: DrawingArguments,
}

pub(super) fn import(arguments: &ImportArguments) -> Result<u8, Stop> {
    let drawing = &arguments.drawing;
    if !is_drawing(drawing) {
        let text = format!(
            "error: {drawing} is no drawing\nhelp: name a file that ends in `.dxf`, or a model \
             of COMPAS that ends in `.json`"
        );
        return Err(Stop::bad_input(text));
    }
    let default = || PathBuf::from(drawing).with_extension("toml");
    let path = arguments.output.clone().unwrap_or_else(default);
    let mut imported = arguments.options.read(drawing, arguments.tolerance, true)?;
    let head_joints = arguments.head_joints;
    imported.case.head_joints = head_joints.unwrap_or(HeadJointsArgument::Contact).all();
    let mut files = in_files(&imported.case, &path)?;
    let known = arguments.options.friction().is_some();
    if !known {
        // Until it is filled in, `run` says that it is missing.
        let fill_in = "# friction = 0.65      # to be filled in: tan φ of every joint\n";
        files.toml = files.toml.replacen("friction = 0.0\n", fill_in, 1);
    }
    let warnings = imported.case.warnings.iter();
    let warnings = warnings.map(|w| format!("warning: {}: {}", w.title(), w.advice()));
    let remarks: Vec<String> = imported.remarks.iter().cloned().chain(warnings).collect();
    files.toml.insert_str(0, &commented(&remarks));
    let first = match known {
        true => String::new(),
        false => format!("fill in `friction` in {}, then ", path.display()),
    };
    write_both(&path, files, &first)
}

fn commented(remarks: &[String]) -> String {
    const MOST: usize = 200;
    let mut text = String::new();
    for remark in remarks.iter().take(MOST) {
        let _ = writeln!(text, "# {remark}");
    }
    if let Some(more @ 1..) = remarks.len().checked_sub(MOST) {
        let _ = writeln!(text, "# and {more} more");
    }
    text
}
