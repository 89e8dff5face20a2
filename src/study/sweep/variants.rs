//! The walls of a sweep: a case with some keys of its file replaced, for every combination.

use std::borrow::Cow;
use std::cell::RefCell;
use std::ops;
use std::sync::Arc;

use rayon::prelude::*;
use toml::Table;

use super::file::File;
use super::replace::{rank, replace};
use super::values::{Placed, text, values};
use crate::case::{Case, Complaint, UnreadCase, Written};
use crate::method::Settings;
use crate::run::Subject;
use crate::scene::HeadJoints;

const MOST_VARIANTS: usize = 1_000_000;

/// A case file before anything is replaced in it.
pub(super) struct Base {
    /// The file, which says what lies beside it.
    pub found: UnreadCase,
    /// What is in it, without title, source, references and demand: those are about another wall as
    /// soon as a value differs.
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
        for key in ["title", "source", "references", "demand"] {
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

pub(super) struct Key<'a> {
    pub name: &'a str,
    span: ops::Range<usize>,
    values: Vec<Placed>,
}

/// The tables `[[vary]]` of a file, their keys in the order they are written in.
pub(super) fn axes(file: &File) -> Result<Vec<Axis<'_>>, Complaint> {
    let mut axes: Vec<Axis> = Vec::new();
    for table in &file.vary {
        let mut keys = Vec::new();
        for (key, written) in table {
            keys.push(Key {
                name: key.get_ref(),
                span: key.span(),
                values: values(key.get_ref(), written)?,
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
            let complaint = Complaint::at(other.span.clone(), title, "these vary together");
            return Err(
                complaint.help("write as many values for each, or put `[[vary]]` between the two")
            );
        }
        let known = axes.iter().flat_map(|axis| &axis.keys);
        if let Some(twice) = keys
            .iter()
            .find(|key| known.clone().any(|k| k.name == key.name))
        {
            let title = format!("`{}` varies twice", twice.name);
            let complaint = Complaint::at(twice.span.clone(), title, "the second time here");
            return Err(complaint.help("remove one of the two"));
        }
        axes.push(Axis { keys, length });
    }
    let count = axes
        .iter()
        .try_fold(1_usize, |all, axis| all.checked_mul(axis.length));
    if count.is_none_or(|count| count > MOST_VARIANTS) {
        let title = format!("a sweep of more than {MOST_VARIANTS} walls");
        let span = axes.last().map_or(0..0, |axis| axis.keys[0].span.clone());
        let complaint = Complaint::at(span, title, "the last factor");
        return Err(complaint.help("write fewer values, or more than one sweep"));
    }
    Ok(axes)
}

pub(super) struct Variant {
    pub case: Arc<Case>,
    /// Number of blocks with head joints in contact.
    blocks: usize,
    /// Text of the case and of the files that it names.
    determined_by: Vec<String>,
    parameters: Vec<(String, String)>,
    pub settings: Settings,
}

impl Variant {
    /// The wall with this setting of its head joints.
    pub fn subject(&self, head_joints: HeadJoints) -> Subject<'_> {
        Subject {
            case: self.case.name.clone(),
            head_joints,
            parameters: self.parameters.clone(),
            blocks: self.blocks,
            sides: Box::new(move || Cow::Owned(self.case.sides(head_joints))),
            determined_by: self.determined_by.clone(),
        }
    }
}

/// Every combination: cases slowest, then the axes in their order.
pub(super) fn variants(
    bases: &[Base],
    axes: &[Axis],
    settings: Settings,
) -> Result<Vec<Variant>, Complaint> {
    let count: usize = axes.iter().map(|axis| axis.length).product();
    let read = (0..bases.len() * count).into_par_iter().map(|index| {
        let base = &bases[index / count];
        Combination::of(axes, index % count).variant(base, settings)
    });
    // Of several complaints always the first, whichever core is faster.
    read.collect::<Vec<_>>().into_iter().collect()
}

/// The values that one combination puts into the case.
#[derive(Clone)]
struct Combination<'a>(Vec<(&'a str, &'a Placed)>);

impl<'a> Combination<'a> {
    /// The last axis runs fastest; keys stand in the order of the axes.
    fn of(axes: &'a [Axis], mut index: usize) -> Self {
        let mut values = Vec::new();
        for axis in axes.iter().rev() {
            let at = index % axis.length;
            index /= axis.length;
            let keys = axis.keys.iter().rev();
            values.extend(keys.map(|key| (key.name, &key.values[at])));
        }
        values.reverse();
        Self(values)
    }

