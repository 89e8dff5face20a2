//! Courses of a bond, from its keys in a file.

use toml::Spanned;

use super::checks::{MOST_BLOCKS, Written, choose, whole, within};
use super::course_string::{MOST_PIECES, blocks_of, too_many_courses};
use super::file::CaseFile;
use super::values::WholeNumber;
use crate::case::complaint::Complaint;
use crate::scene::{BONDS, Bond, Course};

/// Smallest lap of a bond, over the unit's length: less is no bond.
const LEAST_OVERLAP: f64 = 0.01;

/// The courses of the bond of a file, `count` of them.
pub(super) fn courses_in_bond(
    file: &CaseFile,
    count: &Spanned<WholeNumber>,
) -> Result<Vec<Course>, Complaint> {
    let Some(word) = &file.bond else {
        return Err(count
            .wrong("a number of courses without a bond", "which pattern?")
            .help("add `bond = \"running\"` and `units = 5`, or write the courses as strings"));
    };
    let bonds = BONDS.iter().map(|bond| (bond.name, bond));
    let bond = choose("bond", bonds, word)?;
    let overlap = overlap(file, bond)?;
    if let Some(repeat) = &file.repeat {
        return Err(repeat
            .wrong("`repeat` beside a bond", "repeats course strings only")
            .help("remove `repeat` and write the number of all courses in `courses`"));
    }
    let Some(units) = &file.units else {
        return Err(word
            .wrong("a bond without `units`", "how wide?")
            .help("add the width of the wall in full units: `units = 5`"));
    };
    let cut_first = cut_first(file, bond)?;
    let wide = whole("units", units, MOST_PIECES / 2 - 1)?;
    let high = whole("courses", count, MOST_BLOCKS)?;
    let lay = |courses: usize| {
        let laid = bond.lay(courses, wide, cut_first, overlap);
        laid.map_err(|nearest| {
            let title = format!(
                "{} bond does not close at a width of {wide} units",
                bond.name
            );
            let complaint = units.wrong(title, "does not close");
            complaint.help(format!(
                "the nearest width that does is `units = {nearest}`"
            ))
        })
    };
    // Courses take turns, so two of them tell how many blocks all have.
    let pair = lay(2)?;
    let [lower, upper] = [0, 1].map(|course| blocks_of(&pair[course..=course]));
    let blocks = lower.saturating_mul(high.div_ceil(2)) + upper.saturating_mul(high / 2);
    if blocks > MOST_BLOCKS {
        return Err(too_many_courses(count.span()));
    }
    lay(high)
}

fn overlap(file: &CaseFile, bond: &Bond) -> Result<Option<f64>, Complaint> {
    let Some(overlap) = &file.overlap else {
        return Ok(None);
    };
    if !bond.has_overlap() {
        let with_overlap = BONDS.iter().filter(|bond| bond.has_overlap());
        let names: Vec<&str> = with_overlap.map(|bond| bond.name).collect();
        let title = format!("`overlap` beside {} bond", bond.name);
        let complaint = overlap.wrong(title, format!("for {} bond only", names.join(" and ")));
        return Err(complaint.help("remove `overlap`: the bond says it"));
    }
    within("overlap", overlap, LEAST_OVERLAP..=0.5).map(Some)
}

/// Whether the lowest course is the one with cut ends.
fn cut_first(file: &CaseFile, bond: &Bond) -> Result<bool, Complaint> {
    match (&bond.lowest, &file.first) {
        (None, None) => Ok(false),
        (Some(lowest), None) => Ok(lowest.cut_unless_said),
        (Some(lowest), Some(word)) => {
            let words = [(lowest.cut, true), (lowest.whole, false)];
            choose("first", words, word)
        }
        (None, Some(word)) => {
            let name = bond.name;
            let title = format!("`first` beside a {name} bond");
            let complaint = word.wrong(title, "for other bonds only");
            Err(complaint.help(format!(
                "remove `first`: all courses of a {name} bond are alike"
            )))
        }
    }
}
