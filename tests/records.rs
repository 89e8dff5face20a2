//! One record test a case file. `cargo insta review` is how a change of results is accepted. Of long
//! cases `long_records` has it.

mod common;

use std::path::Path;

fn record(path: &Path) -> datatest_stable::Result<()> {
    let case = common::read(path);
    let name = case.name.clone();
    if !common::is_long(&case) {
        common::assert_record(case, &name, |_| true);
    }
    Ok(())
}

datatest_stable::harness! {
    { test = record, root = "cases", pattern = r"^(?!.*\.sweep\.toml$).*\.toml$" },
}
