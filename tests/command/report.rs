//! The report as text: what it holds, what it must not hold, and how large it is.

use std::path::Path;

use trilith::case::find;
use trilith::inside::page;
use trilith::inside::sweep::SweepTable;
use trilith::method::{Settings, methods as all_methods};
use trilith::run::{CaseResult, Plan, run};
use trilith::scene::HeadJoints;

fn results(cases: &[&str], methods: &[&str]) -> Vec<CaseResult> {
    let cases: Vec<_> = cases.iter().flat_map(|name| find(name).unwrap()).collect();
    let wanted = all_methods()
        .into_iter()
        .filter(|m| methods.contains(&m.name()));
    let mut settings = Settings::default();
    settings.pushover.recording = true;
    let plan = Plan {
        methods: wanted.collect(),
        settings,
        head_joints: Some(HeadJoints::Open),
    };
    run(&cases, &plan, &|_| {})
}

fn written(results: &[CaseResult], sweeps: &[SweepTable]) -> String {
    page(results, &Settings::default(), sweeps, None)
}

#[test]
fn a_page_holds_everything_and_asks_for_nothing() {
    let mut results = results(
        &["paper-1"],
        &["macro-block", "associative", "interval", "pushover"],
    );
    results[0].case.title = "</script><b>wall</b>".to_owned();
    let html = written(&results, &[]);
    for part in [
        "Nothing is violated.",
        "0.48712 – 0.94545",
        "class=\"replay\"",
        "equilibrium",
        "penetration",
        "Self-checks of pushover",
        "Known limitations",
        "clarabel",
        "&lt;/script&gt;&lt;b&gt;wall",
    ] {
        assert!(html.contains(part), "{part}");
    }
    // No address but the name of SVG's elements, and two scripts: the page's own and the poses.
    let addresses = html.matches("://").count();
    assert_eq!(
        addresses,
        html.matches("xmlns=\"http://www.w3.org/2000/svg\"").count()
    );
    assert_eq!(
        html.matches("<script").count(),
        html.matches("</script>").count()
    );
    assert_eq!(html.matches("<script").count(), 2);
    assert_eq!(html, written(&results, &[]));
}

#[test]
fn the_page_of_a_large_wall_stays_small() {
    let results = results(&["paper-3"], &["macro-block", "associative"]);
    let html = written(&results, &[]);
    // The paper's cases hold seven such drawings and a replay: under 5 MB together.
    assert!(html.len() < 500_000, "{} bytes", html.len());
}

#[test]
fn a_sweep_is_read_or_refused() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("overburden.csv");
    let read = |path: &Path| SweepTable::read(path);
    assert!(read(&path).is_err_and(|e| e.to_string().starts_with("cannot read ")));
    std::fs::write(&path, "case,method,lower\n").unwrap();
    let refused = read(&path).err().unwrap().to_string();
    assert!(
        refused.contains("line 1: there is no column `upper`"),
        "{refused}"
    );
    let rows = "a,macro-block,0.4,0.9,x,0\na,macro-block,0.3,0.8,x,1\na,interval,0.5,0.5,x,0\n";
    std::fs::write(
        &path,
        format!("case,method,lower,upper,reason,overburden\n{rows}"),
    )
    .unwrap();
    let table = read(&path).unwrap();
    let html = written(&[], &[table]);
    assert!(html.contains(">Overburden</h2>"));
    assert!(html.contains("overburden ratio p/(γH)") && html.contains("3 points as a table"));
}
