//! The library's cross-check: every result beside its references, and what each method is worth.
//!
//! Columns have fixed widths and lines hold no times, so that the texts of two runs differ only in
//! the lines of results that differ.

use std::fmt::Write;

use anstyle::Style;
use indexmap::IndexMap;

use super::styles::{grid_column, of_status, of_verdict};
use crate::answer::{Bracket, Status, magnitude};
use crate::case::Reference;
use crate::judge::{Verdict, comparisons};
use crate::number::{number, short};
use crate::record::fixed_width;
use crate::run::{CaseResult, Row};
use crate::text::{GridColumn, Layout, bold, counted, ended, grid, numbers, sentence, words};

/// Columns of a reference beside what was computed.
fn grid_columns() -> [GridColumn; 9] {
    [
        grid_column("method"),
        grid_column("head_joints"),
        grid_column("status").spare(1),
        words("computed"),
        words("quantity"),
        words("reference"),
        words("kind").spare(2),
        grid_column("error_percent"),
        grid_column("verdict"),
    ]
}

/// Widths of these columns where lines may be of any length, the case before them.
const WIDTHS: [usize; 10] = [24, 12, 8, 15, 18, 9, 9, 12, 8, 0];

/// What comes before the first case.
pub fn library_heading(layout: Layout) -> String {
    if layout.columns().is_some() {
        return String::new();
    }
    let headings = grid_columns().map(|column| column.heading);
    format!(
        "references\n{}",
        line(std::iter::once("case").chain(headings))
    )
}

/// Of one case, one line a reference; one line for a row without any; last what it all comes to.
pub fn library_case(result: &CaseResult, layout: Layout) -> String {
    let lines: Vec<Vec<String>> = result
        .rows
        .iter()
        .flat_map(|row| against(result, row))
        .collect();
    let name = result.case.name.as_str();
    let is_narrow = layout.columns().is_some();
    let mut text = if is_narrow {
        let title = layout.paragraph(name, bold(), &format!(": {}", result.case.title));
        title + &grid(layout, 0, &grid_columns(), &lines)
    } else {
        let lines = lines.iter().map(|cells| {
            let cells = cells.iter().map(String::as_str);
            line(std::iter::once(name).chain(cells))
        });
        lines.collect()
    };
    if let Some(partial) = result.partial() {
        text.push_str(&if is_narrow {
            layout.paragraph("", Style::new(), &partial)
        } else {
            columns([(name, 24), (&partial, 0)].into_iter())
        });
    }
    for conclusion in &result.conclusions {
        let (joints, words) = (conclusion.head_joints.name(), conclusion.to_string());
        text.push_str(&if is_narrow {
            layout.paragraph(&format!("{joints:<8}  "), bold(), &sentence(&words))
        } else {
            let cells = [(name, 24), ("answer", 12), (joints, 8), (&words, 0)];
            columns(cells.into_iter())
        });
    }
    if is_narrow {
        text.push('\n');
    }
    text
}

/// What comes behind the last case: what each method is worth, and what does not hold.
pub fn library_closing(results: &[CaseResult], layout: Layout) -> String {
    [
        methods(results, layout),
        unsettled(results, layout),
        closing(results, layout),
    ]
    .concat()
}

/// A row beside its references: the cells of a line each.
fn against(result: &CaseResult, row: &Row) -> Vec<Vec<String>> {
    let unit = row.multiplier_unit;
    let line =
        |computed: String, [quantity, reference, kind, error]: [String; 4], verdict: &str| {
            vec![
                row.method.clone(),
                row.head_joints.name().to_owned(),
                row.status().name().to_owned(),
                computed,
                quantity,
                reference,
                kind,
                error,
                verdict.to_owned(),
            ]
        };
    let (joints, method) = (row.head_joints, &row.method);
    let compared = comparisons(&result.case, joints, method, &row.computed(), unit);
    if compared.is_empty() {
        let none = ["lambda", "-", "-", "-"].map(str::to_owned);
        let worst = row.verdict.map_or("-", Verdict::name);
        return vec![line(ends(row.bracket(), unit), none, worst)];
    }
    let lines = compared.into_iter().map(|comparison| {
        let reference = comparison.reference;
        let against = [
            reference.quantity.name().to_owned(),
            short(reference.value, 6),
            reference.kind.name().to_owned(),
            comparison.error.map_or("-".to_owned(), percent),
        ];
        let computed = ends(comparison.computed, unit);
        line(computed, against, comparison.verdict.name())
    });
    lines.collect()
}

