//! `trilith draw`.

use std::path::{Path, PathBuf};

use crate::case;
use crate::files::write_whole;
use crate::judge::governing;
use crate::method::{Kind, METHODS, Method, MethodEntry, kind, methods};
use crate::picture::{Options, View, figure};
use crate::run::{CaseResult, Plan};
use crate::scene::HeadJoints;
use clap::Args;

use super::output;
use super::plan::PlanArguments;
use super::run::RESULTS;
use super::screen::{print, print_lines};
use super::solve::{Keeping, solve};
use super::stop::Stop;

#[derive(Args)]
#[command(next_help_heading = RESULTS)]
pub(super) struct DrawArguments {
    /// A case file, the name of a built-in case, or `-` for a case in standard input.
    #[arg(help_heading = None)]
    case: String,
    /// Draw macro-block, interval and pushover beside each other, or the methods that `--method` names.
    #[arg(long)]
    side_by_side: bool,
    /// Also draw the contact forces of each method that gives them.
    #[arg(long)]
    forces: bool,
    /// Write the names on the blocks that answers and JSON use.
    #[arg(long)]
    labels: bool,
    /// The SVG file to write; `-` prints it. A program that is built with `--features print` also writes
    /// PNG and PDF.
    #[arg(short, long, value_name = "FILE.svg")]
    output: PathBuf,
    #[command(flatten)]
    plan: PlanArguments,
}

pub(super) fn draw(arguments: &DrawArguments) -> Result<u8, Stop> {
    let path = &arguments.output;
    let to_file = (path.as_os_str() != "-")
        .then(|| format_of(path))
        .transpose()?;
    let named = std::slice::from_ref(&arguments.case);
    let (mut cases, mut plan) = arguments.plan.read(named, case::paper)?;
    let [case] = cases.as_mut_slice() else {
        let text = format!(
            "error: `{}` stands for {} cases, and a drawing is of one\nhelp: name one case, and \
             methods after `--method`, separated by commas",
            arguments.case,
            cases.len()
        );
        return Err(Stop::bad_input(text));
    };
    let drawn = drawn(arguments, &plan);
    // The closed form always runs: its crack is drawn over every mechanism.
    let wanted = |method: &&dyn Method| {
        kind(method.name()) == Kind::ClosedForm || drawn.iter().any(|name| name == method.name())
    };
    let outside = plan.methods.into_iter();
    let outside = outside.filter(|method| kind(method.name()) == Kind::Outside);
    let methods = methods().into_iter().chain(outside);
    plan.methods = methods.filter(wanted).collect();
    // Side by side, open head joints where the case has them, which the published mechanisms are of.
    let chosen = arguments.plan.names_head_joints();
    if arguments.side_by_side && !chosen && case.head_joints.contains(&HeadJoints::Open) {
        case.head_joints = vec![HeadJoints::Open];
    }
    if to_file.is_some() {
        let folder = path
            .parent()
            .filter(|parent| !parent.as_os_str().is_empty());
        output::test(folder.unwrap_or(Path::new(".")))?;
    }
    if path.is_dir() {
        return Err(Stop::not_written(path.display(), "a folder has its name"));
    }
    let results = solve(&cases, &plan, Keeping::default(), |_| Ok(()), |_, _| Ok(()))?;
    let [result] = results.as_slice() else {
        return Err(Stop::bad_input("error: there is nothing to draw"));
    };
    let views = views(result, &drawn, chosen);
    let pictures = views.len() * if arguments.forces { 2 } else { 1 };
    let options = Options {
        forces: arguments.forces,
        labels: arguments.labels,
        ..Options::for_pictures(pictures)
    };
    let title = format!("{}: {}", result.case.name, result.case.title);
    let svg = figure(&title, &views, &options);
    let Some(printed) = to_file else {
        print(&svg)?;
        return Ok(0);
    };
    let contents = printed(&svg).map_err(|why| Stop::not_written(path.display(), why))?;
    write_whole(path, contents).map_err(|e| Stop::not_written(path.display(), e))?;
    print_lines(&format!("wrote {}\n", path.display()))?;
    Ok(0)
}

/// The drawing in the format of a file; why it cannot be had.
type Print = fn(&str) -> Result<Vec<u8>, String>;

fn format_of(path: &Path) -> Result<Print, Stop> {
    let end = path
        .extension()
        .map(|end| end.to_string_lossy().to_lowercase());
    let help = match end.as_deref() {
        Some("svg") => return Ok(|svg| Ok(svg.into())),
        #[cfg(feature = "print")]
        Some("png") => return Ok(crate::picture::png),
        #[cfg(feature = "print")]
        Some("pdf") => return Ok(crate::picture::pdf),
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

/// Names of the methods that are drawn: those that were named, or the collapse states found; side by
/// side, the paper's Figs. 4 and 5. Outside programs are drawn in any case.
fn drawn(arguments: &DrawArguments, plan: &Plan) -> Vec<String> {
    let named = plan.methods.iter().map(|method| method.name().to_owned());
    if arguments.plan.names_methods() {
        return named.collect();
    }
    let first = |entry: &&MethodEntry| match arguments.side_by_side {
        true => entry.drawn_first,
        false => entry.kind == Kind::CollapseStates,
    };
    let own = METHODS.iter().filter(first);
    let own = own.map(|entry| entry.name().to_owned());
    own.chain(named.filter(|name| kind(name) == Kind::Outside))
        .collect()
}

/// The answers of these methods, in this order, with the macro-block's crack: for `all` settings of the
/// head joints, or for the one that governs.
fn views<'a>(result: &'a CaseResult, methods: &[String], all: bool) -> Vec<View<'a>> {
    let first = governing(&result.conclusions).map(|first| result.conclusions[first].head_joints);
    let settings = result.scenes.iter().map(|(head_joints, _)| *head_joints);
    let settings = settings.filter(|of| all || Some(*of) == first);
    let mut rows = result.rows.iter();
    let closed = rows.find(|row| row.kind() == Kind::ClosedForm);
    let macro_slope = closed.and_then(|row| Some(row.crack?.tan_beta));
    let view = |name: &String, head_joints: HeadJoints| {
        let mut rows = result.rows.iter();
        let row = rows.find(|row| row.method == *name && row.head_joints == head_joints)?;
        let (scene, row) = result.governing(row);
        Some(View {
            scene,
            row,
            macro_slope,
        })
    };
    settings
        .flat_map(|of| methods.iter().filter_map(move |name| view(name, of)))
        .collect()
}
