//! `trilith completions` and `trilith man`: what shells and `man` read, made of the definitions of the
//! arguments.

use std::path::PathBuf;

use clap::Args;
use clap_complete::Shell;
use clap_mangen::Man;

use super::output;
use super::screen::print;
use super::stop::Stop;

#[derive(Args)]
pub(super) struct CompletionsArguments {
    /// The shell that reads them.
    shell: Shell,
}

#[derive(Args)]
pub(super) struct ManArguments {
    /// The command that the page is about; none: all of trilith.
    command: Option<String>,
    /// Write the pages of all commands into this folder instead: trilith.1, trilith-run.1 and so on.
    #[arg(long, value_name = "DIR", conflicts_with = "command")]
    out: Option<PathBuf>,
}

pub(super) fn completions(
    arguments: &CompletionsArguments,
    mut trilith: clap::Command,
) -> Result<u8, Stop> {
    let mut script = Vec::new();
    clap_complete::generate(arguments.shell, &mut trilith, "trilith", &mut script);
    print(&String::from_utf8_lossy(&script))?;
    Ok(0)
}

pub(super) fn man(arguments: &ManArguments, trilith: clap::Command) -> Result<u8, Stop> {
    let mut trilith = trilith.disable_help_subcommand(true);
    trilith.build();
    if let Some(folder) = &arguments.out {
        output::test(folder)?;
        let commands = trilith.get_subcommands().chain([&trilith]);
        let pages = commands.map(|command| {
            let page = Man::new(command.clone());
            Ok((page.get_filename(), text(&page)?))
        });
        output::write(folder, pages.collect::<Result<_, Stop>>()?)?;
        return Ok(0);
    }
    let command = match &arguments.command {
        None => &trilith,
        Some(name) => trilith.find_subcommand(name).ok_or_else(|| {
            let names: Vec<&str> = trilith.get_subcommands().map(|c| c.get_name()).collect();
            let names = names.join(", ");
            Stop::bad_input(format!(
                "error: there is no command named `{name}`\nhelp: commands are {names}"
            ))
        })?,
    };
    print(&text(&Man::new(command.clone()))?)?;
    Ok(0)
}

fn text(page: &Man) -> Result<String, Stop> {
    let mut text = Vec::new();
    page.render(&mut text)
        .map_err(|e| Stop::not_written("the page", e))?;
    Ok(String::from_utf8_lossy(&text).into_owned())
}
