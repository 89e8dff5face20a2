//! A sweep's `sweep.csv`, read as what varies and what came out.

use std::path::Path;

use crate::files::{Input, read_input};
use crate::run::PARTIAL_MARK;

/// A sweep's points.
pub struct SweepTable {
    /// Name of the sweep.
    pub name: String,
    /// Names of the columns.
    pub columns: Vec<String>,
    /// Cells of every point.
    pub rows: Vec<Vec<String>>,
    /// What the last line says of a sweep that did not come to its end.
    pub partial: Option<String>,
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

/// Columns that say what came out; the others, up to the first about the scene, are what varies.
const RESULTS: [&str; 10] = [
    "case", "method", "status", "lower", "upper", "tan_beta", "c", "e", "residual", "reason",
];

/// The first column about the scene.
const SCENE: &str = "blocks";

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
        let stem = path.file_stem().unwrap_or_default().to_string_lossy();
        let folder = path.parent().and_then(Path::file_name).unwrap_or_default();
        let name = match &*stem {
            "sweep" if !folder.is_empty() => folder.to_string_lossy().into_owned(),
            stem => stem.to_owned(),
        };
        let table = Self::parse(&name, &bytes).map_err(unreadable)?;
        for column in ["case", "method", "lower", "upper"] {
            if table.column(column).is_none() {
                let path = shown;
                return Err(SweepError::Column { path, column });
            }
        }
        Ok(table)
    }

    /// The table of a sweep of this name from its CSV.
    ///
    /// # Errors
    /// Lines of different lengths.
    pub fn parse(name: &str, bytes: &[u8]) -> Result<Self, csv::Error> {
        let mut reader = csv::Reader::from_reader(bytes);
        let columns = reader.headers()?.iter().map(str::to_owned).collect();
        let (mut rows, mut partial) = (Vec::new(), None);
        for record in reader.records() {
            let record = record?;
            let first = record.get(0).unwrap_or_default();
            if first.starts_with(PARTIAL_MARK) {
                partial = Some(first.trim_start_matches("# ").to_owned());
                continue;
            }
            rows.push(record.iter().map(str::to_owned).collect());
        }
        Ok(Self {
            name: name.to_owned(),
            columns,
            rows,
            partial,
        })
    }

    fn column(&self, name: &str) -> Option<usize> {
        self.columns.iter().position(|column| column == name)
    }

    /// A cell of a row; empty where there is no such column.
    pub fn cell<'a>(&self, row: &'a [String], column: &str) -> &'a str {
        let index = self.column(column);
        let cell = index.and_then(|index| row.get(index));
        cell.map_or("", String::as_str)
    }

    /// A cell as a number.
    pub fn number(&self, row: &[String], column: &str) -> Option<f64> {
        let value: f64 = self.cell(row, column).parse().ok()?;
        value.is_finite().then_some(value)
    }

    /// The keys that the sweep's file varies, also those of one value.
    pub fn keys(&self) -> impl Iterator<Item = &str> {
        let end = self.column(SCENE).unwrap_or(self.columns.len());
        let names = self.columns[..end].iter().map(String::as_str);
        names.filter(|name| !RESULTS.contains(name))
    }

    /// What varies: keys with all their values, in the order of the table. Keys that vary together, as
    /// those of one table of a sweep's file do, are one: the first speaks for all.
    pub fn variables(&self) -> Vec<Variable> {
        let mut found: Vec<Variable> = Vec::new();
        for name in self.keys() {
            let of_row = |row: &Vec<String>| self.cell(row, name).to_owned();
            let mut values: Vec<String> = Vec::new();
            for value in self.rows.iter().map(of_row) {
                if !values.contains(&value) {
                    values.push(value);
                }
            }
            if values.len() < 2 {
                continue;
            }
            let together = found.iter().any(|known| {
                let pairs = self.rows.iter();
                let pairs: std::collections::BTreeSet<_> = pairs
                    .map(|row| (self.cell(row, &known.name), self.cell(row, name)))
                    .collect();
                pairs.len() == values.len() && values.len() == known.values.len()
            });
            if !together {
                found.push(Variable {
                    name: name.to_owned(),
                    values,
                });
            }
        }
        found
    }

    /// The values of a column, as they first come.
    pub fn distinct(&self, column: &str) -> Vec<&str> {
        let mut values = Vec::new();
        for row in &self.rows {
            let value = self.cell(row, column);
            if !values.contains(&value) {
                values.push(value);
            }
        }
        values
    }
}

/// A key that varies.
#[derive(Clone, Debug, PartialEq)]
pub struct Variable {
    /// Its name.
    pub name: String,
    /// Its values as written, in the order in which they first come.
    pub values: Vec<String>,
}

impl Variable {
    /// The values as numbers, where all are.
    pub fn numbers(&self) -> Option<Vec<f64>> {
        let number = |value: &String| value.parse().ok().filter(|v: &f64| v.is_finite());
        self.values.iter().map(number).collect()
    }

    /// What it is for people.
    pub fn label(&self) -> String {
        match self.name.as_str() {
            "overburden" => "overburden ratio p/(γH)".to_owned(),
            "friction" => "coefficient of friction μ".to_owned(),
            name => name.to_owned(),
        }
    }
}
