//! The courses of a file, from course strings or from a bond, and where each one was written.

use std::ops::Range;

use toml::Spanned;

use super::check::choose;
use super::check::within;
use super::complaint::{Complaint, Document};
use super::course::{MOST_BLOCKS, MOST_PIECES, Written};
use super::file::File;
use super::values::{Courses, Whole};
use crate::scene::{Bond, BondError, Course};

/// Courses from bottom to top, and the strings they were read from.
pub(super) struct Laid {
    /// Every course.
    pub courses: Vec<Course>,
    /// Per course string: its span, and those of its pieces. Empty for a bond.
    strings: Vec<(Range<usize>, Vec<Range<usize>>)>,
}

impl Laid {
    /// The string of a course, which counts from 1 over all repeats.
    pub fn course_place(&self, course: usize) -> Option<Range<usize>> {
        Some(self.string(course)?.0.clone())
    }

    /// The text of a piece, which counts from 1.
    pub fn piece_place(&self, course: usize, piece: usize) -> Option<Range<usize>> {
        let (_, pieces) = self.string(course)?;
        pieces.get(piece.checked_sub(1)?).cloned()
    }

    /// What the underlined text is.
    pub fn label(&self, course: usize) -> String {
        let index = course.saturating_sub(1);
        match index.checked_div(self.strings.len()) {
            Some(0) => format!("in course {course}"),
            Some(turn) => format!("in course {course}: here, in repeat {}", turn + 1),
            None => "here".into(),
        }
    }

    fn string(&self, course: usize) -> Option<&(Range<usize>, Vec<Range<usize>>)> {
        let index = course.checked_sub(1)?;
        self.strings.get(index.checked_rem(self.strings.len())?)
    }
}

/// The courses that a file asks for.
pub(super) fn courses(
    document: &Document,
    file: &File,
    courses: &Spanned<Courses>,
) -> Result<Laid, Complaint> {
    let span = courses.span();
    match courses.get_ref() {
        Courses::One(text) => written(document, file, span.clone(), &[(span, text.as_str())]),
        Courses::List(list) => {
            let list: Vec<_> = list
                .iter()
                .map(|s| (s.span(), s.get_ref().as_str()))
                .collect();
            written(document, file, span, &list)
        }
        Courses::Count(count) => bonded(document, file, &Spanned::new(span, Whole(*count))),
    }
}

/// Courses from strings, the whole list laid `repeat` times.
fn written(
    document: &Document,
    file: &File,
    span: Range<usize>,
    strings: &[(Range<usize>, &str)],
) -> Result<Laid, Complaint> {
    no_bond(document, file)?;
    if strings.is_empty() {
        return Err(document
            .complain(span, "a wall without courses", "no course in here")
            .help("write the courses from bottom to top: `courses = [\"h1111h\", \"11111\"]`"));
    }
    let (mut list, mut places) = (Vec::new(), Vec::new());
    for (span, text) in strings {
        // Where the text begins behind its quotes; unknown if it was written with escapes.
        let begin = document.at(span.clone()).find(text);
        let inside = |place: &Range<usize>| match begin.map(|quotes| span.start + quotes) {
            Some(start) if !place.is_empty() => start + place.start..start + place.end,
            _ => span.clone(),
        };
        let read = Written::read(text).map_err(|error| {
            document
                .complain(inside(&error.place), error.title, "here")
                .help(error.help)
        })?;
        places.push((span.clone(), read.places.iter().map(inside).collect()));
        list.push(read.pieces);
    }
    let repeat = match &file.repeat {
        None => 1,
        Some(repeat) => whole(document, "repeat", repeat, MOST_BLOCKS)?,
    };
    let pieces: usize = list.iter().map(Vec::len).sum();
    if pieces.saturating_mul(repeat) > MOST_BLOCKS {
        let span = file.repeat.as_ref().map_or(span, Spanned::span);
        return Err(too_many(document, span));
    }
    Ok(Laid {
        courses: (0..repeat).flat_map(|_| list.iter().cloned()).collect(),
        strings: places,
    })
}

