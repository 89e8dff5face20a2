//! A sweep as a plot: λ over what varied (the overburden: the paper's Fig. 7).

use std::path::Path;

use maud::{Markup, PreEscaped, html};

use super::table::{TableCell, sortable};
use crate::files::{Input, read_input};
use crate::method::method_look;
use crate::number::short;
use crate::picture::{Line, Plot, PlotAxis, Ticks, plot};
use crate::run::PARTIAL_MARK;

/// A sweep's CSV, read.
pub struct SweepTable {
    name: String,
    columns: Vec<String>,
    rows: Vec<Vec<String>>,
    /// What the last line says of a sweep that did not come to its end.
    partial: Option<String>,
}

/// Why a file is no sweep.
#[derive(Debug, thiserror::Error)]
pub enum SweepError {
    /// It cannot be read.
    #[error("cannot read {path}: {error}")]
    Unreadable {
        /// The file.
        path: String,
        /// Why.
        error: csv::Error,
    },
    /// A column is missing.
    #[error("{path}, line 1: there is no column `{column}`; a sweep's `sweep.csv` is expected")]
    Column {
        /// The file.
        path: String,
        /// Which column.
        column: &'static str,
    },
}

/// Columns that say what came out, and how large the scene was; the others are what varied.
const RESULTS: [&str; 12] = [
    "case", "method", "status", "lower", "upper", "tan_beta", "c", "e", "residual", "reason",
    "blocks", "joints",
];

impl SweepTable {
    /// Reads a sweep's table.
    ///
    /// # Errors
    /// A file that cannot be read, or that lacks a column.
    pub fn read(path: &Path) -> Result<Self, SweepError> {
        let shown = path.display().to_string();
        let unreadable = |error| SweepError::Unreadable {
            path: shown.clone(),
            error,
        };
        let bytes = read_input(path, Input::Table).map_err(|error| unreadable(error.into()))?;
        let mut reader = csv::Reader::from_reader(bytes.as_slice());
        let heading = reader.headers().map_err(unreadable)?;
        let columns: Vec<String> = heading.iter().map(str::to_owned).collect();
        for column in ["case", "method", "lower", "upper"] {
            if !columns.iter().any(|known| known == column) {
                return Err(SweepError::Column {
                    path: shown,
                    column,
                });
            }
        }
        let (mut rows, mut partial) = (Vec::new(), None);
        for record in reader.records() {
            let record = record.map_err(unreadable)?;
            let first = record.get(0).unwrap_or_default();
            if first.starts_with(PARTIAL_MARK) {
                partial = Some(first.trim_start_matches("# ").to_owned());
                continue;
            }
            rows.push(record.iter().map(str::to_owned).collect());
        }
        let stem = path.file_stem().unwrap_or_default().to_string_lossy();
        let folder = path.parent().and_then(Path::file_name).unwrap_or_default();
        let name = match &*stem {
            "sweep" if !folder.is_empty() => folder.to_string_lossy().into_owned(),
            stem => stem.to_owned(),
        };
        Ok(Self {
            name,
            columns,
            rows,
            partial,
        })
    }

    fn column(&self, name: &str) -> Option<usize> {
        self.columns.iter().position(|column| column == name)
    }

    fn number(&self, row: &[String], column: &str) -> Option<f64> {
        let value: f64 = row.get(self.column(column)?)?.parse().ok()?;
        value.is_finite().then_some(value)
    }

    /// The first column that varies and holds numbers in every row: the overburden, where it does.
    fn abscissa(&self) -> Option<&str> {
        let varies = |name: &&str| {
            let values: Option<Vec<f64>> =
                self.rows.iter().map(|row| self.number(row, name)).collect();
            values.is_some_and(|values| values.windows(2).any(|pair| pair[0] != pair[1]))
        };
        let names = self.columns.iter().map(String::as_str);
        let mut names = names.filter(|name| !RESULTS.contains(name)).filter(varies);
        let first = names.clone().find(|name| *name == "overburden");
        first.or_else(|| names.next())
    }

