//! Courses of a bond, from its keys in a file.

use toml::Spanned;

use super::checks::{MOST_BLOCKS, blocks_of, choose, too_many_courses, whole, within};
use super::course_string::MOST_PIECES;
use super::file::CaseFile;
use super::values::WholeNumber;
use crate::case::complaint::{Complaint, Document};
use crate::scene::{BONDS, Bond, Course};

/// Smallest lap of a bond, over the unit's length: less is no bond.
const LEAST_OVERLAP: f64 = 0.01;

/// The courses of the bond of a file, `count` of them.
pub(super) fn courses_in_bond(
    document: &Document,
    file: &CaseFile,
    count: &Spanned<WholeNumber>,
) -> Result<Vec<Course>, Complaint> {
    let Some(word) = &file.bond else {
        return Err(document
            .complain(
                count.span(),
                "a number of courses without a bond",
                "which pattern?",
            )
            .help("add `bond = \"running\"` and `units = 5`, or write the courses as strings"));
    };
    let bonds = BONDS.iter().map(|bond| (bond.name, bond));
    let bond = choose(document, "bond", bonds, word)?;
    let overlap = overlap(document, file, bond)?;
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
            .complain(word.span(), "a bond without `units`", "how wide?")
            .help("add the width of the wall in full units: `units = 5`"));
    };
    let cut_first = cut_first(document, file, bond)?;
    let wide = whole(document, "units", units, MOST_PIECES / 2 - 1)?;
    let high = whole(document, "courses", count, MOST_BLOCKS)?;
    let lay = |courses: usize| {
        bond.lay(courses, wide, cut_first, overlap)
            .map_err(|error| {
                let complaint =
                    document.complain(units.span(), error.to_string(), "does not close");
                complaint.help(format!(
                    "the nearest width that does is `units = {}`",
                    error.nearest
                ))
            })
    };
    // Courses take turns, so two of them tell how many blocks all have.
    let pair = lay(2)?;
    let [lower, upper] = [0, 1].map(|course| blocks_of(&pair[course..=course]));
    let blocks = lower.saturating_mul(high.div_ceil(2)) + upper.saturating_mul(high / 2);
    if blocks > MOST_BLOCKS {
        return Err(too_many_courses(document, count.span()));
    }
    lay(high)
}

/// The overlap that a file asks for.
fn overlap(document: &Document, file: &CaseFile, bond: &Bond) -> Result<Option<f64>, Complaint> {
    let Some(overlap) = &file.overlap else {
        return Ok(None);
    };
    if !bond.has_overlap() {
        let title = format!("`overlap` beside {} bond", bond.name);
        let with_overlap = BONDS.iter().filter(|bond| bond.has_overlap());
        let names: Vec<&str> = with_overlap.map(|bond| bond.name).collect();
        let label = format!("for {} bond only", names.join(" and "));
        return Err(document
            .complain(overlap.span(), title, label)
            .help("remove `overlap`: the bond says it"));
    }
    within(document, "overlap", overlap, LEAST_OVERLAP..=0.5).map(Some)
}

/// Whether the lowest course is the one with cut ends.
fn cut_first(document: &Document, file: &CaseFile, bond: &Bond) -> Result<bool, Complaint> {
    match (&bond.lowest, &file.first) {
        (None, None) => Ok(false),
        (Some(lowest), None) => Ok(lowest.cut_unless_said),
        (Some(lowest), Some(word)) => {
            let words = [(lowest.cut, true), (lowest.whole, false)];
            choose(document, "first", words, word)
        }
        (None, Some(word)) => {
            let title = format!("`first` beside a {} bond", bond.name);
            Err(document
                .complain(word.span(), title, "for other bonds only")
                .help(format!(
                    "remove `first`: all courses of a {} bond are alike",
                    bond.name
                )))
        }
    }
}
