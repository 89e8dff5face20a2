//! What `--accuracy` promises: the stated error, and a bracket no wider than that.

use trilith::case;
use trilith::method::pushover::Pushover;
use trilith::method::{Accuracy, Method, Settings, Status};
use trilith::scene::HeadJoints;

/// Verified open values by linear programs that share no code with the pushover: HiGHS through
/// `oracle.py --start open`.
const WALLS: [(&str, f64); 4] = [
    ("paper-1", 0.639969),
    ("paper-2", 0.562786),
    ("openings-3", 0.355817),
    ("openings-4", 0.263736),
];

fn assert_within(name: &str, exact: f64, accuracy: Accuracy, allowed: f64) {
    let case = case::find(name).unwrap_or_else(|complaint| panic!("{complaint}"));
    let scene = case[0].scene(HeadJoints::Open);
    let settings = Settings {
        accuracy,
        ..Settings::default()
    };
    let outcome = Pushover.solve(&scene, &settings);
    assert_eq!(outcome.status, Status::Bracketed, "{}", outcome.reason);
    let bracket = outcome.bracket.expect("bracketed");
    let stated = outcome.stated_error.expect("a pushover states its error");
    assert!(bracket.relative_width() <= stated, "{name}: {bracket:?}");
    assert!(bracket.error(exact) <= allowed, "{name}: {bracket:?}");
}

#[test]
fn coarse_is_within_a_percent() {
    for (name, exact) in WALLS {
        assert_within(name, exact, Accuracy::Coarse, 1e-2);
    }
}

/// Better than the 0.2 % that it states.
#[test]
fn normal_is_within_a_tenth_of_a_percent() {
    for (name, exact) in WALLS {
        assert_within(name, exact, Accuracy::Normal, 1e-3);
    }
}

#[test]
fn fine_is_within_a_twentieth_of_a_percent() {
    for (name, exact) in &WALLS[..2] {
        assert_within(name, *exact, Accuracy::Fine, 5e-4);
    }
}
