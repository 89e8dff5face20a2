//! The two files of a sweep's rows, as columns of the one list.

use indexmap::IndexSet;

use crate::run::{Row, Value, csv, values};

/// Columns of `sweep.csv` before and behind those of what varies: everything about the answer that
/// is the same in every run.
const ANSWER: [&str; 10] = [
    "case", "method", "status", "lower", "upper", "tan_beta", "c", "e", "residual", "reason",
];
const SCENE: [&str; 4] = ["blocks", "joints", "friction", "push"];

/// The last column of `sweep.csv`: the worst of what the methods say about each other.
const COMPARED: [&str; 1] = ["verdict"];

/// Columns of `times.csv` behind the id and before and behind those of what varies.
const TASK: [&str; 2] = ["case", "method"];
const EFFORT: [&str; 6] = [
    "seconds",
    "modelled",
    "programs",
    "iterations",
    "block_steps",
    "fallbacks",
];

/// Names of the parameters of all rows, as they first come.
fn parameter_names(rows: &[Row]) -> IndexSet<&str> {
    let parameters = rows.iter().flat_map(|row| &row.parameters);
    parameters.map(|(name, _)| name.as_str()).collect()
}

fn parameters(row: &Row, names: &IndexSet<&str>) -> Vec<Value> {
    let value = |name: &&str| row.parameter(name).unwrap_or_default().into();
    names.iter().map(value).collect()
}

/// `sweep.csv`: the contract's columns without `seconds`, then the parameters, then the scene's,
/// then the verdict of the comparison. The
/// same rows give the same bytes. A parameter takes the place of a scene's column of its name.
///
/// # Errors
/// Those of the CSV writer; none is expected in memory.
pub fn sweep_csv(rows: &[Row]) -> Result<String, csv::Error> {
    let names = parameter_names(rows);
    let scene = SCENE.into_iter().filter(|name| !names.contains(name));
    let scene: Vec<&str> = scene.collect();
    let headings = ANSWER.iter().chain(&names).chain(&scene).chain(&COMPARED);
    let line = |row| {
        let parts = [
            values(row, &ANSWER),
            parameters(row, &names),
            values(row, &scene),
            values(row, &COMPARED),
        ];
        parts.concat()
    };
    csv(headings.copied(), rows.iter().map(line))
}

/// `times.csv`: which task took how long, and its effort in counts.
///
/// # Errors
/// Those of the CSV writer; none is expected in memory.
pub fn times_csv(rows: &[Row]) -> Result<String, csv::Error> {
    let names = parameter_names(rows);
    let headings = ["id"].iter().chain(&TASK).chain(&names).chain(&EFFORT);
    let line = |row: &Row| {
        let id = vec![row.id.as_str().into()];
        [
            id,
            values(row, &TASK),
            parameters(row, &names),
            values(row, &EFFORT),
        ]
        .concat()
    };
    csv(headings.copied(), rows.iter().map(line))
}
