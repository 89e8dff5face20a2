//! The house as it is meant to be: rooms use only rooms below them, no two files use each other, and
//! nobody compares a method's name with a literal.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

use syn::visit::{self, Visit};
use syn::{Item, UseTree};
use trilith::inside::METHODS;

/// Rooms from the ground up; those of one line do not use each other.
const FLOORS: [&[&str]; 14] = [
    &["number", "text", "files", "fingerprint"],
    &["scene"],
    &["mechanics", "certificate"],
    &["answer"],
    &["method"],
    &["case"],
    &["external"],
    &["judge"],
    &["run"],
    &["record"],
    &["picture"],
    &["study"],
    &["report"],
    &["command"],
];

/// Files with a method's name as a literal beside the table and the methods' own files, at most.
const FILES_WITH_NAMES: usize = 10;

type Segments = Vec<String>;

/// A module: its file, what it defines, what it takes from elsewhere, and what it mentions.
#[derive(Default)]
struct Module {
    file: PathBuf,
    children: BTreeSet<String>,
    items: BTreeSet<String>,
    uses: Vec<(String, Segments)>,
    paths: Vec<Segments>,
    literals: BTreeSet<String>,
}

type Modules = BTreeMap<Segments, Module>;

fn is_test(attributes: &[syn::Attribute]) -> bool {
    attributes.iter().any(|attribute| {
        let is_cfg = attribute.path().is_ident("cfg");
        is_cfg
            && attribute
                .parse_args::<syn::Ident>()
                .is_ok_and(|what| what == "test")
    })
}

fn flatten(tree: &UseTree, before: &Segments, uses: &mut Vec<(String, Segments)>) {
    let and = |name: String| [before.as_slice(), &[name]].concat();
    match tree {
        UseTree::Path(path) => flatten(&path.tree, &and(path.ident.to_string()), uses),
        UseTree::Group(group) => {
            group
                .items
                .iter()
                .for_each(|item| flatten(item, before, uses));
        }
        UseTree::Name(name) if name.ident == "self" => {
            let last = before.last().cloned().unwrap_or_default();
            uses.push((last, before.clone()));
        }
        UseTree::Name(name) => uses.push((name.ident.to_string(), and(name.ident.to_string()))),
        UseTree::Rename(rename) => {
            uses.push((rename.rename.to_string(), and(rename.ident.to_string())));
        }
        UseTree::Glob(_) => uses.push(("*".to_owned(), before.clone())),
    }
}

impl<'ast> Visit<'ast> for Module {
    fn visit_path(&mut self, path: &'ast syn::Path) {
        let segments = path
            .segments
            .iter()
            .map(|segment| segment.ident.to_string());
        self.paths.push(segments.collect());
        visit::visit_path(self, path);
    }

    fn visit_item_use(&mut self, item: &'ast syn::ItemUse) {
        flatten(&item.tree, &Vec::new(), &mut self.uses);
    }

    fn visit_lit_str(&mut self, literal: &'ast syn::LitStr) {
        self.literals.insert(literal.value());
    }

    fn visit_item_mod(&mut self, item: &'ast syn::ItemMod) {
        if !is_test(&item.attrs) {
            visit::visit_item_mod(self, item);
        }
    }

