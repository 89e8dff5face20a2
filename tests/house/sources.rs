//! What cases cite can be looked up: no source names a file outside the repository, and every value
//! of kind `independent` names the program under `tests/reference/` that recomputes it. No function
//! of the program is longer than a screen.

use std::fs;
use std::path::{Path, PathBuf};

use toml::{Table, Value};

const ROOT: &str = env!("CARGO_MANIFEST_DIR");

/// Endings by which a word is a file.
const FILES: [&str; 10] = [
    "py", "rs", "toml", "csv", "json", "txt", "md", "sh", "snap", "ipynb",
];

/// The files below a folder of the repository whose names end so.
fn below(folder: &str, ending: &str) -> Vec<PathBuf> {
    let mut folders = vec![Path::new(ROOT).join(folder)];
    let mut found = Vec::new();
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(folder).expect("the folder is there") {
            let path = entry.unwrap().path();
            if path.is_dir() {
                folders.push(path);
            } else if path.extension().is_some_and(|of_path| of_path == ending) {
                found.push(path);
            }
        }
    }
    found
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
    let paths = below("cases", "toml");
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
    let paths = below("cases", "toml");
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

/// Lines of a function at most, from its name to its closing brace.
const MOST_LINES: usize = 79;

/// The functions of a source as rustfmt leaves it: the first line of each, and how many it has.
fn functions(text: &str) -> Vec<(&str, usize)> {
    let lines: Vec<&str> = text.lines().collect();
    let is_function = |line: &str| {
        let mut words = line.split_whitespace();
        let word = words.find(|word| *word != "const" && !word.starts_with("pub"));
        word == Some("fn")
    };
    let measured = (0..lines.len()).filter(|&start| is_function(lines[start]));
    let measured = measured.map(|start| {
        let depth = lines[start].find(|c| c != ' ').unwrap_or(0);
        let ends = |line: &&str| {
            let (before, from) = line.split_at_checked(depth).unwrap_or((line, ""));
            let is_at_depth = before.trim().is_empty() && !from.starts_with(' ');
            is_at_depth && from.ends_with(['}', ';'])
        };
        let end = lines[start..].iter().position(ends);
        (lines[start], end.expect("a function ends") + 1)
    });
    measured.collect()
}

#[test]
fn no_function_is_longer_than_a_screen() {
    let mut count = 0;
    for path in below("src", "rs") {
        let text = fs::read_to_string(&path).unwrap();
        for (first, lines) in functions(&text) {
            count += 1;
            assert!(
                lines <= MOST_LINES,
                "{}: {lines} lines: {first}",
                path.display()
            );
        }
    }
    assert!(
        count > 2000,
        "{count} functions: they are not recognised any more"
    );
    let example = "fn a(\n    b: u8,\n) {\n    c();\n}\n    pub fn d();\n";
    assert_eq!(functions(example), [("fn a(", 5), ("    pub fn d();", 1)]);
}
