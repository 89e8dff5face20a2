//! Undecided or a right answer, never a confident wrong one.

use crate::random_walls::truth;
use trilith::answer::{Checked, Fact, Outcome, Status};
use trilith::inside::PushoverFact;
use trilith::inside::{Parameters, solve_with};
use trilith::method::{PushoverSettings, Settings};
use trilith::scene::{Course, HeadJoints, Own, Piece, Point, Push, Scene, Side, Vector, Wall};

/// paper-1 and its verified open value (HiGHS through `oracle.py --start open`).
const PAPER_1: f64 = 0.639969;

fn course(text: &str) -> Course {
    let piece = |kind| match kind {
        'h' => Piece::Half,
        _ => Piece::Unit,
    };
    text.chars().map(piece).collect()
}

fn wall(unit: [f64; 2], friction: f64, courses: &[&str]) -> Wall {
    Wall {
        unit_length: unit[0],
        unit_height: unit[1],
        thickness: 1.0,
        unit_weight: 1.0,
        courses: courses.iter().map(|text| course(text)).collect(),
        friction: friction.into(),
        overburden: 0.0,
        push: Push::Right,
        own: Own::default(),
    }
}

fn paper_1() -> Wall {
    wall([4.0, 1.75], 0.65, &["h1111h", "11111"].repeat(3))
}

fn open(wall: &Wall) -> Scene {
    wall.scene(HeadJoints::Open).expect("the wall can be laid")
}

fn with(scene: &Scene, change: impl Fn(Parameters) -> Parameters) -> Outcome {
    solve_with(scene, &PushoverSettings::default(), change)
}

fn pushed(scene: &Scene) -> Outcome {
    with(scene, |own| own)
}

/// Why a scene may be refused.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Refused {
    /// It sank or spread by more than contacts give under its weight.
    Settled,
    /// The engine has no contact at a joint.
    Unseen,
    /// Contacts beyond what the substep can hold.
    TooStiff,
}

/// Asserts an answer within `tolerance` of `exact`, or undecided for this very reason; whether it is
/// answered. Tests ask for a least number of answers, so that no refusal passes for one.
fn is_answered(
    what: &str,
    outcome: &Outcome,
    exact: f64,
    tolerance: f64,
    refused: Option<Refused>,
) -> bool {
    if let Some(bracket) = outcome.bracket() {
        assert!(
            bracket.error(exact, 1.0) <= tolerance,
            "{what}: {bracket:?} for {exact}: {:?}",
            outcome.evidence.checks()
        );
        return true;
    }
    assert_eq!(outcome.status, Status::Undecided, "{what}");
    let why = outcome.facts.iter().find_map(|fact| match fact {
        Fact::Pushover(PushoverFact::TooStiff) => Some(Refused::TooStiff),
        Fact::Pushover(PushoverFact::Checked(check) | PushoverFact::SelfCheckFailed(check)) => {
            match check.what {
                Checked::Settlement => Some(Refused::Settled),
                Checked::UnseenJoints { .. } => Some(Refused::Unseen),
                _ => None,
            }
        }
        _ => None,
    });
    let reason = outcome.reason();
    assert!(why.is_some() && why == refused, "{what}: {reason}");
    false
}

fn assert_answered(what: &str, outcome: &Outcome, exact: f64, tolerance: f64) {
    is_answered(what, outcome, exact, tolerance, None);
}

/// dt 1/60 s in 4 substeps, frequency 30 / s, damping ratio 5, prediction 0.002 length units,
/// here with courses of 1.75 m: their unit of time is 0.42 s.
#[test]
fn rapiers_default_parameters() {
    let second = (9.81f64 / 1.75).sqrt();
    let outcome = with(&open(&paper_1()), |own| Parameters {
        substep: second / 240.0,
        substeps: 4,
        contact_frequency: 30.0 / second,
        damping_ratio: 5.0,
        prediction: 0.002,
        ..own
    });
    // Its contacts are softer than what the check of the settlement lets pass.
    let refused = Some(Refused::Settled);
    is_answered("default parameters", &outcome, PAPER_1, 2e-3, refused);
}

