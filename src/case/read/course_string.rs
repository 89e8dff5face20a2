//! Courses as people write them: `h` half a unit, `q` a quarter, `1` a unit, `g` a gap, `1*24` twenty-four units.

use std::ops::Range;

use super::checks::MOST_BLOCKS;
use super::pieces::{Legend, Meaning};
use crate::case::complaint::Complaint;
use crate::scene::Course;

pub(super) const MOST_PIECES: usize = 10_000;

/// What is wrong with a course string: the offending part of it (bytes; all of it where that is
/// empty), the title, and what to write instead.
type CourseError = (Range<usize>, String, String);

/// The pieces, for help lines.
fn pieces(legend: &Legend) -> String {
    let own: Vec<String> = legend.own().map(|letter| format!("`{letter}`")).collect();
    let own = match own.as_slice() {
        [] => "; other lengths have a letter in `pieces`".to_owned(),
        own => format!(", or {}", own.join(", ")),
    };
    format!(
        "write `1` for a unit, `h` for half a unit, `q` for a quarter and `g` for a gap one unit \
         wide{own}"
    )
}

/// Reads a course string: its pieces from left to right.
pub(super) fn read_course(text: &str, legend: &Legend) -> Result<Vec<Meaning>, CourseError> {
    let mut course = Vec::new();
    let mut at = 0;
    while let Some(letter) = text[at..].chars().next() {
        let start = at;
        at += letter.len_utf8();
        if letter == ' ' {
            continue;
        }
        let meaning = legend.meaning(letter);
        let piece = meaning.ok_or_else(|| unknown(letter, start, legend))?;
        let mut count = 1;
        if text[at..].starts_with('*') {
            (count, at) = read_count(text, at)?;
        }
        if course.len() + count > MOST_PIECES {
            let title = format!("a course of more than {MOST_PIECES} pieces");
            let help = format!("keep a course to {MOST_PIECES} pieces");
            return Err((start..at, title, help));
        }
        course.extend((0..count).map(|_| piece));
    }
    if course.is_empty() {
        let title = "a course without pieces".to_owned();
        return Err((0..text.len(), title, pieces(legend)));
    }
    Ok(course)
}

fn unknown(letter: char, start: usize, legend: &Legend) -> CourseError {
    let help = match letter {
        '*' => "write the piece, then `*`, then the count, without spaces: `1*24`".into(),
        '0' | '2'..='9' => format!(
            "{}; a count stands behind a `*`, as in `1*24`",
            pieces(legend)
        ),
        '\t' | '\n' | '\r' => "part pieces with spaces, or with nothing".into(),
        'H' | 'Q' | 'G' => format!("write a small letter: `{}`", letter.to_ascii_lowercase()),
        _ => pieces(legend),
    };
    let title = format!("unknown piece `{}` in a course", letter.escape_debug());
    (start..start + letter.len_utf8(), title, help)
}

/// Reads `*24` at byte `star`: the count, and where the text goes on.
fn read_count(text: &str, star: usize) -> Result<(usize, usize), CourseError> {
    let from = star + 1;
    let after = text[from..].trim_start_matches(|c: char| c.is_ascii_digit());
    let end = text.len() - after.len();
    let complain = |title: &str, help: String| Err((from..end, title.to_owned(), help));
    match text[from..end].parse() {
        Ok(0) => complain(
            "a count of zero",
            "write a count of 1 or more, or leave the piece out".into(),
        ),
        Ok(count) if count <= MOST_PIECES => Ok((count, end)),
        _ if from == end => Err((
            star..end,
            "a `*` without a count".into(),
            "write a whole number right behind the `*`, as in `1*24`".into(),
        )),
        _ => complain(
            "an absurd count",
            format!("write a count up to {MOST_PIECES}"),
        ),
    }
}

/// A complaint about more courses than a wall can have.
pub(super) fn too_many_courses(span: Range<usize>) -> Complaint {
    let title = format!("a wall of more than {MOST_BLOCKS} blocks");
    Complaint::at(span, title, "too many courses").help("write fewer or shorter courses")
}

pub(super) fn blocks_of(courses: &[Course]) -> usize {
    let pieces = courses.iter().flatten();
    pieces.filter(|piece| !piece.is_gap()).count()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::Piece::{Gap, Half, Unit};

    #[test]
    fn pieces_counts_and_spaces() {
        let course = read_course("h 1*3g  1*1h", &Legend::default()).unwrap();
        let course: Vec<_> = course.iter().map(|meaning| meaning.piece).collect();
        assert_eq!(course, [Half, Unit, Unit, Unit, Gap, Unit, Half]);
    }

    #[test]
    fn mistakes_are_placed_in_the_string() {
        let place = |text: &str| read_course(text, &Legend::default()).unwrap_err().0;
        assert_eq!(place("h1x1h"), 2..3);
        assert_eq!(place("h1*0h"), 3..4);
        assert_eq!(place("1*"), 1..2);
        assert_eq!(place("*3"), 0..1);
        assert_eq!(place("1 *3"), 2..3);
        assert_eq!(place("1*99999999999999999999999"), 2..25);
        assert_eq!(place("1*10000 1"), 8..9);
        assert_eq!(place("1é"), 1..3);
        assert_eq!(place("  "), 0..2);
    }
}
