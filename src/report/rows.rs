//! Table, CSV and JSON: the same rows three times.

use serde::Serialize;

use crate::answer::Mechanism;
use crate::judge::Verdict;
use crate::number::nine_digits;
use crate::record::{self, HEADING, LEGEND};
use crate::run::{CaseResult, Row};
use crate::scene::HeadJoints;

/// One table for people: a block a case, and every check that does not hold.
pub fn table(results: &[CaseResult]) -> String {
    let mut text = String::new();
    for result in results {
        text.push_str(&record::title(result));
        text.push_str(HEADING);
        text.push('\n');
        for line in record::lines(result) {
            text.push_str(&line);
            text.push('\n');
        }
        text.push_str(&record::tally(&result.checks));
        text.push('\n');
        for check in result.checks.iter().filter(|c| c.verdict > Verdict::Holds) {
            text.push_str(&record::check_line(check));
            text.push('\n');
        }
        text.push('\n');
    }
    text.push_str(LEGEND);
    text.push('\n');
    text
}

/// The contract's columns: numbers with 9 significant digits, empty where there is nothing to
/// vouch for.
#[derive(Serialize)]
struct Flat<'a> {
    case: String,
    method: &'a str,
    status: &'a str,
    lower: String,
    upper: String,
    tan_beta: String,
    c: String,
    e: String,
    residual: String,
    seconds: String,
    reason: String,
    blocks: usize,
    joints: usize,
    modelled: usize,
    programs: usize,
    iterations: usize,
    block_steps: usize,
}

fn flat<'a>(result: &CaseResult, row: &'a Row) -> Flat<'a> {
    let outcome = &row.outcome;
    let text = |value: Option<f64>| value.map_or(String::new(), nine_digits);
    let name = &result.case.name;
    let scene = result.scene(row);
    Flat {
        case: match row.head_joints {
            HeadJoints::Contact => name.clone(),
            HeadJoints::Open => format!("{name}@open"),
        },
        method: &row.method,
        status: outcome.status.name(),
        lower: text(outcome.bracket.map(|b| b.lower)),
        upper: text(outcome.bracket.map(|b| b.upper)),
        tan_beta: text(outcome.crack.map(|c| c.tan_beta)),
        c: text(outcome.crack.and_then(|c| c.c)),
        e: text(outcome.crack.and_then(|c| c.e)),
        residual: text(row.residual),
        seconds: text(Some(row.seconds)),
        reason: outcome.reason(),
        blocks: scene.blocks().len(),
        joints: scene.joints().len(),
        modelled: outcome.work.modelled,
        programs: outcome.work.programs,
        iterations: outcome.work.iterations,
        block_steps: outcome.work.block_steps,
    }
}

/// CSV with a heading line.
///
/// # Errors
/// Those of the CSV writer; none is expected in memory.
pub fn csv(results: &[CaseResult]) -> Result<String, csv::Error> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    for result in results {
        for row in &result.rows {
            writer.serialize(flat(result, row))?;
        }
    }
    let bytes = writer
        .into_inner()
        .map_err(|e| csv::Error::from(e.into_error()))?;
    Ok(String::from_utf8_lossy(&bytes).into_owned())
}

/// JSON: a list of the CSV's rows with numbers as numbers and `null` where CSV is empty, and with
/// the self-checks that ran, in words. Where a recording was asked for, `recording` has its frames,
/// a constant time apart: for each block `[x, y, rotation]`, the displacement of its centroid in the
/// case's length unit and its rotation in radians, counter-clockwise.
///
/// # Errors
/// Those of the JSON writer; none is expected in memory.
pub fn json(results: &[CaseResult]) -> Result<String, serde_json::Error> {
    let mut rows = Vec::new();
    for result in results {
        for row in &result.rows {
            let mut value = serde_json::to_value(flat(result, row))?;
            for key in [
                "lower", "upper", "tan_beta", "c", "e", "residual", "seconds",
            ] {
                value[key] = as_number(&value[key]);
            }
            value["checks"] = row.outcome.checks.iter().map(ToString::to_string).collect();
            if !row.outcome.recording.is_empty() {
                let frames = row.outcome.recording.iter();
                value["recording"] = frames.map(frame).collect();
            }
            rows.push(value);
        }
    }
    let mut text = serde_json::to_string_pretty(&rows)?;
    text.push('\n');
    Ok(text)
}

fn frame(moved: &Mechanism) -> serde_json::Value {
    let motions = moved.motions.iter();
    let numbers = motions.map(|m| [m.velocity.x, m.velocity.y, m.rotation]);
    let digits = numbers.map(|n| n.map(|x| as_number(&nine_digits(x).into())).to_vec());
    digits.map(serde_json::Value::from).collect()
}

fn as_number(text: &serde_json::Value) -> serde_json::Value {
    let parsed = text.as_str().and_then(|digits| digits.parse::<f64>().ok());
    parsed.map_or(serde_json::Value::Null, serde_json::Value::from)
}
