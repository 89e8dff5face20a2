//! The one list of columns. CSV, JSON, tables, the report, sweeps, chart and atlas name columns of
//! it; a new one is one entry.

use super::ends::{End, Ends};
use super::references::{multiplier_reference, reference_end, verdict_words, with_letter};
use super::row::Row;
use crate::answer::{Coverage, Status};
use crate::case::Quantity;
use crate::method::Kind;
use crate::number::{above, below, nine_digits, number, short};

/// What a row says in one column.
#[derive(Clone, Debug, PartialEq)]
pub enum Value {
    /// There is nothing to vouch for.
    Nothing,
    /// Words.
    Text(String),
    /// A number, written with nine digits.
    Number(f64),
    Count(usize),
}

impl Value {
    /// As CSV has it; empty for nothing, and for numbers that are not finite.
    pub fn csv(&self) -> String {
        match self {
            Value::Nothing => String::new(),
            Value::Text(text) => text.clone(),
            Value::Number(number) => nine_digits(*number),
            Value::Count(count) => count.to_string(),
        }
    }

    /// As JSON has it: numbers as numbers, `null` for nothing and for numbers that are not finite.
    pub fn json(&self) -> serde_json::Value {
        match self {
            Value::Nothing => serde_json::Value::Null,
            Value::Text(text) => text.clone().into(),
            Value::Number(number) => {
                let parsed = nine_digits(*number).parse::<f64>().ok();
                parsed.map_or(serde_json::Value::Null, serde_json::Value::from)
            }
            Value::Count(count) => (*count).into(),
        }
    }

    /// The number, also where it stands in words, as in a file.
    pub fn number(&self) -> Option<f64> {
        let number = match self {
            Value::Nothing => None,
            Value::Text(text) => text.parse().ok(),
            Value::Number(number) => Some(*number),
            Value::Count(count) => Some(*count as f64),
        };
        number.filter(|number: &f64| number.is_finite())
    }

    /// The words; empty for nothing and for numbers.
    pub fn words(&self) -> &str {
        match self {
            Value::Text(text) => text,
            Value::Nothing | Value::Number(_) | Value::Count(_) => "",
        }
    }

    /// As tables for people have it: a dash for nothing.
    pub fn shown(&self) -> String {
        match self {
            Value::Nothing => "-".to_owned(),
            other => other.csv(),
        }
    }
}

impl From<Option<f64>> for Value {
    fn from(number: Option<f64>) -> Self {
        number.map_or(Value::Nothing, Value::Number)
    }
}

impl From<Option<String>> for Value {
    fn from(text: Option<String>) -> Self {
        text.map_or(Value::Nothing, Value::Text)
    }
}

impl From<&str> for Value {
    fn from(text: &str) -> Self {
        Value::Text(text.to_owned())
    }
}

/// What a column has, and so whom it is for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ColumnKind {
    /// What came out: CSV and JSON have it.
    Data,
    /// Time and counts: as data, but that sweeps have them in a file of their own.
    Effort,
    /// For people: tables and the report have it, with the digits that the status vouches for.
    Words,
}

pub struct Column {
    /// Its name in CSV and JSON, and in lists of columns.
    pub name: &'static str,
    pub kind: ColumnKind,
    /// What stands above it in tables of text.
    pub heading: &'static str,
    /// What stands above it on pages.
    pub title: &'static str,
    pub value: fn(&Row) -> Value,
}

impl Column {
    const fn new(name: &'static str, kind: ColumnKind, value: fn(&Row) -> Value) -> Self {
        Self {
            name,
            kind,
            heading: name,
            title: name,
            value,
        }
    }

    /// The same with these words above it.
    const fn headed(self, heading: &'static str, title: &'static str) -> Self {
        Self {
            heading,
            title,
            ..self
        }
    }

    /// Whether CSV and JSON have it.
    pub fn is_for_programs(&self) -> bool {
        self.kind != ColumnKind::Words
    }
}

const fn data(name: &'static str, value: fn(&Row) -> Value) -> Column {
    Column::new(name, ColumnKind::Data, value)
}

const fn effort(name: &'static str, value: fn(&Row) -> Value) -> Column {
    Column::new(name, ColumnKind::Effort, value)
}

