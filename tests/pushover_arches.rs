//! The pushover on scenes that are no coursed walls or rougher than the paper's: a right answer or
//! none.

mod scenes;

use scenes::{arch, laid, wall};
use trilith::answer::Status;
use trilith::method::pushover::Pushover;
use trilith::method::{Method, Settings};
use trilith::scene::{HeadJoints, Scene};

/// Asserts a bracket within `error` of `[low, high]`, or a refusal with a reason.
fn assert_right_or_refused(name: &str, scene: &Scene, [low, high]: [f64; 2], error: f64) -> bool {
    let outcome = Pushover.solve(scene, &Settings::default());
    println!("{name}: {:?} {}", outcome.bracket, outcome.reason());
    match outcome.bracket {
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
