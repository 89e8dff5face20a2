//! The colours of verdicts and statuses, and what columns look like on a screen.

use anstyle::{AnsiColor, Style};

use crate::answer::Status;
use crate::judge::Verdict;
use crate::run::column;
use crate::text::{GridColumn, numbers, words};

/// What a verdict looks like: green where it holds, yellow where it is to be looked at, red where it is
/// violated.
pub fn of_verdict(verdict: Verdict) -> Style {
    coloured(match verdict {
        Verdict::Holds => AnsiColor::Green,
        Verdict::Marked | Verdict::NotDecided | Verdict::Deviates => AnsiColor::Yellow,
        Verdict::Violated => return coloured(AnsiColor::Red).bold(),
    })
}

/// What the word of a verdict looks like; other words are plain.
fn of_verdict_word(word: &str) -> Style {
    let named = Verdict::ALL
        .into_iter()
        .find(|verdict| word.starts_with(verdict.name()));
    named.map_or(Style::new(), of_verdict)
}

/// What a status looks like: only a failure stands out.
pub(super) fn of_status(status: Status) -> Style {
    match status {
        Status::Failed => coloured(AnsiColor::Red).bold(),
        Status::Verified
        | Status::Bracketed
        | Status::Estimate
        | Status::Stands
        | Status::Falls
        | Status::NotApplicable
        | Status::Undecided => Style::new(),
    }
}

/// What the word of a status looks like; other words are plain.
fn of_status_word(word: &str) -> Style {
    let named = Status::ALL.into_iter().find(|status| status.name() == word);
    named.map_or(Style::new(), of_status)
}

/// A column of rows on a screen, which is always there.
pub(super) fn grid_column(name: &str) -> GridColumn {
    let heading = column(name).heading;
    match name {
        "error_percent" | "stated_percent" | "times_demand" | "width_c" | "width_e" => {
            numbers(heading)
        }
        "status" => words(heading).styled(of_status_word),
        "verdict" | "verdict_words" => words(heading).styled(of_verdict_word),
        _ => words(heading),
    }
}

fn coloured(colour: AnsiColor) -> Style {
    Style::new().fg_color(Some(colour.into()))
}
