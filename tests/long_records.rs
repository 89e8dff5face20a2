//! Records that take minutes unoptimised. CI compares them, as all others, with the manual that the program
//! writes in release.

mod common;

use std::path::Path;

#[test]
#[ignore = "minutes unoptimised"]
fn records_of_long_cases() {
    for path in common::LONG {
        common::assert_record(Path::new(path));
    }
}
