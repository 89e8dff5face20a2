//! Runs methods on cases. The only place with a clock.

use cpu_time::ThreadTime;
use rayon::prelude::*;

use crate::case::Case;
use crate::judge::{Check, cross_check, judge, open_never_raises, reference_checks};
use crate::method::{Bracket, Method, Outcome, Settings};
use crate::scene::{HeadJoints, Scene};

/// The judged answer of one method for one scene of a case.
#[derive(Clone, Debug)]
pub struct Row {
    /// Head joints of the scene.
    pub head_joints: HeadJoints,
    /// Name of the method.
    pub method: &'static str,
    /// The answer, its status set by the judge.
    pub outcome: Outcome,
    /// Residual that the judge computed, where there was something to judge.
    pub residual: Option<f64>,
    /// CPU time of the method, seconds.
    pub seconds: f64,
}

/// Everything about one case.
#[derive(Clone, Debug)]
pub struct CaseResult {
    /// The case.
    pub case: Case,
    /// The scenes that were run, one a head-joint setting.
    pub scenes: Vec<(HeadJoints, Scene)>,
    /// One row a method and scene, methods in their own order, then contact before open.
    pub rows: Vec<Row>,
    /// The cross-check and the references.
    pub checks: Vec<Check>,
}

/// What to run.
#[derive(Clone)]
pub struct Plan {
    /// The methods, in the order of the rows.
    pub methods: Vec<&'static dyn Method>,
    /// Settings of the methods.
    pub settings: Settings,
    /// Head joints instead of the case's own.
    pub head_joints: Option<HeadJoints>,
}

impl Plan {
    /// Number of method runs for these cases.
    pub fn runs(&self, cases: &[Case]) -> usize {
        let scenes: usize = cases.iter().map(|case| self.scenes(case).len()).sum();
        scenes * self.methods.len()
    }

    fn scenes(&self, case: &Case) -> Vec<HeadJoints> {
        self.head_joints
            .map_or_else(|| case.head_joints.clone(), |only| vec![only])
    }
}

/// Runs every method of the plan on every scene of every case, on all cores, and judges them.
/// `finished` is called after each method run; results keep the order of the cases.
pub fn run(cases: &[Case], plan: &Plan, finished: impl Fn(&str, &str) + Sync) -> Vec<CaseResult> {
    let scenes: Vec<Vec<(HeadJoints, Scene)>> = cases
        .iter()
        .map(|case| {
            let settings = plan.scenes(case).into_iter();
            settings.map(|head| (head, case.scene(head))).collect()
        })
        .collect();
    let mut jobs = Vec::new();
    for (index, of_case) in scenes.iter().enumerate() {
        for method in &plan.methods {
            jobs.extend(
                of_case
                    .iter()
                    .map(|(head, scene)| (index, *method, *head, scene)),
            );
        }
    }
    let rows: Vec<(usize, Row)> = jobs
        .into_par_iter()
        .map(|(index, method, head_joints, scene)| {
            let row = run_one(method, &plan.settings, head_joints, scene);
            finished(&cases[index].name, method.name());
            (index, row)
        })
        .collect();
    let mut of_cases: Vec<Vec<Row>> = cases.iter().map(|_| Vec::new()).collect();
    for (index, row) in rows {
        of_cases[index].push(row);
    }
    let parts = cases.iter().zip(scenes).zip(of_cases);
    parts
        .map(|((case, scenes), rows)| CaseResult {
            checks: check(case, &scenes, &rows),
            case: case.clone(),
            scenes,
            rows,
        })
        .collect()
}

fn run_one(
    method: &'static dyn Method,
    settings: &Settings,
    head_joints: HeadJoints,
    scene: &Scene,
) -> Row {
    let clock = ThreadTime::now();
    let mut outcome = method.solve(scene, settings);
    let seconds = clock.elapsed().as_secs_f64();
    let residual = judge(scene, method.name(), &mut outcome);
    Row {
        head_joints,
        method: method.name(),
        outcome,
        residual,
        seconds,
    }
}

fn check(case: &Case, scenes: &[(HeadJoints, Scene)], rows: &[Row]) -> Vec<Check> {
    let mut checks = Vec::new();
    for (head_joints, _) in scenes {
        let of_scene = rows.iter().filter(|row| row.head_joints == *head_joints);
        let answers: Vec<_> = of_scene.map(|row| (row.method, &row.outcome)).collect();
        checks.extend(cross_check(*head_joints, &answers));
        checks.extend(reference_checks(case, *head_joints, &answers));
    }
    let associative = |head_joints| -> Option<Bracket> {
        let mut found = rows.iter().filter(|row| row.method == "associative");
        found
            .find(|row| row.head_joints == head_joints)?
            .outcome
            .bracket
    };
    let (contact, open) = (
        associative(HeadJoints::Contact),
        associative(HeadJoints::Open),
    );
    checks.extend(open_never_raises(contact, open));
    checks
}
