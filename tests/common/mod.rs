//! Shared by the record tests: one record a case, kept in the top-level `snapshots/`.

use std::path::Path;

use trilith::answer::Status;
use trilith::case::{self, Case};
use trilith::inside::record;
use trilith::judge::Verdict;
use trilith::method::{Settings, defaults};
use trilith::run::{CaseResult, Plan};

/// Cases whose records take tens of seconds unoptimised: they have theirs in an ignored test.
pub const LONG: [&str; 7] = [
    "cases/arches/semicircle-100-thinnest.toml",
    "cases/moves/arch-100-pushed.toml",
    "cases/moves/arch-100-spreads.toml",
    "cases/moves/facade-sinks.toml",
    "cases/published/lact3-wall.toml",
    "cases/published/vertical-cuts-stands.toml",
    "cases/walls/paper-3.toml",
];

/// The one case of a file.
fn read(path: &Path) -> Case {
    let argument = path.to_str().expect("paths of cases are UTF-8");
    let mut cases = case::find(argument).unwrap_or_else(|complaint| panic!("{complaint}"));
    assert_eq!(cases.len(), 1);
    cases.remove(0)
}

/// Runs all methods, compares the record with the snapshot named after the case, and asserts that
/// nothing failed and no reference is violated: accepting a snapshot cannot hide that.
pub fn assert_record(path: &Path) {
    let case = read(path);
    let name = case.name.clone();
    let plan = Plan {
        methods: defaults(),
        settings: Settings::default(),
        head_joints: None,
    };
    let results = trilith::run::run(&[case], &plan, &|_| {});
    let [result] = results.as_slice() else {
        panic!("one case gives one result");
    };
    let mut settings = insta::Settings::clone_current();
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("snapshots");
    settings.set_snapshot_path(folder);
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    settings.bind(|| insta::assert_snapshot!(name, record(result)));
    assert_sound(result);
}

fn assert_sound(result: &CaseResult) {
    for row in &result.rows {
        let reason = &row.outcome.reason();
        assert_ne!(
            row.outcome.status,
            Status::Failed,
            "{}: {reason}",
            row.method
        );
    }
    for check in &result.checks {
        assert_ne!(check.verdict, Verdict::Violated, "{}", check.text);
    }
}
