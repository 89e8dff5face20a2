//! The pushover on scenes that are no coursed walls, slender or rougher than the paper's: a right
//! answer or none.

use crate::scenes::{arch, ground, homogeneous, laid, rectangle, scene, wall};
use trilith::answer::Status;
use trilith::method::pushover::Pushover;
use trilith::method::{Method, Settings};
use trilith::scene::{HeadJoints, Scene};

/// Asserts a bracket within `error` of `[low, high]`, or a refusal with a reason.
fn assert_right_or_refused(name: &str, scene: &Scene, [low, high]: [f64; 2], error: f64) -> bool {
    let outcome = Pushover.solve(scene, &Settings::default());
    println!("{name}: {:?} {}", outcome.bracket(), outcome.reason());
    match outcome.bracket() {
        Some(bracket) => {
            let right =
                bracket.upper >= low * (1.0 - error) && bracket.lower <= high * (1.0 + error);
            assert!(right, "{name}: {bracket:?} for [{low}, {high}]");
            true
        }
        None => {
            assert_eq!(
                outcome.status,
                Status::Undecided,
                "{name}: {}",
                outcome.reason()
            );
            assert!(!outcome.reason().is_empty());
            false
        }
    }
}

/// Oppenheim's arch, t/R 0.15 and 157.5°, and semicircles: λ by an independent program with HiGHS.
/// Three of them have to be answered.
#[test]
fn arches_are_pushed_to_their_multipliers() {
    let known = [
        (157.5, 7, 0.37001),
        (157.5, 14, 0.3589),
        (180.0, 9, 0.14547),
        (180.0, 27, 0.14510),
    ];
    let answered = known.into_iter().filter(|&(embrace, voussoirs, lambda)| {
        let scene = arch(0.15, embrace, voussoirs, 10.0);
        assert_right_or_refused(&format!("arch of {voussoirs}"), &scene, [lambda; 2], 0.01)
    });
    assert!(answered.count() >= 3);
}

/// paper-2 with rougher joints, open: verified intervals by an independent program with HiGHS.
#[test]
fn rougher_joints_are_pushed_to_the_verified_interval() {
    for (friction, interval) in [(0.8, [0.58355, 0.58365]), (1.0, [0.60516, 0.60569])] {
        let wall = wall(&["h1111h", "11111"].repeat(5), friction);
        let scene = laid(&wall, HeadJoints::Open);
        let name = format!("paper-2 with friction {friction}");
        assert!(assert_right_or_refused(&name, &scene, interval, 1e-3));
    }
}

/// Columns of one block a course: each tilts about its lowest toe at λ = width / height. They sway
/// more slowly than anything else that stands.
fn assert_columns_tilt(columns: &[(usize, f64)]) {
    for &(blocks, width) in columns {
        let stone = |k: usize| rectangle(0.0, width, k as f64, k as f64 + 1.0);
        let stones = (0..blocks).map(|k| homogeneous(stone(k)));
        let column = scene(stones.collect(), vec![ground()], 0.6);
        let exact = width / blocks as f64;
        let outcome = Pushover.solve(&column, &Settings::default());
        let name = format!("a column of {blocks}, {width} wide");
        let reason = outcome.reason();
        println!("{name}: {:?} {reason}", outcome.bracket());
        let bracket = outcome
            .bracket()
            .unwrap_or_else(|| panic!("{name}: {reason}"));
        let error = outcome
            .evidence
            .stated_error()
            .expect("levels measure an error");
        assert!(error <= 2e-3, "{name}: {error}");
        assert!(bracket.error(exact, 1.0) <= error, "{name}: {bracket:?}");
    }
}

#[test]
fn a_slender_column_tilts_about_its_toe() {
    assert_columns_tilt(&[(12, 1.0), (20, 1.5)]);
}

#[test]
#[ignore = "half a minute"]
fn columns_of_fifty_blocks_tilt_about_their_toes() {
    assert_columns_tilt(&[(50, 2.0), (50, 1.0), (30, 0.7)]);
}

/// Semicircles, t/R 0.20: within 0.5 % of λ_A.
#[test]
#[ignore = "seconds"]
fn semicircles_are_pushed_to_their_multiplier() {
    for (voussoirs, lambda) in [(27, 0.284_094_1), (100, 0.283_791_7)] {
        let arch = arch(0.20, 180.0, voussoirs, 10.0);
        let outcome = Pushover.solve(&arch, &Settings::default());
        let bracket = outcome
            .bracket()
            .unwrap_or_else(|| panic!("{voussoirs}: {}", outcome.reason()));
        assert!(
            bracket.error(lambda, 1.0) <= 5e-3,
            "{voussoirs}: {bracket:?}"
        );
    }
}
