//! What `--verify` compares, and head joints in contact as a range.

use trilith::answer::Repetition::{HalfSubstep, Mirrored, Undamped};
use trilith::answer::{Checked, Mechanism, Outcome, SelfCheck, Status};
use trilith::case;
use trilith::inside::PushoverFact;
use trilith::method::pushover::Pushover;
use trilith::method::{Collapse, Method, Settings};
use trilith::scene::{HeadJoints, Scene};

fn scene(name: &str, head_joints: HeadJoints) -> Scene {
    let case = case::find(name).unwrap_or_else(|complaint| panic!("{complaint}"));
    case[0].scene(head_joints)
}

fn bracketed(scene: &Scene, settings: &Settings) -> Outcome {
    let outcome = Pushover.solve(scene, settings);
    assert_eq!(outcome.status, Status::Bracketed, "{}", outcome.reason());
    outcome
}

/// Half the substep, mirrored and undamped: each within the stated error, with its figures.
#[test]
fn the_papers_walls_pass_every_check() {
    let mut settings = Settings::default();
    settings.pushover.verify = true;
    for name in ["paper-1", "paper-2"] {
        let outcome = bracketed(&scene(name, HeadJoints::Open), &settings);
        for repeated in [HalfSubstep, Mirrored, Undamped] {
            let agrees = |check: &&SelfCheck| {
                matches!(check.what, Checked::Repetition { with, answer: Ok(_) } if with == repeated)
                    && check.passed()
            };
            let checks = outcome.evidence.checks();
            let count = checks.iter().filter(agrees).count();
            assert_eq!(count, 1, "{repeated:?} {checks:?}");
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
        let range = outcome.bracket().expect("bracketed");
        let error = outcome.evidence.stated_error().expect("stated");
        assert!(range.lower >= lowest * (1.0 - error), "{name}: {range:?}");
        assert!(
            range.upper <= associative * (1.0 + error),
            "{name}: {range:?}"
        );
        assert_eq!(outcome.facts, [PushoverFact::Range.into()]);
    }
}

#[test]
fn a_long_range_is_not_run_unless_asked_for() {
    let outcome = Pushover.solve(&scene("paper-3", HeadJoints::Contact), &Settings::default());
    assert_eq!(outcome.status, Status::Undecided);
    let not_run = PushoverFact::RangeNotRun { blocks: 1176 };
    assert_eq!(outcome.facts, [not_run.into()]);
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
            assert_eq!(first.bracket(), again.bracket());
            assert_eq!(first.evidence.mechanism(), again.evidence.mechanism());
            assert_eq!(first.evidence.checks(), again.evidence.checks());
            assert_eq!(first.work, again.work);
        }
    }
}

/// The first slip comes before the collapse, and says so by a lower bracket; a block on a plane
/// slips and runs away at once (min(μ, b/h) = 0.3).
#[test]
fn first_slip_is_not_above_the_collapse() {
    let mut settings = Settings::default();
    settings.pushover.collapse = Collapse::FirstSlip;
    for name in ["paper-1", "paper-2", "sliding-block"] {
        let scene = scene(name, HeadJoints::Open);
        let collapse = bracketed(&scene, &Settings::default()).bracket();
        let outcome = Pushover.solve(&scene, &settings);
        assert_eq!(outcome.status, Status::Estimate, "{}", outcome.reason());
        let first_slip = PushoverFact::FirstSlip { slip: 1e-3 };
        assert_eq!(outcome.facts[0], first_slip.into());
        assert_eq!(outcome.evidence.stated_error(), None);
        let slip = outcome.bracket();
        let (collapse, slip) = (collapse.expect("bracketed"), slip.expect("bracketed"));
        assert!(
            slip.lower <= collapse.upper,
            "{name}: {slip:?} {collapse:?}"
        );
    }
}

#[test]
fn a_recording_follows_the_collapse() {
    let mut settings = Settings::default();
    settings.pushover.recording = true;
    let scene = scene("paper-1", HeadJoints::Open);
    let outcome = bracketed(&scene, &settings);
    let recording = outcome
        .evidence
        .observed()
        .and_then(|seen| seen.recording.as_ref())
        .expect("it was asked for");
    let frames = recording.frames.len();
    assert!((30..200).contains(&frames), "{frames} frames");
    let moved = |frame: &Mechanism| {
        let far = frame.motions.iter().map(|motion| motion.velocity.norm());
        far.fold(0.0, f64::max)
    };
    // It is called at a few hundredths of a course height (1.75), and goes on for about a whole one, as
    // a fall does: ever faster.
    let at = |part: usize| moved(&recording.frames[part * (frames - 1) / 4]);
    assert!(at(0) < 0.15 && at(4) > 0.8 * 1.75, "{} {}", at(0), at(4));
    assert!(at(4) - at(3) > at(2) - at(1), "{:?}", [1, 2, 3, 4].map(at));
    // Without being asked, nothing is kept, and nothing else changes.
    let plain = bracketed(&scene, &Settings::default());
    assert!(
        plain
            .evidence
            .observed()
            .is_none_or(|seen| seen.recording.is_none())
            && plain.bracket() == outcome.bracket()
    );
}
