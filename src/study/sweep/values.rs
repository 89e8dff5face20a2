//! The values that a key runs through, and what they are called.

use std::collections::HashSet;
use std::ops;

use toml::{Spanned, Value};

use super::file::{Scalar, ValueRange, Values};
use crate::case::{Complaint, Written};
use crate::number::nine_digits;

const MOST_VALUES: usize = 100_000;

/// A value, and where it was written.
pub(super) type Placed = (Value, ops::Range<usize>);

/// Every value of a key, in order. No value comes twice.
pub(super) fn values(key: &str, written: &Spanned<Values>) -> Result<Vec<Placed>, Complaint> {
    let values: Vec<Placed> = match written.get_ref() {
        Values::List(list) => list
            .iter()
            .map(|scalar| (scalar.get_ref().0.clone(), scalar.span()))
            .collect(),
        Values::ValueRange(range) => {
            let numbers = range_values(range)?;
            numbers.map(|value| (value, written.span())).collect()
        }
    };
    if values.is_empty() {
        let complaint = written.wrong(format!("`{key}` runs through no value"), "nothing in here");
        return Err(complaint.help("write at least one value, or drop the key"));
    }
    let mut texts = HashSet::new();
    if let Some((value, span)) = values.iter().find(|(value, _)| !texts.insert(text(value))) {
        let title = format!("`{key}` runs through {} twice", text(value));
        return Err(Complaint::at(span.clone(), title, "again").help("write each value once"));
    }
    Ok(values)
}

/// A number as CSV shows it, a word as it is.
pub(super) fn text(value: &Value) -> String {
    match value {
        Value::String(word) => word.clone(),
        Value::Float(number) => nine_digits(*number),
        other => other.to_string(),
    }
}

/// Numbers evenly from one to another, rounded to nine digits: what the table shows is what ran.
/// They are whole where all of them can be, as for a number of courses.
fn range_values(range: &ValueRange) -> Result<impl Iterator<Item = Value>, Complaint> {
    let from = number("from", &range.from)?;
    let to = number("to", &range.to)?;
    let count = match range.count.get_ref().0 {
        Value::Integer(count) if (2..=MOST_VALUES as i64).contains(&count) => count,
        _ => {
            let complaint = range.count.wrong("`count` is out of range", "how many?");
            return Err(complaint.help(format!("write a whole number from 2 to {MOST_VALUES}")));
        }
    };
    let logarithmic = match &range.spacing {
        None => false,
        Some(word) if word.get_ref() == "linear" => false,
        Some(word) if word.get_ref() == "logarithmic" => true,
        Some(word) => {
            let title = format!("unknown spacing `{}`", word.get_ref());
            let complaint = word.wrong(title, "not a spacing");
            let help = "write `spacing = \"linear\"` or `spacing = \"logarithmic\"`";
            return Err(complaint.help(help));
        }
    };
    if logarithmic && !(from > 0.0 && to > 0.0) {
        let end = if from > 0.0 { &range.to } else { &range.from };
        let complaint = end.wrong("a logarithmic range through zero", "not positive");
        return Err(complaint.help("write a positive number, or drop `spacing`"));
    }
    let whole = |scalar: &Spanned<Scalar>| matches!(scalar.get_ref().0, Value::Integer(_));
    let whole = whole(&range.from)
        && whole(&range.to)
        && !logarithmic
        && ((to - from) / (count - 1) as f64).fract() == 0.0;
    Ok((0..count).map(move |i| {
        let share = i as f64 / (count - 1) as f64;
        // The ends are exact in either spacing.
        let value = if i == 0 {
            from
        } else if i == count - 1 {
            to
        } else if logarithmic {
            from * (to / from).powf(share)
        } else {
            from + (to - from) * share
        };
        if whole {
            Value::Integer(value as i64)
        } else {
            Value::Float(nine_digits(value).parse().unwrap_or(value))
        }
    }))
}

fn number(key: &str, scalar: &Spanned<Scalar>) -> Result<f64, Complaint> {
    let number = match scalar.get_ref().0 {
        Value::Integer(number) => Some(number as f64),
        Value::Float(number) => Some(number),
        _ => None,
    };
    number.filter(|n| n.abs() <= 1e12).ok_or_else(|| {
        let complaint = scalar.wrong(format!("`{key}` is no usable number"), "here");
        complaint.help("write a number of size up to 1e12, such as `0.65`")
    })
}
