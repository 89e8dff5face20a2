//! The library's cross-check: every result beside its references, and what each method is worth.
//!
//! Columns have fixed widths and lines hold no times, so that the texts of two runs differ only in
//! the lines of results that differ.

use std::fmt::Write;

use indexmap::IndexMap;

use crate::answer::{Bracket, Status, magnitude};
use crate::judge::{Verdict, comparisons};
use crate::number::{number, short};
use crate::record::fixed_width;
use crate::run::{CaseResult, Row};

/// Limits of error that answers are counted within, relative to the reference.
const LIMITS: [f64; 3] = [1e-3, 1e-2, 5e-2];

/// What comes before the first case.
pub fn library_heading() -> String {
    let heading = [
        "case",
        "joints",
        "method",
        "status",
        "computed",
        "quantity",
        "reference",
        "kind",
        "error %",
        "verdict",
    ];
    format!("references\n{}", line(heading.map(str::to_owned)))
}

/// Of one case, one line a reference; one line for a row without any; last what it all comes to.
pub fn library_case(result: &CaseResult) -> String {
    let mut text = String::new();
    for row in &result.rows {
        let unit = row.multiplier_unit;
        let compared = comparisons(
            &result.case,
            row.head_joints,
            &row.method,
            &row.outcome,
            unit,
        );
        if compared.is_empty() {
            let lambda = ends(row.bracket(), row.multiplier_unit);
            let none = ["lambda", "-", "-", "-"].map(str::to_owned);
            let worst = row.verdict.map_or("-", Verdict::name);
            text.push_str(&reference_line(row, lambda, none, worst));
        }
        for comparison in compared {
            let reference = comparison.reference;
            let against = [
                reference.quantity.name().to_owned(),
                short(reference.value, 6),
                reference.kind.name().to_owned(),
                comparison.error.map_or("-".to_owned(), percent),
            ];
            let computed = ends(comparison.computed, unit);
            let verdict = comparison.verdict.name();
            text.push_str(&reference_line(row, computed, against, verdict));
        }
    }
    if let Some(partial) = result.partial() {
        text.push_str(&columns(
            [(result.case.name.as_str(), 24), (&partial, 0)].into_iter(),
        ));
    }
    for conclusion in &result.conclusions {
        let cells = [
            (result.case.name.as_str(), 24),
            (conclusion.head_joints.name(), 8),
            ("answer", 12),
            (&conclusion.to_string(), 0),
        ];
        text.push_str(&columns(cells.into_iter()));
    }
    text
}

/// What comes behind the last case: what each method is worth, and what does not hold.
pub fn library_closing(results: &[CaseResult]) -> String {
    [methods(results), unsettled(results), closing(results)].concat()
}

fn reference_line(
    row: &Row,
    computed: String,
    [quantity, reference, kind, error]: [String; 4],
    verdict: &str,
) -> String {
    line([
        row.case.clone(),
        row.head_joints.name().to_owned(),
        row.method.clone(),
        row.outcome.status.name().to_owned(),
        computed,
        quantity,
        reference,
        kind,
        error,
        verdict.to_owned(),
    ])
}

