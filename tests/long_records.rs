//! Records that take minutes unoptimised; CI runs them in release with `--include-ignored`.

mod common;

use std::path::Path;

fn paper_3(name: &str, wanted: fn(&str) -> bool) {
    let case = common::read(Path::new("cases/walls/paper-3.toml"));
    assert!(common::is_long(&case));
    common::assert_record(case, name, wanted);
}

#[test]
#[ignore = "collapse states of 1176 blocks take a minute unoptimised"]
fn record_of_paper_3() {
    paper_3("paper-3", |method| method != "pushover");
}

#[test]
#[ignore = "the pushover of 1176 blocks takes tens of seconds"]
fn pushover_of_paper_3() {
    paper_3("paper-3.pushover", |method| method == "pushover");
}

#[test]
#[ignore = "pushovers of tens of seconds unoptimised"]
fn records_of_slow_cases() {
    for name in common::SLOW {
        let path = format!("cases/published/{name}.toml");
        common::assert_record(common::read(Path::new(&path)), name, |_| true);
    }
}
