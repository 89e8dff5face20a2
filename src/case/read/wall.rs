//! A coursed wall from a file, laid once with head joints in contact and once with open ones.

use std::ops::Range;

use toml::Spanned;

use super::checks::{HEAD_JOINTS, not_negative, positive};
use super::courses::{PlacedCourses, courses};
use super::explain::missing_key;
use super::file::{CaseFile, UnitTable};
use super::friction::friction;
use super::own_blocks::own_blocks;
use super::pieces::legend;
use crate::case::complaint::{Complaint, Document};
use crate::number::short;
use crate::scene::{Course, OfBlocks, Push, Wall, WallError};

/// Units longer or higher than this times the other side would fall under the joint search's
/// tolerance.
const MOST_SLENDER: f64 = 1000.0;

/// The wall of a file.
pub(super) fn wall(
    document: &Document,
    file: &CaseFile,
    warnings: &mut Vec<Complaint>,
) -> Result<Wall, Complaint> {
    let Some(unit) = &file.unit else {
        return Err(missing_key(document, 0..0, "unit"));
    };
    let Some(list) = &file.courses else {
        return Err(missing_key(document, 0..0, "courses"));
    };
    let unit_length = positive(document, "length", &unit.get_ref().length)?;
    let legend = legend(document, file, unit_length)?;
    let laid = courses(document, file, list, &legend)?;
    let mut wall = sized(document, file, unit.get_ref(), laid.courses.clone())?;
    not_too_slender(document, unit, &wall)?;
    for head_joints in HEAD_JOINTS {
        wall.scene(head_joints).map_err(|error| {
            let (place, label, help) = not_laid(&laid, &error);
            let place = match error {
                WallError::Shape(_) => unit.span(),
                _ => place.unwrap_or(list.span()),
            };
            document
                .complain(place, error.to_string(), label)
                .help(help)
        })?;
    }
    warnings.extend(one_of_another_length(document, &laid, &wall));
    own_blocks(document, file, &mut wall, laid.weights)?;
    Ok(wall)
}

/// A warning where one course string is longer or shorter than all others, which are alike: a piece
/// that was forgotten. Walls that step back or out have more than one such course.
fn one_of_another_length(
    document: &Document,
    laid: &PlacedCourses,
    wall: &Wall,
) -> Option<Complaint> {
    let strings = laid.strings().len();
    let lengths = wall.courses[..strings].iter();
    let lengths: Vec<f64> = lengths.map(|course| wall.course_width(course)).collect();
    let alike = |a: f64, b: f64| (a - b).abs() < 1e-6 * wall.unit_length;
    // Of three strings and more, one of the first two has the length of the others.
    let common = *lengths.iter().take(2).find(|&&length| {
        let others = lengths.iter().filter(|&&other| alike(length, other));
        strings > 2 && others.count() == strings - 1
    })?;
    let odd = lengths.iter().position(|&length| !alike(length, common))?;
    let units = |length: f64| short(length / wall.unit_length, 3);
    let title = format!(
        "course {} is {} units long, and all others are {}",
        odd + 1,
        units(lengths[odd]),
        units(common)
    );
    let place = laid.course_place(odd + 1)?;
    let warning = document.complain(place, title, "a piece too many or too few?");
    let help = "count the pieces; a gap at the end, `g`, says that nothing is there on purpose";
    Some(warning.help(help).into_warning())
}

fn sized(
    document: &Document,
    file: &CaseFile,
    unit: &UnitTable,
    courses: Vec<Course>,
) -> Result<Wall, Complaint> {
    Ok(Wall {
        unit_length: positive(document, "length", &unit.length)?,
        unit_height: positive(document, "height", &unit.height)?,
        thickness: match &unit.thickness {
            None => 1.0,
            Some(value) => positive(document, "thickness", value)?,
        },
        unit_weight: positive(document, "weight", &unit.weight)?,
        courses,
        friction: friction(document, file)?,
        overburden: match &file.overburden {
            None => 0.0,
            Some(value) => not_negative(document, "overburden", value)?,
        },
        push: Push::Right,
        of_blocks: OfBlocks::default(),
    })
}

fn not_too_slender(
    document: &Document,
    unit: &Spanned<UnitTable>,
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

/// The course, or the piece of it, that cannot be laid, with its label and the help.
fn not_laid(
    laid: &PlacedCourses,
    error: &WallError,
) -> (Option<Range<usize>>, String, &'static str) {
    let (place, help) = match error {
        WallError::NoCourses => (None, "write at least one course"),
        WallError::EmptyCourse { course } => (
            laid.course_place(*course),
            "put a unit `1` or half a unit `h` into the course; `g` is a gap",
        ),
        WallError::Shape(_) => (None, "check length and height of the unit"),
        WallError::Scene(_) => (None, "check weight, friction and overburden"),
    };
    let label = match error {
        WallError::EmptyCourse { course } => laid.label(*course),
        WallError::NoCourses | WallError::Shape(_) | WallError::Scene(_) => "here".into(),
    };
    (place, label, help)
}
