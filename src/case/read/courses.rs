//! The courses of a file, from course strings or from a bond, and where each one was written.

use std::collections::BTreeMap;
use std::ops::Range;

use toml::Spanned;

use super::bond::courses_in_bond;
use super::checks::{MOST_BLOCKS, blocks_of, too_many_courses, whole};
use super::course_string::read_course;
use super::file::CaseFile;
use super::pieces::{Legend, Meaning};
use super::values::{CoursesValue, WholeNumber};
use crate::case::complaint::{Complaint, Document};
use crate::scene::Course;

/// Courses from bottom to top, and the strings they were read from.
pub(super) struct PlacedCourses {
    /// Every course.
    pub courses: Vec<Course>,
    /// Weights that pieces of the legend give their blocks, by the place of the block.
    pub weights: BTreeMap<usize, f64>,
    /// Span of every course string. Empty for a bond.
    strings: Vec<Range<usize>>,
}

impl PlacedCourses {
    /// The course strings from bottom to top; they may be laid several times.
    pub fn strings(&self) -> &[Range<usize>] {
        &self.strings
    }

    /// The string of a course, which counts from 1 over all repeats.
    pub fn course_place(&self, course: usize) -> Option<Range<usize>> {
        let index = course.checked_sub(1)?;
        let string = self.strings.get(index.checked_rem(self.strings.len())?)?;
        Some(string.clone())
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
}

/// The courses that a file asks for.
pub(super) fn courses(
    document: &Document,
    file: &CaseFile,
    courses: &Spanned<CoursesValue>,
    legend: &Legend,
) -> Result<PlacedCourses, Complaint> {
    let span = courses.span();
    match courses.get_ref() {
        CoursesValue::One(text) => {
            let list = [(span.clone(), text.as_str())];
            from_strings(document, file, span, &list, legend)
        }
        CoursesValue::List(list) => {
            let list: Vec<_> = list
                .iter()
                .map(|s| (s.span(), s.get_ref().as_str()))
                .collect();
            from_strings(document, file, span, &list, legend)
        }
        CoursesValue::Count(count) => {
            if let Some(pieces) = &file.pieces {
                return Err(document
                    .complain(
                        pieces.span(),
                        "`pieces` beside a bond",
                        "for course strings only",
                    )
                    .help("remove `pieces`, or write the courses as strings"));
            }
            let count = Spanned::new(span, WholeNumber(*count));
            let courses = courses_in_bond(document, file, &count)?;
            Ok(PlacedCourses {
                courses,
                weights: BTreeMap::new(),
                strings: Vec::new(),
            })
        }
    }
}

/// Courses from strings, the whole list laid `repeat` times.
fn from_strings(
    document: &Document,
    file: &CaseFile,
    span: Range<usize>,
    strings: &[(Range<usize>, &str)],
    legend: &Legend,
) -> Result<PlacedCourses, Complaint> {
    no_bond(document, file)?;
    if strings.is_empty() {
        return Err(document
            .complain(span, "a wall without courses", "no course in here")
            .help("write the courses from bottom to top: `courses = [\"h1111h\", \"11111\"]`"));
    }
    let mut list = Vec::new();
    for (span, text) in strings {
        // Where the text begins behind its quotes; unknown if it was written with escapes.
        let begin = document.at(span.clone()).find(text);
        let inside = |place: &Range<usize>| match begin.map(|quotes| span.start + quotes) {
            Some(start) if !place.is_empty() => start + place.start..start + place.end,
            _ => span.clone(),
        };
        let read = read_course(text, legend).map_err(|error| {
            document
                .complain(inside(&error.place), error.title, "here")
                .help(error.help)
        })?;
        list.push(read);
    }
    let repeat = match &file.repeat {
        None => 1,
        Some(repeat) => whole(document, "repeat", repeat, MOST_BLOCKS)?,
    };
    let course = |meanings: &Vec<Meaning>| meanings.iter().map(|m| m.piece).collect();
    let courses: Vec<Course> = list.iter().map(course).collect();
    let pieces: usize = courses.iter().map(Vec::len).sum();
    let blocks = blocks_of(&courses);
    let beyond = |count: usize, most: usize| count.saturating_mul(repeat) > most;
    if beyond(blocks, MOST_BLOCKS) || beyond(pieces, MOST_PIECES_OF_ALL) {
        let span = file.repeat.as_ref().map_or(span, Spanned::span);
        return Err(too_many_courses(document, span));
    }
    let meanings = list.iter().flatten();
    let of_blocks = meanings.filter(|meaning| !meaning.piece.is_gap());
    let once: Vec<Option<f64>> = of_blocks.map(|meaning| meaning.weight).collect();
    let weighted = |block: usize| Some((block, once[block % once.len()]?));
    Ok(PlacedCourses {
        weights: match once.iter().any(Option::is_some) {
            true => (0..blocks * repeat).filter_map(weighted).collect(),
            false => BTreeMap::new(),
        },
        courses: (0..repeat).flat_map(|_| courses.iter().cloned()).collect(),
        strings: strings.iter().map(|(span, _)| span.clone()).collect(),
    })
}

/// Most pieces of a wall, gaps counted in: what keeps a file of gaps from filling the memory.
const MOST_PIECES_OF_ALL: usize = 10 * MOST_BLOCKS;

/// Refuses the keys of a bond beside course strings.
fn no_bond(document: &Document, file: &CaseFile) -> Result<(), Complaint> {
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
