//! From a file to a case: every value judged, the geometry laid once.

use std::ops::{Range, RangeInclusive};

use toml::Spanned;

use super::complaint::{Complaint, Document, listed, nearest, shorten};
use super::explain::missing_key;
use super::file::{self, File};
use super::values::{self, Number};
use super::{Beside, Case, Geometry, Kind, METHOD_NAMES, Quantity, Reference, arch, blocks, wall};
use crate::scene::{Friction, HeadJoints, Push};

/// Smallest and largest size of any number: far outside of masonry in any unit, and squares of it
/// are still far from the ends of `f64`.
const SMALLEST: f64 = 1e-12;
pub(super) const LARGEST: f64 = 1e12;

/// What head joints can carry, in the order of a case's results.
pub(super) const SETTINGS: [HeadJoints; 2] = [HeadJoints::Contact, HeadJoints::Open];

/// Judges a file and makes the case of it. `beside` reads a file that lies beside it.
pub(super) fn case(
    document: &Document,
    name: &str,
    file: &File,
    beside: Beside,
) -> Result<Case, Complaint> {
    let geometry = geometry(document, file, beside)?;
    let head_joints = head_joints(document, file, &geometry)?;
    let references = file.references.iter();
    Ok(Case {
        name: name.to_owned(),
        title: file.title.clone().unwrap_or_else(|| name.to_owned()),
        source: file.source.clone().unwrap_or_default(),
        references: references
            .map(|reference| check_reference(document, reference, &head_joints))
            .collect::<Result<_, _>>()?,
        geometry,
        pushes: pushes(document, file)?,
        head_joints,
    })
}

/// The one geometry of a file: the first key that belongs to one form decides which, and a key of
/// another is refused.
fn geometry(document: &Document, file: &File, beside: Beside) -> Result<Geometry, Complaint> {
    let keys = form_keys(file);
    let first = |key: &&FormKey| (key.forms.len(), key.span.start);
    let Some(form) = keys.iter().min_by_key(first).map(|key| key.forms[0]) else {
        return Err(missing_key(document, 0..0, "unit"));
    };
    if let Some(key) = keys.iter().find(|key| !key.forms.contains(&form)) {
        let title = format!("`{}` beside {}", key.name, form.name());
        return Err(document
            .complain(
                key.span.clone(),
                title,
                format!("goes with {}", key.forms[0].name()),
            )
            .help(format!(
                "remove `{}`: a case is either a coursed wall, or blocks, or an arch",
                key.name
            )));
    }
    match form {
        Form::Wall => wall::wall(document, file).map(Geometry::Wall),
        Form::Blocks => blocks::assembly(document, file, beside).map(Geometry::Blocks),
        Form::Arch => arch::arch(document, file).map(Geometry::Arch),
    }
}

/// The forms of a case.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Form {
    Wall,
    Blocks,
    Arch,
}

impl Form {
    fn name(self) -> &'static str {
        match self {
            Form::Wall => "a coursed wall",
            Form::Blocks => "explicit blocks",
            Form::Arch => "an arch",
        }
    }
}

/// A key that belongs to some forms only, the first of them its own.
struct FormKey {
    name: &'static str,
    span: Range<usize>,
    forms: &'static [Form],
}

/// Every such key of the file.
fn form_keys(file: &File) -> Vec<FormKey> {
    const WALL: &[Form] = &[Form::Wall];
    const BLOCKS: &[Form] = &[Form::Blocks];
    const FORCES: &[Form] = &[Form::Blocks, Form::Arch];
    let spans = [
        ("unit", WALL, file.unit.as_ref().map(Spanned::span)),
        ("courses", WALL, file.courses.as_ref().map(Spanned::span)),
        ("repeat", WALL, file.repeat.as_ref().map(Spanned::span)),
        ("bond", WALL, file.bond.as_ref().map(Spanned::span)),
        ("units", WALL, file.units.as_ref().map(Spanned::span)),
        ("first", WALL, file.first.as_ref().map(Spanned::span)),
        ("overlap", WALL, file.overlap.as_ref().map(Spanned::span)),
        (
            "overburden",
            WALL,
            file.overburden.as_ref().map(Spanned::span),
        ),
        ("arch", &[Form::Arch], file.arch.as_ref().map(Spanned::span)),
        ("blocks", BLOCKS, file.blocks.as_ref().map(Spanned::span)),
        ("block", BLOCKS, file.block.first().map(Spanned::span)),
        ("support", BLOCKS, file.support.first().map(Spanned::span)),
        ("live", FORCES, file.live.as_ref().map(Spanned::span)),
        ("load", FORCES, file.load.first().map(Spanned::span)),
    ];
    let keys = spans.into_iter().filter_map(|(name, forms, span)| {
        let span = span?;
        Some(FormKey { name, span, forms })
    });
    keys.collect()
}

/// The coefficients of friction; `head` and `base` are those of `bed` where they are left out.
pub(super) fn friction(document: &Document, file: &File) -> Result<Friction, Complaint> {
    match file.friction.get_ref() {
        values::Friction::One(number) => {
            let number = Spanned::new(file.friction.span(), Number(*number));
            Ok(not_negative(document, "friction", &number)?.into())
        }
        values::Friction::Classes(classes) => {
            let bed = not_negative(document, "bed", &classes.bed)?;
            let other = |key, value: &Option<Spanned<Number>>| match value {
                None => Ok(bed),
                Some(value) => not_negative(document, key, value),
            };
            Ok(Friction {
                bed,
                head: other("head", &classes.head)?,
                base: other("base", &classes.base)?,
            })
        }
    }
}

fn head_joints(
    document: &Document,
    file: &File,
    geometry: &Geometry,
) -> Result<Vec<HeadJoints>, Complaint> {
    let Some(word) = &file.head_joints else {
        return Ok(vec![HeadJoints::Contact]);
    };
    if let Geometry::Arch(_) = geometry {
        let title = "an arch has no head joints";
        return Err(document
            .complain(word.span(), title, "its joints are radial")
            .help("remove `head_joints`"));
    }
    let [contact, open] = SETTINGS.map(|setting| (setting.name(), vec![setting]));
    let both = ("both", SETTINGS.to_vec());
    choose(document, "head_joints", [contact, open, both], word)
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
