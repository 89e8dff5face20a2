//! The values that a key runs through, and what they are called.

use std::collections::HashSet;
use std::ops;

use toml::{Spanned, Value};

use super::file::{Scalar, ValueRange, Values};
use crate::case::{Complaint, Document};
use crate::number::nine_digits;

const MOST_VALUES: usize = 100_000;

/// A value, and where it was written.
pub(super) type Placed = (Value, ops::Range<usize>);

/// Every value of a key, in order. No value comes twice.
pub(super) fn values(
    document: &Document,
    key: &str,
    written: &Spanned<Values>,
) -> Result<Vec<Placed>, Complaint> {
    let values: Vec<Placed> = match written.get_ref() {
        Values::List(list) => list
            .iter()
            .map(|scalar| (scalar.get_ref().0.clone(), scalar.span()))
            .collect(),
        Values::ValueRange(range) => {
            let numbers = range_values(document, range)?;
            numbers.map(|value| (value, written.span())).collect()
        }
    };
    none_twice(document, key, written, &values)?;
    Ok(values)
}

fn none_twice(
    document: &Document,
    key: &str,
    written: &Spanned<Values>,
    values: &[Placed],
) -> Result<(), Complaint> {
    if values.is_empty() {
        return Err(document
            .complain(
                written.span(),
                format!("`{key}` runs through no value"),
                "nothing in here",
            )
            .help("write at least one value, or drop the key"));
    }
    let mut texts = HashSet::new();
    match values.iter().find(|(value, _)| !texts.insert(text(value))) {
        None => Ok(()),
        Some((value, span)) => {
            let title = format!("`{key}` runs through {} twice", text(value));
            Err(document
                .complain(span.clone(), title, "again")
                .help("write each value once"))
        }
    }
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
fn range_values(
    document: &Document,
    range: &ValueRange,
) -> Result<impl Iterator<Item = Value>, Complaint> {
    let from = number(document, "from", &range.from)?;
    let to = number(document, "to", &range.to)?;
    let count = match range.count.get_ref().0 {
        Value::Integer(count) if (2..=MOST_VALUES as i64).contains(&count) => count,
        _ => {
            return Err(document
                .complain(range.count.span(), "`count` is out of range", "how many?")
                .help(format!("write a whole number from 2 to {MOST_VALUES}")));
        }
    };
    let logarithmic = match range.spacing.as_ref().map(Spanned::get_ref) {
        None => false,
        Some(word) if word == "linear" => false,
        Some(word) if word == "logarithmic" => true,
        Some(word) => {
            let span = range.spacing.as_ref().map_or(0..0, Spanned::span);
            return Err(document
                .complain(span, format!("unknown spacing `{word}`"), "not a spacing")
                .help("write `spacing = \"linear\"` or `spacing = \"logarithmic\"`"));
        }
    };
    if logarithmic && !(from > 0.0 && to > 0.0) {
        let span = if from > 0.0 {
            range.to.span()
        } else {
            range.from.span()
        };
        return Err(document
            .complain(span, "a logarithmic range through zero", "not positive")
            .help("write a positive number, or drop `spacing`"));
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

fn number(document: &Document, key: &str, scalar: &Spanned<Scalar>) -> Result<f64, Complaint> {
    let number = match scalar.get_ref().0 {
        Value::Integer(number) => Some(number as f64),
        Value::Float(number) => Some(number),
        _ => None,
    };
    number.filter(|n| n.abs() <= 1e12).ok_or_else(|| {
        document
            .complain(
                scalar.span(),
                format!("`{key}` is no usable number"),
                "here",
            )
            .help("write a number of size up to 1e12, such as `0.65`")
    })
}
