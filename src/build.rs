//! What is made before compiling: the fingerprint of everything the program is compiled from, so
//! that a sweep never takes an answer of another program for its own; and the lists of the files
//! below `cases/`, which are embedded in the program.

#[path = "fingerprint.rs"]
mod fingerprint;

use std::cmp::Ordering;
use std::env;
use std::fmt::Write;
use std::fs;
use std::path::{Path, PathBuf};

use fingerprint::Fingerprint;

fn main() {
    for entry in fs::read_dir("src").into_iter().flatten().flatten() {
        let path = entry.path();
        if path != Path::new(PYTHON) {
            println!("cargo::rerun-if-changed={}", path.display());
        }
    }
    println!("cargo::rerun-if-changed=cases");
    println!("cargo::rerun-if-changed=Cargo.lock");
    println!("cargo::rustc-env=TRILITH_SOURCES={}", sources());
    // Half the size of the program; its backtraces read them all the same. Without -O2 lld compresses
    // with the lowest level of zlib.
    if env::var("CARGO_CFG_TARGET_OS").is_ok_and(|system| system == "linux") {
        println!("cargo::rustc-link-arg-bins=-Wl,-O2,--compress-debug-sections=zlib");
    }
    embed();
}

/// The module that drives the program, which is no part of it.
const PYTHON: &str = "src/python";

/// Fingerprint of the sources, of the cases that are built in, and of the versions of the
/// dependencies.
fn sources() -> String {
    let mut files = vec!["Cargo.lock".to_owned()];
    files.extend(files_below(Path::new("src")));
    files.extend(files_below(Path::new("cases")));
    files.retain(|path| !path.starts_with(CERTIFICATES) && !Path::new(path).starts_with(PYTHON));
    files.sort();
    let mut sources = Fingerprint::new();
    for file in files {
        sources.add(file.as_bytes());
        // A package without a lock file is compiled all the same.
        sources.add(&fs::read(&file).unwrap_or_default());
    }
    sources.hex()
}

/// The paths of all files below a folder, with `/` between their parts, in any order.
fn files_below(folder: &Path) -> Vec<String> {
    let mut files = Vec::new();
    for entry in fs::read_dir(folder).into_iter().flatten().flatten() {
        let path = entry.path();
        if path.is_dir() {
            files.extend(files_below(&path));
        } else {
            files.push(path.to_string_lossy().replace('\\', "/"));
        }
    }
    files
}

/// What is proved of cases, which is no part of them: it is read where it lies, and the program knows
/// the names.
const CERTIFICATES: &str = "cases/certificates/";

/// What comes first among the cases. All others follow by path.
const FIRST: [&str; 6] = [
    "cases/walls/paper-1.toml",
    "cases/walls/paper-2.toml",
    "cases/walls/paper-3.toml",
    "cases/walls/",
    "cases/limits/",
    "cases/columns/",
];

/// Lists the cases, the sweeps, and the files that cases may name.
fn embed() {
    let files = files_below(Path::new("cases"));
    let (mut certified, mut files): (Vec<_>, Vec<_>) = files
        .into_iter()
        .partition(|path| path.starts_with(CERTIFICATES));
    certified.sort();
    let names = certified.iter().map(|path| &path[CERTIFICATES.len()..]);
    write_out("certified.rs", &format!("&{:?}", names.collect::<Vec<_>>()));
    files.retain(|path| !path.split('/').any(|part| part.starts_with('.')));
    files.sort_by(|a, b| {
        let key = |path: &str| {
            let first = FIRST.iter().position(|first| path.starts_with(first));
            (first.unwrap_or(FIRST.len()), sort_key(path))
        };
        let order = key(a).partial_cmp(&key(b)).unwrap_or(Ordering::Equal);
        order.then_with(|| a.cmp(b))
    });
    let is_sweep = |path: &String| path.ends_with(".sweep.toml");
    let (sweeps, files): (Vec<_>, Vec<_>) = files.into_iter().partition(is_sweep);
    let is_case = |path: &String| path.ends_with(".toml");
    let (cases, files): (Vec<_>, Vec<_>) = files.into_iter().partition(is_case);
    write_list("embedded_cases.rs", &cases);
    write_list("embedded_files.rs", &files);
    write_list("embedded_sweeps.rs", &sweeps);
}

/// Writes an expression: a slice of (path, text of the file).
fn write_list(name: &str, paths: &[String]) {
    let mut list = String::from("&[\n");
    for path in paths {
        let file = format!(
            "concat!(env!(\"CARGO_MANIFEST_DIR\"), {:?})",
            format!("/{path}")
        );
        let _ = writeln!(list, "    ({path:?}, include_str!({file})),");
    }
    list.push_str("]\n");
    write_out(name, &list);
}

/// Writes a file that the sources include.
fn write_out(name: &str, text: &str) {
    let folder = PathBuf::from(env::var_os("OUT_DIR").expect("cargo names a folder"));
    fs::write(folder.join(name), text).expect("cargo's folder can be written to");
}

/// The characters of a path, every number in it as one: `column-2` is before `column-10`.
fn sort_key(path: &str) -> Vec<(char, f64)> {
    let mut key = Vec::new();
    let mut rest = path;
    while let Some(letter) = rest.chars().next() {
        let length = number_length(rest);
        if let Ok(number) = rest[..length].parse() {
            key.push(('0', number));
            rest = &rest[length..];
        } else {
            key.push((letter, 0.0));
            rest = &rest[letter.len_utf8()..];
        }
    }
    key
}

/// Length of the number that a text begins with, such as `10` or `0.25`; 0 where it does not.
fn number_length(text: &str) -> usize {
    let digits =
        |text: &str| text.len() - text.trim_start_matches(|c: char| c.is_ascii_digit()).len();
    let whole = digits(text);
    match text[whole..].strip_prefix('.').map(digits) {
        Some(decimals) if whole > 0 && decimals > 0 => whole + 1 + decimals,
        _ => whole,
    }
}
