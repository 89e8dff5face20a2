//! Commands: arguments in, text and an exit status out.

mod atlas;
mod cases;
mod chart;
mod check;
mod convert;
mod draw;
mod drawing;
mod export;
mod interrupt;
mod output;
mod pages;
mod plan;
mod progress;
mod reference;
mod report;
mod run;
mod screen;
mod settings;
mod show;
mod slurm;
mod solve;
mod stop;
mod sweep;

use std::process::ExitCode;

use clap::error::{ContextKind, ContextValue};
use clap::{ArgAction, CommandFactory, Parser, Subcommand};

use crate::case::nearest;

/// Validation and regression harness for the limit analysis of dry-joint masonry walls.
#[derive(Parser)]
#[command(version, arg_required_else_help = true, term_width = 80)]
#[command(
    propagate_version = true,
    disable_version_flag = true,
    disable_help_flag = true
)]
struct Arguments {
    #[command(flatten)]
    screen: screen::ScreenArguments,
    #[command(subcommand)]
    command: Command,
    /// Print this help: `--help` all of it, `-h` what is used most.
    #[arg(short, long, global = true, action = ArgAction::Help, help_heading = screen::HEADING)]
    help: Option<bool>,
    /// Print the version.
    #[arg(short = 'V', visible_short_alias = 'v', long, global = true)]
    #[arg(action = ArgAction::Version, help_heading = screen::HEADING)]
    version: Option<bool>,
}

#[derive(Subcommand)]
enum Command {
    /// Run the methods on cases and print what each answers and what it all comes to.
    #[command(after_long_help = reference::RUN)]
    Run(run::RunArguments),
    /// Check the answers against published values and against each other; where no case is named, for the
    /// whole library.
    Check(check::CheckArguments),
    /// Draw a wall and how it collapses, as SVG.
    Draw(draw::DrawArguments),
    /// Vary values of a case over ranges; a sweep that is interrupted goes on when it is started again.
    #[command(after_help = sweep::FORMAT)]
    Sweep(sweep::SweepArguments),
    /// Merge the parts of a sweep that ran on several machines.
    Merge(sweep::MergeArguments),
    /// Draw speed against accuracy: every method with settings from fast to accurate.
    #[command(after_long_help = reference::CHART)]
    Chart(chart::ChartArguments),
    /// Map where each method is right, inaccurate, without an answer or wrong.
    #[command(after_long_help = reference::ATLAS)]
    Atlas(atlas::AtlasArguments),
    /// Run the methods on cases and write a report, one HTML file that needs nothing else.
    Report(report::ReportArguments),
    /// List the cases and sweeps that are built in, and the methods.
    List,
    /// Print a case as it is read: its file, blocks and joints.
    Show {
        /// A case file, the name of a built-in case, or `-` for a case in standard input.
        case: String,
        /// Also print every parameter that the pushover runs the case with, and its unit.
        #[arg(long)]
        pushover: bool,
    },
    /// Print the scene of a case as JSON, as external methods read it.
    #[command(after_long_help = reference::EXPORT)]
    Export(export::ExportArguments),
    /// Make a case from a DXF drawing or a model of COMPAS: every closed outline becomes a block.
    #[command(after_long_help = reference::IMPORT)]
    Import(convert::ImportArguments),
    /// Write a case of any form as explicit blocks, a case file with a CSV beside it.
    Convert(convert::ConvertArguments),
    /// Print the JSON schema of what external methods read or write.
    Schema {
        /// Which of the two.
        of: export::SchemaOf,
    },
    /// Write a commented template NAME.toml for a case of your own.
    New {
        /// Name of the case, or a path that ends in .toml.
        name: String,
        /// What the case is made of.
        #[arg(long, default_value = "wall")]
        kind: cases::KindArgument,
    },
    /// Print completions for a shell.
    #[command(after_help = COMPLETIONS)]
    Completions(pages::CompletionsArguments),
    /// Print the man page, as troff: `trilith man | man -l -`.
    Man(pages::ManArguments),
}

/// Where completions go.
const COMPLETIONS: &str = "\
To have them in every new shell:
  bash  trilith completions bash > ~/.local/share/bash-completion/completions/trilith
  zsh   trilith completions zsh > DIR/_trilith, DIR a folder in $fpath
  fish  trilith completions fish > ~/.config/fish/completions/trilith.fish";

/// The mistake with the command that may be meant, also where clap finds none.
fn suggesting(mut error: clap::Error) -> clap::Error {
    let written = match error.get(ContextKind::InvalidSubcommand) {
        Some(ContextValue::String(written)) => written.clone(),
        _ => return error,
    };
    let trilith = Arguments::command();
    let commands = trilith.get_subcommands().map(clap::Command::get_name);
    if error.get(ContextKind::SuggestedSubcommand).is_none()
        && let Some(near) = nearest(&written, commands)
    {
        let near = ContextValue::Strings(vec![near.to_owned()]);
        error.insert(ContextKind::SuggestedSubcommand, near);
    }
    error
}

/// Parses the arguments, runs the command, and turns its end into an exit status.
pub fn main() -> ExitCode {
    interrupt::watch();
    let arguments = Arguments::try_parse().unwrap_or_else(|error| suggesting(error).exit());
    arguments.screen.settle();
    let done = match arguments.command {
        Command::Run(arguments) => run::run(&arguments),
        Command::Check(arguments) => check::check(&arguments),
        Command::Draw(arguments) => draw::draw(&arguments),
        Command::Sweep(arguments) => sweep::sweep(&arguments),
        Command::Merge(arguments) => sweep::merge(&arguments),
        Command::Chart(arguments) => chart::chart(&arguments),
        Command::Atlas(arguments) => atlas::atlas(&arguments),
        Command::Report(arguments) => report::report(&arguments),
        Command::List => cases::list(),
        Command::Show { case, pushover } => show::show(&case, pushover),
        Command::Export(arguments) => export::export(&arguments),
        Command::Import(arguments) => convert::import(&arguments),
        Command::Convert(arguments) => convert::convert(&arguments),
        Command::Schema { of } => export::schema(of),
        Command::New { name, kind } => cases::new(&name, kind),
        Command::Completions(arguments) => pages::completions(&arguments, Arguments::command()),
        Command::Man(arguments) => pages::man(&arguments, Arguments::command()),
    };
    match done {
        Ok(status) => ExitCode::from(status),
        Err(stop) => {
            screen::tell_text(stop.text.trim_end());
            ExitCode::from(stop.status)
        }
    }
}
