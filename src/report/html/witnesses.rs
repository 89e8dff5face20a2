//! What engines that others wrote answer on a case, as stored by `tests/reference/witnesses.py`: it takes
//! an hour to compute.

use maud::{Markup, html};
use serde::Deserialize;

use super::sortable::{TableCell, plain};
use crate::method::METHODS;
use crate::number::{percent, short};

/// A scene by one engine; empty where it has no bracket.
#[derive(Deserialize)]
struct Witness {
    /// `CASE`, or `CASE@open` with open head joints.
    case: String,
    method: String,
    status: String,
    lower: Option<f64>,
    upper: Option<f64>,
    stated_error: Option<f64>,
    seconds: f64,
    remark: String,
}

/// The engines' answers on a case as a table; nothing where none was asked.
pub fn witnesses(case: &str) -> Markup {
    let stored = include_str!("../../../tests/reference/witnesses.csv");
    let rows: Vec<Vec<TableCell>> = csv::Reader::from_reader(stored.as_bytes())
        .deserialize()
        .map(|row| row.expect("a test reads the stored table"))
        .filter_map(|row: Witness| cells(case, row))
        .collect();
    let columns = [
        "Engine", "Joints", "Status", "λ", "Stated %", "CPU s", "Remark",
    ];
    html! { @if !rows.is_empty() { (plain("Engines that others wrote", &columns, &rows)) } }
}

fn cells(case: &str, row: Witness) -> Option<Vec<TableCell>> {
    let (name, joints) = row.case.split_once('@').unwrap_or((&row.case, "contact"));
    let outside = METHODS.iter().all(|method| method.name() != row.method);
    (name == case && outside).then(|| {
        let bracket = row.lower.zip(row.upper);
        let bracket = bracket.map(|(a, b)| format!("{} - {}", short(a, 5), short(b, 5)));
        vec![
            TableCell::text(row.method),
            TableCell::text(joints),
            TableCell::text(row.status),
            TableCell::number(bracket.unwrap_or_default()),
            TableCell::number(row.stated_error.map_or(String::new(), percent)),
            TableCell::number(short(row.seconds, 1)),
            TableCell::text(row.remark),
        ]
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn stored_witnesses_are_read_and_belong_to_their_case() {
        let shown = witnesses("oppenheim-7").into_string();
        assert!(shown.contains("lmgc90"), "{shown}");
        assert!(!shown.contains("pushover"), "it stands among the answers");
        assert!(witnesses("block-flat").into_string().is_empty());
    }
}
