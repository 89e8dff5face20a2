//! A sweep's points as a table of what varies and what came out, from its rows or from `sweep.csv`,
//! and its files.

use std::collections::BTreeSet;
use std::path::Path;

use indexmap::IndexSet;

use crate::files::{Input, read_input};
use crate::run::{
    COLUMNS, Column, ColumnKind, PARTIAL_MARK, Partial, Row, Value, csv as csv_of, values,
};

/// Columns of `sweep.csv` before those of what varies: the contract's without the time.
const ANSWER: [&str; 10] = [
    "case", "method", "status", "lower", "upper", "tan_beta", "c", "e", "residual", "reason",
];

/// Columns of `sweep.csv` behind those of what varies: the scene's, and last the worst of what the
/// methods say about each other.
const SCENE: [&str; 5] = ["blocks", "joints", "friction", "push", "verdict"];

/// Columns of `times.csv` behind the id and before those of what varies; the effort stands last.
const TASK: [&str; 2] = ["case", "method"];

/// A sweep's points.
pub struct SweepTable {
    /// Name of the sweep.
    pub name: String,
    /// Names of the columns.
    pub columns: Vec<String>,
    /// Cells of every point.
    pub rows: Vec<Vec<Value>>,
    /// What is said of a sweep that did not come to its end.
    pub partial: Option<String>,
}

impl SweepTable {
    /// The table of a sweep's rows, which is the same for the same rows. A parameter takes the place
    /// of a scene's column of its name.
    pub fn of(name: &str, rows: &[Row], partial: Option<&Partial>) -> Self {
        let names = parameter_names(rows);
        let scene = SCENE.into_iter().filter(|name| !names.contains(name));
        let scene: Vec<&str> = scene.collect();
        let columns = ANSWER.iter().chain(&names).chain(&scene);
        let line = |row| {
            let answer = values(row, &ANSWER);
            [answer, parameters(row, &names), values(row, &scene)].concat()
        };
        Self {
            name: name.to_owned(),
            columns: columns.map(|name| (*name).to_owned()).collect(),
            rows: rows.iter().map(line).collect(),
            partial: partial.map(ToString::to_string),
        }
    }

    /// `sweep.csv`.
    pub fn csv(&self) -> String {
        let headings = self.columns.iter().map(String::as_str);
        csv_of(headings, self.rows.iter().cloned())
    }

    /// Reads a sweep's table.
    ///
    /// # Errors
    /// A file that cannot be read, or that lacks a column.
    pub fn read(path: &Path) -> Result<Self, String> {
        let shown = path.display();
        let unreadable = |error: csv::Error| format!("cannot read {shown}: {error}");
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
                return Err(format!(
                    "{shown}, line 1: there is no column `{column}`; a sweep's `sweep.csv` is expected"
                ));
            }
        }
        Ok(table)
    }

    /// The table of a sweep of this name from its CSV: its cells as words.
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
            rows.push(record.iter().map(Value::from).collect());
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

    /// A cell of a row; nothing where there is no such column.
    pub fn cell<'a>(&self, row: &'a [Value], column: &str) -> &'a Value {
        let index = self.column(column);
        index.and_then(|at| row.get(at)).unwrap_or(&Value::Nothing)
    }

    pub(super) fn words<'a>(&self, row: &'a [Value], column: &str) -> &'a str {
        self.cell(row, column).words()
    }

    pub(super) fn number(&self, row: &[Value], column: &str) -> Option<f64> {
        self.cell(row, column).number()
    }

    /// The keys that the sweep's file varies, also those of one value: they stand before the first
    /// column about the scene.
    pub fn keys(&self) -> impl Iterator<Item = &str> {
        let end = self.column(SCENE[0]).unwrap_or(self.columns.len());
        let names = self.columns[..end].iter().map(String::as_str);
        names.filter(|name| !ANSWER.contains(name))
    }

    /// What varies: keys with all their values, in the order of the table. Keys that vary together, as
    /// those of one table of a sweep's file do, are one: the first speaks for all.
    pub fn variables(&self) -> Vec<Variable> {
        let mut found: Vec<Variable> = Vec::new();
        for name in self.keys() {
            let values = self.distinct(name);
            let together = found.iter().any(|known| {
                let rows = self.rows.iter();
                let pair = |row: &'_ Vec<Value>| {
                    [known.name.as_str(), name].map(|name| self.cell(row, name).csv())
                };
                let pairs: BTreeSet<_> = rows.map(pair).collect();
                pairs.len() == values.len() && values.len() == known.values.len()
            });
            if values.len() > 1 && !together {
                found.push(Variable {
                    kind: VariableKind::of(name),
                    name: name.to_owned(),
                    values: values.into_iter().map(str::to_owned).collect(),
                });
            }
        }
        found
    }

    /// The words of a column, as they first come.
    pub fn distinct(&self, column: &str) -> Vec<&str> {
        let words = self.rows.iter().map(|row| self.words(row, column));
        words.collect::<IndexSet<_>>().into_iter().collect()
    }
}

/// Names of the parameters of all rows, as they first come.
fn parameter_names(rows: &[Row]) -> IndexSet<&str> {
    let parameters = rows.iter().flat_map(|row| &row.parameters);
    parameters.map(|(name, _)| name.as_str()).collect()
}

fn parameters(row: &Row, names: &IndexSet<&str>) -> Vec<Value> {
    let value = |name: &&str| row.parameter(name).unwrap_or_default().into();
    names.iter().map(value).collect()
}

/// `times.csv`: which task took how long, and its effort in counts.
pub fn times_csv(rows: &[Row]) -> String {
    let names = parameter_names(rows);
    let effort = |column: &&Column| column.kind == ColumnKind::Effort;
    let effort: Vec<&str> = (COLUMNS.iter().filter(effort))
        .map(|column| column.name)
        .collect();
    let headings = ["id"].iter().chain(&TASK).chain(&names).chain(&effort);
    let line = |row: &Row| {
        let id = vec![row.id.as_str().into()];
        let (task, effort) = (values(row, &TASK), values(row, &effort));
        [id, task, parameters(row, &names), effort].concat()
    };
    csv_of(headings.copied(), rows.iter().map(line))
}

/// Keys of a case of which more is known than their names.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum VariableKind {
    /// The overburden ratio: what the paper's Fig. 7 runs through, so that values from elsewhere are
    /// known.
    Overburden,
    Friction,
    Other,
}

impl VariableKind {
    fn of(key: &str) -> Self {
        match key {
            "overburden" => VariableKind::Overburden,
            "friction" => VariableKind::Friction,
            _ => VariableKind::Other,
        }
    }
}

#[derive(Clone, Debug, PartialEq)]
pub struct Variable {
    pub name: String,
    pub kind: VariableKind,
    /// Its values as written, in the order in which they first come.
    pub values: Vec<String>,
}

impl Variable {
    pub fn numbers(&self) -> Option<Vec<f64>> {
        let number = |value: &String| value.parse().ok().filter(|v: &f64| v.is_finite());
        self.values.iter().map(number).collect()
    }

    pub fn label(&self) -> String {
        match self.kind {
            VariableKind::Overburden => "overburden ratio p/(γH)".to_owned(),
            VariableKind::Friction => "coefficient of friction μ".to_owned(),
            VariableKind::Other => self.name.clone(),
        }
    }
}
