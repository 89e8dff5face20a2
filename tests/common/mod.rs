//! Shared by the record tests: one record a case, kept in the top-level `snapshots/`.

use std::path::Path;

use trilith::answer::Status;
use trilith::case::{self, Case};
use trilith::inside::record;
use trilith::judge::Verdict;
use trilith::method::{Settings, defaults};
use trilith::run::{CaseResult, Plan};

/// Walls of more blocks than this have their records in ignored tests: they take minutes unoptimised.
const QUICK: usize = 300;

/// Smaller cases whose pushovers take tens of seconds unoptimised.
pub const SLOW: [&str; 2] = ["lact3-wall", "vertical-cuts-stands"];

/// The one case of a file.
pub fn read(path: &Path) -> Case {
    let argument = path.to_str().expect("paths of cases are UTF-8");
    let mut cases = case::find(argument).unwrap_or_else(|complaint| panic!("{complaint}"));
    assert_eq!(cases.len(), 1);
    cases.remove(0)
}

/// Whether the case belongs to the long records.
pub fn is_long(case: &Case) -> bool {
    let blocks = |head| case.scene(head).blocks().len();
    SLOW.contains(&case.name.as_str()) || case.head_joints.iter().any(|&head| blocks(head) > QUICK)
}

/// Runs the methods that `wanted` names, compares the record with the snapshot `name`, and asserts
/// that nothing failed and no reference is violated: accepting a snapshot cannot hide that.
pub fn assert_record(case: Case, name: &str, wanted: impl Fn(&str) -> bool) {
    let methods = defaults().into_iter().filter(|m| wanted(m.name()));
    let plan = Plan {
        methods: methods.collect(),
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
