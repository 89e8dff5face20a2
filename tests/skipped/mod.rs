//! Tests that cannot run on a machine say so, and are counted.

use std::fs::OpenOptions;
use std::io::Write;

/// Says why a test is skipped, also in the file that TRILITH_SKIPPED names: `.ci/run` counts its
/// lines, and fails where they are more than may be.
pub fn skipped(why: &str) {
    eprintln!("skipped: {why}");
    if let Some(path) = std::env::var_os("TRILITH_SKIPPED") {
        let file = OpenOptions::new().create(true).append(true).open(path);
        let written = file.and_then(|mut file| writeln!(file, "{why}"));
        written.expect("TRILITH_SKIPPED names a file that can be written to");
    }
}