#[test]
fn too_few_substeps() {
    let mut answered = 0;
    for factor in [2.0, 4.0, 8.0, 16.0, 32.0] {
        let outcome = with(&open(&paper_1()), |own| Parameters {
            substep: own.substep * factor,
            substeps: (32.0 / factor) as usize,
            contact_frequency: own.contact_frequency / factor,
            ..own
        });
        let what = format!("substep × {factor}");
        let soft = is_answered(&what, &outcome, PAPER_1, 2e-3, Some(Refused::Settled));
        // Contacts as stiff as the short substep allowed: beyond what the solver can hold.
        let outcome = with(&open(&paper_1()), |own| Parameters {
            substep: own.substep * factor,
            substeps: (32.0 / factor) as usize,
            ..own
        });
        let what = format!("substep × {factor}, stiff");
        is_answered(&what, &outcome, PAPER_1, 2e-3, Some(Refused::TooStiff));
        answered += usize::from(soft);
    }
    assert!(answered >= 1, "twice the substep is short enough");
}

#[test]
fn other_units_and_a_far_origin() {
    for scale in [1e-3, 1e3] {
        let wall = Wall {
            unit_length: 4.0 * scale,
            unit_height: 1.75 * scale,
            ..paper_1()
        };
        assert_answered(
            &format!("scale {scale}"),
            &pushed(&open(&wall)),
            PAPER_1,
            1e-3,
        );
    }
    let far = moved(&open(&paper_1()), |_, p| p + Vector::new(1e6, -1e6));
    assert_answered("1e6 away", &pushed(&far), PAPER_1, 1e-3);
}

/// Every corner and load through `to`, which gets the block too (`None`: a support).
fn moved(scene: &Scene, to: impl Fn(Option<usize>, Point) -> Point) -> Scene {
    let moved = scene.moved(|body, point| match body {
        Side::Block(block) => to(Some(block), point),
        Side::Support(_) => to(None, point),
    });
    moved.expect("as valid as before")
}

/// Every course 1 % of a unit's length too low, so that it overlaps the one below: the joints, and with
/// them the multiplier, are those of lower courses.
#[test]
fn an_initial_overlap() {
    let overlapping = moved(&open(&paper_1()), |id, p| match id {
        Some(id) => {
            let course = (0..6).rev().find(|c| id >= [0, 6, 11, 17, 22, 28][*c]);
            p - Vector::new(0.0, 0.04 * (1 + course.unwrap_or(0)) as f64)
        }
        None => p,
    });
    let exact = truth(&overlapping).expect("it is verified");
    assert!(exact.lower > 1.01 * PAPER_1, "{exact:?}");
    let (seen, refused) = (pushed(&overlapping), Some(Refused::Settled));
    is_answered("overlap", &seen, exact.lower, 2e-3, refused);
    // One block alone.
    let one = moved(&open(&paper_1()), |id, p| match id {
        Some(13) => p - Vector::new(0.0, 0.04),
        _ => p,
    });
    is_answered(
        "overlap of one block",
        &pushed(&one),
        PAPER_1,
        2e-3,
        Some(Refused::Unseen),
    );
}

/// Without friction nothing can be pushed. With much, the pushover stands between its value at
/// μ = 0.65 and the associative one of the same scene (verified to 1e-6 by the linear programs).
#[test]
fn little_and_much_friction() {
    let smooth = Wall {
        friction: 0.0.into(),
        ..paper_1()
    };
    let outcome = pushed(&open(&smooth));
    let still = outcome
        .bracket()
        .is_some_and(|b| b.lower == 0.0 && b.upper <= 1e-4);
    assert!(still, "{outcome:?}");
    let rough = Wall {
        friction: 3.0.into(),
        ..paper_1()
    };
    let outcome = pushed(&open(&rough));
    let associative = trilith::inside::METHODS
        .iter()
        .find(|m| m.name() == "associative");
    let highest = associative.and_then(|m| {
        m.method
            .solve(&open(&rough), &Settings::default())
            .bracket()
    });
    let highest = highest.expect("associative answers").upper;
    let sound = outcome
        .bracket()
        .is_some_and(|b| b.lower <= highest * 1.002 && b.lower >= 0.639);
    assert!(sound, "{:?} above {highest}", outcome.bracket());
}

