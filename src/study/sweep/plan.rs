//! From a sweep file to its tasks.

use std::path::Path;

use super::file::{self, CaseSource, File};
use super::variants::{Base, Variant, axes, settings, variants};
use crate::case::{self, Complaint, Document, UnreadCase, Written, listed, nearest, printable};
use crate::method::{METHODS, Method, defaults, methods as all_methods};
use crate::run::Task;

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
}

impl Sweep {
    /// Reads a sweep from the bytes of a file; `path` names it and stands in complaints. Cases are
    /// looked for beside the file first.
    ///
    /// # Errors
    /// What is wrong, where, and what to write instead: the first mistake of the file, or of a case
    /// that it makes.
    pub fn read(path: &str, bytes: &[u8]) -> Result<Self, Complaint> {
        Self::named(sweep_name(path)?, path, bytes)
    }

    /// The same with a name of its own.
    pub(super) fn named(name: String, path: &str, bytes: &[u8]) -> Result<Self, Complaint> {
        let document = Document::read(path, bytes)?;
        let sweep = file::parse(&document).and_then(|file| Self::of_file(name, path, &file));
        sweep.map_err(|complaint| complaint.in_document(&document))
    }

    fn of_file(name: String, path: &str, file: &File) -> Result<Self, Complaint> {
        let methods = methods(file)?;
        let settings = settings(file)?;
        let axes = axes(file)?;
        let bases = bases(path, file, &name)?;
        let variants = variants(&bases, &axes, settings)?;
        Ok(Self {
            title: printable(file.title.as_deref().unwrap_or(&name)),
            source: printable(file.source.as_deref().unwrap_or_default()),
            name,
            variants,
            methods,
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
        for variant in &self.variants {
            for &method in &self.methods {
                for &head_joints in &variant.case.head_joints {
                    let subject = variant.subject(head_joints);
                    tasks.push(Task::new(subject, method, variant.settings));
                }
            }
        }
        tasks
    }
}

/// Sweeps are named by their files.
pub(super) fn stem(path: &str) -> &str {
    let file = path.rsplit(['/', '\\']).next().unwrap_or(path);
    let file = file.strip_suffix(".toml").unwrap_or(file);
    file.strip_suffix(".sweep").unwrap_or(file)
}

/// The name of a sweep, which goes into the names of files.
fn sweep_name(path: &str) -> Result<String, Complaint> {
    let name = stem(path);
    let plain = |c: char| c.is_alphanumeric() || "-_.".contains(c);
    if path.ends_with(".toml") && !name.is_empty() && name.chars().all(plain) {
        return Ok(name.to_owned());
    }
    let title = if path.ends_with(".toml") {
        format!("{path}: a sweep is named by its file, and `{name}` is not a plain word")
    } else {
        format!("{path} is not a sweep: its name does not end in `.toml`")
    };
    Err(Complaint::new(title)
        .help("use letters, digits, `-`, `_` and `.`, and let the name end in `.sweep.toml`"))
}

fn methods(file: &File) -> Result<Vec<&'static dyn Method>, Complaint> {
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
            return Err(word.wrong(title, "not a method").help(help));
        }
        if words[..index].iter().any(|other| other.get_ref() == name) {
            let title = format!("the method `{name}` is named twice");
            let complaint = word.wrong(title, "the second time here");
            return Err(complaint.help("remove one of the two"));
        }
    }
    if words.is_empty() {
        let complaint = written.wrong("a sweep without methods", "none in here");
        return Err(complaint.help("name a method, or drop `methods` for all of them"));
    }
    let named = |method: &&dyn Method| words.iter().any(|word| word.get_ref() == method.name());
    Ok(all_methods().into_iter().filter(named).collect())
}

/// The cases before anything is replaced in them.
fn bases(path: &str, file: &File, name: &str) -> Result<Vec<Base>, Complaint> {
    let folder = Path::new(path).parent().unwrap_or(Path::new(""));
    let mut bases: Vec<Base> = Vec::new();
    let mut add = |argument: &str, span: std::ops::Range<usize>| -> Result<(), Complaint> {
        let beside = folder.join(argument);
        let argument = if beside.exists() {
            beside.to_string_lossy().into_owned()
        } else {
            argument.to_owned()
        };
        let found = case::locate(&argument).map_err(|inner| {
            Complaint::at(span.clone(), inner.title(), "named here").help(inner.advice())
        })?;
        for one in found {
            let path = &one.path;
            if bases.iter().any(|base| base.found.path == *path) {
                let title = format!("the case {path} comes twice");
                return Err(Complaint::at(span, title, "again").help("name each case once"));
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
        let complaint = file.case.wrong("a sweep without a case", "none in here");
        return Err(complaint.help("write `case = \"paper-1\"`"));
    }
    if let Some(word) = &file.head_joints {
        let known = ["contact", "open", "both"];
        let written = word.get_ref().as_str();
        if !known.contains(&written) {
            let title = format!("unknown head_joints `{written}`");
            let complaint = word.wrong(title, "not one of the known words");
            return Err(
                complaint.help(format!("the words for `head_joints` are {}", listed(known)))
            );
        }
        for base in &mut bases {
            base.table.insert("head_joints".to_owned(), written.into());
        }
    }
    Ok(bases)
}
