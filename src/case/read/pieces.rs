//! Pieces of any length for course strings, from the legend of a file: lintels, closers, openings.

use std::collections::BTreeMap;

use toml::Spanned;

use super::checks::{Written, positive, within};
use super::file::CaseFile;
use super::values::PieceTable;
use crate::case::complaint::{Complaint, shorten};
use crate::scene::Piece;

/// Lengths of pieces over the unit's length.
const LENGTHS: std::ops::RangeInclusive<f64> = 1e-3..=1e3;

/// The letters that always mean the same.
const FIXED: [(char, Piece); 4] = [
    ('1', Piece::Unit),
    ('h', Piece::Half),
    ('q', Piece::Quarter),
    ('g', Piece::Gap),
];

/// What a letter of a course string stands for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Meaning {
    pub piece: Piece,
    /// The weight of each of them, where it is not the units'.
    pub weight: Option<f64>,
}

/// The letters of course strings.
pub(super) struct Legend(BTreeMap<char, Meaning>);

/// The letters that always mean the same, alone.
impl Default for Legend {
    fn default() -> Self {
        let meaning = |piece| Meaning {
            piece,
            weight: None,
        };
        Self(FIXED.map(|(letter, piece)| (letter, meaning(piece))).into())
    }
}

impl Legend {
    pub fn meaning(&self, letter: char) -> Option<Meaning> {
        self.0.get(&letter).copied()
    }

    /// The letters that a file adds.
    pub fn own(&self) -> impl Iterator<Item = char> {
        let fixed = |letter: &&char| FIXED.iter().any(|(known, _)| known == *letter);
        self.0.keys().filter(move |letter| !fixed(letter)).copied()
    }
}

/// The legend of a file, whose units are so long.
pub(super) fn legend(file: &CaseFile, unit_length: f64) -> Result<Legend, Complaint> {
    let mut legend = Legend::default();
    let pieces = file.pieces.as_ref().map(Spanned::get_ref);
    for (word, table) in pieces.iter().flat_map(|pieces| &pieces.0) {
        let letter = letter(word)?;
        let meaning = meaning(word, table.get_ref(), unit_length)?;
        legend.0.insert(letter, meaning);
    }
    Ok(legend)
}

/// The one letter of a key, which no other piece has.
fn letter(word: &Spanned<String>) -> Result<char, Complaint> {
    let complain = |title: String, help: &str| Err(word.wrong(title, "here").help(help));
    let shown = shorten(word.get_ref(), 60);
    let mut letters = word.get_ref().chars();
    match (letters.next(), letters.next()) {
        (Some(letter), None) if FIXED.iter().any(|&(known, _)| known == letter) => complain(
            format!("the piece `{shown}` has its meaning already"),
            "choose another letter: `1` is a unit, `h` half of one, `q` a quarter, `g` a gap",
        ),
        (Some(letter), None) if letter.is_alphabetic() => Ok(letter),
        _ => complain(
            format!("`{shown}` is no letter for a piece"),
            "write one letter, as in `pieces = { L = { units = 2.5 } }`",
        ),
    }
}

fn meaning(
    word: &Spanned<String>,
    written: &PieceTable,
    unit_length: f64,
) -> Result<Meaning, Complaint> {
    let part = match (&written.units, &written.length) {
        (Some(units), None) => within("units", units, LENGTHS)?,
        (None, Some(length)) => {
            let part = positive("length", length)? / unit_length;
            if !LENGTHS.contains(&part) {
                return Err(length
                    .wrong(format!("a piece of {part:e} units"), "out of range")
                    .help("write a length from a thousandth to a thousand units"));
            }
            part
        }
        (Some(_), Some(length)) => {
            return Err(length
                .wrong("`length` beside `units`", "which of the two?")
                .help("remove one of them"));
        }
        (None, None) => {
            let title = format!("the piece `{}` has no length", word.get_ref());
            return Err(word
                .wrong(title, "neither `units` nor `length`")
                .help("write `{ units = 2.5 }`, in units of the wall, or `{ length = 0.6 }`"));
        }
    };
    let is_gap = written.gap.unwrap_or(false);
    let weight = match &written.weight {
        None => None,
        Some(weight) if is_gap => {
            return Err(weight
                .wrong("the weight of a gap", "there is nothing in it")
                .help("remove the weight, or `gap`"));
        }
        Some(weight) => Some(positive("weight", weight)?),
    };
    let piece = if is_gap {
        Piece::Opening(part)
    } else {
        Piece::Part(part)
    };
    Ok(Meaning { piece, weight })
}
