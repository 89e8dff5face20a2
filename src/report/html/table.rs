//! Tables that sort, in a container of their own that scrolls where the page is narrow.

use maud::{Markup, html};

use crate::record::{LEGEND, cells};
use crate::run::CaseResult;

/// One cell.
pub struct Cell {
    text: String,
    /// Where a click leads.
    link: Option<String>,
    /// Class that colours a verdict or status.
    class: &'static str,
}

impl Cell {
    /// Plain text.
    pub fn text(text: impl Into<String>) -> Self {
        Self {
            text: text.into(),
            link: None,
            class: "",
        }
    }

    /// A number, or "-".
    pub fn number(text: impl Into<String>) -> Self {
        Self {
            class: "n",
            ..Self::text(text)
        }
    }

    /// A word that says whether all is well.
    pub fn word(text: impl Into<String>) -> Self {
        let text = text.into();
        let class = match text.as_str() {
            "holds" | "verified" => "good",
            "VIOLATED" | "failed" => "bad",
            "deviates" | "undecided" | "marked" | "not decided" => "mixed",
            _ => "word",
        };
        Self {
            class,
            ..Self::text(text)
        }
    }

    /// Text that leads to a place on the page.
    pub fn link(text: impl Into<String>, to: impl Into<String>) -> Self {
        Self {
            link: Some(to.into()),
            ..Self::text(text)
        }
    }
}

/// A table with a caption; a click on a column's name sorts by it.
pub fn sortable(caption: &str, columns: &[&str], rows: &[Vec<Cell>]) -> Markup {
    html! {
        div.scroll tabindex="0" role="region" aria-label=(caption) {
            table.sortable {
                caption { (caption) }
                thead { tr {
                    @for column in columns {
                        th scope="col" aria-sort="none" { button type="button" { (column) } }
                    }
                } }
                tbody {
                    @for row in rows {
                        tr { @for (place, cell) in row.iter().enumerate() { (shown(place, cell)) } }
                    }
                }
            }
        }
    }
}

fn shown(place: usize, cell: &Cell) -> Markup {
    let inner = html! {
        @if let Some(to) = &cell.link { a href=(to) { (cell.text) } } @else { (cell.text) }
    };
    match (place, cell.class) {
        (0, _) => html! { th scope="row" { (inner) } },
        (_, "") => html! { td { (inner) } },
        (_, class) => html! { td class=(class) { (inner) } },
    }
}

/// Every row of every case, published beside computed.
pub fn multipliers(results: &[CaseResult]) -> Markup {
    // λ and what it is worth come first; the note, which is long, last.
    let columns = [
        ("Method", 0),
        ("Joints", 1),
        ("Status", 2),
        ("Verdict", 10),
        ("λ", 3),
        ("Reference", 4),
        ("Error %", 5),
        ("tan β", 6),
        ("Ref. β", 7),
        ("c", 8),
        ("e", 9),
        ("Note", 11),
    ];
    let mut names: Vec<&str> = columns.iter().map(|(name, _)| *name).collect();
    names.insert(0, "Case");
    names.insert(names.len() - 1, "CPU s");
    let mut rows = Vec::new();
    for result in results {
        let name = &result.case.name;
        for row in &result.rows {
            let mut line = vec![Cell::link(name, format!("#case-{name}"))];
            let cells = cells(result, row);
            for (name, column) in columns {
                let text = cells[column].replace(" - ", " – ");
                line.push(match name {
                    "Method" | "Joints" | "Note" => Cell::text(text),
                    "Status" | "Verdict" => Cell::word(text),
                    _ => Cell::number(text),
                });
            }
            let seconds = Cell::number(crate::number::number(row.seconds, 2));
            line.insert(line.len() - 1, seconds);
            rows.push(line);
        }
    }
    html! {
        (sortable("Computed beside reference", &names, &rows))
        p.small { (LEGEND) "." }
    }
}
