//! Commands: arguments in, text and an exit status out.

mod atlas;
mod cases;
mod chart;
mod check;
mod draw;
mod external;
mod interrupt;
mod plan;
mod progress;
mod report;
mod run;
mod slurm;
mod solve;
mod sweep;

use std::path::PathBuf;
use std::process::ExitCode;

use clap::{Args, Parser, Subcommand, ValueEnum};
use plan::PlanArguments;
use sweep::{MergeArguments, SweepArguments};
use trilith::case::Template;

/// Validation and regression harness for the limit analysis of dry-joint masonry walls.
#[derive(Parser)]
#[command(version, arg_required_else_help = true)]
struct Arguments {
    #[command(subcommand)]
    command: Command,
}

#[derive(Subcommand)]
enum Command {
    /// Run the methods on cases and print published beside computed.
    Run(RunArguments),
    /// Check cases against their references and against each other; none named: the whole library.
    Check(CheckArguments),
    /// Draw a wall with its mechanism, as SVG.
    Draw(DrawArguments),
    /// Run a sweep over ranges of a case's values; interrupted and started again, it goes on.
    #[command(after_help = sweep::FORMAT)]
    Sweep(SweepArguments),
    /// Merge the shards of a sweep that ran on several machines.
    Merge(MergeArguments),
    /// Draw speed against accuracy: every method over its ladder of settings.
    Chart(chart::ChartArguments),
    /// Map where each method is right, inaccurate, without an answer, or wrong.
    Atlas(atlas::AtlasArguments),
    /// Run the methods on cases and write one HTML file about it that needs nothing else.
    Report(ReportArguments),
    /// List the cases and sweeps that are built in, and the methods.
    List,
    /// Print a case as it is read: its file, blocks and joints.
    Show {
        /// A case file, or the name of a built-in case.
        case: String,
        /// Also every parameter with which the pushover runs the case, with its unit.
        #[arg(long)]
        pushover: bool,
    },
    /// Print the scene of a case as JSON, as external methods read it.
    Export {
        /// A case file, or the name of a built-in case.
        case: String,
        /// Head joints instead of the first that the case runs with.
        #[arg(long)]
        head_joints: Option<plan::HeadJointsArgument>,
    },
    /// Print the JSON schema of what external methods read or write.
    Schema {
        /// Which of the two.
        of: SchemaOf,
    },
    /// Write a commented template NAME.toml for a case of your own.
    New {
        /// Name of the case, or a path that ends in .toml.
        name: String,
        /// What the case is made of.
        #[arg(long, default_value = "wall")]
        kind: KindArgument,
    },
}

#[derive(Clone, Copy, ValueEnum)]
enum KindArgument {
    /// A coursed wall.
    Wall,
    /// Blocks of any convex shape.
    Blocks,
    /// A circular voussoir arch.
    Arch,
}

impl From<KindArgument> for Template {
    fn from(argument: KindArgument) -> Self {
        match argument {
            KindArgument::Wall => Template::Wall,
            KindArgument::Blocks => Template::Blocks,
            KindArgument::Arch => Template::Arch,
        }
    }
}

#[derive(Args)]
struct RunArguments {
    /// Case files, folders of them, or names of built-in cases; none: the paper's three walls.
    #[arg(value_name = "CASE")]
    cases: Vec<String>,
    #[command(flatten)]
    plan: PlanArguments,
    /// Also write results.csv, results.json and one record a case into this folder.
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
    /// How results are printed.
    #[arg(long, default_value = "table")]
    format: Format,
    /// Compare records with the .snap files in this folder; write .snap.new and exit 1 on change.
    #[arg(long, value_name = "DIR")]
    record: Option<PathBuf>,
}

#[derive(Args)]
struct CheckArguments {
    /// Case files, folders of them, or names of built-in cases; none: the whole library.
    #[arg(value_name = "CASE")]
    cases: Vec<String>,
    #[command(flatten)]
    plan: PlanArguments,
    /// Also write results.csv, results.json and one record a case into this folder.
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
}

#[derive(Args)]
struct DrawArguments {
    /// A case file, or the name of a built-in case.
    case: String,
    #[command(flatten)]
    plan: PlanArguments,
    /// Macro-block, interval and pushover beside each other, unless `--method` names others.
    #[arg(long)]
    side_by_side: bool,
    /// Also draw the contact forces of each method that gives them.
    #[arg(long)]
    forces: bool,
    /// The file to write.
    #[arg(short, long, value_name = "FILE.svg")]
    output: PathBuf,
}

#[derive(Args)]
struct ReportArguments {
    /// Case files, folders of them, or names of built-in cases; none: the paper's three walls.
    #[arg(value_name = "CASE")]
    cases: Vec<String>,
    #[command(flatten)]
    plan: PlanArguments,
    /// Also plot this sweep's `sweep.csv`; the overburden's is the paper's Fig. 7.
    #[arg(long, value_name = "FILE.csv")]
    sweep: Vec<PathBuf>,
    /// Folder for report.html, results.csv, results.json and one record a case.
    #[arg(long, value_name = "DIR")]
    out: PathBuf,
}

#[derive(Clone, Copy, ValueEnum)]
enum Format {
    Table,
    Csv,
    Json,
}

#[derive(Clone, Copy, ValueEnum)]
enum SchemaOf {
    /// The scene, on standard input.
    Scene,
    /// The answer, on standard output.
    Result,
}

/// Exit status of a result that failed, a published value violated, a record that changed.
const REFUTED: u8 = 1;

/// Exit status of bad input and usage, which is also clap's.
const BAD_INPUT: u8 = 2;

/// Why a command stops, printed to standard error by [`main`].
struct Stop {
    text: String,
    status: u8,
}

impl Stop {
    fn bad_input(text: impl Into<String>) -> Self {
        Self {
            text: text.into(),
            status: BAD_INPUT,
        }
    }
}

/// Parses the arguments, runs the command, and turns its end into an exit status.
pub fn main() -> ExitCode {
    let done = match Arguments::parse().command {
        Command::Run(arguments) => run::run(&arguments),
        Command::Check(arguments) => check::check(&arguments),
        Command::Draw(arguments) => draw::draw(&arguments),
        Command::Sweep(arguments) => sweep::sweep(&arguments),
        Command::Merge(arguments) => sweep::merge(&arguments),
        Command::Chart(arguments) => chart::chart(&arguments),
        Command::Atlas(arguments) => atlas::atlas(&arguments),
        Command::Report(arguments) => report::report(&arguments),
        Command::List => cases::list(),
        Command::Show { case, pushover } => cases::show(&case, pushover),
        Command::Export { case, head_joints } => {
            external::export(&case, head_joints.map(Into::into))
        }
        Command::Schema { of } => external::schema(of),
        Command::New { name, kind } => cases::new(&name, kind.into()),
    };
    match done {
        Ok(status) => ExitCode::from(status),
        Err(stop) => {
            eprintln!("{}", stop.text.trim_end());
            ExitCode::from(stop.status)
        }
    }
}

/// Prints to standard output; a closed pipe ends the program quietly, as `head` expects.
fn print(text: &str) -> Result<(), Stop> {
    use std::io::Write;
    let mut out = std::io::stdout().lock();
    match out.write_all(text.as_bytes()).and_then(|()| out.flush()) {
        Err(e) if e.kind() != std::io::ErrorKind::BrokenPipe => {
            Err(Stop::bad_input(format!("error: cannot write results: {e}")))
        }
        _ => Ok(()),
    }
}
