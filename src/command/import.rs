//! `trilith import`.

use std::fmt::Write;
use std::path::PathBuf;

use crate::case::BlocksFiles;
use crate::scene::HeadJoints;
use clap::Args;

use super::cases::quoted;
use super::convert::in_files;
use super::drawing::{DrawingArguments, is_drawing};
use super::head_joints::HeadJointsArgument;
use super::output::write_files;
use super::screen::print_lines;
use super::stop::Stop;

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
    /// Edges that face each other are made to touch where they are within this part of the smaller block's
    /// extent, up to 0.01; 0 moves nothing [default: 0.005].
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
    let path = match &arguments.output {
        Some(path) => path.clone(),
        None => PathBuf::from(drawing).with_extension("toml"),
    };
    let mut imported = arguments.options.read(drawing, arguments.tolerance, true)?;
    imported.case.head_joints = match arguments.head_joints {
        None | Some(HeadJointsArgument::Contact) => vec![HeadJoints::Contact],
        Some(HeadJointsArgument::Open) => vec![HeadJoints::Open],
        Some(HeadJointsArgument::Both) => vec![HeadJoints::Contact, HeadJoints::Open],
    };
    let mut files = in_files(&imported.case, &path)?;
    let known = arguments.options.friction().is_some();
    if !known {
        // Until it is filled in, `run` says that it is missing.
        let fill_in = "# friction = 0.65      # to be filled in: tan φ of every joint\n";
        files.toml = files.toml.replacen("friction = 0.0\n", fill_in, 1);
    }
    let remarks = commented(&imported.remarks);
    let csv = path.with_extension("csv");
    let BlocksFiles { toml, csv: rows } = files;
    write_files(&[(path.clone(), remarks + &toml), (csv.clone(), rows)])?;
    let shown = path.display().to_string();
    let next = match known {
        true => format!("next: trilith run {}", quoted(&shown)),
        false => format!(
            "next: fill in `friction` in {shown}, then trilith run {}",
            quoted(&shown)
        ),
    };
    print_lines(&format!("wrote {shown} and {}; {next}\n", csv.display()))?;
    Ok(0)
}

/// Remarks as the first lines of a case file.
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
