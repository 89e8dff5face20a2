//! A coursed wall from a file, laid once with head joints in contact and once with open ones.

use std::collections::BTreeSet;

use toml::Spanned;

use super::checks::{HEAD_JOINTS, Written, not_negative, positive, positive_or_one, whole};
use super::courses::{PlacedCourses, courses};
use super::file::{BodyTable, CaseFile, UnitTable};
use super::friction::friction;
use super::missing::missing_key;
use super::own_blocks::own_blocks;
use super::pieces::legend;
use super::values::{CoursesValue, Number};
use crate::case::complaint::{Complaint, Document};
use crate::number::short;
use crate::scene::{Course, HeadJoints, Own, Push, Wall, WallError};
use crate::text::counted;

/// Units longer or higher than this times the other side would fall under the joint search's
/// tolerance.
const MOST_SLENDER: f64 = 1000.0;

pub(super) fn wall(
    document: &Document,
    file: &CaseFile,
    warnings: &mut Vec<Complaint>,
) -> Result<Wall, Complaint> {
    let unit = file
        .unit
        .as_ref()
        .ok_or_else(|| missing_key(0..0, "unit"))?;
    let list = file.courses.as_ref();
    let list = list.ok_or_else(|| missing_key(0..0, "courses"))?;
    let unit_length = positive("length", &unit.get_ref().length)?;
    let legend = legend(file, unit_length)?;
    let laid = courses(document, file, list, &legend)?;
    let mut wall = sized(file, unit, laid.courses.clone())?;
    not_too_slender(unit.get_ref(), &wall)?;
    wall.own.heights = heights(file, &laid, &wall)?;
    for head_joints in HEAD_JOINTS {
        wall.scene(head_joints)
            .map_err(|error| not_laid(unit, list, &laid, &error))?;
    }
    warnings.extend(one_of_another_length(&laid, &wall));
    own_blocks(file, &mut wall, laid.weights)?;
    wall.own.open = open_head_joints(file, wall.courses.len())?;
    Ok(wall)
}

/// The height of every course, from one for each course string or one for each course; none where all
/// are as high as a unit.
fn heights(file: &CaseFile, laid: &PlacedCourses, wall: &Wall) -> Result<Vec<f64>, Complaint> {
    let Some(list) = &file.heights else {
        return Ok(Vec::new());
    };
    let (strings, courses) = (laid.strings.len(), wall.courses.len());
    let given = list.get_ref().len();
    if given != courses && (given != strings || given == 0) {
        let title = format!(
            "{} for {}",
            counted(given, "height"),
            counted(courses, "course")
        );
        let complaint = list.wrong(title, "here");
        return Err(complaint.help(match strings {
            0 => "write a height for every course, from bottom to top",
            _ => "write a height for every string of `courses`, or one for every course with all repeats",
        }));
    }
    let height = |value: &Spanned<Number>| {
        let height = positive("height", value)?;
        let ratio = wall.unit_length / height;
        if !(1.0 / MOST_SLENDER..=MOST_SLENDER).contains(&ratio) {
            return Err(too_slender(value, ratio));
        }
        Ok(height)
    };
    let once: Vec<f64> = list
        .get_ref()
        .iter()
        .map(height)
        .collect::<Result<_, _>>()?;
    let heights = once.iter().copied().cycle().take(courses);
    Ok(
        match once.iter().all(|&height| height == wall.unit_height) {
            true => Vec::new(),
            false => heights.collect(),
        },
    )
}

/// The courses whose head joints are open while those of others are not.
fn open_head_joints(file: &CaseFile, courses: usize) -> Result<BTreeSet<usize>, Complaint> {
    let Some(list) = &file.open_head_joints else {
        return Ok(BTreeSet::new());
    };
    let word = file
        .head_joints
        .as_ref()
        .map(|word| word.get_ref().as_str());
    if word == Some(HeadJoints::Open.name()) {
        let complaint = list.wrong("all head joints are open already", "these among them");
        return Err(
            complaint.help("remove it, or write `head_joints = \"contact\"` for the others")
        );
    }
    let course = |value| whole("open_head_joints", value, courses);
    list.get_ref().iter().map(course).collect()
}

