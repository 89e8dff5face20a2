//! The courses of a file, from course strings or from a bond, and where each one was written.

use std::ops::Range;

use toml::Spanned;

use super::bond::courses_in_bond;
use super::checks::{MOST_BLOCKS, too_many_courses, whole};
use super::course_string::read_course;
use super::file::CaseFile;
use super::values::{CoursesValue, WholeNumber};
use crate::case::complaint::{Complaint, Document};
use crate::scene::Course;

/// Courses from bottom to top, and the strings they were read from.
pub(super) struct PlacedCourses {
    /// Every course.
    pub courses: Vec<Course>,
    /// Span of every course string. Empty for a bond.
    strings: Vec<Range<usize>>,
}

impl PlacedCourses {
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
) -> Result<PlacedCourses, Complaint> {
    let span = courses.span();
    match courses.get_ref() {
        CoursesValue::One(text) => {
            from_strings(document, file, span.clone(), &[(span, text.as_str())])
        }
        CoursesValue::List(list) => {
            let list: Vec<_> = list
                .iter()
                .map(|s| (s.span(), s.get_ref().as_str()))
                .collect();
            from_strings(document, file, span, &list)
        }
        CoursesValue::Count(count) => {
            let count = Spanned::new(span, WholeNumber(*count));
            let courses = courses_in_bond(document, file, &count)?;
            Ok(PlacedCourses {
                courses,
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
        let read = read_course(text).map_err(|error| {
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
    let pieces: usize = list.iter().map(Vec::len).sum();
    if pieces.saturating_mul(repeat) > MOST_BLOCKS {
        let span = file.repeat.as_ref().map_or(span, Spanned::span);
        return Err(too_many_courses(document, span));
    }
    Ok(PlacedCourses {
        courses: (0..repeat).flat_map(|_| list.iter().cloned()).collect(),
        strings: strings.iter().map(|(span, _)| span.clone()).collect(),
    })
}

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