fn line<'a>(cells: impl Iterator<Item = &'a str>) -> String {
    columns(cells.zip(WIDTHS))
}

/// Cells, each padded to its width, as a line.
fn columns<'a>(cells: impl Iterator<Item = (&'a str, usize)>) -> String {
    fixed_width(cells) + "\n"
}

fn rows(results: &[CaseResult]) -> impl Iterator<Item = (&CaseResult, &Row)> {
    results
        .iter()
        .flat_map(|result: &CaseResult| result.rows.iter().map(move |row| (result, row)))
}

/// A value with the decimals that every method's table has.
fn ends(bracket: Option<Bracket>, unit: f64) -> String {
    let Some(Bracket { lower, upper }) = bracket else {
        return "-".to_owned();
    };
    if upper - lower <= 2e-6 * magnitude(upper, unit) {
        number(lower, 5)
    } else {
        format!("{} - {}", number(lower, 5), number(upper, 5))
    }
}

fn percent(error: f64) -> String {
    number(100.0 * error, 2)
}

/// What is counted of rows: a heading, and whether a row counts below it.
type Count = (&'static str, fn(&Row, &str) -> bool);

const COUNTS: [Count; 11] = [
    ("scenes", |_, _| true),
    ("numbers", |row, _| row.bracket().is_some()),
    ("verified", is_headed),
    ("endings", is_headed),
    ("declined", is_headed),
    ("undecided", is_headed),
    ("failed", is_headed),
    ("compared", |row, _| row.error().is_some()),
    ("0.1 %", |row, _| is_within(row, 1e-3)),
    ("1 %", |row, _| is_within(row, 1e-2)),
    ("5 %", |row, _| is_within(row, 5e-2)),
];

fn is_headed(row: &Row, heading: &str) -> bool {
    counted_below(row.status()) == Some(heading)
}

/// The heading below which a status is counted, where a number alone does not say it.
fn counted_below(status: Status) -> Option<&'static str> {
    match status {
        Status::Verified => Some("verified"),
        Status::Stands | Status::Falls => Some("endings"),
        Status::NotApplicable => Some("declined"),
        Status::Undecided => Some("undecided"),
        Status::Failed => Some("failed"),
        Status::Bracketed | Status::Estimate => None,
    }
}

/// Whether the error is so small, relative to the reference. One that is printed to the limit's own digit
/// must not fall beside it.
fn is_within(row: &Row, limit: f64) -> bool {
    row.error().is_some_and(|e| e <= limit * (1.0 + 1e-9))
}

/// How each method ended, and how far off its answers are: one line a method.
fn methods(results: &[CaseResult], layout: Layout) -> String {
    let mut of_methods: IndexMap<&str, Vec<&Row>> = IndexMap::new();
    for (_, row) in rows(results) {
        of_methods.entry(&row.method).or_default().push(row);
    }
    let part = |shown: &[Count]| {
        let headings = shown.iter().map(|(heading, _)| numbers(heading));
        let headings: Vec<_> = std::iter::once(words("method")).chain(headings).collect();
        let lines = of_methods.iter().map(|(name, own)| {
            let counts = shown.iter().map(|(heading, counts)| {
                let counted = own.iter().filter(|row| counts(row, heading));
                counted.count().to_string()
            });
            std::iter::once((*name).to_owned()).chain(counts).collect()
        });
        grid(layout, 0, &headings, &lines.collect::<Vec<_>>())
    };
    let tables = match layout.columns() {
        Some(_) => format!("{}\n{}", part(&COUNTS[..7]), part(&COUNTS[7..])),
        None => part(&COUNTS),
    };
    let heading = layout.painted("methods", bold());
    let legend = "endings: answers that a scene stands or falls; declined: the method is not \
                  applicable; compared: answers with a multiplier and a reference for it, and behind \
                  it how many of these lie within an error of 0.1, 1 and 5 %, where the farther end \
                  of a range counts";
    let legend = layout.paragraph("", Style::new(), legend);
    format!("\n{heading}\n{tables}{legend}")
}