/// A warning where one course string is longer or shorter than all others, which are alike: a piece
/// that was forgotten. Walls that step back or out have more than one such course.
fn one_of_another_length(laid: &PlacedCourses, wall: &Wall) -> Option<Complaint> {
    let strings = laid.strings.len();
    let lengths = wall.courses[..strings].iter();
    let lengths: Vec<f64> = lengths.map(|course| wall.course_width(course)).collect();
    let alike = |a: f64, b: f64| (a - b).abs() < 1e-6 * wall.unit_length;
    // Of three strings and more, one of the first two has the length of the others.
    let common = *lengths.iter().take(2).find(|&&length| {
        let others = lengths.iter().filter(|&&other| alike(length, other));
        strings > 2 && others.count() == strings - 1
    })?;
    let odd = lengths.iter().position(|&length| !alike(length, common))?;
    let [odd_units, units] = [lengths[odd], common].map(|l| short(l / wall.unit_length, 3));
    let course = odd + 1;
    let title = format!("course {course} is {odd_units} units long, and all others are {units}");
    let place = laid.course_place(course)?;
    let warning = Complaint::at(place, title, "a piece too many or too few?");
    let help = "count the pieces; a gap at the end, `g`, says that nothing is there on purpose";
    Some(warning.help(help).into_warning())
}

fn sized(
    file: &CaseFile,
    table: &Spanned<UnitTable>,
    courses: Vec<Course>,
) -> Result<Wall, Complaint> {
    let (unit, overburden) = (table.get_ref(), file.overburden.as_ref());
    Ok(Wall {
        unit_length: positive("length", &unit.length)?,
        unit_height: positive("height", &unit.height)?,
        thickness: positive_or_one("thickness", unit.thickness.as_ref())?,
        unit_weight: unit_weight(file, table)?,
        courses,
        friction: friction(file)?,
        overburden: overburden.map_or(Ok(0.0), |value| not_negative("overburden", value))?,
        push: Push::Right,
        own: Own::default(),
    })
}

/// The weight of a unit. Where none is written, it is the unit of force: then nothing else may be a force
/// of its own.
fn unit_weight(file: &CaseFile, unit: &Spanned<UnitTable>) -> Result<f64, Complaint> {
    if let Some(weight) = &unit.get_ref().weight {
        return positive("weight", weight);
    }
    let pieces = file.pieces.as_ref().map(Spanned::get_ref);
    let mut pieces = pieces.iter().flat_map(|pieces| &pieces.0);
    let weighs = |block: &BodyTable| block.weight.is_some() || block.specific_weight.is_some();
    let beside = [
        (
            pieces.any(|(_, piece)| piece.get_ref().weight.is_some()),
            "the weight of a piece",
        ),
        (
            file.block.iter().any(|block| weighs(block.get_ref())),
            "the weight of a block",
        ),
        (!file.load.is_empty(), "a load"),
        (!file.moves.is_empty(), "the reaction of a support"),
    ];
    match beside.into_iter().find(|(is_there, _)| *is_there) {
        None => Ok(1.0),
        Some((_, what)) => Err(missing_key(unit.span(), "weight").help(format!(
            "add `weight = 1.0`, that of one unit: {what} is written in the same unit of force"
        ))),
    }
}

fn not_too_slender(unit: &UnitTable, wall: &Wall) -> Result<(), Complaint> {
    let ratio = wall.unit_length / wall.unit_height;
    let longer = match ratio {
        ratio if ratio > MOST_SLENDER => &unit.length,
        ratio if ratio < 1.0 / MOST_SLENDER => &unit.height,
        _ => return Ok(()),
    };
    Err(too_slender(longer, ratio))
}

fn too_slender(value: &Spanned<Number>, ratio: f64) -> Complaint {
    let title =
        format!("a unit more than {MOST_SLENDER} times longer or higher than the other way");
    let complaint = value.wrong(title, format!("length / height is {ratio:e}"));
    complaint.help("check that length and height are in one and the same unit of length")
}

/// What is wrong with a wall that cannot be laid, at its course, its unit or its list of courses.
fn not_laid(
    unit: &Spanned<UnitTable>,
    list: &Spanned<CoursesValue>,
    laid: &PlacedCourses,
    error: &WallError,
) -> Complaint {
    let here = "here".to_owned();
    let (span, label, help) = match error {
        WallError::Heights { .. } => (list.span(), here, "write a height for every course"),
        WallError::NoCourses => (list.span(), here, "write at least one course"),
        WallError::EmptyCourse { course } => (
            laid.course_place(*course).unwrap_or(list.span()),
            laid.label(*course),
            "put a unit `1` or half a unit `h` into the course; `g` is a gap",
        ),
        WallError::Shape(_) => (unit.span(), here, "check length and height of the unit"),
        WallError::Scene(_) => (list.span(), here, "check weight, friction and overburden"),
    };
    Complaint::at(span, error.to_string(), label).help(help)
}
