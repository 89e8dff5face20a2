//! What cases cite can be looked up: no source names a file outside the repository, and every value
//! of kind `independent` names the program under `tests/reference/` that recomputes it.

use std::fs;
use std::path::{Path, PathBuf};

use toml::{Table, Value};

const ROOT: &str = env!("CARGO_MANIFEST_DIR");

/// Endings by which a word is a file.
const FILES: [&str; 10] = [
    "py", "rs", "toml", "csv", "json", "txt", "md", "sh", "snap", "ipynb",
];

fn cases(folder: &Path, into: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).expect("the folder of cases is there") {
        let path = entry.unwrap().path();
        if path.is_dir() {
            cases(&path, into);
        } else if path.extension().is_some_and(|ending| ending == "toml") {
            into.push(path);
        }
    }
}

/// The words of a text that are names of files.
fn files(text: &str) -> impl Iterator<Item = &str> {
    let apart = |c: char| c.is_whitespace() || "\"'`()[]{},;:=".contains(c);
    let words = text.split(apart).map(|word| word.trim_end_matches('.'));
    words.filter(|word| {
        let ending = word.rsplit_once('.').filter(|(stem, _)| !stem.is_empty());
        ending.is_some_and(|(_, ending)| FILES.contains(&ending))
    })
}

#[test]
fn cases_cite_no_file_outside_the_repository() {
    let mut paths = Vec::new();
    cases(&Path::new(ROOT).join("cases"), &mut paths);
    let mut cited = 0;
    for path in &paths {
        let text = fs::read_to_string(path).unwrap();
        for word in files(&text) {
            cited += 1;
            let beside = path.parent().unwrap().join(word);
            assert!(
                !word.contains("..") && (Path::new(ROOT).join(word).is_file() || beside.is_file()),
                "{} cites {word}, which is not in the repository",
                path.display()
            );
        }
    }
    assert!(
        cited > 100,
        "{cited} files are cited: words are not understood"
    );
    assert_eq!(files("through shared/oracle.py.").count(), 1);
}

#[test]
fn independent_values_name_the_program_that_recomputes_them() {
    let mut paths = Vec::new();
    cases(&Path::new(ROOT).join("cases"), &mut paths);
    let mut independent = 0;
    for path in &paths {
        let case: Table = fs::read_to_string(path).unwrap().parse().unwrap();
        let references = case.get("references").and_then(Value::as_array);
        for reference in references.into_iter().flatten() {
            let word = |key: &str| reference.get(key).and_then(Value::as_str).unwrap_or("");
            if word("kind") == "independent" {
                independent += 1;
                let source = word("source");
                assert!(
                    files(source).any(|file| file.starts_with("tests/reference/")),
                    "{}: {source:?} names no program",
                    path.display()
                );
            }
        }
    }
    assert!(independent >= 154, "{independent} values");
}
