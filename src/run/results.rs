//! Cases: every method of a plan on every scene, as rows with the checks about them.

use std::borrow::Cow;

use super::row::Row;
use crate::answer::{Bracket, Evidence, Fact, LimitFact, Outcome, PushoverFact};
use crate::case::Case;
use crate::judge::{
    Check, Conclusion, conclude, cross_check, of_wall, open_never_raises, reference_checks,
};
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

    /// A row and its scene for the push that governs the wall, whichever governs the row itself, so that
    /// methods are drawn side by side for the same push.
    pub fn governing<'a>(&'a self, row: &'a Row) -> (&'a Scene, Cow<'a, Row>) {
        let mut conclusions = self.conclusions.iter();
        let of_row = conclusions.find(|conclusion| conclusion.head_joints == row.head_joints);
        let push = of_row.map_or(row.push, |conclusion| conclusion.push);
        let row = match row.side(push) {
            Some(_) => row.of_side(push),
            None => Cow::Borrowed(row),
        };
        (self.side(row.head_joints, row.push), row)
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
        let of_sides = conclusions(&scenes, &rows);
        for conclusion in of_sides.iter().flatten() {
            let of_setting = |row: &&mut Row| row.head_joints == conclusion.head_joints;
            for row in rows.iter_mut().filter(of_setting) {
                row.change_side(conclusion.push, |outcome| {
                    name_bound(outcome, conclusion);
                    name_states(outcome, conclusion);
                });
            }
        }
        let conclusions = of_sides.into_iter().map(of_wall).collect();
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
#[derive(Clone, Default)]
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

/// The answers for one side of the push.
fn answers<'a>(rows: &'a [Row], scene: &Scene) -> Vec<(&'a str, &'a Outcome)> {
    let of_setting = rows
        .iter()
        .filter(|row| row.head_joints == scene.head_joints());
    of_setting
        .filter_map(|row| Some((row.method.as_str(), row.side(scene.push())?)))
        .collect()
}

/// Where another method proves a higher lower bound, says so instead of that none is known.
fn name_bound(outcome: &mut Outcome, conclusion: &Conclusion) {
    // Of a support that moves, the conclusion alone has the proof in terms of the reaction.
    let Some(floor) = conclusion
        .floor
        .as_ref()
        .filter(|_| conclusion.reaction.is_none())
    else {
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

/// Where a scene has several collapse states, says of what was seen that it is not their range.
fn name_states(outcome: &mut Outcome, conclusion: &Conclusion) {
    let is_seen = matches!(outcome.evidence, Evidence::Observed(_)) && outcome.bracket().is_some();
    let lowest = conclusion.bracket.filter(|_| is_seen);
    let Some((lowest, highest)) = lowest.zip(conclusion.highest_state) else {
        return;
    };
    let states = Bracket {
        lower: lowest.lower,
        upper: highest,
    };
    outcome
        .facts
        .push(PushoverFact::OfSeveral { states }.into());
}

fn checks(case: &Case, scenes: &[(HeadJoints, Vec<Scene>)], rows: &[Row]) -> Vec<Check> {
    let mut checks = Vec::new();
    for (head_joints, sides) in scenes {
        // What holds between methods holds for one and the same scene.
        for scene in sides {
            let of_side = cross_check(scene, &answers(rows, scene));
            checks.extend(of_side.into_iter().map(|check| named(check, scene, sides)));
        }
        let unit = sides.first().map_or(1.0, Scene::multiplier_unit);
        let of_setting = rows.iter().filter(|row| row.head_joints == *head_joints);
        let computed = of_setting.map(|row| (row.method.as_str(), row.computed()));
        let computed: Vec<_> = computed.collect();
        checks.extend(reference_checks(case, *head_joints, &computed, unit));
    }
    let sides = |wanted| {
        let found = scenes.iter().find(|(setting, _)| *setting == wanted);
        found.map_or(&[][..], |(_, sides)| sides)
    };
    let open = sides(HeadJoints::Open);
    for (contact, open_scene) in sides(HeadJoints::Contact).iter().zip(open) {
        let of_side = open_never_raises(
            (contact, &answers(rows, contact)),
            (open_scene, &answers(rows, open_scene)),
        );
        checks.extend(
            of_side
                .into_iter()
                .map(|check| named(check, open_scene, open)),
        );
    }
    checks
}

/// A check about one side, which names it where there are two.
pub(crate) fn named(check: Check, scene: &Scene, sides: &[Scene]) -> Check {
    if scene.reaction().is_some() {
        let text = format!("by the change of the reaction, {}", check.text);
        return Check { text, ..check };
    }
    if sides.len() < 2 {
        return check;
    }
    let text = format!("pushed to the {}, {}", scene.push().name(), check.text);
    Check { text, ..check }
}

/// The conclusions about every side, by head-joint setting.
fn conclusions(scenes: &[(HeadJoints, Vec<Scene>)], rows: &[Row]) -> Vec<Vec<Conclusion>> {
    let of_sides = |sides: &Vec<Scene>| {
        let sides = sides.iter();
        sides
            .map(|scene| conclude(scene, &answers(rows, scene)))
            .collect()
    };
    let with_sides = scenes.iter().filter(|(_, sides)| !sides.is_empty());
    with_sides.map(|(_, sides)| of_sides(sides)).collect()
}
