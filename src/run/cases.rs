//! Cases while they run: complete ones are shown in order, and what is finished is never lost.

use std::collections::BTreeMap;
use std::io;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Mutex, OnceLock};

use super::execute::run_tasks;
use super::journal::Journal;
use super::kept::Keeps;
use super::progress::{Event, Progress};
use super::proofs::{LastProofs, Proof, keeping};
use super::results::{CaseResult, CaseScenes, Plan};
use super::row::Row;
use super::schedule::InOrder;
use super::task::{Subject, Task};
use crate::case::Case;

/// Runs every method of the plan on every scene of every case, on all cores, and judges them.
pub fn run(cases: &[Case], plan: &Plan, progress: &(dyn Fn(Event) + Sync)) -> Vec<CaseResult> {
    let scenes = plan.scenes(cases);
    let runs = CaseRuns::new(cases, &scenes, plan);
    // Without a journal nothing can fail.
    let _ = runs.run(None, progress, &|_| {});
    runs.finished().0
}

/// Cases while they run: what is finished can be taken at any moment, before the last is done.
pub struct CaseRuns<'a> {
    cases: &'a [Case],
    scenes: &'a [CaseScenes],
    tasks: Vec<Task<'a>>,
    /// The case of each task.
    case_of: Vec<usize>,
    rows: Vec<OnceLock<Row>>,
    /// Tasks of each case that are not finished.
    open: Vec<AtomicUsize>,
    results: InOrder<CaseResult>,
    /// Lower bounds of tasks that go on.
    proofs: Mutex<LastProofs>,
}

impl<'a> CaseRuns<'a> {
    /// Every method of the plan on every scene of the cases, which [`Plan::scenes`] made.
    pub fn new(cases: &'a [Case], scenes: &'a [CaseScenes], plan: &Plan<'a>) -> Self {
        let (mut tasks, mut case_of, mut open) = (Vec::new(), Vec::new(), Vec::new());
        for (index, (case, of_case)) in cases.iter().zip(scenes).enumerate() {
            let first = tasks.len();
            for &method in &plan.methods {
                for (head_joints, sides) in of_case {
                    let subject = Subject {
                        head_joints: *head_joints,
                        ..Subject::of_scenes(&case.name, sides)
                    };
                    tasks.push(Task::new(subject, method, plan.settings));
                    case_of.push(index);
                }
            }
            open.push(AtomicUsize::new(tasks.len() - first));
        }
        Self {
            cases,
            scenes,
            rows: tasks.iter().map(|_| OnceLock::new()).collect(),
            tasks,
            case_of,
            open,
            results: InOrder::default(),
            proofs: Mutex::default(),
        }
    }

    /// The tasks, in the order of the rows.
    pub fn tasks(&self) -> &[Task<'a>] {
        &self.tasks
    }

    /// Runs what the journal does not know. `show` gets each case's result as soon as those before
    /// it are shown. Without methods, every case is complete at once.
    ///
    /// # Errors
    /// Where the journal cannot be written; nothing further is begun then.
    pub fn run(
        &self,
        journal: Option<&Journal>,
        progress: &Progress,
        show: &(dyn Fn(&CaseResult) + Sync),
    ) -> io::Result<()> {
        let complete = |case: usize| {
            let result = self.result(case);
            self.results.add(case, result, |result| show(result));
        };
        for (case, open) in self.open.iter().enumerate() {
            if open.load(Ordering::SeqCst) == 0 {
                complete(case);
            }
        }
        let finished = |task: usize, row: Row| {
            self.rows[task].get_or_init(|| row);
            let case = self.case_of[task];
            if self.open[case].fetch_sub(1, Ordering::SeqCst) == 1 {
                complete(case);
            }
        };
        let keeps = Keeps::Everything;
        run_tasks(
            &self.tasks,
            &self.case_of,
            keeps,
            journal,
            &keeping(&self.proofs, progress),
            &finished,
        )
    }

    /// What is finished by now, in the order of the cases, and how many of these results were shown:
    /// the first ones. A case of which some rows are finished comes with these and names the missing
    /// ones; one without any does not come. Nothing is shown afterwards.
    pub fn finished(&self) -> (Vec<CaseResult>, usize) {
        let (mut results, waiting) = self.results.take();
        let shown = results.len();
        let mut waiting: BTreeMap<usize, CaseResult> = waiting.into_iter().collect();
        let rest = (shown..self.cases.len()).filter_map(|case| {
            waiting.remove(&case).or_else(|| {
                let result = self.result(case);
                (!result.rows.is_empty()).then_some(result)
            })
        });
        results.extend(rest);
        (results, shown)
    }

    /// What tasks that go on have proved by now.
    pub fn proofs(&self) -> Vec<Proof> {
        let proofs = self.proofs.lock().expect("no other thread panicked");
        proofs.values().cloned().collect()
    }

    /// Rows that are finished, and all.
    pub fn counts(&self) -> [usize; 2] {
        let finished = self.rows.iter().filter(|row| row.get().is_some());
        [finished.count(), self.rows.len()]
    }

    /// What is not finished.
    pub fn missing(&self) -> Vec<String> {
        let tasks = self.tasks.iter().zip(&self.rows);
        let open = tasks.filter(|(_, row)| row.get().is_none());
        open.map(|(task, _)| task.describe()).collect()
    }

    /// What the finished rows of a case come to.
    fn result(&self, case: usize) -> CaseResult {
        let (mut rows, mut missing) = (Vec::new(), Vec::new());
        let first = self.case_of.partition_point(|&of| of < case);
        let behind = self.case_of.partition_point(|&of| of <= case);
        for task in first..behind {
            match self.rows[task].get() {
                Some(row) => rows.push(row.clone()),
                None => missing.push(self.tasks[task].describe()),
            }
        }
        let scenes = self.scenes[case].clone();
        CaseResult::new(self.cases[case].clone(), scenes, rows, missing)
    }
}
