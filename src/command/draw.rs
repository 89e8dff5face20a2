//! `trilith draw`.

use std::path::{Path, PathBuf};

use crate::case;
use crate::files::write_whole;
use crate::method::{Kind, METHODS, Method, MethodEntry, kind, methods};
use crate::picture::{Options, View, figure};
use crate::run::{CaseResult, Plan};
use crate::scene::HeadJoints;
use clap::Args;

use super::output;
use super::plan::PlanArguments;
use super::screen::{print, print_lines};
use super::solve::solve;
use super::stop::Stop;

#[derive(Args)]
pub(super) struct DrawArguments {
    /// A case file, or the name of a built-in case.
    case: String,
    #[command(flatten)]
    plan: PlanArguments,
    /// Draw macro-block, interval and pushover beside each other, or the methods that `--method` names.
    #[arg(long)]
    side_by_side: bool,
    /// Also draw the contact forces of each method that gives them.
    #[arg(long)]
    forces: bool,
    /// The SVG file to write; `-` prints it. A program that is built with `--features print` also writes
    /// PNG and PDF.
    #[arg(short, long, value_name = "FILE.svg")]
    output: PathBuf,
}

pub(super) fn draw(arguments: &DrawArguments) -> Result<u8, Stop> {
    let to_standard_output = arguments.output.as_os_str() == "-";
    let format = if to_standard_output {
        Format::Svg
    } else {
        Format::of(&arguments.output)?
    };
    let (mut cases, mut plan) = arguments
        .plan
        .read(std::slice::from_ref(&arguments.case), case::paper)?;
    if cases.len() != 1 {
        let text = format!(
            "error: `{}` stands for {} cases, and a drawing is of one\nhelp: name one case, and \
             methods after `--method`, separated by commas",
            arguments.case,
            cases.len()
        );
        return Err(Stop::bad_input(text));
    }
    let drawn = drawn(arguments, &plan);
    // The closed form always runs: its crack is drawn over every mechanism.
    let wanted = |method: &&dyn Method| {
        kind(method.name()) == Kind::ClosedForm || drawn.iter().any(|name| name == method.name())
    };
    let outside = plan.methods.into_iter();
    let outside = outside.filter(|method| kind(method.name()) == Kind::Outside);
    plan.methods = methods()
        .into_iter()
        .chain(outside)
        .filter(wanted)
        .collect();
    let case = &mut cases[0];
    // One setting a drawing: open head joints where the case has them, which the published
    // mechanisms are of.
    let open = case.head_joints.contains(&HeadJoints::Open);
    let one = if open {
        HeadJoints::Open
    } else {
        case.head_joints[0]
    };
    plan.head_joints = plan.head_joints.or(Some(one));
    let path = &arguments.output;
    let folder = path
        .parent()
        .filter(|parent| !parent.as_os_str().is_empty());
    if !to_standard_output {
        output::test(folder.unwrap_or(Path::new(".")))?;
    }
    if path.is_dir() {
        return Err(Stop::not_written(path.display(), "a folder has its name"));
    }
    let results = solve(&cases, &plan, None, |_| Ok(()), |_, _| Ok(()))?;
    let [result] = results.as_slice() else {
        return Err(Stop::bad_input("error: there is nothing to draw"));
    };
    let views = views(result, &drawn);
    let pictures = views.len() * if arguments.forces { 2 } else { 1 };
    let options = Options {
        forces: arguments.forces,
        ..Options::for_pictures(pictures)
    };
    let title = format!("{}: {}", result.case.name, result.case.title);
    let svg = figure(&title, &views, &options);
    if to_standard_output {
        print(&svg)?;
        return Ok(0);
    }
    let contents = format.print(svg);
    let contents = contents.map_err(|why| Stop::not_written(path.display(), why))?;
    write_whole(path, contents).map_err(|e| Stop::not_written(path.display(), e))?;
    print_lines(&format!("wrote {}\n", path.display()))?;
    Ok(0)
}

/// What a file of a drawing holds.
#[derive(Clone, Copy)]
enum Format {
    Svg,
    #[cfg(feature = "print")]
    Png,
    #[cfg(feature = "print")]
    Pdf,
}

impl Format {
    /// By the end of a file's name.
    fn of(path: &Path) -> Result<Self, Stop> {
        let end = path
            .extension()
            .map(|end| end.to_string_lossy().to_lowercase());
        let help = match end.as_deref() {
            Some("svg") => return Ok(Format::Svg),
            #[cfg(feature = "print")]
            Some("png") => return Ok(Format::Png),
            #[cfg(feature = "print")]
            Some("pdf") => return Ok(Format::Pdf),
            #[cfg(not(feature = "print"))]
            Some("png" | "pdf") => {
                "PNG and PDF are made by a trilith that is built with `cargo build --release \
                 --features print`"
            }
            _ => "write `-o FILE.svg`, or `-o -` for standard output",
        };
        Err(Stop::bad_input(format!(
            "error: a drawing is SVG, and {} does not end in `.svg`\nhelp: {help}",
            path.display()
        )))
    }

    /// The drawing in this format; why it cannot be had.
    fn print(self, svg: String) -> Result<Vec<u8>, String> {
        match self {
            Format::Svg => Ok(svg.into_bytes()),
            #[cfg(feature = "print")]
            Format::Png => crate::picture::png(&svg).map_err(|error| error.to_string()),
            #[cfg(feature = "print")]
            Format::Pdf => crate::picture::pdf(&svg).map_err(|error| error.to_string()),
        }
    }
}

/// Names of the methods that are drawn: those that were named, or the collapse states found; side by
/// side, the paper's Figs. 4 and 5. Outside programs are drawn in any case.
fn drawn(arguments: &DrawArguments, plan: &Plan) -> Vec<String> {
    let named = plan.methods.iter().map(|method| method.name().to_owned());
    if arguments.plan.names_methods() {
        return named.collect();
    }
    let first = |entry: &&MethodEntry| {
        if arguments.side_by_side {
            entry.drawn_first
        } else {
            entry.kind == Kind::CollapseStates
        }
    };
    let own = METHODS
        .iter()
        .filter(first)
        .map(|entry| entry.name().to_owned());
    let outside = named.filter(|name| kind(name) == Kind::Outside);
    own.chain(outside).collect()
}

/// The answers of these methods, in this order, with the macro-block's crack.
fn views<'a>(result: &'a CaseResult, methods: &[String]) -> Vec<View<'a>> {
    let closed = result
        .rows
        .iter()
        .find(|row| row.kind() == Kind::ClosedForm);
    let slope = closed.and_then(|row| row.crack);
    let row = |name: &String| result.rows.iter().find(|row| row.method == *name);
    let rows = methods.iter().filter_map(row);
    rows.map(|row| {
        let (scene, row) = result.governing(row);
        View {
            scene,
            row,
            macro_slope: slope.map(|crack| crack.tan_beta),
        }
    })
    .collect()
}
