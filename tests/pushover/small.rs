//! Small scenes with known multipliers (sources with each test). All figures are dimensionless.

use crate::scenes;
use trilith::answer::{Bracket, Outcome, Status};
use trilith::method::pushover::Pushover;
use trilith::method::{Method, Settings};
use trilith::scene::{HeadJoints, Polygon, Push, Scene, SceneParts, Vector, Wall};

fn wall([unit_length, unit_height]: [f64; 2], friction: f64, courses: &[&str]) -> Wall {
    Wall {
        unit_length,
        unit_height,
        ..scenes::wall(courses, friction)
    }
}

fn paper_1() -> Wall {
    scenes::wall(&["h1111h", "11111"].repeat(3), 0.65)
}

fn pushover(scene: &Scene) -> Outcome {
    Pushover.solve(scene, &Settings::default())
}

fn pushed(wall: &Wall) -> Outcome {
    pushover(&wall.scene(HeadJoints::Open).unwrap())
}

fn bracket(outcome: &Outcome) -> Bracket {
    outcome
        .bracket()
        .unwrap_or_else(|| panic!("{}", outcome.reason()))
}

/// A block b × h on a plane: λ = min(μ, b/h), in closed form; within 1e-3, in both directions.
#[test]
fn a_block_slides_or_rocks() {
    for (unit, friction, exact) in [
        ([4.0, 1.75], 0.3, 0.3),
        ([1.0, 4.0], 0.65, 0.25),
        ([0.05, 1.0], 0.65, 0.05),
    ] {
        for push in [Push::Right, Push::Left] {
            let block = Wall {
                push,
                ..wall(unit, friction, &["1"])
            };
            let outcome = pushed(&block);
            assert!(bracket(&outcome).error(exact, 1.0) < 1e-3, "{outcome:?}");
        }
    }
}

/// A stack of total height H: λ = min(μ, b/H), in closed form; within 1e-3.
#[test]
fn a_stack_slides_or_rocks() {
    for (friction, exact) in [(0.3, 0.3), (0.65, 0.4)] {
        let stack = wall([1.0, 0.5], friction, &["1"; 5]);
        assert!(bracket(&pushed(&stack)).error(exact, 1.0) < 1e-3);
    }
}

/// paper-1 with open head joints: 0.639969, verified by linear programs that share no code with
/// this method; c = 8, e = 12 as published (tan β = 0.7619). Within 0.1 %, no wider than 0.1 %.
#[test]
fn the_first_wall_of_the_paper() {
    let outcome = pushed(&paper_1());
    assert_eq!(outcome.status, Status::Bracketed, "{}", outcome.reason());
    let bracket = bracket(&outcome);
    assert!(bracket.error(0.639969, 1.0) < 1e-3 && bracket.relative_width(1.0) < 1e-3);
    let crack = outcome.evidence.observed().unwrap().crack.unwrap();
    assert_eq!((crack.c, crack.e), (Some(8.0), Some(12.0)));
    assert_eq!(outcome.evidence.checks().len(), 6);
}

/// Lengths and the origin do not matter: millimetres, and 10⁶ course heights away. Push to the
/// left, so that this is a mirrored run too.
#[test]
fn scale_origin_and_direction_do_not_matter() {
    let small = Wall {
        unit_length: 4e-3,
        unit_height: 1.75e-3,
        unit_weight: 1e-6,
        push: Push::Left,
        ..paper_1()
    };
    let scene = small.scene(HeadJoints::Open).unwrap();
    let away = Vector::new(1750.0, -1750.0);
    let scene = scene.moved(|_, point| point + away).unwrap();
    let outcome = pushover(&scene);
    assert!(
        bracket(&outcome).error(0.639969, 1.0) < 1e-3,
        "{}",
        outcome.reason()
    );
}

#[test]
fn the_same_run_gives_the_same_bits() {
    let column = wall([4.0, 1.75], 0.65, &["1", "hh", "1"]);
    let (one, other) = (pushed(&column), pushed(&column));
    assert_eq!(one.bracket(), other.bracket());
    assert_eq!(one.evidence.mechanism(), other.evidence.mechanism());
    assert_eq!(one.evidence.checks(), other.evidence.checks());
    assert_eq!(one.work, other.work);
}

#[test]
fn without_friction_nothing_can_be_pushed() {
    let slippery = wall([4.0, 1.75], 0.0, &["1"]);
    let (lower, upper) = (0.0, 1e-5);
    assert_eq!(bracket(&pushed(&slippery)), Bracket { lower, upper });
}

#[test]
fn what_cannot_be_answered_is_undecided() {
    // Nothing pushes: it stands at every λ, and no number is made of that.
    let unpushed = wall([4.0, 1.75], 0.65, &["1"])
        .scene(HeadJoints::Open)
        .unwrap()
        .with_loads(|load, _| load.live = Vector::zeros());
    let outcome = pushover(&unpushed);
    assert!(outcome.status == Status::Undecided && outcome.bracket().is_none());
}

/// Every joint slides with its own coefficient: a stack of five, of which the fourth joint is the
/// smoothest (λ = 0.1); with rough joints it rocks (λ = b/H = 0.4). Closed forms, within 1e-3.
#[test]
fn every_joint_has_its_own_friction() {
    let rough = wall([1.0, 0.5], 0.65, &["1"; 5]);
    let scene = rough.scene(HeadJoints::Open).unwrap();
    for (fourth, lambda) in [(0.1, 0.1), (0.8, 0.4)] {
        let coefficients = [0.9, 0.5, 0.6, fourth, 0.7];
        let scene = scene.clone().with_friction(|joint, _| coefficients[joint]);
        assert!(bracket(&pushover(&scene)).error(lambda, 1.0) < 1e-3);
    }
}

/// A block whose centre of mass lies beyond the edge of its support.
#[test]
fn an_overhanging_block_falls() {
    let whole = wall([4.0, 1.75], 0.65, &["1"])
        .scene(HeadJoints::Open)
        .unwrap();
    let ground = Polygon::rectangle(-10.0, 1.5, -1.75, 0.0).unwrap();
    let parts = SceneParts::new(whole.blocks().to_vec(), vec![ground], 0.65);
    let scene = Scene::new(parts).unwrap();
    let outcome = pushover(&scene);
    assert_eq!(outcome.status, Status::Falls, "{}", outcome.reason());
}

/// The large atlas found it: contacts so soft that the wall sinks through them.
#[test]
fn a_wall_let_down_by_soft_contacts_is_undecided() {
    let scene = wall([4.0, 1.75], 0.65, &["h1h", "11"])
        .scene(HeadJoints::Open)
        .unwrap();
    let mut soft = Settings::default();
    soft.pushover.substep = 64.0;
    soft.pushover.stiffness = 1.0 / 256.0;
    let outcome = Pushover.solve(&scene, &soft);
    assert_eq!(outcome.status, Status::Undecided, "{}", outcome.reason());
}
