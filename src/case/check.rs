//! From a file to a case: every value judged, the wall laid once for each setting.

use std::ops::{Range, RangeInclusive};

use toml::Spanned;

use super::complaint::{Complaint, Document, listed, nearest, shorten};
use super::courses::{Laid, courses};
use super::file::{self, File, Number, Unit};
use super::{Case, Geometry, Kind, METHOD_NAMES, Quantity, Reference};
use crate::scene::{Course, HeadJoints, Push, Wall, WallError};

/// Smallest and largest size of any number: far outside of masonry in any unit, and squares of it
/// are still far from the ends of `f64`.
const SMALLEST: f64 = 1e-12;
const LARGEST: f64 = 1e12;

/// What head joints can carry, in the order of a case's results.
const SETTINGS: [HeadJoints; 2] = [HeadJoints::Contact, HeadJoints::Open];

/// Units longer or higher than this times the other side would fall under the joint search's
/// tolerance.
const MOST_SLENDER: f64 = 1000.0;

/// Judges a file and makes the case of it.
pub(super) fn case(document: &Document, name: &str, file: &File) -> Result<Case, Complaint> {
    let laid = courses(document, file)?;
    let head_joints = head_joints(document, file)?;
    let wall = wall(document, file, laid.courses.clone())?;
    not_too_slender(document, &file.unit, &wall)?;
    for setting in SETTINGS {
        wall.scene(setting)
            .map_err(|error| not_laid(document, file, &laid, &error))?;
    }
    let references = file.references.iter();
    Ok(Case {
        name: name.to_owned(),
        title: file.title.clone().unwrap_or_else(|| name.to_owned()),
        source: file.source.clone().unwrap_or_default(),
        references: references
            .map(|reference| check_reference(document, reference, &head_joints))
            .collect::<Result<_, _>>()?,
        geometry: Geometry::Wall(wall),
        pushes: pushes(document, file)?,
        head_joints,
    })
}

fn head_joints(document: &Document, file: &File) -> Result<Vec<HeadJoints>, Complaint> {
    let Some(word) = &file.head_joints else {
        return Ok(vec![HeadJoints::Contact]);
    };
    let [contact, open] = SETTINGS.map(|setting| (setting.name(), vec![setting]));
    let both = ("both", SETTINGS.to_vec());
    choose(document, "head_joints", [contact, open, both], word)
}

fn wall(document: &Document, file: &File, courses: Vec<Course>) -> Result<Wall, Complaint> {
    let unit = file.unit.get_ref();
    Ok(Wall {
        unit_length: positive(document, "length", &unit.length)?,
        unit_height: positive(document, "height", &unit.height)?,
        thickness: match &unit.thickness {
            None => 1.0,
            Some(value) => positive(document, "thickness", value)?,
        },
        unit_weight: positive(document, "weight", &unit.weight)?,
        courses,
        friction: not_negative(document, "friction", &file.friction)?.into(),
        overburden: match &file.overburden {
            None => 0.0,
            Some(value) => not_negative(document, "overburden", value)?,
        },
        push: Push::Right,
    })
}

fn pushes(document: &Document, file: &File) -> Result<Vec<Push>, Complaint> {
    let Some(word) = &file.push else {
        return Ok(vec![Push::Right]);
    };
    let words = [
        ("right", vec![Push::Right]),
        ("left", vec![Push::Left]),
        ("both", vec![Push::Right, Push::Left]),
    ];
    choose(document, "push", words, word)
}

fn check_reference(
    document: &Document,
    reference: &file::Reference,
    settings: &[HeadJoints],
) -> Result<Reference, Complaint> {
    let methods = METHOD_NAMES.map(|name| (name, name));
    let head_joints = match &reference.head_joints {
        None => None,
        Some(word) => {
            let names = SETTINGS.map(|setting| (setting.name(), setting));
            let setting = choose(document, "head_joints", names, word)?;
            // It would never be compared with anything, and nobody would notice.
            if !settings.contains(&setting) {
                let title = format!("the case does not run with {} head joints", setting.name());
                return Err(document
                    .complain(word.span(), title, "never compared with a result")
                    .help("write `head_joints = \"both\"` at the top, or drop this reference"));
            }
            Some(setting)
        }
    };
    let kinds = Kind::ALL.map(|kind| (kind.name(), kind));
    let quantities = Quantity::ALL.map(|quantity| (quantity.name(), quantity));
    Ok(Reference {
        method: choose(document, "method", methods, &reference.method)?.to_owned(),
        head_joints,
        quantity: choose(document, "quantity", quantities, &reference.quantity)?,
        value: not_negative(document, "value", &reference.value)?,
        tolerance: positive(document, "tolerance", &reference.tolerance)?,
        source: reference.source.clone(),
        kind: choose(document, "kind", kinds, &reference.kind)?,
        note: reference.note.clone().unwrap_or_default(),
        deviation: reference.deviation.clone(),
    })
}

/// The choice that a word stands for.
pub(super) fn choose<T, const N: usize>(
    document: &Document,
    key: &str,
    choices: [(&str, T); N],
    word: &Spanned<String>,
) -> Result<T, Complaint> {
    let written = word.get_ref().as_str();
    let words = choices.each_ref().map(|(known, _)| *known);
    let found = choices.into_iter().find(|(known, _)| *known == written);
    found.map(|(_, choice)| choice).ok_or_else(|| {
        let title = format!("unknown {key} `{}`", shorten(written, 60));
        let help = match nearest(written, words) {
            Some(near) => format!("did you mean `{key} = \"{near}\"`?"),
            None => format!("the words for `{key}` are {}", listed(words)),
        };
        document
            .complain(word.span(), title, "not one of the known words")
            .help(help)
    })
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

fn not_too_slender(
    document: &Document,
    unit: &Spanned<Unit>,
    wall: &Wall,
) -> Result<(), Complaint> {
    let ratio = wall.unit_length / wall.unit_height;
    if (1.0 / MOST_SLENDER..=MOST_SLENDER).contains(&ratio) {
        return Ok(());
    }
    let span = if ratio > 1.0 {
        unit.get_ref().length.span()
    } else {
        unit.get_ref().height.span()
    };
    let title =
        format!("a unit more than {MOST_SLENDER} times longer or higher than the other way");
    Err(document
        .complain(span, title, format!("length / height is {ratio:e}"))
        .help("check that length and height are in one and the same unit of length"))
}

/// Points at the course, or at the piece of it, that cannot be laid.
fn not_laid(document: &Document, file: &File, laid: &Laid, error: &WallError) -> Complaint {
    let (place, help): (Option<Range<usize>>, &str) = match error {
        WallError::NoCourses => (None, "write at least one course"),
        WallError::EmptyCourse { course } => (
            laid.course_place(*course),
            "put a unit `1` or half a unit `h` into the course; `g` is a gap",
        ),
        WallError::Unsupported { course } => (
            laid.course_place(*course),
            "let a block of this course lie on a block of the course below",
        ),
        WallError::Floating { course, piece } => (
            laid.piece_place(*course, *piece),
            "fill a gap beside or below it with `1`, or make it a gap `g`",
        ),
        WallError::Shape(_) => (
            Some(file.unit.span()),
            "check length and height of the unit",
        ),
    };
    let label = match error {
        WallError::EmptyCourse { course }
        | WallError::Unsupported { course }
        | WallError::Floating { course, .. } => laid.label(*course),
        WallError::NoCourses | WallError::Shape(_) => "here".into(),
    };
    document
        .complain(
            place.unwrap_or(file.courses.span()),
            error.to_string(),
            label,
        )
        .help(help)
}
