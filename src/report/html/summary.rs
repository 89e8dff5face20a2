//! What came out, in figures, and everything that does not simply hold.

use maud::{Markup, html};

use super::sortable::{TableCell, sortable, status_class, verdict_class};
use crate::answer::Status;
use crate::judge::{Check, Verdict};
use crate::report::governing::Governing;
use crate::run::CaseResult;
use crate::text::counted;

/// The verdicts in the order of their tiles, and what is said of the checks.
const CHECK_TILES: [(Verdict, &str); Verdict::ALL.len()] = [
    (Verdict::Holds, "hold"),
    (Verdict::Marked, "marked"),
    (Verdict::Deviates, "deviate, for a stated reason"),
    (Verdict::NotDecided, "not decided"),
    (Verdict::Violated, "violated"),
];

/// What each case comes to, with a link to it.
pub fn verdicts(results: &[CaseResult]) -> Markup {
    html! {
        @for result in results {
            @let name = &result.case.name;
            @if let Some(governing) = Governing::of(result) {
                p.answer { b { a href={"#case-" (name)} { (name) } } ": " (governing.text()) }
            }
        }
    }
}

/// Counts of verdicts and statuses, then the checks that need a word.
pub fn summary(results: &[CaseResult]) -> Markup {
    let checks: Vec<_> = results
        .iter()
        .flat_map(|result| result.checks.iter().map(move |check| (result, check)))
        .collect();
    let rows: Vec<_> = results.iter().flat_map(|result| &result.rows).collect();
    let verdicts = |verdict| checks.iter().filter(|(_, c)| c.verdict == verdict).count();
    let statuses = |status| rows.iter().filter(|row| row.status() == status).count();
    let bad = verdicts(Verdict::Violated) + statuses(Status::Failed);
    let undecided = statuses(Status::Undecided);
    let headline = headline(bad, undecided, verdicts(Verdict::NotDecided));
    // Every result is in one tile of the first list, every check in one of the second.
    let by_status = Status::ALL.into_iter().map(|status| {
        let class = status_class(status).unwrap_or("");
        (statuses(status), status.name(), class)
    });
    let by_status: Vec<_> = by_status.filter(|(count, ..)| *count > 0).collect();
    let by_verdict =
        CHECK_TILES.map(|(verdict, words)| (verdicts(verdict), words, verdict_class(verdict)));
    let of_results = format!(
        "{} results of {}",
        rows.len(),
        counted(results.len(), "case")
    );
    let of_checks = format!("{} checks", checks.len());
    let tiles = [(of_results, by_status), (of_checks, by_verdict.into())];
    html! {
        p.headline.bad[bad > 0] { (headline) }
        @for (heading, tiles) in &tiles {
            p.tiles-title { (heading) }
            dl.tiles {
                @for (count, words, class) in tiles {
                    div class=(if *count > 0 { class } else { "" }) { dt { (words) } dd { (count) } }
                }
            }
        }
        (open(&checks))
    }
}

/// The checks that do not simply hold; nothing where there are none.
fn open(checks: &[(&CaseResult, &Check)]) -> Markup {
    let open = checks
        .iter()
        .filter(|(_, check)| check.verdict > Verdict::Holds);
    let lines = open.map(|(result, check)| {
        let name = &result.case.name;
        vec![
            TableCell::link(name, format!("#case-{name}")),
            TableCell::text(check.head_joints.name()),
            TableCell::text(&check.method),
            TableCell::verdict(check.verdict),
            TableCell::text(&check.text),
        ]
    });
    let lines: Vec<Vec<TableCell>> = lines.collect();
    html! {
        @if !lines.is_empty() {
            (sortable(
                "Checks that do not simply hold",
                &["Case", "Head joints", "Method", "Verdict", "What"],
                &lines,
            ))
        }
    }
}

/// Whether all is well, and how much is left open.
fn headline(bad: usize, undecided: usize, not_decided: usize) -> String {
    let headline = match bad {
        0 => "Nothing is violated",
        _ => "Something is violated or failed: see below",
    };
    let open_ends = [
        (undecided, "undecided", "result"),
        (not_decided, "not decided", "check"),
    ];
    let open_ends = open_ends.iter().filter(|(count, ..)| *count > 0);
    let open_ends: Vec<String> = open_ends
        .map(|(count, word, of)| match count {
            1 => format!("1 {of} is {word}"),
            _ => format!("{count} {of}s are {word}"),
        })
        .collect();
    match open_ends.as_slice() {
        [] => format!("{headline}."),
        all => format!("{headline}; {}.", all.join(", ")),
    }
}
