//! Fingerprint of everything the program is compiled from, so that a sweep never takes an answer of
//! another program for its own.

#[path = "fingerprint.rs"]
mod fingerprint;

use std::fs;
use std::path::{Path, PathBuf};

use fingerprint::Fingerprint;

fn main() {
    println!("cargo::rerun-if-changed=src");
    println!("cargo::rerun-if-changed=Cargo.lock");
    let mut files = vec![PathBuf::from("Cargo.lock")];
    collect(Path::new("src"), &mut files);
    // Folders are listed in any order.
    files.sort();
    let mut sources = Fingerprint::new();
    for file in files {
        // A package without a lock file is compiled all the same.
        sources.add(file.to_string_lossy().replace('\\', "/").as_bytes());
        sources.add(&fs::read(&file).unwrap_or_default());
    }
    println!("cargo::rustc-env=TRILITH_SOURCES={}", sources.hex());
}

fn collect(folder: &Path, files: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).into_iter().flatten().flatten() {
        let path = entry.path();
        if path.is_dir() {
            collect(&path, files);
        } else {
            files.push(path);
        }
    }
}
