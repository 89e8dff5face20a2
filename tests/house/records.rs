//! Every stored record is of a case, or of a test that names it: one that nothing compares would go
//! unseen.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

/// Records that are of no case alone, with the test that compares each.
const OTHERS: [(&str, &str); 1] = [("malformed", "tests/command/malformed.rs")];

/// Names of the files below a folder that end so, without the ending.
fn names(folder: &Path, ending: &str, into: &mut BTreeSet<String>) {
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            names(&path, ending, into);
        } else if let Some(name) = path
            .file_name()
            .unwrap()
            .to_str()
            .unwrap()
            .strip_suffix(ending)
        {
            into.insert(name.to_owned());
        }
    }
}

#[test]
fn every_record_is_compared() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let (mut records, mut cases) = (BTreeSet::new(), BTreeSet::new());
    names(&root.join("snapshots"), ".snap", &mut records);
    names(&root.join("cases"), ".toml", &mut cases);
    for (name, test) in OTHERS {
        let text = fs::read_to_string(root.join(test)).unwrap();
        assert!(
            text.contains(&format!("\"{name}\"")),
            "{test} has no {name}"
        );
        cases.insert(name.to_owned());
    }
    let strays: Vec<&String> = records.difference(&cases).collect();
    assert!(strays.is_empty(), "nothing compares {strays:?}");
    assert!(records.len() > 100, "{}", records.len());
}
