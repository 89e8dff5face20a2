//! From a sweep file to its tasks.

use std::borrow::Cow;
use std::path::Path;

use toml::Spanned;

use super::file::{self, CaseSource, File};
use super::name::sweep_name;
use super::neighbours::FromNeighbours;
use super::variants::{Axis, Base, Variant, axes, settings, variants};
use crate::case::{self, Complaint, Document, UnreadCase, listed, nearest, printable};
use crate::method::{Kind, METHODS, Method, defaults, kind, methods as all_methods};
use crate::run::{Subject, Task};
use crate::scene::HeadJoints;

/// A sweep: walls, methods and settings, in a fixed order.
pub struct Sweep {
    /// The file's name without `.sweep.toml`.
    pub name: String,
    /// One line for people.
    pub title: String,
    /// Where the question comes from, and what is to be known about the answer; may be empty.
    pub source: String,
    variants: Vec<Variant>,
    methods: Vec<&'static dyn Method>,
    /// How far apart in `variants` the neighbours are that the interval also starts from, and on
    /// which axis they lie.
    neighbours: Option<(usize, usize)>,
}

impl Sweep {
    /// Reads a sweep from the bytes of a file; `path` names it and stands in complaints. Cases are
    /// looked for beside the file first.
    ///
    /// # Errors
    /// What is wrong, where, and what to write instead: the first mistake of the file, or of a case
    /// that it makes.
    pub fn read(path: &str, bytes: &[u8]) -> Result<Self, Complaint> {
        let name = sweep_name(path)?;
        let document = Document::read(path, bytes)?;
        let file = file::parse(&document)?;
        let methods = methods(&document, &file)?;
        let settings = settings(&document, &file)?;
        let axes = axes(&document, &file)?;
        let bases = bases(&document, &file, &name)?;
        let variants = variants(&document, &bases, &axes, settings)?;
        let neighbours = neighbours(&document, &file, &axes, &variants)?;
        Ok(Self {
            title: printable(file.title.as_deref().unwrap_or(&name)),
            source: printable(file.source.as_deref().unwrap_or_default()),
            name,
            variants,
            methods,
            neighbours,
        })
    }

    /// The sweep with outside programs behind its methods.
    pub fn with_programs(mut self, programs: Vec<&'static dyn Method>) -> Self {
        self.methods.extend(programs);
        self
    }

    /// Every task: walls slowest, then methods, then head joints, as in the tables of `run`.
    pub fn tasks(&self) -> Vec<Task<'_>> {
        let mut tasks = Vec::new();
        for (index, variant) in self.variants.iter().enumerate() {
            for &method in &self.methods {
                for &head_joints in &variant.case.head_joints {
                    tasks.push(self.task(index, method, head_joints));
                }
            }
        }
        tasks
    }

    fn subject(&self, index: usize, head_joints: HeadJoints) -> Subject<'_> {
        let variant = &self.variants[index];
        Subject {
            case: variant.case.name.clone(),
            head_joints,
            parameters: variant.parameters.clone(),
            blocks: variant.blocks,
            sides: Box::new(move || Cow::Owned(variant.case.sides(head_joints))),
            determined_by: variant.determined_by.clone(),
        }
    }

    fn task(&self, index: usize, method: &'static dyn Method, head_joints: HeadJoints) -> Task<'_> {
        let variant = &self.variants[index];
        let mut subject = self.subject(index, head_joints);
        if kind(method.name()) != Kind::CollapseStates || self.neighbours.is_none() {
            return Task::new(subject, method, variant.settings);
        }
        let neighbours = self.beside(index);
        let texts = neighbours.iter().flat_map(|other| &other.determined_by);
        subject.determined_by.extend(texts.cloned());
        let method = FromNeighbours {
            neighbours,
            head_joints,
        };
        Task::new(subject, method, variant.settings)
    }

    /// The walls before and after this one on the axis of neighbours.
    fn beside(&self, index: usize) -> Vec<&Variant> {
        let Some((stride, axis)) = self.neighbours else {
            return Vec::new();
        };
        let here = self.variants[index].place[axis];
        let before = index.checked_sub(stride).map(|i| (i, here.wrapping_sub(1)));
        let after = Some((index + stride, here + 1));
        let both = [before, after].into_iter().flatten();
        let on_axis = both.filter_map(|(i, place)| {
            let other = self.variants.get(i)?;
            (other.place[axis] == place).then_some(other)
        });
        on_axis.collect()
    }
}

