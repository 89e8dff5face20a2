//! The walls of a sweep: a case with some keys of its file replaced, for every combination.

use std::cell::RefCell;
use std::ops;
use std::sync::Arc;

use rayon::prelude::*;
use toml::{Spanned, Table};

use super::file::File;
use super::replace::{Rank, replace};
use super::values::{Placed, text, values};
use crate::case::{Case, Complaint, Document, UnreadCase};
use crate::method::Settings;

/// Most combinations of one sweep.
const MOST_VARIANTS: usize = 1_000_000;

/// A case file before anything is replaced in it.
pub(super) struct Base {
    /// The file, which says what lies beside it.
    pub found: UnreadCase,
    /// What is in it, without title, source and references: those are about another wall as soon as
    /// a value differs.
    pub table: Table,
    /// Where it is written, if that is in the sweep.
    pub span: Option<ops::Range<usize>>,
}

impl Base {
    /// Reads the text of a case, which has to be a sound one by itself.
    pub fn read(found: UnreadCase) -> Result<Self, Complaint> {
        found.read()?;
        let text = String::from_utf8_lossy(&found.bytes);
        let table = toml::from_str(&text).map_err(|e| Complaint::new(e.to_string()))?;
        Ok(Self::new(found, table, None))
    }

    /// The case of this table, which is written at `span` of the sweep.
    pub fn new(found: UnreadCase, mut table: Table, span: Option<ops::Range<usize>>) -> Self {
        for key in ["title", "source", "references"] {
            table.remove(key);
        }
        Self { found, table, span }
    }

    /// The case of another table, and the texts that determine it: its own and what it names.
    fn with(&self, text: String) -> (Result<Case, Complaint>, Vec<String>) {
        let beside: RefCell<Vec<String>> = RefCell::default();
        let read = |name: &str| {
            let bytes = self.found.read_file(name)?;
            let text = String::from_utf8_lossy(&bytes).into_owned();
            beside.borrow_mut().push(text);
            Ok(bytes)
        };
        let case = Case::read_with(&self.found.path, text.as_bytes(), &read);
        let mut texts = beside.into_inner();
        texts.insert(0, text);
        (case, texts)
    }
}

/// Keys that vary together: one table `[[vary]]`.
pub(super) struct Axis<'a> {
    pub keys: Vec<Key<'a>>,
    pub length: usize,
}

/// A key with all its values.
pub(super) struct Key<'a> {
    pub name: &'a str,
    span: ops::Range<usize>,
    values: Vec<Placed>,
}

/// The tables `[[vary]]` of a file, their keys in the order they are written in.
pub(super) fn axes<'a>(document: &Document, file: &'a File) -> Result<Vec<Axis<'a>>, Complaint> {
    let mut axes: Vec<Axis> = Vec::new();
    for table in &file.vary {
        let mut keys = Vec::new();
        for (key, written) in table {
            keys.push(Key {
                name: key.get_ref(),
                span: key.span(),
                values: values(document, key.get_ref(), written)?,
            });
        }
        keys.sort_by_key(|key| key.span.start);
        let Some(first) = keys.first() else {
            continue;
        };
        let length = first.values.len();
        if let Some(other) = keys.iter().find(|key| key.values.len() != length) {
            let title = format!(
                "`{}` has {} values and `{}` has {length}",
                other.name,
                other.values.len(),
                first.name
            );
            return Err(document
                .complain(other.span.clone(), title, "these vary together")
                .help("write as many values for each, or put `[[vary]]` between the two"));
        }
        let known = axes.iter().flat_map(|axis| &axis.keys);
        if let Some(twice) = keys
            .iter()
            .find(|key| known.clone().any(|k| k.name == key.name))
        {
            let title = format!("`{}` varies twice", twice.name);
            return Err(document
                .complain(twice.span.clone(), title, "the second time here")
                .help("remove one of the two"));
        }
        axes.push(Axis { keys, length });
    }
    let count = axes
        .iter()
        .try_fold(1_usize, |all, axis| all.checked_mul(axis.length));
    if count.is_none_or(|count| count > MOST_VARIANTS) {
        let title = format!("a sweep of more than {MOST_VARIANTS} walls");
        let span = axes.last().map_or(0..0, |axis| axis.keys[0].span.clone());
        return Err(document
            .complain(span, title, "the last factor")
            .help("write fewer values, or more than one sweep"));
    }
    Ok(axes)
}

/// One wall of the sweep.
pub(super) struct Variant {
    pub case: Arc<Case>,
    /// Number of blocks with head joints in contact.
    pub blocks: usize,
    /// Text of the case and of the files that it names.
    pub determined_by: Vec<String>,
    pub parameters: Vec<(String, String)>,
    pub settings: Settings,
    /// Index of the value on every axis.
    pub place: Vec<usize>,
}

/// Every combination: cases slowest, then the axes in their order.
pub(super) fn variants(
    document: &Document,
    bases: &[Base],
    axes: &[Axis],
    settings: Settings,
) -> Result<Vec<Variant>, Complaint> {
    let count: usize = axes.iter().map(|axis| axis.length).product();
    let place = |mut index: usize| {
        let mut place = vec![0; axes.len()];
        for (at, axis) in place.iter_mut().zip(axes).rev() {
            *at = index % axis.length;
            index /= axis.length;
        }
        place
    };
    let read = (0..bases.len() * count).into_par_iter().map(|index| {
        let replaced = Replaced::new(axes, place(index % count));
        replaced.variant(document, &bases[index / count], settings)
    });
    // Of several complaints always the first, whichever core is faster.
    read.collect::<Vec<_>>().into_iter().collect()
}