/// Refuses the keys of a bond beside course strings.
fn no_bond(document: &Document, file: &File) -> Result<(), Complaint> {
    let spans = [
        ("bond", file.bond.as_ref().map(Spanned::span)),
        ("units", file.units.as_ref().map(Spanned::span)),
        ("first", file.first.as_ref().map(Spanned::span)),
        ("overlap", file.overlap.as_ref().map(Spanned::span)),
    ];
    for (key, span) in spans {
        if let Some(span) = span {
            let title = format!("`{key}` beside course strings");
            return Err(document
                .complain(span, title, "goes with a number of courses")
                .help(format!(
                    "remove `{key}`, or write `bond = \"running\"`, `courses = 6`, `units = 5`"
                )));
        }
    }
    Ok(())
}

/// Courses from a pattern.
fn bonded(document: &Document, file: &File, count: &Spanned<Whole>) -> Result<Laid, Complaint> {
    let Some(bond) = &file.bond else {
        return Err(document
            .complain(
                count.span(),
                "a number of courses without a bond",
                "which pattern?",
            )
            .help("add `bond = \"running\"` and `units = 5`, or write the courses as strings"));
    };
    let pattern = pattern(document, file, bond)?;
    if let Some(repeat) = &file.repeat {
        return Err(document
            .complain(
                repeat.span(),
                "`repeat` beside a bond",
                "repeats course strings only",
            )
            .help("remove `repeat` and write the number of all courses in `courses`"));
    }
    let Some(units) = &file.units else {
        return Err(document
            .complain(bond.span(), "a bond without `units`", "how wide?")
            .help("add the width of the wall in full units: `units = 5`"));
    };
    let cut_first = cut_first(document, file, pattern)?;
    let wide = whole(document, "units", units, MOST_PIECES / 2 - 1)?;
    let high = whole(document, "courses", count, MOST_BLOCKS)?;
    if (2 * wide + 1).saturating_mul(high) > MOST_BLOCKS {
        return Err(too_many(document, count.span()));
    }
    let courses = pattern.lay(high, wide, cut_first).map_err(|error| {
        let BondError::Width { nearest, .. } = error;
        let complaint = document.complain(units.span(), error.to_string(), "does not close");
        complaint.help(format!(
            "the nearest width that does is `units = {nearest}`"
        ))
    })?;
    Ok(Laid {
        courses,
        strings: Vec::new(),
    })
}

/// The bond of `bond` and `overlap`.
fn pattern(document: &Document, file: &File, bond: &Spanned<String>) -> Result<Bond, Complaint> {
    let bonds = [
        Bond::RUNNING,
        Bond::Stack,
        Bond::English,
        Bond::Flemish,
        Bond::Header,
    ];
    let pattern = choose(
        document,
        "bond",
        bonds.map(|bond| (bond.name(), bond)),
        bond,
    )?;
    match (pattern, &file.overlap) {
        (_, None) => Ok(pattern),
        (Bond::Running { .. }, Some(overlap)) => Ok(Bond::Running {
            overlap: within(document, "overlap", overlap, LEAST_OVERLAP..=0.5)?,
        }),
        (_, Some(overlap)) => Err(document
            .complain(
                overlap.span(),
                format!("`overlap` beside {} bond", pattern.name()),
                "for running bond only",
            )
            .help("remove `overlap`: the bond says it")),
    }
}

/// Smallest lap of running bond, over the unit's length: less is no bond.
const LEAST_OVERLAP: f64 = 0.01;

/// Whether the lowest course is the one with cut ends.
fn cut_first(document: &Document, file: &File, pattern: Bond) -> Result<bool, Complaint> {
    let (cut, whole) = match pattern {
        Bond::Running { .. } => ("half", "whole"),
        Bond::English => ("header", "stretcher"),
        Bond::Flemish | Bond::Header => ("closer", "whole"),
        Bond::Stack => {
            return match &file.first {
                None => Ok(false),
                Some(word) => Err(document
                    .complain(
                        word.span(),
                        "`first` beside a stack bond",
                        "for other bonds only",
                    )
                    .help("remove `first`: all courses of a stack bond are alike")),
            };
        }
    };
    match &file.first {
        None => Ok(matches!(pattern, Bond::Running { .. })),
        Some(word) => choose(document, "first", [(cut, true), (whole, false)], word),
    }
}

/// A whole number from 1 to `most`.
pub(super) fn whole(
    document: &Document,
    key: &str,
    value: &Spanned<Whole>,
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

fn too_many(document: &Document, span: Range<usize>) -> Complaint {
    document
        .complain(
            span,
            format!("a wall of more than {MOST_BLOCKS} blocks"),
            "too many courses",
        )
        .help("write fewer or shorter courses")
}
