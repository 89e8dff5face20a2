//! Checks of single values: words, names of blocks, numbers and points.

use std::ops::{Range, RangeInclusive};

use toml::Spanned;

use super::values::{Number, Pair, WholeNumber};
use crate::case::complaint::{Complaint, Document, shorten};
use crate::case::suggestion::{listed, nearest};
use crate::scene::{Course, HeadJoints, Point};

/// Smallest and largest size of any number: far outside of masonry in any unit, and squares of it
/// are still far from the ends of `f64`.
pub(super) const SMALLEST: f64 = 1e-12;
pub(super) const LARGEST: f64 = 1e12;

/// Most blocks of one case.
pub(super) const MOST_BLOCKS: usize = 100_000;

/// What head joints can carry, in the order of a case's results.
pub(super) const HEAD_JOINTS: [HeadJoints; 2] = [HeadJoints::Contact, HeadJoints::Open];

/// The choice that a word stands for.
pub(super) fn choose<'a, T>(
    document: &Document,
    key: &str,
    choices: impl IntoIterator<Item = (&'a str, T)>,
    word: &Spanned<String>,
) -> Result<T, Complaint> {
    let written = word.get_ref().as_str();
    let mut words = Vec::new();
    for (known, choice) in choices {
        if known == written {
            return Ok(choice);
        }
        words.push(known);
    }
    let title = format!("unknown {key} `{}`", shorten(written, 60));
    let help = match nearest(written, words.iter().copied()) {
        Some(near) => format!("did you mean `{key} = \"{near}\"`?"),
        None => format!("the words for `{key}` are {}", listed(words)),
    };
    Err(document
        .complain(word.span(), title, "not one of the known words")
        .help(help))
}

/// A name that no block has.
pub(super) fn unknown_block<'a>(
    document: &Document,
    word: &Spanned<String>,
    known: impl Iterator<Item = &'a str> + Clone,
) -> Complaint {
    let name = shorten(word.get_ref(), 60);
    // Every short name is near every other.
    let near = nearest(&name, known.clone()).filter(|near| near.chars().count() > 2);
    let help = match near {
        Some(near) => format!("did you mean `{near}`?"),
        None => format!("the blocks are {}", listed(known.take(20))),
    };
    document
        .complain(
            word.span(),
            format!("unknown block `{name}`"),
            "no such block",
        )
        .help(help)
}

pub(super) fn positive(
    document: &Document,
    key: &str,
    value: &Spanned<Number>,
) -> Result<f64, Complaint> {
    within(document, key, value, SMALLEST..=LARGEST)
}

pub(super) fn not_negative(
    document: &Document,
    key: &str,
    value: &Spanned<Number>,
) -> Result<f64, Complaint> {
    // The sum turns -0.0 into 0.0.
    within(document, key, value, 0.0..=LARGEST).map(|number| number + 0.0)
}

/// A finite number in `range`; TOML knows `nan` and `inf`, we do not.
pub(super) fn within(
    document: &Document,
    key: &str,
    value: &Spanned<Number>,
    range: RangeInclusive<f64>,
) -> Result<f64, Complaint> {
    let number = value.get_ref().0;
    if range.contains(&number) {
        return Ok(number);
    }
    let (least, most) = (*range.start(), *range.end());
    let title = if !number.is_finite() {
        format!("`{key}` is not a finite number")
    } else if number < 0.0 && least >= 0.0 {
        format!("`{key}` is negative")
    } else if number == 0.0 {
        format!("`{key}` is zero")
    } else if most < LARGEST {
        format!("`{key}` is out of range")
    } else if number < least {
        format!("`{key}` is absurdly small")
    } else {
        format!("`{key}` is absurdly large")
    };
    let written = |end: f64| match end.abs() {
        0.0 | 0.001..1e6 => end.to_string(),
        _ => format!("{end:e}"),
    };
    Err(document
        .complain(value.span(), title, "out of range")
        .help(format!(
            "write a number from {} to {}",
            written(least),
            written(most)
        )))
}

/// A whole number from 1 to `most`.
pub(super) fn whole(
    document: &Document,
    key: &str,
    value: &Spanned<WholeNumber>,
    most: usize,
) -> Result<usize, Complaint> {
    let number = usize::try_from(value.get_ref().0).unwrap_or(0);
    if (1..=most).contains(&number) {
        return Ok(number);
    }
    let title = format!("`{key}` is out of range");
    Err(document
        .complain(value.span(), title, "out of range")
        .help(format!("write a whole number from 1 to {most}")))
}

/// `[x, y]` as a point.
pub(super) fn coordinates(
    document: &Document,
    pair: &Spanned<Pair>,
    what: &str,
) -> Result<Point, Complaint> {
    let [x, y] = pair.get_ref().0.as_slice() else {
        return Err(document
            .complain(pair.span(), format!("{what} is two numbers"), "here")
            .help("write `[x, y]`, such as `[1.5, 0.0]`"));
    };
    let number = |key: &str, value: &Spanned<Number>| {
        within(document, key, value, -LARGEST..=LARGEST).map(|number| number + 0.0)
    };
    Ok(Point::new(number("x", x)?, number("y", y)?))
}

/// A complaint about more courses than a wall can have.
pub(super) fn too_many_courses(document: &Document, span: Range<usize>) -> Complaint {
    document
        .complain(
            span,
            format!("a wall of more than {MOST_BLOCKS} blocks"),
            "too many courses",
        )
        .help("write fewer or shorter courses")
}

/// Blocks of these courses.
pub(super) fn blocks_of(courses: &[Course]) -> usize {
    let pieces = courses.iter().flatten();
    pieces.filter(|piece| !piece.is_gap()).count()
}
