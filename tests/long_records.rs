//! Records that take minutes unoptimised; CI runs them in release with `--include-ignored`.

mod common;

use std::path::Path;

#[test]
#[ignore = "the pushover of 1176 blocks takes tens of seconds"]
fn pushover_of_paper_3() {
    let case = common::read(Path::new("cases/walls/paper-3.toml"));
    assert!(common::is_long(&case));
    common::assert_record(case, "paper-3.pushover", |method| method == "pushover");
}
