//! The courses of a file, from course strings or from a bond, and where each one was written.

use std::collections::BTreeMap;
use std::ops::Range;

use toml::Spanned;

use super::bond::courses_in_bond;
use super::checks::{MOST_BLOCKS, Written, whole};
use super::course_string::{blocks_of, read_course, too_many_courses};
use super::file::{CaseFile, Place};
use super::pieces::{Legend, Meaning};
use super::values::{CoursesValue, WholeNumber};
use crate::case::complaint::{Complaint, Document};
use crate::scene::Course;

/// Most pieces of a wall, gaps counted in: what keeps a file of gaps from filling the memory.
const MOST_PIECES_OF_ALL: usize = 10 * MOST_BLOCKS;

/// Courses from bottom to top, and the strings they were read from.
#[derive(Default)]
pub(super) struct PlacedCourses {
    pub courses: Vec<Course>,
    /// Weights that pieces of the legend give their blocks, by the place of the block.
    pub weights: BTreeMap<usize, f64>,
    /// Span of every course string from bottom to top; they may be laid several times. Empty for a
    /// bond.
    pub strings: Vec<Range<usize>>,
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
    legend: &Legend,
) -> Result<PlacedCourses, Complaint> {
    let span = courses.span();
    let count = match courses.get_ref() {
        CoursesValue::One(text) => {
            let list = [Spanned::new(span.clone(), text.clone())];
            return from_strings(document, file, span, &list, legend);
        }
        CoursesValue::List(list) => return from_strings(document, file, span, list, legend),
        CoursesValue::Count(count) => Spanned::new(span, WholeNumber(*count)),
    };
    if let Some(pieces) = &file.pieces {
        return Err(pieces
            .wrong("`pieces` beside a bond", "for course strings only")
            .help("remove `pieces`, or write the courses as strings"));
    }
    Ok(PlacedCourses {
        courses: courses_in_bond(file, &count)?,
        ..PlacedCourses::default()
    })
}

/// Courses from strings, the whole list laid `repeat` times.
fn from_strings(
    document: &Document,
    file: &CaseFile,
    span: Range<usize>,
    strings: &[Spanned<String>],
    legend: &Legend,
) -> Result<PlacedCourses, Complaint> {
    no_bond(file)?;
    if strings.is_empty() {
        return Err(
            Complaint::at(span, "a wall without courses", "no course in here")
                .help("write the courses from bottom to top: `courses = [\"h1111h\", \"11111\"]`"),
        );
    }
    let read = |string: &Spanned<String>| {
        let (span, text) = (string.span(), string.get_ref());
        // Where the text begins behind its quotes; unknown if it was written with escapes.
        let begin = document.at(span.clone()).find(text);
        read_course(text, legend).map_err(|(place, title, help)| {
            let inside = match begin {
                Some(quotes) if !place.is_empty() => {
                    let start = span.start + quotes;
                    start + place.start..start + place.end
                }
                _ => span,
            };
            Complaint::at(inside, title, "here").help(help)
        })
    };
    let list: Vec<Vec<Meaning>> = strings.iter().map(read).collect::<Result<_, _>>()?;
    let repeat = file.repeat.as_ref();
    let repeat = repeat.map_or(Ok(1), |repeat| whole("repeat", repeat, MOST_BLOCKS))?;
    let course = |meanings: &Vec<Meaning>| meanings.iter().map(|m| m.piece).collect();
    let courses: Vec<Course> = list.iter().map(course).collect();
    let pieces: usize = courses.iter().map(Vec::len).sum();
    let blocks = blocks_of(&courses);
    let beyond = |count: usize, most: usize| count.saturating_mul(repeat) > most;
    if beyond(blocks, MOST_BLOCKS) || beyond(pieces, MOST_PIECES_OF_ALL) {
        return Err(too_many_courses(file.repeat.place().unwrap_or(span)));
    }
    let meanings = list.iter().flatten();
    let of_blocks = meanings.filter(|meaning| !meaning.piece.is_gap());
    let once: Vec<Option<f64>> = of_blocks.map(|meaning| meaning.weight).collect();
    let weighted = |block: usize| Some((block, once[block % once.len()]?));
    Ok(PlacedCourses {
        weights: (0..blocks * repeat).filter_map(weighted).collect(),
        courses: (0..repeat).flat_map(|_| courses.iter().cloned()).collect(),
        strings: strings.iter().map(Spanned::span).collect(),
    })
}

/// Refuses the keys of a bond beside course strings.
fn no_bond(file: &CaseFile) -> Result<(), Complaint> {
    let Some(key) = file.form_keys().into_iter().find(|key| key.of_bond) else {
        return Ok(());
    };
    let title = format!("`{}` beside course strings", key.name);
    let complaint = Complaint::at(key.span, title, "goes with a number of courses");
    Err(complaint.help(format!(
        "remove `{}`, or write `bond = \"running\"`, `courses = 6`, `units = 5`",
        key.name
    )))
}
