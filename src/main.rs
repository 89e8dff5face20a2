//! The command line of trilith.

mod command;

use std::process::ExitCode;

fn main() -> ExitCode {
    command::main()
}
