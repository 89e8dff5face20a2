//! What the library shows stays small: what is no part of its contract is the crate's own, so that the
//! compiler finds it when nobody needs it any more.

use std::fs;
use std::path::Path;

use syn::{Attribute, Item, UseTree, Visibility};

/// Public items of the library at most: modules and what they define or take from below.
const MOST: usize = 119;

/// The items of a file.
fn items(path: &Path) -> Vec<Item> {
    let text = fs::read_to_string(path).unwrap_or_else(|e| panic!("{}: {e}", path.display()));
    syn::parse_file(&text).expect("a source of Rust").items
}

/// Names that a use brings.
fn names(tree: &UseTree, into: &mut Vec<String>) {
    match tree {
        UseTree::Path(path) => names(&path.tree, into),
        UseTree::Group(group) => group.items.iter().for_each(|tree| names(tree, into)),
        UseTree::Name(name) => into.push(name.ident.to_string()),
        UseTree::Rename(rename) => into.push(rename.rename.to_string()),
        UseTree::Glob(_) => panic!("a glob makes public what nobody named"),
    }
}

fn is_hidden(attributes: &[Attribute]) -> bool {
    let mut docs = attributes.iter().filter(|a| a.path().is_ident("doc"));
    docs.any(|doc| {
        doc.parse_args::<syn::Ident>()
            .is_ok_and(|word| word == "hidden")
    })
}

/// The public names of a module in `folder`, and of the public modules below it.
fn public(folder: &Path, items: &[Item], into: &mut Vec<String>) {
    for item in items {
        let (visibility, attributes, name) = match item {
            Item::Use(item) if matches!(item.vis, Visibility::Public(_)) => {
                names(&item.tree, into);
                continue;
            }
            Item::Const(item) => (&item.vis, &item.attrs, &item.ident),
            Item::Enum(item) => (&item.vis, &item.attrs, &item.ident),
            Item::Fn(item) => (&item.vis, &item.attrs, &item.sig.ident),
            Item::Mod(item) => (&item.vis, &item.attrs, &item.ident),
            Item::Static(item) => (&item.vis, &item.attrs, &item.ident),
            Item::Struct(item) => (&item.vis, &item.attrs, &item.ident),
            Item::Trait(item) => (&item.vis, &item.attrs, &item.ident),
            Item::Type(item) => (&item.vis, &item.attrs, &item.ident),
            _ => continue,
        };
        if !matches!(visibility, Visibility::Public(_)) || is_hidden(attributes) {
            continue;
        }
        into.push(name.to_string());
        if let Item::Mod(module) = item {
            let below = folder.join(module.ident.to_string());
            match &module.content {
                Some((_, items)) => public(&below, items, into),
                None => public(&below, &self::items(&below.join("mod.rs")), into),
            }
        }
    }
}

#[test]
fn the_library_is_small() {
    let source = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let mut found = Vec::new();
    public(&source, &items(&source.join("lib.rs")), &mut found);
    for name in ["Scene", "Method", "Interval", "judge", "Outcome", "answer"] {
        assert!(found.iter().any(|other| other == name), "{name} is public");
    }
    assert!(
        found.len() <= MOST,
        "{} public items, and {MOST} are the most: {found:?}",
        found.len()
    );
}
