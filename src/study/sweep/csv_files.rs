//! The files of a sweep's rows, as columns of the one list.

use indexmap::IndexSet;

use super::points::{ANSWER, SCENE, SweepTable};
use crate::run::{COLUMNS, Column, ColumnKind, Partial, Row, Value, csv, values};

/// Columns of `times.csv` behind the id and before those of what varies; the effort stands last.
const TASK: [&str; 2] = ["case", "method"];

/// Names of the parameters of all rows, as they first come.
fn parameter_names(rows: &[Row]) -> IndexSet<&str> {
    let parameters = rows.iter().flat_map(|row| &row.parameters);
    parameters.map(|(name, _)| name.as_str()).collect()
}

fn parameters(row: &Row, names: &IndexSet<&str>) -> Vec<Value> {
    let value = |name: &&str| row.parameter(name).unwrap_or_default().into();
    names.iter().map(value).collect()
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
    ///
    /// # Errors
    /// Those of the CSV writer; none is expected in memory.
    pub fn csv(&self) -> Result<String, csv::Error> {
        let headings = self.columns.iter().map(String::as_str);
        csv(headings, self.rows.iter().cloned())
    }
}

/// `times.csv`: which task took how long, and its effort in counts.
///
/// # Errors
/// Those of the CSV writer; none is expected in memory.
pub fn times_csv(rows: &[Row]) -> Result<String, csv::Error> {
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
    csv(headings.copied(), rows.iter().map(line))
}