fn methods(document: &Document, file: &File) -> Result<Vec<&'static dyn Method>, Complaint> {
    let Some(written) = &file.methods else {
        return Ok(defaults());
    };
    let names: Vec<&str> = METHODS.iter().map(|entry| entry.name()).collect();
    let words = &written.get_ref().0;
    for (index, word) in words.iter().enumerate() {
        let name = word.get_ref().as_str();
        if !names.contains(&name) {
            let help = match nearest(name, names.iter().copied()) {
                Some(near) => format!("did you mean `{near}`?"),
                None => format!("methods are {}", listed(names.iter().copied())),
            };
            let title = format!("there is no method named `{name}`");
            return Err(document
                .complain(word.span(), title, "not a method")
                .help(help));
        }
        if words[..index].iter().any(|other| other.get_ref() == name) {
            let title = format!("the method `{name}` is named twice");
            return Err(document
                .complain(word.span(), title, "the second time here")
                .help("remove one of the two"));
        }
    }
    if words.is_empty() {
        return Err(document
            .complain(written.span(), "a sweep without methods", "none in here")
            .help("name a method, or drop `methods` for all of them"));
    }
    let named = |method: &&dyn Method| words.iter().any(|word| word.get_ref() == method.name());
    Ok(all_methods().into_iter().filter(named).collect())
}

/// The cases before anything is replaced in them.
fn bases(document: &Document, file: &File, name: &str) -> Result<Vec<Base>, Complaint> {
    let folder = Path::new(&document.path).parent().unwrap_or(Path::new(""));
    let mut bases: Vec<Base> = Vec::new();
    let mut add = |argument: &str, span: std::ops::Range<usize>| -> Result<(), Complaint> {
        let beside = folder.join(argument);
        let argument = if beside.exists() {
            beside.to_string_lossy().into_owned()
        } else {
            argument.to_owned()
        };
        let found = case::locate(&argument).map_err(|inner| {
            document
                .complain(span.clone(), inner.title(), "named here")
                .help(inner.advice())
        })?;
        for one in found {
            let path = &one.path;
            if bases.iter().any(|base| base.found.path == *path) {
                return Err(document
                    .complain(
                        span.clone(),
                        format!("the case {path} comes twice"),
                        "again",
                    )
                    .help("name each case once"));
            }
            bases.push(Base::read(one)?);
        }
        Ok(())
    };
    match file.case.get_ref() {
        CaseSource::One(argument) => add(argument, file.case.span())?,
        CaseSource::Named(list) => {
            for argument in list {
                add(argument.get_ref(), argument.span())?;
            }
        }
        CaseSource::Inline(table) => {
            let path = folder.join(format!("{name}.toml"));
            let found = UnreadCase {
                path: path.to_string_lossy().into_owned(),
                file: Some(path),
                bytes: Vec::new(),
            };
            bases.push(Base::new(found, table.clone(), Some(file.case.span())));
        }
    }
    if bases.is_empty() {
        return Err(document
            .complain(file.case.span(), "a sweep without a case", "none in here")
            .help("write `case = \"paper-1\"`"));
    }
    if let Some(word) = &file.head_joints {
        let known = ["contact", "open", "both"];
        let written = word.get_ref().as_str();
        if !known.contains(&written) {
            let title = format!("unknown head_joints `{written}`");
            return Err(document
                .complain(word.span(), title, "not one of the known words")
                .help(format!("the words for `head_joints` are {}", listed(known))));
        }
        for base in &mut bases {
            base.table.insert("head_joints".to_owned(), written.into());
        }
    }
    Ok(bases)
}

fn neighbours(
    document: &Document,
    file: &File,
    axes: &[Axis],
    variants: &[Variant],
) -> Result<Option<(usize, usize)>, Complaint> {
    let Some(word) = &file.neighbours else {
        return Ok(None);
    };
    let complain = |title: String, help: String| {
        let complaint = document.complain(Spanned::span(word), title, "these neighbours");
        Err(complaint.help(help))
    };
    let name = word.get_ref().as_str();
    let holds = |axis: &Axis| axis.keys.iter().any(|key| key.name == name);
    let Some(axis) = axes.iter().position(holds) else {
        let keys = axes.iter().flat_map(|axis| &axis.keys).map(|key| key.name);
        let help = format!("write one of the keys that vary: {}", listed(keys));
        return complain(format!("`{name}` does not vary"), help);
    };
    let stride: usize = axes[axis + 1..].iter().map(|axis| axis.length).product();
    let stride = stride.max(1);
    let of_a_size = variants.iter().enumerate().all(|(index, variant)| {
        let next = variants.get(index + stride);
        next.is_none_or(|next| {
            next.place[axis] != variant.place[axis] + 1 || next.blocks == variant.blocks
        })
    });
    if !of_a_size {
        let help = "take a key that leaves every block where it is, such as `overburden`".into();
        return complain(format!("walls along `{name}` have different blocks"), help);
    }
    Ok(Some((stride, axis)))
}