    fn visit_attribute(&mut self, _: &'ast syn::Attribute) {}

    fn visit_visibility(&mut self, _: &'ast syn::Visibility) {}
}

fn name_of(item: &Item) -> Option<String> {
    Some(match item {
        Item::Const(item) => item.ident.to_string(),
        Item::Enum(item) => item.ident.to_string(),
        Item::Fn(item) => item.sig.ident.to_string(),
        Item::Macro(item) => item.ident.as_ref()?.to_string(),
        Item::Static(item) => item.ident.to_string(),
        Item::Struct(item) => item.ident.to_string(),
        Item::Trait(item) => item.ident.to_string(),
        Item::Type(item) => item.ident.to_string(),
        _ => return None,
    })
}

fn read(file: &Path, name: Segments, modules: &mut Modules) {
    let text = fs::read_to_string(file).expect("the sources are there");
    let tree = syn::parse_file(&text).expect("the sources are Rust");
    let is_parent = file
        .file_name()
        .is_some_and(|f| f == "mod.rs" || f == "main.rs" || f == "lib.rs");
    let folder = if is_parent {
        file.parent().expect("a file has a folder").to_owned()
    } else {
        file.with_extension("")
    };
    let mut module = Module {
        file: file.to_owned(),
        ..Module::default()
    };
    for item in &tree.items {
        if let Item::Mod(child) = item
            && child.content.is_none()
            && !is_test(&child.attrs)
        {
            let child = child.ident.to_string();
            let candidates = [
                folder.join(format!("{child}.rs")),
                folder.join(&child).join("mod.rs"),
            ];
            let found = candidates.iter().find(|path| path.exists());
            let path = [name.as_slice(), std::slice::from_ref(&child)].concat();
            read(found.expect("a module has a file"), path, modules);
            module.children.insert(child);
        }
        module.items.extend(name_of(item));
    }
    module.visit_file(&tree);
    modules.insert(name, module);
}

/// The sources of the library.
fn modules() -> Modules {
    let src = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let mut modules = Modules::new();
    read(&src.join("lib.rs"), Vec::new(), &mut modules);
    modules
}

/// The module that defines what a path in a module means; `None` where another crate does.
fn definition(modules: &Modules, at: &Segments, path: &[String], depth: usize) -> Option<Segments> {
    let (first, rest) = path.split_first()?;
    if depth > 20 {
        return None;
    }
    let parent = || at[..at.len().saturating_sub(1)].to_vec();
    let (mut here, mut rest) = match first.as_str() {
        "crate" => (Vec::new(), rest),
        "super" => (parent(), rest),
        "self" => (at.clone(), rest),
        _ => (at.clone(), path),
    };
    while let Some((name, after)) = rest.split_first() {
        if name == "super" {
            here.pop();
            rest = after;
            continue;
        }
        let module = modules.get(&here)?;
        if module.children.contains(name) {
            here.push(name.clone());
            rest = after;
        } else if module.items.contains(name) {
            return Some(here);
        } else {
            let (_, taken) = module.uses.iter().find(|(known, _)| known == name)?;
            // A name of another crate's that shadows nothing of ours.
            if taken.first() == Some(name) && here == *at {
                return None;
            }
            let from = definition(modules, &here, taken, depth + 1)?;
            // A module that was taken whole: what is behind it is inside.
            let whole = modules
                .contains_key(&[from.as_slice(), std::slice::from_ref(name)].concat())
                || taken.last().is_some_and(|last| from.last() == Some(last));
            return if whole && !after.is_empty() {
                definition(
                    modules,
                    &from,
                    &[&["self".to_owned()], after].concat(),
                    depth + 1,
                )
            } else {
                Some(from)
            };
        }
    }
    Some(here)
}

/// Which file uses which, without the file that a room's exports stand in.
fn uses(modules: &Modules) -> BTreeMap<PathBuf, BTreeSet<PathBuf>> {
    let mut graph: BTreeMap<PathBuf, BTreeSet<PathBuf>> = BTreeMap::new();
    for (name, module) in modules {
        let exports = module.items.is_empty() && module.children.len() > 1;
        if name.is_empty() || exports {
            continue;
        }
        let taken = module.uses.iter().map(|(_, path)| path);
        for path in taken.chain(&module.paths) {
            let Some(from) = definition(modules, name, path, 0) else {
                continue;
            };
            let other = &modules[&from].file;
            if *other != module.file {
                graph
                    .entry(module.file.clone())
                    .or_default()
                    .insert(other.clone());
            }
        }
    }
    graph
}

fn shown(file: &Path) -> String {
    let top = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let inside = file.strip_prefix(top).unwrap_or(file);
    inside.display().to_string()
}

/// A way from a file back to itself.
fn circle(graph: &BTreeMap<PathBuf, BTreeSet<PathBuf>>, start: &PathBuf) -> Option<Vec<PathBuf>> {
    let mut before: BTreeMap<&PathBuf, &PathBuf> = BTreeMap::new();
    let mut open = vec![start];
    while let Some(file) = open.pop() {
        for next in graph.get(file).into_iter().flatten() {
            if next == start {
                let mut way = vec![file.clone()];
                let mut at = file;
                while let Some(&from) = before.get(at) {
                    way.push(from.clone());
                    at = from;
                }
                return Some(way);
            }
            if !before.contains_key(next) {
                before.insert(next, file);
                open.push(next);
            }
        }
    }
    None
}

#[test]
fn no_two_files_use_each_other() {
    let graph = uses(&modules());
    let edges: usize = graph.values().map(BTreeSet::len).sum();
    assert!(edges > 300, "{edges} edges: the sources are not understood");
    let circles: Vec<String> = graph
        .keys()
        .filter_map(|file| circle(&graph, file))
        .map(|way| {
            way.iter()
                .map(|file| shown(file))
                .collect::<Vec<_>>()
                .join(" <- ")
        })
        .collect();
    assert!(circles.is_empty(), "circles:\n{}", circles.join("\n"));
}

#[test]
fn rooms_use_only_rooms_below() {
    let floor = |file: &str| {
        let room = file.split(['/', '.']).next().unwrap_or_default();
        let found = FLOORS.iter().position(|rooms| rooms.contains(&room));
        found.unwrap_or_else(|| panic!("{file} is in no room"))
    };
    let room = |file: &str| file.split(['/', '.']).next().map(str::to_owned);
    let mut wrong = Vec::new();
    for (file, others) in uses(&modules()) {
        let file = shown(&file);
        for other in others {
            let other = shown(&other);
            if other != "lib.rs" && room(&file) != room(&other) && floor(&file) <= floor(&other) {
                wrong.push(format!("{file} uses {other}"));
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn methods_are_asked_of_the_table() {
    let names: Vec<&str> = METHODS.iter().map(|entry| entry.name()).collect();
    let with_names = modules().into_values().filter(|module| {
        let literals = module.literals.iter();
        literals
            .clone()
            .any(|literal| names.contains(&literal.as_str()))
    });
    let files: Vec<String> = with_names.map(|module| shown(&module.file)).collect();
    let own = names.len();
    assert!(files.len() <= own + FILES_WITH_NAMES, "{files:#?}");
    println!("files with a method's name: {files:#?}");
}