/// Everything that does not hold, with its reason.
fn unsettled(results: &[CaseResult], layout: Layout) -> String {
    let mut text = String::new();
    let parts = [
        ("violated", Verdict::Violated),
        ("known deviations", Verdict::Deviates),
        ("not decided", Verdict::NotDecided),
        ("marked", Verdict::Marked),
    ];
    for (title, verdict) in parts {
        let lines = results.iter().flat_map(|result| {
            let checks = result.checks.iter();
            let checks = checks.filter(move |check| check.verdict == verdict);
            checks.map(|check| {
                let joints = check.head_joints.name();
                remark(layout, [&result.case.name, joints], &check.text)
            })
        });
        section(&mut text, layout.painted(title, of_verdict(verdict)), lines);
    }
    for status in [Status::Failed, Status::Undecided] {
        let rows = rows(results).filter(|(_, row)| row.status() == status);
        let lines = rows.map(|(result, row)| {
            let (joints, reason) = (row.head_joints.name(), row.reason());
            remark(layout, [&result.case.name, joints, &row.method], &reason)
        });
        let title = layout.painted(status.name(), of_status(status));
        section(&mut text, title, lines);
    }
    text
}

/// What is to be said about a case and more that names it: a line, or a paragraph on a screen.
fn remark<const N: usize>(layout: Layout, about: [&str; N], words: &str) -> String {
    if layout.columns().is_some() {
        let words = format!("{}: {}", about.join(" "), ended(words));
        return layout.paragraph("  ", Style::new(), &words);
    }
    let about = about.into_iter().zip([24, 8, 12]);
    columns(about.chain([(words, 0)]))
}

fn section(text: &mut String, title: String, lines: impl Iterator<Item = String>) {
    let lines: Vec<String> = lines.collect();
    if !lines.is_empty() {
        let _ = write!(text, "\n{title}\n{}", lines.concat());
    }
}

/// One line: how much was checked, and whether all is well.
fn closing(results: &[CaseResult], layout: Layout) -> String {
    let checks = || results.iter().flat_map(|result| &result.checks);
    let violated = checks()
        .filter(|check| check.verdict == Verdict::Violated)
        .count();
    let failed = rows(results)
        .filter(|(_, row)| row.status() == Status::Failed)
        .count();
    let references = || {
        let of = |result| move |reference| (result, reference);
        let results = results.iter();
        results.flat_map(move |result| result.case.references.iter().map(of(result)))
    };
    let compared = references().filter(|(result, reference): &(&CaseResult, &Reference)| {
        let is_about = |only| reference.head_joints.is_none_or(|joints| joints == only);
        let mut rows = result.rows.iter();
        rows.any(|row| row.method == reference.method && is_about(row.head_joints))
    });
    let counts = format!(
        "{}, {}, {} of {} compared, {}:",
        counted(results.len(), "case"),
        counted(rows(results).count(), "result"),
        compared.count(),
        counted(references().count(), "reference value"),
        counted(checks().count(), "check"),
    );
    let style = of_verdict(if violated + failed > 0 {
        Verdict::Violated
    } else {
        Verdict::Holds
    });
    let ends = format!("{violated} violated, {failed} failed");
    let counts = layout.paragraph("", Style::new(), &counts);
    format!("\n{counts}{}", layout.paragraph(&ends, style, ""))
}
