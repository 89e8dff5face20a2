//! What came out, in figures, and everything that does not simply hold.

use maud::{Markup, html};

use super::sortable::{TableCell, sortable};
use crate::answer::Status;
use crate::judge::Verdict;
use crate::run::CaseResult;

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
    let of_status = |status: &Status| {
        let class = match status {
            Status::Verified => "good",
            Status::Undecided => "mixed",
            Status::Failed => "bad",
            _ => "",
        };
        (statuses(*status), status.name(), class)
    };
    let results_by_status = Status::ALL.iter().map(of_status);
    let results_by_status = results_by_status.filter(|(count, ..)| *count > 0);
    let checks_by_verdict = [
        (verdicts(Verdict::Holds), "hold", "good"),
        (verdicts(Verdict::Marked), "marked", "mixed"),
        (
            verdicts(Verdict::Deviates),
            "deviate, for a stated reason",
            "mixed",
        ),
        (verdicts(Verdict::NotDecided), "not decided", "mixed"),
        (verdicts(Verdict::Violated), "violated", "bad"),
    ];
    let tiles = [
        (
            format!("{} results of {} cases", rows.len(), results.len()),
            results_by_status.collect::<Vec<_>>(),
        ),
        (
            format!("{} checks", checks.len()),
            checks_by_verdict.to_vec(),
        ),
    ];
    let open: Vec<Vec<TableCell>> = checks
        .iter()
        .filter(|(_, check)| check.verdict > Verdict::Holds)
        .map(|(result, check)| {
            let name = &result.case.name;
            vec![
                TableCell::link(name, format!("#case-{name}")),
                TableCell::text(check.head_joints.name()),
                TableCell::text(&check.method),
                TableCell::word(check.verdict.name()),
                TableCell::text(&check.text),
            ]
        })
        .collect();
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
        @if !open.is_empty() {
            (sortable(
                "Checks that do not simply hold",
                &["Case", "Head joints", "Method", "Verdict", "What"],
                &open,
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
