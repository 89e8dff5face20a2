//! A method that panics on one scene costs one failed row; all others are there.

use trilith::answer::{Outcome, Status};
use trilith::case::{Case, find};
use trilith::inside::Layout;
use trilith::inside::page;
use trilith::inside::record;
use trilith::inside::sweep;
use trilith::inside::{Subject, Task, run_rows};
use trilith::inside::{case_table, csv, library_case, library_closing};
use trilith::method::limit::Associative;
use trilith::method::{Method, Settings};
use trilith::run::{CaseResult, Plan, Row, run};
use trilith::scene::{HeadJoints, Scene};

/// λ_A, but on one block alone.
struct PanicsOnStacks;

impl Method for PanicsOnStacks {
    fn name(&self) -> &str {
        "planted"
    }

    fn solve(&self, scene: &Scene, settings: &Settings) -> Outcome {
        assert_eq!(scene.blocks().len(), 1, "a stack\nis too much");
        Associative.solve(scene, settings)
    }
}

const MESSAGE: &str = "the method panicked: assertion `left == right` failed: a stack is too much";

fn cases() -> Vec<Case> {
    let names = ["sliding-block", "stack", "rocking-block"];
    names.iter().flat_map(|name| find(name).unwrap()).collect()
}

fn results() -> Vec<CaseResult> {
    let plan = Plan {
        methods: vec![&PanicsOnStacks, &Associative],
        settings: Settings::default(),
        head_joints: Some(HeadJoints::Contact),
    };
    run(&cases(), &plan, &|_| {})
}

/// One row failed, with what the panic said; the others hold.
fn assert_one_failed<'a>(rows: impl Iterator<Item = &'a Row>, count: usize) {
    let rows: Vec<&Row> = rows.collect();
    assert_eq!(rows.len(), count);
    for row in rows {
        let planted = row.method == "planted" && row.case == "stack";
        assert_eq!(row.status() == Status::Failed, planted, "{row:?}");
        assert_eq!(row.bracket().is_none(), planted, "{row:?}");
        let reason = row.outcome.reason();
        assert!(!planted || reason.starts_with(MESSAGE), "{reason}");
    }
}

#[test]
fn in_run_check_and_report() {
    let (results, layout) = (results(), Layout::default());
    assert_eq!(results.len(), 3);
    assert_one_failed(results.iter().flat_map(|result| &result.rows), 6);
    let tables: String = results.iter().map(|r| case_table(r, layout)).collect();
    let checked: String = results
        .iter()
        .map(|result| library_case(result, layout))
        .collect();
    let checked = checked + &library_closing(&results, layout);
    assert!(
        checked.contains("\nfailed\n") && checked.contains("1 failed"),
        "{checked}"
    );
    let page = page(&results, &Settings::default(), &[], None);
    for text in [tables, csv(&results), checked, page] {
        assert!(text.contains("sliding-block"));
        assert!(text.contains(MESSAGE), "{text}");
        assert!(text.contains("rocking-block"));
    }
    assert!(record(&results[1]).contains("failed"));
}

#[test]
fn in_a_sweep() {
    let cases = cases();
    let scenes: Vec<Vec<Scene>> = (cases.iter())
        .map(|case| case.sides(HeadJoints::Contact))
        .collect();
    let methods: [&dyn Method; 2] = [&PanicsOnStacks, &Associative];
    let task = |case: &Case, sides, method| {
        Task::new(
            Subject::of_scenes(&case.name, sides),
            method,
            Settings::default(),
        )
    };
    let tasks: Vec<Task> = (cases.iter().zip(&scenes))
        .flat_map(|(case, sides)| methods.map(|method| task(case, sides, method)))
        .collect();
    let rows = run_rows(&tasks, None, &|_| {}).unwrap();
    assert_one_failed(rows.iter(), 6);
    let text = sweep::SweepTable::of("", &rows, None).csv();
    assert_eq!(text.lines().count(), 7, "{text}");
}
