//! Cases: every method of a plan on every scene, as rows with the checks about them.

use super::row::Row;
use crate::answer::{Fact, LimitFact, Outcome};
use crate::case::Case;
use crate::judge::{Check, Conclusion, conclude, cross_check, open_never_raises, reference_checks};
use crate::method::{Method, Settings};
use crate::scene::{HeadJoints, Push, Scene};

/// Everything about one case.
#[derive(Clone, Debug)]
pub struct CaseResult {
    /// The case.
    pub case: Case,
    /// What was run for each head-joint setting: one scene a direction of the push.
    pub scenes: CaseScenes,
    /// One row a method and head-joint setting, methods in their own order, then contact before
    /// open.
    pub rows: Vec<Row>,
    /// The cross-check and the references.
    pub checks: Vec<Check>,
    /// What it all comes to, one a head-joint setting.
    pub conclusions: Vec<Conclusion>,
    /// What was not finished when the run was ended early; empty where the case is complete.
    pub missing: Vec<String>,
}

impl CaseResult {
    /// The scene that a row's answer is about.
    ///
    /// # Panics
    /// Where the row is of another result.
    pub fn scene(&self, row: &Row) -> &Scene {
        self.side(row.head_joints, row.push)
    }

    /// The scene of a head-joint setting and a direction of the push.
    ///
    /// # Panics
    /// Where it did not run.
    pub fn side(&self, head_joints: HeadJoints, push: Push) -> &Scene {
        let scenes = self.scenes.iter();
        let mut of_setting = scenes.filter(|(setting, _)| *setting == head_joints);
        let sides = of_setting.next().map(|(_, sides)| sides.as_slice());
        let mut sides = sides.unwrap_or_default().iter();
        let scene = sides.find(|scene| scene.push() == push);
        scene.expect("this side ran")
    }

    /// Why the result is not complete, in words; `None` where it is.
    pub fn partial(&self) -> Option<String> {
        let missing = self.missing.join(", ");
        (!missing.is_empty()).then(|| format!("PARTIAL: not finished: {missing}"))
    }

    pub(super) fn new(
        case: Case,
        scenes: CaseScenes,
        mut rows: Vec<Row>,
        missing: Vec<String>,
    ) -> Self {
        let checks = checks(&case, &scenes, &rows);
        rows.iter_mut().for_each(|row| row.compare(&case, &checks));
        let conclusions = conclusions(&scenes, &rows);
        for conclusion in &conclusions {
            let of_setting = |row: &&mut Row| row.head_joints == conclusion.head_joints;
            for row in rows.iter_mut().filter(of_setting) {
                name_bound(&mut row.outcome, conclusion);
            }
        }
        Self {
            case,
            scenes,
            rows,
            checks,
            conclusions,
            missing,
        }
    }
}

/// What to run.
#[derive(Clone)]
pub struct Plan<'a> {
    /// The methods, in the order of the rows.
    pub methods: Vec<&'a dyn Method>,
    /// Settings of the methods.
    pub settings: Settings,
    /// Head joints instead of the case's own.
    pub head_joints: Option<HeadJoints>,
}

impl Plan<'_> {
    /// The scenes of cases, which their runs borrow.
    pub fn scenes(&self, cases: &[Case]) -> Vec<CaseScenes> {
        cases.iter().map(|case| self.of_case(case)).collect()
    }

    fn of_case(&self, case: &Case) -> CaseScenes {
        let settings = match self.head_joints {
            Some(only) => vec![only],
            None => case.head_joints.clone(),
        };
        let sides = settings.into_iter().map(|head| (head, case.sides(head)));
        sides.collect()
    }
}

/// The scenes of a case: one a direction of the push for each head-joint setting.
pub type CaseScenes = Vec<(HeadJoints, Vec<Scene>)>;

/// The answers of a head-joint setting.
fn answers(rows: &[Row], head_joints: HeadJoints) -> Vec<(&str, &Outcome)> {
    let of_setting = rows.iter().filter(|row| row.head_joints == head_joints);
    of_setting
        .map(|row| (row.method.as_str(), &row.outcome))
        .collect()
}

/// Where another method proves a higher lower bound, says so instead of that none is known.
fn name_bound(outcome: &mut Outcome, conclusion: &Conclusion) {
    let Some(floor) = &conclusion.floor else {
        return;
    };
    for fact in &mut outcome.facts {
        let Fact::Limit(LimitFact::FoundNoBounds { frictionless }) = fact else {
            continue;
        };
        if frictionless.is_none_or(|lambda| lambda < floor.lower) {
            let (proof, by) = (floor.to_string(), floor.by.clone());
            *fact = LimitFact::FoundAboveBound { proof, by }.into();
        }
    }
}

fn checks(case: &Case, scenes: &[(HeadJoints, Vec<Scene>)], rows: &[Row]) -> Vec<Check> {
    let mut checks = Vec::new();
    for (head_joints, sides) in scenes {
        // What holds between methods holds for one and the same scene.
        for scene in sides {
            let of_side = rows
                .iter()
                .filter(|row| row.head_joints == *head_joints && row.push == scene.push());
            let of_side: Vec<_> = of_side
                .map(|row| (row.method.as_str(), &row.outcome))
                .collect();
            checks.extend(cross_check(scene, &of_side));
        }
        let unit = sides.first().map_or(1.0, Scene::multiplier_unit);
        let answers = answers(rows, *head_joints);
        checks.extend(reference_checks(case, *head_joints, &answers, unit));
    }
    let scene = |wanted| {
        let found = scenes
            .iter()
            .find(|(head_joints, _)| *head_joints == wanted);
        found.and_then(|(_, sides)| sides.first())
    };
    let both = scene(HeadJoints::Contact).zip(scene(HeadJoints::Open));
    if let Some((contact, open)) = both {
        checks.extend(open_never_raises(
            (contact, &answers(rows, HeadJoints::Contact)),
            (open, &answers(rows, HeadJoints::Open)),
        ));
    }
    checks
}

fn conclusions(scenes: &[(HeadJoints, Vec<Scene>)], rows: &[Row]) -> Vec<Conclusion> {
    let with_sides = scenes.iter().filter_map(|(head_joints, sides)| {
        let scene = sides.first()?;
        Some(conclude(scene, &answers(rows, *head_joints)))
    });
    with_sides.collect()
}