fn line(cells: [String; 10]) -> String {
    let widths = [24, 8, 12, 15, 18, 9, 9, 12, 8, 0];
    columns(cells.iter().map(String::as_str).zip(widths))
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

/// What one method did over all cases.
#[derive(Default)]
struct Tally {
    scenes: usize,
    numbers: usize,
    verified: usize,
    endings: usize,
    declined: usize,
    undecided: usize,
    failed: usize,
    compared: usize,
    within: [usize; LIMITS.len()],
}

impl Tally {
    fn count(&mut self, row: &Row) {
        self.scenes += 1;
        self.numbers += usize::from(row.bracket().is_some());
        match row.status() {
            Status::Verified => self.verified += 1,
            Status::Stands | Status::Falls => self.endings += 1,
            Status::NotApplicable => self.declined += 1,
            Status::Undecided => self.undecided += 1,
            Status::Failed => self.failed += 1,
            Status::Bracketed | Status::Estimate => {}
        }
        let Some(error) = row.error() else {
            return;
        };
        self.compared += 1;
        for (count, limit) in self.within.iter_mut().zip(LIMITS) {
            // A reference printed to the limit's own digit must not fall beside it.
            *count += usize::from(error <= limit * (1.0 + 1e-9));
        }
    }

    fn cells(&self) -> Vec<String> {
        let counts = [
            self.scenes,
            self.numbers,
            self.verified,
            self.endings,
            self.declined,
            self.undecided,
            self.failed,
            self.compared,
        ];
        counts
            .iter()
            .chain(&self.within)
            .map(usize::to_string)
            .collect()
    }
}

/// One line a method.
fn methods(results: &[CaseResult]) -> String {
    let mut tallies: IndexMap<&str, Tally> = IndexMap::new();
    for (_, row) in rows(results) {
        tallies.entry(&row.method).or_default().count(row);
    }
    let heading = [
        "method",
        "scenes",
        "numbers",
        "verified",
        "endings",
        "declined",
        "undecided",
        "failed",
        "compared",
        "0.1 %",
        "1 %",
        "5 %",
    ];
    let widths = [12, 7, 8, 9, 8, 9, 10, 7, 9, 6, 6, 0];
    let mut text = String::from("\nmethods\n");
    text.push_str(&columns(heading.into_iter().zip(widths)));
    for (name, tally) in tallies {
        let cells = tally.cells();
        let cells = std::iter::once(name).chain(cells.iter().map(String::as_str));
        text.push_str(&columns(cells.zip(widths)));
    }
    text.push_str(
        "endings: stands or falls; declined: not applicable; compared: answers with a multiplier \
         and a reference for it, and how many of them lie within these errors (the farther end \
         counts)\n",
    );
    text
}

/// Everything that does not hold, with its reason.
fn unsettled(results: &[CaseResult]) -> String {
    let mut text = String::new();
    let parts = [
        ("violated", Verdict::Violated),
        ("known deviations", Verdict::Deviates),
        ("not decided", Verdict::NotDecided),
        ("marked", Verdict::Marked),
    ];
    for (title, verdict) in parts {
        let mut lines = Vec::new();
        for result in results {
            let checks = result.checks.iter();
            lines.extend(
                checks
                    .filter(|check| check.verdict == verdict)
                    .map(|check| {
                        let joints = check.head_joints.name();
                        format!("{:<24} {joints:<8} {}\n", result.case.name, check.text)
                    }),
            );
        }
        section(&mut text, title, lines.into_iter());
    }
    let told = |statuses: &'static [Status]| {
        let rows = rows(results).filter(|(_, row)| statuses.contains(&row.outcome.status));
        rows.map(|(result, row)| {
            columns(
                [
                    (result.case.name.as_str(), 24),
                    (row.head_joints.name(), 8),
                    (row.method.as_str(), 12),
                    (row.outcome.reason().as_str(), 0),
                ]
                .into_iter(),
            )
        })
    };
    section(&mut text, "failed", told(&[Status::Failed]));
    section(&mut text, "undecided", told(&[Status::Undecided]));
    text
}

/// A section, where it has lines.
fn section(text: &mut String, title: &str, lines: impl Iterator<Item = String>) {
    let lines: Vec<String> = lines.collect();
    if !lines.is_empty() {
        let _ = write!(text, "\n{title}\n{}", lines.concat());
    }
}

/// One line: how much was checked, and whether all is well.
fn closing(results: &[CaseResult]) -> String {
    let checks = || results.iter().flat_map(|result| &result.checks);
    let violated = checks()
        .filter(|check| check.verdict == Verdict::Violated)
        .count();
    let failed = rows(results)
        .filter(|(_, row)| row.outcome.status == Status::Failed)
        .count();
    let values: usize = results
        .iter()
        .map(|result| result.case.references.len())
        .sum();
    format!(
        "\n{} cases, {} results, {values} reference values, {} checks: {violated} violated, {failed} failed\n",
        results.len(),
        rows(results).count(),
        checks().count(),
    )
}
