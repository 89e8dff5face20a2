//! The verification manual: every case on a page of its own, with what it is, what is known of it, what
//! every method answers, and what the judge computed of that.

use maud::{Markup, PreEscaped, html};

use super::document::{Document, document};
use super::panel::verdict;
use super::prose;
use super::ranges::range_figure;
use super::residuals::in_short;
use super::sortable::{TableCell, cells, plain, titles};
use super::witnesses::witnesses;
use crate::judge::{Check, Verdict};
use crate::method::Settings;
use crate::number::nine_digits;
use crate::run::{CaseResult, Partial};

/// The manual of these results as a page.
pub fn manual(results: &[CaseResult], settings: &Settings, partial: Option<&Partial>) -> String {
    let lead = format!(
        "{} cases: what each is, what is known of it from elsewhere, what every method answers, and \
         the residuals that the judge recomputed.",
        results.len()
    );
    let after = html! {
        section.case id="reading" { h2 { "How to read it" } (prose::reading()) }
        section id="made-with" { h2 { "Made with" } (prose::made_with(settings)) }
    };
    cases(results, ("Verification manual", lead), Some(after), partial)
}

/// A page for each of these cases and nothing else, as for a file on one's own wall.
pub fn pages(results: &[CaseResult], partial: Option<&Partial>) -> String {
    let lead =
        "What it comes to, the wall as it was read, and what every method answers.".to_owned();
    cases(
        results,
        ("Collapse of dry-joint masonry", lead),
        None,
        partial,
    )
}

fn cases(
    results: &[CaseResult],
    (heading, lead): (&str, String),
    after: Option<Markup>,
    partial: Option<&Partial>,
) -> String {
    let links = results.iter().map(|result| {
        let name = &result.case.name;
        (format!("case-{name}"), name.clone())
    });
    let links: Vec<_> = links.collect();
    let said = partial.map_or("", |_| "PARTIAL: ");
    document(&Document {
        title: format!("{said}trilith: {}", heading.to_lowercase()),
        class: if links.len() > 1 {
            "manual"
        } else {
            "manual single"
        },
        heading,
        lead,
        links,
        body: html! {
            @if let Some(partial) = partial { p.headline.bad { (partial) } }
            @for result in results { (case(result, after.is_some())) }
            @if let Some(after) = &after { (after) }
        },
    })
}

/// A case; the `notes` and residuals of all methods fill more than a sheet.
fn case(result: &CaseResult, notes: bool) -> Markup {
    let name = &result.case.name;
    html! {
        section.case id={"case-" (name)} {
            h2 { (name) }
            (verdict(result))
            div.drawings {
                @if let Some(svg) = range_figure(result) { figure.drawing { (PreEscaped(svg)) } }
            }
            @if !result.case.references.is_empty() { (references(result)) }
            (answers(result, notes))
            (witnesses(name))
            @for conclusion in &result.conclusions {
                p.answer { b { (conclusion.head_joints.name()) " head joints: " } (conclusion) }
            }
            (open_checks(result))
            (in_short(result, notes))
        }
    }
}

fn references(result: &CaseResult) -> Markup {
    let references = result.case.references.iter().map(|r| {
        let about = match &r.deviation {
            Some(reason) => format!("{}. Known deviation: {reason}", r.source),
            None if r.note.is_empty() => r.source.clone(),
            None => format!("{}. {}", r.source, r.note),
        };
        vec![
            TableCell::text(&r.method),
            TableCell::text(r.head_joints.map_or("both", |only| only.name())),
            TableCell::text(r.quantity.name()),
            TableCell::number(nine_digits(r.value)),
            TableCell::number(nine_digits(r.tolerance)),
            TableCell::text(r.kind.name()),
            TableCell::text(about),
        ]
    });
    let columns = [
        "About",
        "Joints",
        "Quantity",
        "Value",
        "Tolerance",
        "Kind",
        "Source",
    ];
    let references: Vec<_> = references.collect();
    plain("Known from elsewhere", &columns, &references)
}

fn answers(result: &CaseResult, notes: bool) -> Markup {
    let columns = [
        "method",
        "head_joints",
        "status",
        "lambda",
        "stated_percent",
        "lambda_reference",
        "error_percent",
        "slope",
        "verdict",
        "note",
    ];
    let columns = &columns[..columns.len() - usize::from(!notes)];
    let rows = result.rows.iter().map(|row| cells(row, columns));
    plain("Answers", &titles(columns), &rows.collect::<Vec<_>>())
}

/// How many checks hold, and those that do not simply.
fn open_checks(result: &CaseResult) -> Markup {
    let (open, hold): (Vec<&Check>, Vec<&Check>) =
        (result.checks.iter()).partition(|check| check.verdict > Verdict::Holds);
    html! {
        p { (hold.len()) " of " (result.checks.len()) " checks hold." }
        ul.checks {
            @for check in open {
                li { b { (check.verdict.name()) } ", " (check.head_joints.name()) ": " (check.text) }
            }
        }
    }
}