/// What can vary, for help lines.
const VARIES: &str = "vary a key of the case, such as `overburden` or `\"unit.length\"`, a setting \
                      such as `\"settings.starts\"`, `aspect` or `refine`";

/// The values that one combination puts into the case.
struct Replaced<'a> {
    values: Vec<(&'a str, &'a Placed)>,
    place: Vec<usize>,
}

impl<'a> Replaced<'a> {
    fn new(axes: &'a [Axis], place: Vec<usize>) -> Self {
        let mut values = Vec::new();
        for (axis, &at) in axes.iter().zip(&place) {
            values.extend(axis.keys.iter().map(|key| (key.name, &key.values[at])));
        }
        Self { values, place }
    }

    fn variant(
        self,
        document: &Document,
        base: &Base,
        mut settings: Settings,
    ) -> Result<Variant, Complaint> {
        let mut table = base.table.clone();
        for rank in [Rank::Plain, Rank::Aspect, Rank::Refine] {
            for (key, (value, span)) in &self.values {
                let refused = |what: String, help: &str| {
                    let title = format!("`{key}` cannot vary: {what}");
                    document.complain(span.clone(), title, "here").help(help)
                };
                match key.strip_prefix("settings.") {
                    Some(name) if rank == Rank::Plain => settings
                        .set(name, &text(value))
                        .map_err(|error| refused(error.to_string(), &error.advice()))?,
                    None if rank == Rank::of(key) => replace(&mut table, key, value)
                        .map_err(|error| refused(error.what, error.help.unwrap_or(VARIES)))?,
                    _ => {}
                }
            }
        }
        let written = toml::to_string(&table).map_err(|e| Complaint::new(e.to_string()))?;
        let (case, determined_by) = base.with(written);
        let case = case.map_err(|inner| self.blame(document, base, &determined_by[0], &inner))?;
        let blocks = case.scene(case.head_joints[0]).blocks().len();
        let parameters = self.values.iter();
        Ok(Variant {
            case: Arc::new(case),
            blocks,
            determined_by,
            parameters: parameters
                .map(|(key, (value, _))| ((*key).to_owned(), text(value)))
                .collect(),
            settings,
            place: self.place,
        })
    }

    /// Points at the value that a case does not take, with the case's own complaint.
    fn blame(
        &self,
        document: &Document,
        base: &Base,
        written: &str,
        inner: &Complaint,
    ) -> Complaint {
        let wrong = inner.line().and_then(|(_, line)| key_at(written, line));
        let guilty = self.values.iter().find(|(key, _)| {
            let wrong = wrong.as_deref();
            wrong == Some(key) || *key == "aspect" && wrong == Some("unit.length")
        });
        let first = self.values.first();
        let span = match (guilty, &base.span, first) {
            (Some((_, (_, span))), _, _)
            | (None, Some(span), _)
            | (None, None, Some((_, (_, span)))) => span,
            (None, None, None) => {
                let title = format!("{}: {}", base.found.path, inner.title());
                return Complaint::new(title).help(inner.advice());
            }
        };
        let values = self.values.iter();
        let values: Vec<String> = values
            .map(|(key, (value, _))| format!("{key} = {value}"))
            .collect();
        let label = if values.is_empty() {
            "in this case".to_owned()
        } else {
            format!("with {}", values.join(", "))
        };
        let title = format!("no such wall: {}", inner.title());
        document
            .complain(span.clone(), title, label)
            .help(inner.advice())
    }
}

/// The key that a line of a table as `toml` writes it is about, with the names of the tables that it
/// stands in; lines count from 1.
fn key_at(written: &str, line: usize) -> Option<String> {
    let lines: Vec<&str> = written.lines().take(line).map(str::trim).collect();
    let (key, _) = lines.last()?.split_once('=')?;
    let table = |line: &&str| Some(line.strip_prefix('[')?.strip_suffix(']')?.to_owned());
    let table = lines.iter().rev().find_map(table);
    Some(match table {
        Some(table) => format!("{table}.{}", key.trim()),
        None => key.trim().to_owned(),
    })
}

/// The settings of a file.
pub(super) fn settings(document: &Document, file: &File) -> Result<Settings, Complaint> {
    let mut settings = Settings::default();
    let mut written: Vec<_> = file.settings.iter().collect();
    written.sort_by_key(|(name, _)| name.span().start);
    for (name, value) in written {
        let set = settings.set(name.get_ref(), &text(&value.get_ref().0));
        set.map_err(|error| {
            let span = Spanned::span(value);
            let complaint = document.complain(span, error.to_string(), "here");
            complaint.help(error.advice())
        })?;
    }
    Ok(settings)
}

#[cfg(test)]
mod tests {
    use super::key_at;

    #[test]
    fn a_line_is_about_a_key_and_not_about_one_that_begins_alike() {
        let written = "head = 1\nheight = 2\n\n[unit]\nheight = 3\n\n[friction]\nbed = 4\n";
        let keys = [1, 2, 3, 5, 8].map(|line| key_at(written, line));
        let expected = [
            Some("head"),
            Some("height"),
            None,
            Some("unit.height"),
            Some("friction.bed"),
        ];
        assert_eq!(keys, expected.map(|key| key.map(str::to_owned)));
    }
}