const fn words(name: &'static str, value: fn(&Row) -> Value) -> Column {
    Column::new(name, ColumnKind::Words, value)
}

/// Every column. Those for programs stand in the order of `results.csv`; the first eleven are a
/// contract with scripts, further ones are only ever added behind the others.
pub static COLUMNS: &[Column] = &[
    data("case", |row| Value::Text(row.scene_name())).headed("case", "Case"),
    data("method", |row| row.method.as_str().into()).headed("method", "Method"),
    data("status", |row| row.status().name().into()).headed("status", "Status"),
    data("lower", |row| row.ends().lower.map(End::written).into()),
    data("upper", |row| row.ends().upper.map(End::written).into()),
    data("tan_beta", |row| row.crack.map(|c| c.tan_beta).into()),
    data("c", |row| row.crack.and_then(|c| c.c).into()),
    data("e", |row| row.crack.and_then(|c| c.e).into()),
    data("residual", |row| row.residual().into()),
    effort("seconds", |row| Value::Number(row.seconds)),
    data("reason", |row| Value::Text(row.reason())),
    data("blocks", |row| Value::Count(row.blocks)),
    data("joints", |row| Value::Count(row.joints)),
    effort("modelled", |row| Value::Count(row.outcome.work.modelled)),
    effort("programs", |row| Value::Count(row.outcome.work.programs)),
    effort("iterations", |row| {
        Value::Count(row.outcome.work.iterations)
    }),
    effort("block_steps", |row| {
        Value::Count(row.outcome.work.block_steps)
    }),
    data("stated_error", |row| row.stated_error().into()),
    data("reference", |row| reference_end(row, 0).into()),
    data("reference_upper", |row| reference_end(row, 1).into()),
    data("error", |row| row.error().into()),
    data("verdict", |row| {
        row.verdict.map(|v| v.name().to_owned()).into()
    })
    .headed("verdict", "Verdict"),
    data("friction", |row| row.friction_words().into()),
    data("push", |row| row.push.name().into()),
    data("starts", |row| coverage(row, |found| found.starts)),
    data("states", |row| coverage(row, |found| found.distinct)),
    data("lowest_met", |row| coverage(row, |found| found.lowest_met)),
    data("unseen", |row| {
        let search = row.outcome.search();
        search.map(|search| search.coverage().unseen).into()
    }),
    data("lower_push", |row| push_of(row.ends().lower)),
    data("upper_push", |row| push_of(row.ends().upper)),
    effort("fallbacks", |row| Value::Count(row.outcome.work.fallbacks)),
    data("over_demand", |row| row.over_demand().into()),
    words("times_demand", |row| {
        // As λ beside it, but for the last digit that is shown of that.
        let times = row.over_demand();
        times.map(|times| below(times * (1.0 + 1e-6), 2)).into()
    })
    .headed("/ demand", "λ / demand"),
    words("head_joints", |row| row.head_joints.name().into()).headed("joints", "Joints"),
    words("lambda", multiplier).headed("λ", "λ"),
    words("stated_percent", |row| {
        // Never less than is stated, but for the rounding of the multiplication.
        let error = row.stated_error();
        error
            .map(|error| above(100.0 * (1.0 - 1e-9) * error, 2))
            .into()
    })
    .headed("stated %", "Stated %"),
    words("lambda_reference", |row| multiplier_reference(row).into())
        .headed("reference", "Reference"),
    words("error_percent", |row| {
        row.error().map(|error| number(100.0 * error, 2)).into()
    })
    .headed("error %", "Error %"),
    words("slope", slope).headed("tan β", "tan β"),
    words("slope_reference", |row| {
        row.reference(Quantity::TanBeta).map(with_letter).into()
    })
    .headed("ref. β", "Ref. β"),
    words("width_c", |row| width(row.crack.and_then(|c| c.c))).headed("c", "c"),
    words("width_e", |row| width(row.crack.and_then(|c| c.e))).headed("e", "e"),
    words("verdict_words", |row| verdict_words(row).into()).headed("verdict", "Verdict"),
    words("note", |row| Value::Text(note(row))).headed("note", "Note"),
    words("cpu_seconds", |row| Value::Text(number(row.seconds, 2))).headed("CPU s", "CPU s"),
];

