//! What came out, in figures, and everything that does not simply hold.

use maud::{Markup, html};

use super::table::{TableCell, sortable};
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
    let statuses = |status| {
        rows.iter()
            .filter(|row| row.outcome.status == status)
            .count()
    };
    let bad = verdicts(Verdict::Violated) + statuses(Status::Failed);
    let headline = match (bad, verdicts(Verdict::NotDecided)) {
        (0, 0) => "Nothing is violated.",
        (0, _) => "Nothing is violated; some checks could not be decided.",
        _ => "Something is violated or failed: see below.",
    };
    let tiles = [
        (results.len(), "cases", ""),
        (rows.len(), "results", ""),
        (statuses(Status::Verified), "of them verified", "good"),
        (verdicts(Verdict::Holds), "checks hold", "good"),
        (verdicts(Verdict::Marked), "marked", "mixed"),
        (
            verdicts(Verdict::Deviates),
            "deviate, for a stated reason",
            "mixed",
        ),
        (verdicts(Verdict::NotDecided), "not decided", "mixed"),
        (bad, "violated or failed", if bad == 0 { "" } else { "bad" }),
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
        dl.tiles {
            @for (count, words, class) in tiles {
                div class=(class) { dt { (words) } dd { (count) } }
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
