//! Running a plan with progress and Ctrl-C.

use std::sync::Mutex;

use trilith::case::Case;
use trilith::run::{CaseResult, Plan, run_each};

use super::progress::Progress;
use super::{Stop, interrupt};

/// Runs the plan with progress. On Ctrl-C `keep` prints or writes the results of the cases that are
/// complete, and says where; standard error names those and the missing ones.
pub(super) fn solve(
    cases: &[Case],
    plan: &Plan,
    keep: impl FnOnce(&[CaseResult]) -> Result<String, Stop>,
) -> Vec<CaseResult> {
    let progress = Progress::new(plan.runs(cases));
    let complete: Mutex<Vec<Option<CaseResult>>> = Mutex::new(vec![None; cases.len()]);
    let take = || -> Vec<Option<CaseResult>> {
        std::mem::take(&mut *complete.lock().expect("no other thread panicked"))
    };
    let work = || {
        run_each(
            cases,
            plan,
            |case, method| progress.done(format!("{case} {method}")),
            |index, result| {
                // Empty once `leave` has taken what was there.
                let mut complete = complete.lock().expect("no other thread panicked");
                if let Some(place) = complete.get_mut(index) {
                    *place = Some(result);
                }
            },
        );
    };
    interrupt::or_leave(work, || {
        progress.clear();
        let (mut kept, mut missing) = (Vec::new(), Vec::new());
        for (case, result) in cases.iter().zip(take()) {
            match result {
                Some(result) => kept.push(result),
                None => missing.push(case.name.as_str()),
            }
        }
        let missing = missing.join(", ");
        if kept.is_empty() {
            eprintln!("interrupted: no case is complete; missing: {missing}");
            return;
        }
        let names: Vec<&str> = kept.iter().map(|kept| kept.case.name.as_str()).collect();
        match keep(&kept) {
            Ok(how) => eprintln!(
                "interrupted: {how}: {}; missing: {missing}",
                names.join(", ")
            ),
            Err(stop) => eprintln!("interrupted: {}", stop.text.trim_end()),
        }
    });
    progress.clear();
    take().into_iter().flatten().collect()
}
