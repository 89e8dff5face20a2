//! What a row says of the values that it is compared with.

use super::row::Row;
use crate::case::{Quantity, Reference, SourceKind};
use crate::judge::{Verdict, compare};
use crate::number::short;

/// One end of what the multiplier is compared with; there is a second where the ends of a range have
/// values of their own.
pub(super) fn reference_end(row: &Row, end: usize) -> Option<f64> {
    let references = row.multiplier_references();
    references.get(end).map(|reference| reference.value)
}

/// The value of a reference and what is behind it: p published, a analytic, i independent code.
pub(super) fn with_letter(reference: &Reference) -> String {
    let letter = match reference.kind {
        SourceKind::Published => 'p',
        SourceKind::Analytic => 'a',
        SourceKind::Independent => 'i',
    };
    format!("{} {letter}", short(reference.value, 6))
}

pub(super) fn multiplier_reference(row: &Row) -> Option<String> {
    Some(match row.multiplier_references().as_slice() {
        [] => return None,
        [one] => with_letter(one),
        [low, high, ..] => format!("{} - {}", short(low.value, 6), with_letter(high)),
    })
}

/// The verdict in words: where it is about another value than the one whose error stands beside it,
/// about which.
pub(super) fn verdict_words(row: &Row) -> Option<String> {
    let verdict = row.verdict?;
    let shown = row.multiplier_references();
    let computed = row.computed();
    let unit = row.multiplier_unit;
    let of_verdict = |r: &&Reference| compare(r, &computed, unit).verdict == verdict;
    let about = row.references.iter().find(of_verdict);
    let about = about.filter(|about| {
        verdict == Verdict::Deviates
            && !shown
                .iter()
                .any(|shown| of_verdict(shown) || shown == about)
    });
    Some(match about {
        Some(about) if about.quantity == Quantity::Lambda => {
            format!("{} from {}", verdict.name(), with_letter(about))
        }
        Some(about) => format!("{} in {}", verdict.name(), about.quantity.words()),
        None => verdict.name().to_owned(),
    })
}
