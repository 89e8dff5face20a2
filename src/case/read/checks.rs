//! Checks of single values: words, names of blocks, numbers and points.

use std::ops::RangeInclusive;

use toml::Spanned;

use super::values::{Number, Pair, WholeNumber};
use crate::case::complaint::{Complaint, shorten};
use crate::case::suggestion::{listed, nearest};
use crate::scene::{HeadJoints, Point};

/// Smallest and largest size of any number: far outside of masonry in any unit, and squares of it
/// are still far from the ends of `f64`.
pub(super) const SMALLEST: f64 = 1e-12;
pub(super) const LARGEST: f64 = 1e12;

pub(super) const MOST_BLOCKS: usize = 100_000;

/// What head joints can carry, in the order of a case's results.
pub(super) const HEAD_JOINTS: [HeadJoints; 2] = [HeadJoints::Contact, HeadJoints::Open];

/// A value of the file, which knows where it stands.
pub(crate) trait Written {
    /// A complaint about it, with a label below it.
    fn wrong(&self, title: impl Into<String>, label: impl Into<String>) -> Complaint;
}

impl<T> Written for Spanned<T> {
    fn wrong(&self, title: impl Into<String>, label: impl Into<String>) -> Complaint {
        Complaint::at(self.span(), title, label)
    }
}

/// The choice that a word stands for.
pub(super) fn choose<'a, T>(
    key: &str,
    choices: impl IntoIterator<Item = (&'a str, T)>,
    word: &Spanned<String>,
) -> Result<T, Complaint> {
    let written = word.get_ref().as_str();
    let mut words: Vec<&str> = Vec::new();
    for (known, choice) in choices {
        if known == written {
            return Ok(choice);
        }
        words.push(known);
    }
    let title = format!("unknown {key} `{}`", shorten(written, 60));
    let near = nearest(written, words.iter().copied());
    let help = match near {
        Some(near) => format!("did you mean `{key} = \"{near}\"`?"),
        None => format!(
            "the words for `{key}` are {}",
            listed(words.iter().copied())
        ),
    };
    let complaint = word.wrong(title, "not one of the known words");
    let sound = near.or(words.first().copied()).unwrap_or_default();
    let sound = format!("\"{sound}\"");
    Err(complaint.help(help).mended(word.span(), sound))
}

/// A name that no block has, or no support.
pub(super) fn unknown<'a>(
    what: &str,
    word: &Spanned<String>,
    known: impl Iterator<Item = &'a str> + Clone,
) -> Complaint {
    let name = shorten(word.get_ref(), 60);
    // Every short name is near every other.
    let near = nearest(&name, known.clone()).filter(|near| near.chars().count() > 2);
    let help = match near {
        Some(near) => format!("did you mean `{near}`?"),
        None => format!("the {what}s are {}", listed(known.take(20))),
    };
    word.wrong(
        format!("unknown {what} `{name}`"),
        format!("no such {what}"),
    )
    .help(help)
}

pub(super) fn positive(key: &str, value: &Spanned<Number>) -> Result<f64, Complaint> {
    within(key, value, SMALLEST..=LARGEST)
}

/// A positive number, or 1 where none is written.
pub(super) fn positive_or_one(
    key: &str,
    value: Option<&Spanned<Number>>,
) -> Result<f64, Complaint> {
    value.map_or(Ok(1.0), |value| positive(key, value))
}

pub(super) fn not_negative(key: &str, value: &Spanned<Number>) -> Result<f64, Complaint> {
    // The sum turns -0.0 into 0.0.
    within(key, value, 0.0..=LARGEST).map(|number| number + 0.0)
}

/// A finite number in `range`; TOML knows `nan` and `inf`, we do not.
pub(super) fn within(
    key: &str,
    value: &Spanned<Number>,
    range: RangeInclusive<f64>,
) -> Result<f64, Complaint> {
    let number = value.get_ref().0;
    if range.contains(&number) {
        return Ok(number);
    }
    let (least, most) = (*range.start(), *range.end());
    let why = if !number.is_finite() {
        "not a finite number"
    } else if number < 0.0 && least >= 0.0 {
        "negative"
    } else if number == 0.0 {
        "zero"
    } else if most < LARGEST {
        "out of range"
    } else if number < least {
        "absurdly small"
    } else {
        "absurdly large"
    };
    let [least, most] = [least, most].map(|end| match end.abs() {
        0.0 | 0.001..1e6 => end.to_string(),
        _ => format!("{end:e}"),
    });
    let complaint = value.wrong(format!("`{key}` is {why}"), "out of range");
    let sound = if range.contains(&1.0) {
        "1"
    } else {
        least.as_str()
    };
    let complaint = complaint.help(format!("write a number from {least} to {most}"));
    Err(complaint.mended(value.span(), sound))
}

/// A whole number from 1 to `most`.
pub(super) fn whole(
    key: &str,
    value: &Spanned<WholeNumber>,
    most: usize,
) -> Result<usize, Complaint> {
    let number = usize::try_from(value.get_ref().0).unwrap_or(0);
    if (1..=most).contains(&number) {
        return Ok(number);
    }
    let complaint = value.wrong(format!("`{key}` is out of range"), "out of range");
    let complaint = complaint.help(format!("write a whole number from 1 to {most}"));
    Err(complaint.mended(value.span(), "1"))
}

/// `[x, y]` as a point.
pub(super) fn coordinates(pair: &Spanned<Pair>, what: &str) -> Result<Point, Complaint> {
    let [x, y] = pair.get_ref().0.as_slice() else {
        return Err(pair
            .wrong(format!("{what} is two numbers"), "here")
            .help("write `[x, y]`, such as `[1.5, 0.0]`"));
    };
    let number = |key: &str, value: &Spanned<Number>| {
        within(key, value, -LARGEST..=LARGEST).map(|number| number + 0.0)
    };
    Ok(Point::new(number("x", x)?, number("y", y)?))
}
