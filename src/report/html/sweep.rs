//! A sweep as plots (the overburden's are the paper's Fig. 7) and as a table.

use maud::{Markup, PreEscaped, html};

use super::sortable::{TableCell, sortable};
use crate::number::short;
use crate::study::sweep::{SweepTable, VariableKind, sweep_pictures};

pub fn title(table: &SweepTable) -> String {
    match table.variables().as_slice() {
        [only] if only.kind == VariableKind::Overburden => "Overburden".to_owned(),
        _ => format!("Sweep {}", table.name),
    }
}

/// The plots, or why there are none; and the table.
pub fn section(table: &SweepTable) -> Markup {
    let columns: Vec<&str> = table.columns.iter().map(String::as_str).collect();
    let rows: Vec<Vec<TableCell>> = table
        .rows
        .iter()
        .map(|row| row.iter().map(|cell| fitting(&cell.csv())).collect())
        .collect();
    html! {
        @if let Some(partial) = &table.partial { p.headline.bad { (partial) } }
        @match sweep_pictures(table) {
            Ok(all) => { div.plots { @for svg in &all { figure { (PreEscaped(svg)) } } } }
            Err(why) => { p.small { (why) "." } }
        }
        details {
            summary { (table.rows.len()) " points as a table" }
            (sortable(&format!("Points of {}", table.name), &columns, &rows))
        }
    }
}

fn fitting(cell: &str) -> TableCell {
    match cell.parse::<f64>() {
        Ok(value) if cell.contains('.') => TableCell::number(short(value, 5)),
        Ok(_) => TableCell::number(cell),
        Err(_) => TableCell::text(cell),
    }
}
