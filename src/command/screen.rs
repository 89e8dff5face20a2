//! The screens that a person reads: how wide they are, whether they have colours, and how complaints
//! fit them.

use std::io::{IsTerminal, Write};
use std::sync::OnceLock;

use crate::text::{LEAST_WIDTH, Layout, wrapped};
use anstream::{AutoStream, ColorChoice};
use anstyle::{AnsiColor, Style};
use clap::{Args, ValueEnum};

use super::stop::Stop;

/// Where the help has what every command takes.
pub(super) const HEADING: &str = "Screen and help";

/// Arguments of every command.
#[derive(Args)]
pub(super) struct ScreenArguments {
    /// Print every column, in lines of any length, also on a terminal.
    #[arg(long, global = true, conflicts_with = "width", help_heading = HEADING)]
    wide: bool,
    /// Fit tables and sentences into this many columns, 80 or more [default: the terminal's width; in a
    /// pipe or a file, lines of any length].
    #[arg(long, global = true, value_name = "COLUMNS", help_heading = HEADING,
          value_parser = clap::value_parser!(u16).range(80..))]
    width: Option<u16>,
    /// When verdicts and complaints are coloured; `NO_COLOR` in the environment means never.
    #[arg(long, global = true, value_name = "WHEN", default_value = "auto", help_heading = HEADING)]
    color: clap::ColorChoice,
    /// How standard error tells how far long work is: a bar on a terminal, or lines for a program,
    /// `progress SHARE SECONDS`, the share of the work that is done and the time left, and `proved SCENE
    /// PUSH LOWER STATE`, a lower bound as it grows and the lowest state.
    #[arg(long, global = true, value_name = "HOW", default_value = "bar", help_heading = HEADING,
          hide_short_help = true)]
    progress: ProgressArgument,
}

#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
enum ProgressArgument {
    Bar,
    Lines,
}

#[derive(Clone, Copy, Default)]
struct Screen {
    out: Layout,
    error: Layout,
    tells_progress: bool,
}

static SCREEN: OnceLock<Screen> = OnceLock::new();

impl ScreenArguments {
    /// Settles what the screens layout like, before anything is printed.
    pub(super) fn settle(&self) {
        let choice = match self.color {
            clap::ColorChoice::Auto => ColorChoice::Auto,
            clap::ColorChoice::Always => ColorChoice::Always,
            clap::ColorChoice::Never => ColorChoice::Never,
        };
        choice.write_global();
        let width = |terminal: Option<usize>| match (self.wide, self.width) {
            (true, _) => None,
            (false, Some(width)) => Some(usize::from(width)),
            (false, None) => terminal,
        };
        let (out, error) = (std::io::stdout(), std::io::stderr());
        let layout = |width, choice| Layout {
            width,
            colours: choice != ColorChoice::Never,
        };
        let _ = SCREEN.set(Screen {
            out: layout(width(columns(&out)), AutoStream::choice(&out)),
            error: layout(width(columns(&error)), AutoStream::choice(&error)),
            tells_progress: self.progress == ProgressArgument::Lines,
        });
    }
}

/// Columns of a stream that is a terminal; 80 where the terminal does not say.
fn columns(stream: &impl IsTerminal) -> Option<usize> {
    stream.is_terminal().then(|| {
        let size = terminal_size::terminal_size();
        size.map_or(LEAST_WIDTH, |(width, _)| usize::from(width.0))
    })
}

pub(super) fn layout() -> Layout {
    SCREEN.get().copied().unwrap_or_default().out
}

pub(super) fn tells_progress() -> bool {
    SCREEN.get().copied().unwrap_or_default().tells_progress
}

/// Prints to standard output; a closed pipe ends the program quietly, as `head` expects.
pub(super) fn print(text: &str) -> Result<(), Stop> {
    let mut out = std::io::stdout().lock();
    match out.write_all(text.as_bytes()).and_then(|()| out.flush()) {
        Err(e) if e.kind() != std::io::ErrorKind::BrokenPipe => {
            Err(Stop::not_written("results", e))
        }
        _ => Ok(()),
    }
}

/// Prints to standard output; lines that are too long for a terminal are wrapped.
pub(super) fn print_lines(text: &str) -> Result<(), Stop> {
    print(&wrapped(text, layout().width, 2))
}

/// Prints to standard error as `eprintln!` does, wrapped and coloured where that is a terminal.
macro_rules! tell {
    ($($text:tt)*) => {
        $crate::command::screen::tell_text(&format!($($text)*))
    };
}

pub(super) use tell;

/// Prints a text to standard error, as [`tell!`] does.
pub(super) fn tell_text(text: &str) {
    let layout = SCREEN.get().copied().unwrap_or_default().error;
    eprintln!("{}", fitted(text, layout));
}

/// Lines wrapped to the width, each further one below the first words of its own; complaints coloured.
fn fitted(text: &str, layout: Layout) -> String {
    let lines = text.split('\n').map(|line| fitted_line(line, layout));
    lines.collect::<Vec<_>>().join("\n")
}

fn fitted_line(line: &str, layout: Layout) -> String {
    let kinds = [
        ("error:", Some(AnsiColor::Red)),
        ("warning:", Some(AnsiColor::Yellow)),
        ("help:", Some(AnsiColor::Cyan)),
        ("= help:", Some(AnsiColor::Cyan)),
        ("-->", Some(AnsiColor::Blue)),
    ];
    let body = line.trim_start();
    let kind = kinds.iter().find(|(lead, _)| body.starts_with(lead));
    let (lead, colour) = kind.map_or(("", None), |&(lead, colour)| (lead, colour));
    // The lines of a file that a complaint shows stay as they are.
    let is_source = body
        .trim_start_matches(|c: char| c.is_ascii_digit() || c == ' ')
        .starts_with('|');
    let indent = if lead.is_empty() { 0 } else { lead.len() + 1 };
    let wrapped = match is_source {
        true => line.to_owned(),
        false => wrapped(line, layout.width, indent),
    };
    match colour.filter(|_| layout.colours) {
        Some(colour) => {
            let style = Style::new().bold().fg_color(Some(colour.into()));
            wrapped.replacen(lead, &format!("{style}{lead}{style:#}"), 1)
        }
        None => wrapped,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn complaints_are_wrapped_below_their_words_and_coloured() {
        let layout = |colours| Layout {
            width: Some(80),
            colours,
        };
        let long = "word ".repeat(30);
        let text = format!(
            "error: {long}\n  |\n3 | {}\n  = help: {long}",
            "x".repeat(90)
        );
        let plain = fitted(&text, layout(false));
        let lines: Vec<&str> = plain.lines().collect();
        assert!(lines[1].starts_with("       word"), "{plain}");
        assert!(
            lines
                .last()
                .is_some_and(|line| line.starts_with("          word")),
            "{plain}"
        );
        let long = lines.iter().filter(|line| line.len() > 80).count();
        assert_eq!(long, 1, "the line of the file alone:\n{plain}");
        let coloured = fitted(&text, layout(true));
        assert!(
            coloured.contains("\u{1b}[1m\u{1b}[31merror:\u{1b}[0m"),
            "{coloured:?}"
        );
        assert_eq!(fitted(&text, Layout::default()), text);
    }
}
