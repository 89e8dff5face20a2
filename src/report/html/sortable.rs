//! Tables that sort, in a container of their own that scrolls where the page is narrow.

use maud::{Markup, html};

use crate::answer::Status;
use crate::judge::Verdict;
use crate::record::LEGEND;
use crate::run::{CaseResult, Row, column};

#[derive(Clone)]
pub struct TableCell {
    text: String,
    link: Option<String>,
    /// Class that colours a verdict or status.
    class: &'static str,
}

impl TableCell {
    fn of(class: &'static str, text: impl Into<String>) -> Self {
        let (text, link) = (text.into(), None);
        Self { text, link, class }
    }

    pub fn text(text: impl Into<String>) -> Self {
        Self::of("", text)
    }

    pub fn number(text: impl Into<String>) -> Self {
        Self::of("n", text)
    }

    /// A word that says nothing of good or bad.
    pub fn word(text: impl Into<String>) -> Self {
        Self::of("word", text)
    }

    pub fn status(status: Status) -> Self {
        Self::of(status_class(status).unwrap_or("word"), status.name())
    }

    pub fn verdict(verdict: Verdict) -> Self {
        Self::of(verdict_class(verdict), verdict.name())
    }

    /// Text that leads to a place on the page.
    pub fn link(text: impl Into<String>, to: impl Into<String>) -> Self {
        Self {
            link: Some(to.into()),
            ..Self::text(text)
        }
    }
}

/// Class that colours a status, where it says whether all is well.
pub fn status_class(status: Status) -> Option<&'static str> {
    match status {
        Status::Verified => Some("good"),
        Status::Undecided => Some("mixed"),
        Status::Failed => Some("bad"),
        Status::Bracketed
        | Status::Estimate
        | Status::Stands
        | Status::Falls
        | Status::NotApplicable => None,
    }
}

pub fn verdict_class(verdict: Verdict) -> &'static str {
    match verdict {
        Verdict::Holds => "good",
        Verdict::Marked | Verdict::NotDecided | Verdict::Deviates => "mixed",
        Verdict::Violated => "bad",
    }
}

/// A table with a caption; a click on a column's name sorts by it.
pub fn sortable(caption: &str, columns: &[&str], rows: &[Vec<TableCell>]) -> Markup {
    table(caption, columns, rows, true)
}

/// A table with a caption, for print.
pub fn plain(caption: &str, columns: &[&str], rows: &[Vec<TableCell>]) -> Markup {
    table(caption, columns, rows, false)
}

/// Narrow screens show a row as a list of cells behind the names of their columns; print, which cannot
/// repeat buttons, takes the names in their stead.
///
/// Columns in which no row has anything are left out.
fn table(caption: &str, columns: &[&str], rows: &[Vec<TableCell>], sorts: bool) -> Markup {
    let has_any = |&place: &usize| {
        let mut cells = rows.iter().filter_map(|row| row.get(place));
        cells.any(|cell| !["", "-"].contains(&cell.text.as_str()))
    };
    let kept: Vec<usize> = (0..columns.len()).filter(has_any).collect();
    html! {
        div.scroll tabindex="0" role="region" aria-label=(caption) {
            table.sortable[sorts] {
                caption { (caption) }
                thead { tr {
                    @for column in kept.iter().map(|&place| columns[place]) {
                        @if sorts {
                            th scope="col" aria-sort="none" data-name=(column) { button type="button" { (column) } }
                        } @else {
                            th scope="col" { (column) }
                        }
                    }
                } }
                tbody {
                    @for row in rows {
                        tr { @for &place in &kept {
                            (shown(place, columns[place], &row[place]))
                        } }
                    }
                }
            }
        }
    }
}

fn shown(place: usize, name: &str, cell: &TableCell) -> Markup {
    let inner = html! {
        @if let Some(to) = &cell.link { a href=(to) { (cell.text) } } @else { (cell.text) }
    };
    match (place, cell.class) {
        (0, _) => html! { th scope="row" { (inner) } },
        (_, "") => html! { td data-name=(name) { (inner) } },
        (_, class) => html! { td class=(class) data-name=(name) { (inner) } },
    }
}

pub fn titles(names: &[&str]) -> Vec<&'static str> {
    names.iter().map(|name| column(name).title).collect()
}

pub fn cells(row: &Row, names: &[&str]) -> Vec<TableCell> {
    let cell = |name: &&str| {
        let text = row.value(name).shown().replace(" - ", " – ");
        match *name {
            "method" | "head_joints" | "note" => TableCell::text(text),
            "status" => TableCell::status(row.status()),
            "verdict" => match row.verdict {
                Some(verdict) => TableCell::verdict(verdict),
                None => TableCell::word(text),
            },
            _ => TableCell::number(text),
        }
    };
    names.iter().map(cell).collect()
}

/// Columns of the multipliers behind the case: λ and what it is worth come first; the note, which is
/// long, last.
const MULTIPLIERS: [&str; 14] = [
    "method",
    "head_joints",
    "status",
    "verdict",
    "lambda",
    "stated_percent",
    "lambda_reference",
    "error_percent",
    "slope",
    "slope_reference",
    "width_c",
    "width_e",
    "cpu_seconds",
    "note",
];

/// Every row of every case, published beside computed.
pub fn multipliers(results: &[CaseResult]) -> Markup {
    let rows = results.iter().flat_map(|result| {
        let name = &result.case.name;
        let line = move |row| {
            let mut line = vec![TableCell::link(name, format!("#case-{name}"))];
            line.extend(cells(row, &MULTIPLIERS));
            line
        };
        result.rows.iter().map(line)
    });
    let titles = [titles(&["case"]), titles(&MULTIPLIERS)].concat();
    html! {
        (sortable("Computed beside reference", &titles, &rows.collect::<Vec<_>>()))
        p.small { (LEGEND) }
    }
}
