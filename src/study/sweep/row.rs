//! One row of a sweep: an answer with its parameters, and the two files of all rows.

use serde::{Deserialize, Serialize};

use super::Point;
use crate::answer::{Status, Work};
use crate::number::nine_digits;
use crate::run::Answer;

/// The answer of one point, its numbers rounded to the nine digits that files show: what is read
/// back is what was written.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Row {
    /// Id of the point.
    pub id: String,
    /// Name of the case, with `@open` where head joints are open.
    pub case: String,
    /// Name of the method.
    pub method: String,
    /// What the answer is worth.
    #[serde(with = "status_word")]
    pub status: Status,
    /// Lower value of the multiplier, where there is one to vouch for.
    pub lower: Option<f64>,
    /// Upper value.
    pub upper: Option<f64>,
    /// Error that the method states for its bracket, relative.
    pub stated_error: Option<f64>,
    /// Slope of the crack.
    pub tan_beta: Option<f64>,
    /// Width that moves as one rigid body along the top, in the case's unit of length.
    pub c: Option<f64>,
    /// Width that moves at all along the top.
    pub e: Option<f64>,
    /// Residual that the judge computed.
    pub residual: Option<f64>,
    /// Why this status, in words.
    pub reason: String,
    /// What varies in the sweep, by name.
    pub parameters: Vec<(String, String)>,
    /// Blocks of the scene.
    pub blocks: usize,
    /// Joints of the scene.
    pub joints: usize,
    /// Blocks that were modelled as movable, linear programs, their iterations, block steps.
    pub work: [usize; 4],
    /// CPU time of the method, seconds. The only thing in a row that is not the same in every run.
    pub seconds: f64,
}

impl Row {
    pub(super) fn new(point: &Point, size: [usize; 2], answer: &Answer) -> Self {
        let outcome = &answer.outcome;
        let crack = outcome.crack;
        let Work {
            modelled,
            programs,
            iterations,
            block_steps,
        } = outcome.work;
        Self {
            id: point.id().to_owned(),
            case: point.case().to_owned(),
            method: point.method().name().to_owned(),
            status: outcome.status,
            lower: outcome.bracket.and_then(|b| rounded(b.lower)),
            upper: outcome.bracket.and_then(|b| rounded(b.upper)),
            stated_error: outcome.stated_error,
            tan_beta: crack.and_then(|c| rounded(c.tan_beta)),
            c: crack.and_then(|c| c.c).and_then(rounded),
            e: crack.and_then(|c| c.e).and_then(rounded),
            residual: answer.residual.and_then(rounded),
            reason: outcome.reason().clone(),
            parameters: point.parameters().to_vec(),
            blocks: size[0],
            joints: size[1],
            work: [modelled, programs, iterations, block_steps],
            seconds: rounded(answer.seconds).unwrap_or(0.0),
        }
    }

    /// Whether both rows say the same: everything but the time.
    pub fn agrees(&self, other: &Row) -> bool {
        let timeless = |row: &Row| Row {
            seconds: 0.0,
            ..row.clone()
        };
        timeless(self) == timeless(other)
    }

    /// The value of a parameter.
    pub fn parameter(&self, name: &str) -> Option<&str> {
        let found = self.parameters.iter().find(|(known, _)| known == name);
        found.map(|(_, value)| value.as_str())
    }
}

fn rounded(value: f64) -> Option<f64> {
    nine_digits(value).parse().ok()
}

/// A status as its word.
mod status_word {
    use serde::{Deserialize, Deserializer, Serializer, de::Error};

    use crate::answer::Status;

    pub(super) fn serialize<S: Serializer>(
        status: &Status,
        serializer: S,
    ) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(status.name())
    }

    pub(super) fn deserialize<'de, D: Deserializer<'de>>(
        deserializer: D,
    ) -> Result<Status, D::Error> {
        let word = String::deserialize(deserializer)?;
        let found = Status::ALL.into_iter().find(|s| s.name() == word);
        found.ok_or_else(|| D::Error::custom(format!("no status `{word}`")))
    }
}

/// Names of the parameters of all rows, as they first come.
fn parameter_names(rows: &[Row]) -> Vec<&str> {
    let mut names: Vec<&str> = Vec::new();
    for (name, _) in rows.iter().flat_map(|row| &row.parameters) {
        if !names.contains(&name.as_str()) {
            names.push(name);
        }
    }
    names
}

/// `sweep.csv`: the contract's columns without `seconds`, then the parameters, blocks and joints.
/// The same rows give the same bytes.
///
/// # Errors
/// Those of the CSV writer; none is expected in memory.
pub fn sweep_csv(rows: &[Row]) -> Result<String, csv::Error> {
    let names = parameter_names(rows);
    let columns = "case,method,status,lower,upper,tan_beta,c,e,residual,reason";
    let heading = columns.split(',').chain(names.iter().copied());
    let heading = heading.chain(["blocks", "joints"]);
    csv_text(heading, rows, |row| {
        let number = |value: Option<f64>| value.map_or(String::new(), nine_digits);
        let numbers = [
            row.lower,
            row.upper,
            row.tan_beta,
            row.c,
            row.e,
            row.residual,
        ];
        let mut fields: Vec<String> = vec![
            row.case.clone(),
            row.method.clone(),
            row.status.name().to_owned(),
        ];
        fields.extend(numbers.map(number));
        fields.push(row.reason.clone());
        fields.extend(values(row, &names));
        fields.extend([row.blocks.to_string(), row.joints.to_string()]);
        fields
    })
}

/// `times.csv`: which point took how long, and its effort in counts.
///
/// # Errors
/// Those of the CSV writer; none is expected in memory.
pub fn times_csv(rows: &[Row]) -> Result<String, csv::Error> {
    let names = parameter_names(rows);
    let heading = ["id", "case", "method"].into_iter();
    let counts = "seconds,modelled,programs,iterations,block_steps".split(',');
    let heading = heading.chain(names.iter().copied()).chain(counts);
    csv_text(heading, rows, |row| {
        let mut fields = vec![row.id.clone(), row.case.clone(), row.method.clone()];
        fields.extend(values(row, &names));
        fields.push(nine_digits(row.seconds));
        fields.extend(row.work.map(|count| count.to_string()));
        fields
    })
}

fn values(row: &Row, names: &[&str]) -> Vec<String> {
    let value = |name: &&str| row.parameter(name).unwrap_or_default().to_owned();
    names.iter().map(value).collect()
}

fn csv_text<'a>(
    heading: impl Iterator<Item = &'a str>,
    rows: &[Row],
    fields: impl Fn(&Row) -> Vec<String>,
) -> Result<String, csv::Error> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    writer.write_record(heading)?;
    for row in rows {
        writer.write_record(fields(row))?;
    }
    let bytes = writer
        .into_inner()
        .map_err(|e| csv::Error::from(e.into_error()))?;
    Ok(String::from_utf8_lossy(&bytes).into_owned())
}