/// The top course 100 and 1000 times heavier, against the associative open value of the same scene
/// (verified to 1e-6 by the linear programs).
#[test]
fn a_heavy_top_course() {
    for factor in [100.0, 1000.0] {
        let scene = open(&paper_1());
        let top = scene.bounds().1.y;
        let scene = scene.with_loads(|load, shape| {
            if (shape.bounds().1.y - top).abs() < 1e-9 {
                load.dead *= factor;
                load.live *= factor;
            }
        });
        let associative = trilith::inside::METHODS
            .iter()
            .find(|m| m.name() == "associative");
        let exact =
            associative.and_then(|m| m.method.solve(&scene, &Settings::default()).bracket());
        let exact = exact.expect("associative answers").upper;
        let what = format!("top × {factor}");
        assert_answered(&what, &pushed(&scene), exact, 2e-3);
    }
}

/// min(μ, b/h) and min(μ, b/H), in closed form.
#[test]
fn slender_blocks_and_columns() {
    for slender in [0.5, 0.2, 0.1, 0.05] {
        let block = wall([slender, 1.0], 0.65, &["1"]);
        assert_answered(
            &format!("b/h {slender}"),
            &pushed(&open(&block)),
            slender,
            2e-3,
        );
    }
    for (count, friction) in [(2, 0.65), (5, 0.65), (10, 0.65), (10, 0.05), (20, 0.65)] {
        let column = wall([1.0, 0.5], friction, &vec!["1"; count]);
        let exact = f64::min(friction, 2.0 / count as f64);
        let what = format!("column of {count}, μ {friction}");
        assert_answered(&what, &pushed(&open(&column)), exact, 2e-3);
    }
}

/// The whole scene turned by 0.2 rad, gravity and push with it: slanted polygons instead of level
/// rectangles, the same λ.
#[test]
fn a_turned_scene() {
    let (sin, cos) = 0.2f64.sin_cos();
    let turn = |v: Vector| Vector::new(cos * v.x - sin * v.y, sin * v.x + cos * v.y);
    let turned = moved(&open(&paper_1()), |_, p| Point::from(turn(p.coords)));
    let turned = turned
        .with_loads(|load, _| (load.dead, load.live) = (turn(load.dead), turn(load.live)))
        .without_wall();
    assert_answered("turned", &pushed(&turned), PAPER_1, 2e-3);
}

/// Tilting the ground by atan λ is the same as pushing: with gravity tilted half way the push that
/// is left is the other half; tilted beyond the limit the wall has none.
#[test]
fn tilted_gravity() {
    for (lambda, stands) in [(PAPER_1 * 0.5, true), (PAPER_1 * 1.01, false)] {
        let tilted = open(&paper_1()).with_loads(|load, _| load.dead += load.live * lambda);
        let outcome = pushed(&tilted);
        match outcome.bracket() {
            // λ counts on from the tilt.
            Some(rest) => {
                assert!(stands, "{rest:?}");
                let sum = (lambda + rest.lower, lambda + rest.upper);
                let near = |end: f64| (end - PAPER_1).abs() <= 2e-3 * PAPER_1;
                assert!(near(sum.0) && near(sum.1), "{sum:?}");
            }
            None => {
                assert!(!stands, "{}", outcome.reason());
                assert_eq!(outcome.status, Status::Falls, "{}", outcome.reason());
            }
        }
    }
}
