//! What must not change the multiplier: units, place, left and right. And what may, within reason:
//! friction, overburden, a heavy top.

use crate::scenes::{laid, mirrored, scaled, shifted, small_walls, with_heavy_top};
use crate::share::share;
use trilith::answer::{Bracket, Outcome, Status};
use trilith::judge::judge;
use trilith::method::limit::{Associative, Interval};
use trilith::method::{Method, Settings};
use trilith::scene::{HeadJoints, Scene, Vector, Wall};

const BOTH: [HeadJoints; 2] = [HeadJoints::Contact, HeadJoints::Open];

fn judged(method: &dyn Method, scene: &Scene) -> Outcome {
    judged_with(method, scene, &Settings::default())
}

fn judged_with(method: &dyn Method, scene: &Scene, settings: &Settings) -> Outcome {
    let mut outcome = method.solve(scene, settings);
    let residual = judge(scene, &mut outcome).residual();
    if outcome.status == Status::Verified {
        // NaN fails, and so does nothing to judge.
        assert!(residual.is_some_and(|residual| residual <= 1e-8));
    }
    outcome
}

/// A verified bracket.
fn verified(method: &dyn Method, scene: &Scene) -> Bracket {
    let outcome = judged(method, scene);
    assert_eq!(outcome.status, Status::Verified, "{}", outcome.reason());
    outcome.bracket().expect("verified with a bracket")
}

/// λ_A and the lowest state.
fn multipliers(scene: &Scene) -> [f64; 2] {
    [
        verified(&Associative, scene).upper,
        verified(&Interval, scene).lower,
    ]
}

fn assert_same(name: &str, one: [f64; 2], other: &Scene) {
    let other = multipliers(other);
    for (a, b) in one.into_iter().zip(other) {
        assert!((a - b).abs() <= 1e-6 * a, "{name}: {one:?} {other:?}");
    }
}

type Walls = Vec<(&'static str, Wall, HeadJoints)>;

fn all_walls() -> Walls {
    let walls = small_walls().into_iter();
    let both = |(name, wall): (_, Wall)| BOTH.map(|head| (name, wall.clone(), head));
    walls.flat_map(both).collect()
}

/// paper-1 with head joints in contact, openings-3 with open ones.
fn two_walls() -> Walls {
    let walls = all_walls();
    vec![walls[0].clone(), walls[5].clone()]
}

#[test]
fn units_place_and_side_leave_the_multiplier() {
    assert_units_place_and_side_leave_the_multiplier(two_walls());
}

#[test]
#[ignore = "a minute in release: all walls"]
fn units_place_and_side_leave_the_multiplier_of_every_wall() {
    let mut walls = all_walls();
    walls.truncate(share(walls.len()));
    assert_units_place_and_side_leave_the_multiplier(walls);
}

#[test]
fn ranges_give_true_answers() {
    assert_any_friction_gives_a_true_answer(two_walls());
    assert_any_load_gives_a_true_answer(two_walls());
}

#[test]
#[ignore = "a minute in release: all walls"]
fn ranges_give_true_answers_on_every_wall() {
    assert_any_friction_gives_a_true_answer(all_walls());
    assert_any_load_gives_a_true_answer(all_walls());
}

/// Same λ_A and same lowest state to 1e-6, joints searched afresh.
fn assert_units_place_and_side_leave_the_multiplier(walls: Walls) {
    for (name, wall, head_joints) in walls {
        let scene = laid(&wall, head_joints);
        let as_it_is = multipliers(&scene);
        for length in [1e-3, 1e3] {
            assert_same(name, as_it_is, &scaled(&scene, length, 1.0));
        }
        for weight in [1e-6, 1e6] {
            assert_same(name, as_it_is, &scaled(&scene, 1.0, weight));
        }
        let far = 1e6 * wall.unit_height;
        for by in [Vector::new(far, 0.0), Vector::new(-far, far)] {
            assert_same(name, as_it_is, &shifted(&scene, by));
        }
        assert_same(name, as_it_is, &mirrored(&scene));
    }
}

/// Every ending of a wall with level beds that stands is verified or has a name; λ_A of a wall on
/// level ground is μ where it slides as a whole, and never above.
fn assert_any_friction_gives_a_true_answer(walls: Walls) {
    for (name, wall, head_joints) in walls {
        let mut last = -1e-9;
        for friction in [0.0, 1e-6, 1e-3, 0.1, 0.3, 0.5, 0.7, 1.0, 1.5, 2.0, 3.0] {
            let wall = Wall {
                friction: friction.into(),
                ..wall.clone()
            };
            let scene = laid(&wall, head_joints);
            let lambda = verified(&Associative, &scene).upper;
            // Sliding off the ground is admissible; λ_A rises with μ. Both exact.
            assert!(lambda <= friction + 1e-8, "{name} {friction}: {lambda}");
            assert!(lambda >= last - 1e-8, "{name} {friction}: {lambda} {last}");
            last = lambda;
            assert_interval_below(name, &scene, lambda);
        }
    }
}

/// With few starts: it holds for every state that is found.
fn assert_interval_below(name: &str, scene: &Scene, highest: f64) {
    let mut settings = Settings::default();
    settings.interval.starts = 4;
    let outcome = judged_with(&Interval, scene, &settings);
    match outcome.status {
        Status::Verified => {
            let bracket = outcome.bracket().expect("verified with a bracket");
            let slack = 1e-6 * highest.max(1e-3);
            assert!(bracket.lower >= -slack, "{name}: {bracket:?}");
            assert!(
                bracket.upper <= highest + slack,
                "{name}: {bracket:?} {highest}"
            );
        }
        Status::Undecided => assert!(!outcome.reason().is_empty()),
        status => panic!("{name}: {} {}", status.name(), outcome.reason()),
    }
}

/// Overburden and heavy tops: verified, and towards a limit. A wall under a load that dwarfs its
/// own weight has the multiplier of weightless blocks, so ratios 50 and 100 differ by at most 2 %.
fn assert_any_load_gives_a_true_answer(walls: Walls) {
    for (name, wall, head_joints) in walls {
        let at = |overburden: f64| {
            let scene = laid(
                &Wall {
                    overburden,
                    ..wall.clone()
                },
                head_joints,
            );
            let lambda = verified(&Associative, &scene).upper;
            assert_interval_below(name, &scene, lambda);
            lambda
        };
        let [_, _, _, b, c] = [0.0, 0.1, 1.0, 50.0, 100.0].map(at);
        assert!((b - c).abs() <= 0.02 * c, "{name}: {b} {c}");
        let heavy = |factor| {
            let scene = with_heavy_top(&laid(&wall, head_joints), factor);
            let lambda = verified(&Associative, &scene).upper;
            assert_interval_below(name, &scene, lambda);
            lambda
        };
        let [a, b] = [1e3, 2e3].map(heavy);
        assert!((a - b).abs() <= 0.002 * b, "{name}: {a} {b}");
    }
}