    fn variant(&self, base: &Base, mut settings: Settings) -> Result<Variant, Complaint> {
        let (case, determined_by) = self.case(base, &mut settings)?;
        let case = case.map_err(|inner| self.blame(base, &inner))?;
        let values = self.0.iter();
        Ok(Variant {
            blocks: case.scene(case.head_joints[0]).blocks().len(),
            case: Arc::new(case),
            determined_by,
            parameters: values
                .map(|(key, (value, _))| ((*key).to_owned(), text(value)))
                .collect(),
            settings,
        })
    }

    /// The case with the values, and the texts that determine it; those of settings go into these.
    /// What cannot be put into a case is complained of here, what the case does not take there.
    fn case(
        &self,
        base: &Base,
        settings: &mut Settings,
    ) -> Result<(Result<Case, Complaint>, Vec<String>), Complaint> {
        let mut table = base.table.clone();
        let mut ranked = self.0.clone();
        ranked.sort_by_key(|(key, _)| rank(key));
        for (key, (value, span)) in ranked {
            let refused = |what: String, help: &str| {
                let title = format!("`{key}` cannot vary: {what}");
                Complaint::at(span.clone(), title, "here").help(help)
            };
            match key.strip_prefix("settings.") {
                Some(name) => settings
                    .set(name, &text(value))
                    .map_err(|error| refused(error.to_string(), &error.advice()))?,
                None => {
                    replace(&mut table, key, value).map_err(|(what, help)| refused(what, help))?
                }
            }
        }
        let written = toml::to_string(&table).map_err(|e| Complaint::new(e.to_string()))?;
        Ok(base.with(written))
    }

    /// Whether the case takes it no better without the value of this place.
    fn is_innocent(&self, base: &Base, at: usize, inner: &Complaint) -> bool {
        let mut others = self.clone();
        others.0.remove(at);
        let without = others.case(base, &mut Settings::default());
        let still = without.and_then(|(case, _)| case).err();
        still.is_some_and(|still| still.title() == inner.title())
    }

    /// Points at the value that a case does not take, with the case's own complaint.
    fn blame(&self, base: &Base, inner: &Complaint) -> Complaint {
        let places = 0..self.0.len();
        let mut guilty = places.filter(|&at| !self.is_innocent(base, at, inner));
        let place = |at: usize| &self.0[at].1.1;
        let span = guilty.next().map(place).or(base.span.as_ref());
        let Some(span) = span.or(self.0.first().map(|(_, (_, span))| span)) else {
            let title = format!("{}: {}", base.found.path, inner.title());
            return Complaint::new(title).help(inner.advice());
        };
        let values = self.0.iter();
        let values: Vec<String> = values
            .map(|(key, (value, _))| format!("{key} = {value}"))
            .collect();
        let label = if values.is_empty() {
            "in this case".to_owned()
        } else {
            format!("with {}", values.join(", "))
        };
        let title = format!("no such wall: {}", inner.title());
        Complaint::at(span.clone(), title, label).help(inner.advice())
    }
}

pub(super) fn settings(file: &File) -> Result<Settings, Complaint> {
    let mut settings = Settings::default();
    let mut written: Vec<_> = file.settings.iter().collect();
    written.sort_by_key(|(name, _)| name.span().start);
    for (name, value) in written {
        let set = settings.set(name.get_ref(), &text(&value.get_ref().0));
        set.map_err(|error| value.wrong(error.to_string(), "here").help(error.advice()))?;
    }
    Ok(settings)
}
