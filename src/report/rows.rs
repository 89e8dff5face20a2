//! Table, CSV and JSON: the same rows three times.

use serde_json::json;

use crate::answer::Mechanism;
use crate::external::{SceneFile, answers};
use crate::judge::Verdict;
use crate::record::{self, LEGEND};
use crate::run::{self, Audience, COLUMNS, CaseResult, Column, Row, Value};

/// One table for people: a block a case, and every check that does not hold.
pub fn table(results: &[CaseResult]) -> String {
    let cases: Vec<String> = results.iter().map(case_table).collect();
    cases.concat() + &legend()
}

/// The block of one case.
pub fn case_table(result: &CaseResult) -> String {
    let mut lines = vec![record::heading()];
    lines.extend(record::lines(result));
    lines.push(record::tally(&result.checks));
    let open = result.checks.iter().filter(|c| c.verdict > Verdict::Holds);
    lines.extend(open.map(record::check_line));
    format!("{}{}\n\n", record::title(result), lines.join("\n"))
}

/// What stands below the last block.
pub fn legend() -> String {
    format!("{LEGEND}\n")
}

fn for_programs() -> impl Iterator<Item = &'static Column> {
    let columns = COLUMNS.iter();
    columns.filter(|column| column.audience == Audience::Programs)
}

fn rows(results: &[CaseResult]) -> impl Iterator<Item = &Row> {
    results.iter().flat_map(|result| &result.rows)
}

/// CSV with a heading line: numbers with 9 significant digits, empty where there is nothing to vouch
/// for.
///
/// # Errors
/// Those of the CSV writer; none is expected in memory.
pub fn csv(results: &[CaseResult]) -> Result<String, csv::Error> {
    let headings = for_programs().map(|column| column.name);
    let line = |row| for_programs().map(|column| (column.value)(row)).collect();
    run::csv(headings, rows(results).map(line))
}

/// JSON: a list of the CSV's rows with numbers as numbers and `null` where CSV is empty, and with
/// the self-checks that ran, in words. Where a recording was asked for, `recording` has its frames,
/// a constant time apart: for each block `[x, y, rotation]`, the displacement of its centroid in the
/// case's length unit and its rotation in radians, counter-clockwise.
///
/// # Errors
/// Those of the JSON writer; none is expected in memory.
pub fn json(results: &[CaseResult]) -> Result<String, serde_json::Error> {
    let list: Vec<JsonObject> = rows(results).map(object).collect();
    let mut text = serde_json::to_string_pretty(&list)?;
    text.push('\n');
    Ok(text)
}

/// As [`json`], a row a line, each with its `head_joints` and with the `sides` that it was pushed
/// to, the row's own side first: the scene and every answer of the method, in the formats of outside
/// programs and in full digits, so that another program can confirm each claim.
///
/// # Errors
/// As [`json`].
pub fn json_with_states(results: &[CaseResult]) -> Result<String, serde_json::Error> {
    let mut lines = Vec::new();
    for result in results {
        for row in &result.rows {
            let mut object = object(row);
            object.insert("head_joints".to_owned(), row.head_joints.name().into());
            object.insert("sides".to_owned(), sides(result, row)?);
            lines.push(serde_json::to_string(&object)?);
        }
    }
    Ok(format!("[\n{}\n]\n", lines.join(",\n")))
}

type JsonObject = serde_json::Map<String, serde_json::Value>;

/// A row with the columns for programs, its self-checks and its recording.
fn object(row: &Row) -> JsonObject {
    let cells = for_programs().map(|column| {
        let value = (column.value)(row);
        (column.name.to_owned(), value.json())
    });
    let mut object: JsonObject = cells.collect();
    let checks = row.outcome.checks.iter().map(ToString::to_string);
    object.insert("checks".to_owned(), checks.collect());
    if !row.outcome.recording.is_empty() {
        let frames = row.outcome.recording.iter().map(frame);
        object.insert("recording".to_owned(), frames.collect());
    }
    object
}

fn sides(result: &CaseResult, row: &Row) -> Result<serde_json::Value, serde_json::Error> {
    let own = (row.push, &row.outcome);
    let other = row.stronger.iter();
    let other = other.map(|stronger| (stronger.push, &*stronger.outcome));
    let sides = std::iter::once(own).chain(other).map(|(push, outcome)| {
        Ok(json!({
            "push": push.name(),
            "status": outcome.status.name(),
            "lower": outcome.bracket.map(|bracket| bracket.lower),
            "upper": outcome.bracket.map(|bracket| bracket.upper),
            "scene": serde_json::to_value(SceneFile::from(result.side(row.head_joints, push)))?,
            "answers": serde_json::to_value(answers(outcome))?,
        }))
    });
    sides.collect()
}

fn frame(moved: &Mechanism) -> serde_json::Value {
    let motions = moved.motions.iter();
    let numbers = motions.map(|m| [m.velocity.x, m.velocity.y, m.rotation]);
    let digits = numbers.map(|n| n.map(|x| Value::Number(x).json()).to_vec());
    digits.map(serde_json::Value::from).collect()
}
