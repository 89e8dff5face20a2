//! What `--verify` compares, and head joints in contact as a range.

use trilith::case;
use trilith::method::pushover::Pushover;
use trilith::method::{Method, Outcome, Settings, Status};
use trilith::scene::{HeadJoints, Scene};

fn scene(name: &str, head_joints: HeadJoints) -> Scene {
    let case = case::find(name).unwrap_or_else(|complaint| panic!("{complaint}"));
    case[0].scene(head_joints)
}

fn bracketed(scene: &Scene, settings: &Settings) -> Outcome {
    let outcome = Pushover.solve(scene, settings);
    assert_eq!(outcome.status, Status::Bracketed, "{}", outcome.reason);
    outcome
}

/// Half the substep, mirrored and undamped: each within the stated error, with its figures.
#[test]
fn the_papers_walls_pass_every_check() {
    let settings = Settings {
        verify: true,
        ..Settings::default()
    };
    for name in ["paper-1", "paper-2"] {
        let outcome = bracketed(&scene(name, HeadJoints::Open), &settings);
        for what in ["half the substep: [", "mirrored: [", "undamped: ["] {
            let figures = outcome.checks.iter().filter(|text| text.starts_with(what));
            assert_eq!(figures.count(), 1, "{what} {:?}", outcome.checks);
        }
    }
}

/// Inside what linear programs verify for head joints in contact (HiGHS through `oracle.py`: lowest
/// non-associative state found, associative multiplier), widened by the stated error.
#[test]
fn head_joints_in_contact_give_a_range() {
    for (name, lowest, associative) in [
        ("paper-1", 0.638982, 0.642859),
        ("paper-2", 0.557416, 0.579999),
    ] {
        let outcome = bracketed(&scene(name, HeadJoints::Contact), &Settings::default());
        let range = outcome.bracket.expect("bracketed");
        let error = outcome.stated_error.expect("stated");
        assert!(range.lower >= lowest * (1.0 - error), "{name}: {range:?}");
        assert!(
            range.upper <= associative * (1.0 + error),
            "{name}: {range:?}"
        );
        assert!(outcome.reason.contains("not unique"));
    }
}

#[test]
fn a_long_range_is_not_run_unless_asked_for() {
    let outcome = Pushover.solve(&scene("paper-3", HeadJoints::Contact), &Settings::default());
    assert_eq!(outcome.status, Status::Undecided);
    assert!(outcome.reason.starts_with("not run"), "{}", outcome.reason);
}

/// The same bits twenty times.
#[test]
#[ignore = "twenty runs"]
fn twenty_runs_give_the_same_bits() {
    for name in ["paper-1", "paper-2"] {
        let scene = scene(name, HeadJoints::Open);
        let first = bracketed(&scene, &Settings::default());
        for _ in 1..20 {
            let again = bracketed(&scene, &Settings::default());
            assert_eq!(first.bracket, again.bracket);
            assert_eq!(first.mechanism, again.mechanism);
            assert_eq!(first.checks, again.checks);
            assert_eq!(first.work, again.work);
        }
    }
}