    /// Heading of its section.
    pub fn title(&self) -> String {
        match self.abscissa() {
            Some("overburden") => "Overburden".to_owned(),
            _ => format!("Sweep {}", self.name),
        }
    }

    /// Everything that tells one line from another: case, method and what varies beside `x`.
    fn series(&self, x: &str) -> Vec<(String, String, Vec<&Vec<String>>)> {
        let beside: Vec<usize> = (0..self.columns.len())
            .filter(|&i| !RESULTS.contains(&self.columns[i].as_str()) && self.columns[i] != x)
            .filter(|&i| {
                self.rows
                    .windows(2)
                    .any(|pair| pair[0].get(i) != pair[1].get(i))
            })
            .collect();
        let cell = |row: &[String], column: Option<usize>| {
            column.and_then(|i| row.get(i)).cloned().unwrap_or_default()
        };
        let mut found: Vec<(String, String, Vec<&Vec<String>>)> = Vec::new();
        for row in &self.rows {
            let method = cell(row, self.column("method"));
            let mut label = format!("{} {method}", cell(row, self.column("case")));
            for &i in &beside {
                label.push_str(&format!(", {} {}", self.columns[i], cell(row, Some(i))));
            }
            match found.iter_mut().find(|(known, _, _)| *known == label) {
                Some((_, _, rows)) => rows.push(row),
                None => found.push((label, method, vec![row])),
            }
        }
        found
    }
}

/// Most lines that a plot can hold and still be read.
const LINES: usize = 14;

/// The plot, where something varies and few enough lines come of it; and the table.
pub fn section(table: &SweepTable) -> Markup {
    let columns: Vec<&str> = table.columns.iter().map(String::as_str).collect();
    let rows: Vec<Vec<TableCell>> = table
        .rows
        .iter()
        .map(|row| row.iter().map(|cell| fitting(cell)).collect())
        .collect();
    html! {
        @if let Some(partial) = &table.partial { p.headline.bad { (partial) } }
        @if let Some(x) = table.abscissa() {
            @if let Some(svg) = plotted(table, x) {
                figure { (PreEscaped(svg)) figcaption { "λ over " (x) ": both ends of each method's range" } }
            }
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

fn plotted(table: &SweepTable, x: &str) -> Option<String> {
    let series = table.series(x);
    if series.len() > LINES {
        return None;
    }
    let mut lines = Vec::new();
    for (label, method, rows) in &series {
        let end = |which: &str| {
            let points = rows
                .iter()
                .filter_map(|row| Some([table.number(row, x)?, table.number(row, which)?]));
            let mut points: Vec<[f64; 2]> = points.collect();
            points.sort_by(|a, b| a[0].total_cmp(&b[0]));
            points
        };
        let (low, high) = (end("lower"), end("upper"));
        let wide = low
            .iter()
            .zip(&high)
            .any(|([_, a], [_, b])| b - a > 0.01 * b.abs().max(1e-3));
        let line = |points, name: Option<String>| Line {
            points,
            colour: method_look(method, 0).colour,
            dashed: name.is_none(),
            name,
        };
        if wide {
            lines.push(line(low, None));
        }
        lines.push(line(high, Some(label.clone())));
    }
    let axis = |label: &str, ticks| PlotAxis {
        label: label.to_owned(),
        ticks,
    };
    let across = match x {
        "overburden" => "overburden ratio p/(γH)",
        other => other,
    };
    let picture = Plot {
        title: String::new(),
        x: axis(across, Ticks::Fitting),
        y: axis("collapse multiplier λ", Ticks::With(0.0)),
        bands: Vec::new(),
        lines,
        marks: Vec::new(),
        notes: Vec::new(),
    };
    Some(plot(&picture, &format!("λ over {x}")))
}