/// The column of this name.
///
/// # Panics
/// Where there is none: names of columns are written in the program.
pub fn column(name: &str) -> &'static Column {
    let found = COLUMNS.iter().find(|column| column.name == name);
    found.unwrap_or_else(|| panic!("no column `{name}`"))
}

impl Row {
    /// What it says in the column of this name.
    pub(crate) fn value(&self, name: &str) -> Value {
        (column(name).value)(self)
    }
}

/// What a row says in the columns of these names.
pub fn values(row: &Row, names: &[&str]) -> Vec<Value> {
    names.iter().map(|name| row.value(name)).collect()
}

/// A heading, and what stands below it of a thing.
pub type Heading<T> = (&'static str, fn(&T) -> Value);

/// CSV of these headings, a line a thing.
pub fn csv_of<T>(columns: &[Heading<T>], things: &[T]) -> String {
    let line = |thing| columns.iter().map(|(_, value)| value(thing)).collect();
    csv(
        columns.iter().map(|(name, _)| *name),
        things.iter().map(line),
    )
}

/// CSV of these headings, and of lines that are as long.
pub fn csv<'a>(
    headings: impl IntoIterator<Item = &'a str>,
    lines: impl IntoIterator<Item = Vec<Value>>,
) -> String {
    let written = "memory takes lines of one length";
    let mut writer = csv::Writer::from_writer(Vec::new());
    writer.write_record(headings).expect(written);
    for line in lines {
        writer
            .write_record(line.iter().map(Value::csv))
            .expect(written);
    }
    let bytes = writer.into_inner().expect(written);
    String::from_utf8_lossy(&bytes).into_owned()
}

/// The direction of the push that an end belongs to.
fn push_of(end: Option<End>) -> Value {
    end.map(|end| end.push.name().to_owned()).into()
}

/// λ with the digits that its status vouches for; proved bounds are rounded outwards.
fn multiplier(row: &Row) -> Value {
    let Ends { lower, upper } = row.ends();
    // The closed form and the pushover's grid are exact in 5 decimals, and so is a proof to 1e-6.
    let exact = row.status() != Status::Estimate || row.kind() == Kind::ClosedForm;
    let decimals = if exact { 5 } else { 4 };
    let nearest = |end: End| number(end.lambda, decimals);
    Value::Text(match (lower, upper) {
        (None, None) => return Value::Nothing,
        (None, Some(end)) => format!("≤ {}", end.outwards(decimals)),
        (Some(end), None) => format!("≥ {}", end.outwards(decimals)),
        (Some(low), Some(high)) => {
            if row.is_one_number() {
                nearest(low)
            } else {
                let [low, high] = [low, high].map(|end| end.outwards(decimals));
                format!("{low} - {high}")
            }
        }
    })
}

/// tan β, with `~` where c or e is not sharp.
fn slope(row: &Row) -> Value {
    let text = row.crack.map(|crack| {
        let mark = if crack.sharp { "" } else { "~" };
        format!("{}{mark}", number(crack.tan_beta, 4))
    });
    text.into()
}

/// A count of the search for collapse states, where there was one.
fn coverage(row: &Row, count: fn(&Coverage) -> usize) -> Value {
    let search = row.outcome.search();
    let count = search.map(|search| count(&search.coverage()) as f64);
    count.into()
}

fn width(value: Option<f64>) -> Value {
    value.map(|value| short(value, 3)).into()
}

/// The reason, and the residual where it fails what `verified` asks for.
fn note(row: &Row) -> String {
    let mut note = row.settled_reason();
    let fails = row
        .residual()
        .is_some_and(|r| r > crate::mechanics::VERIFIED_RESIDUAL);
    if fails && row.status() != Status::Failed {
        note.push_str(if note.is_empty() { "" } else { "; " });
        note.push_str("the largest residual is above 1e-8");
    }
    if row.crack.is_some_and(|crack| !crack.sharp) {
        if !note.is_empty() {
            note.push_str("; ");
        }
        note.push_str("the crack (~) is not sharp");
    }
    note
}
