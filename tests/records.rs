//! One record test a case file. `cargo insta review` is how a change of results is accepted. Of long
//! cases `long_records` has it.

mod common;

use std::path::Path;

fn record(path: &Path) -> datatest_stable::Result<()> {
    if !common::LONG.iter().any(|long| path.ends_with(long)) {
        common::assert_record(path);
    }
    Ok(())
}

datatest_stable::harness! {
    { test = record, root = "cases", pattern = r"^(?!.*\.sweep\.toml$).*\.toml$" },
}
