//! All mistakes of a file at once: where one is found, something sound is put in its place, and the file
//! is read on. What comes of that, and of nothing else that is written, is no mistake of its own.

use std::ops::Range;

use toml::Spanned;
use toml::de::{DeTable, DeValue};

use crate::case::complaint::{Complaint, Document};

/// Mistakes that are told at once.
const MOST: usize = 20;

/// Longest text that is read again and again, in bytes.
const LONGEST: usize = 1 << 20;

/// A text with other words in some places of it.
#[derive(Clone, Default)]
struct Mended(Vec<(Range<usize>, String)>);

impl Mended {
    fn with(&self, place: Range<usize>, words: &str) -> Self {
        let mut all = self.clone();
        let goes = |known: &Range<usize>| {
            !known.is_empty() && place.start <= known.start && known.end <= place.end
        };
        all.0.retain(|(known, _)| !goes(known));
        all.0.push((place, words.to_owned()));
        all.0.sort_by_key(|(place, _)| (place.start, place.end));
        all
    }

    fn document(&self, original: &Document) -> Document {
        let mut text = String::new();
        let mut at = 0;
        for (place, words) in &self.0 {
            text.push_str(original.at(at..place.start));
            text.push_str(words);
            at = place.end;
        }
        text.push_str(original.at(at..original.text.len()));
        Document {
            path: original.path.clone(),
            text: text.into(),
        }
    }

    /// Where a part of the mended text stands in the original; `None` where any of it was mended.
    fn original(&self, part: &Range<usize>) -> Option<Range<usize>> {
        let mut shift = 0_isize;
        for (place, words) in &self.0 {
            let start = place.start.checked_add_signed(shift)?;
            let end = start + words.len();
            if part.start <= end && part.end >= start && !words.ends_with('\n') {
                return None;
            }
            if end <= part.start {
                shift += words.len() as isize - place.len() as isize;
            }
        }
        let moved = |at: usize| at.checked_add_signed(-shift);
        Some(moved(part.start)?..moved(part.end)?)
    }
}

/// The first complaint about a file with all others, in the order of their lines. `read` reads it as
/// another text.
pub(super) fn all_mistakes(
    document: &Document,
    first: Complaint,
    read: impl Fn(&Document) -> Option<Complaint>,
) -> Complaint {
    let mut found = vec![first];
    let mut mended = Mended::default();
    while found.len() < MOST && document.text.len() <= LONGEST {
        let last = &found[found.len() - 1];
        let further = ways(document, &mended, last).into_iter().find_map(|way| {
            let next = read(&way.document(document));
            match next {
                None => Some((way, None)),
                Some(next) => {
                    let place = match next.mend() {
                        // A key that is missing: the first line stands for the file.
                        Some((Range { end: 0, .. }, _)) => 0..document.text.len(),
                        _ => way.original(&next.place_in(&way.document(document))?)?,
                    };
                    let next = next.moved_to(document, place);
                    let own = next.mend().is_some() && !follows(&next, &found, &way, document);
                    own.then_some((way, Some(next)))
                }
            }
        });
        let Some((way, Some(next))) = further else {
            break;
        };
        mended = way;
        found.push(next);
    }
    found.sort_by_key(|complaint| match complaint.mend() {
        // What is missing stands behind what is there.
        Some((Range { end: 0, .. }, _)) => usize::MAX,
        _ => complaint.place_in(document).map_or(0, |place| place.start),
    });
    let first = found.remove(0);
    first.with_others(found)
}

/// Whether a complaint is known, or a key is missing that was taken out, or that another one names.
fn follows(next: &Complaint, found: &[Complaint], way: &Mended, document: &Document) -> bool {
    let Some(key) = next.title().strip_prefix("missing key `") else {
        return found.iter().any(|known| known == next);
    };
    let key = key.trim_end_matches('`');
    let named = format!("`{key}");
    let taken = |(place, _): &(Range<usize>, _)| document.at(place.clone()).starts_with(key);
    found.iter().any(|known| known.advice().contains(&named)) || way.0.iter().any(taken)
}

/// Texts in which a complaint's place is mended: as it says itself, and without the key.
fn ways(document: &Document, mended: &Mended, complaint: &Complaint) -> Vec<Mended> {
    let Some((place, words)) = complaint.mend() else {
        return Vec::new();
    };
    if words.is_empty() && complaint.title().starts_with("missing key") {
        return Vec::new();
    }
    let put = mended.with(place.clone(), words);
    let (table, _) = DeTable::parse_recoverable(&document.text);
    let without = entry(table.get_ref(), place.start).map(|(key, value)| {
        let key = key.start..value.end.max(key.end);
        mended.with(with_its_table(&document.text, key), "")
    });
    [Some(put), without].into_iter().flatten().collect()
}

/// The innermost key and value that byte `at` is in.
fn entry(table: &DeTable, at: usize) -> Option<(Range<usize>, Range<usize>)> {
    table.iter().find_map(|(key, value)| {
        let (name, place) = (key.span(), value.span());
        let here = name.contains(&at) || place.contains(&at);
        inside(value, at).or(here.then_some((name, place)))
    })
}

fn inside(value: &Spanned<DeValue>, at: usize) -> Option<(Range<usize>, Range<usize>)> {
    match value.get_ref() {
        DeValue::Table(table) => entry(table, at),
        DeValue::Array(items) => items.iter().find_map(|item| inside(item, at)),
        _ => None,
    }
}

/// A key and its value with the comma behind it; of a table that begins with `[`, all that is in it.
fn with_its_table(text: &str, entry: Range<usize>) -> Range<usize> {
    let line = text[..entry.start].rfind('\n').map_or(0, |end| end + 1);
    if text[line..].trim_start().starts_with('[') && !text[line..entry.start].contains(['=', '{']) {
        let next = text[entry.end..].find("\n[");
        return line..next.map_or(text.len(), |next| entry.end + next + 1);
    }
    let behind = &text[entry.end..];
    let comma = behind.trim_start().starts_with(',');
    let comma = if comma {
        behind.find(',').map_or(0, |at| at + 1)
    } else {
        0
    };
    entry.start..entry.end + comma
}
