//! The command line of trilith.

fn main() -> std::process::ExitCode {
    trilith::main()
}
