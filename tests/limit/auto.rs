//! `auto`: right or undecided, and never more model than needed.

use std::path::Path;

use crate::scenes;

use trilith::answer::{Fact, Outcome, Status};
use trilith::case::{find, library};
use trilith::inside::chart::reference;
use trilith::inside::{AutoFact, Uniqueness};
use trilith::method::limit::Interval;
use trilith::method::{Auto, Settings};
use trilith::run::answer;
use trilith::scene::{HeadJoints, Scene};

fn auto(sides: &[Scene], settings: Settings) -> Outcome {
    answer(sides, &Auto, settings).outcome
}

/// How far apart the ends of an answer are.
fn uniqueness(outcome: &Outcome) -> Option<Uniqueness> {
    outcome.facts.iter().find_map(|fact| match fact {
        Fact::Auto(AutoFact::Uniqueness(uniqueness)) => Some(*uniqueness),
        _ => None,
    })
}

/// Every library case up to `blocks`: within the tolerance of its reference, or undecided with a
/// reference between the ends, or without a multiplier as the case is.
fn holds_on_the_library(blocks: std::ops::Range<usize>, least: usize) {
    let settings = Settings::default();
    let (mut compared, mut without) = (0, Vec::new());
    for case in library() {
        // Where a support moves, λ is the change of the reaction that references give.
        if Path::new(&format!("cases/moves/{}.toml", case.name)).exists() {
            continue;
        }
        for &head_joints in &case.head_joints {
            let sides = case.sides(head_joints);
            if !blocks.contains(&sides[0].blocks().len()) {
                continue;
            }
            let outcome = auto(&sides, settings);
            let what = format!("{} {}: {outcome:?}", case.name, head_joints.name());
            assert_ne!(outcome.status, Status::Failed, "{what}");
            assert_ne!(outcome.status, Status::Estimate, "{what}");
            let (Some(known), Some(bracket)) = (reference(&case, head_joints), outcome.bracket())
            else {
                without.push(format!("{} {}", case.name, head_joints.name()));
                continue;
            };
            compared += 1;
            if outcome.status == Status::Undecided {
                // Not unique: the ends are proved and apart.
                assert!(
                    bracket.relative_width(1.0) > settings.auto.tolerance,
                    "{what}"
                );
                let slack = 2.0 * settings.auto.tolerance * known.range.lower;
                assert!(known.range.lower <= bracket.upper + slack, "{what}");
            } else {
                assert!(
                    bracket.error(known.range.lower, 1.0) <= settings.auto.tolerance,
                    "{what}"
                );
            }
        }
    }
    println!("{compared} compared; without a reference or a number: {without:?}");
    assert!(compared >= least, "{compared} compared, not {without:?}");
}

#[test]
#[ignore = "the whole library: in release"]
fn auto_is_right_or_undecided_on_the_library() {
    holds_on_the_library(0..300, 80);
}

#[test]
#[ignore = "seconds in release, minutes in debug"]
fn auto_is_right_or_undecided_on_large_cases() {
    holds_on_the_library(300..usize::MAX, 1);
}

/// The bond has a branch 4 % below λ_A, which one start from λ_A misses.
#[test]
fn a_branch_far_below_is_not_missed() {
    let wall = scenes::wall(&["h1h", "1hh", "h1h", "hh1", "h1h"], 0.65);
    let outcome = auto(
        &[scenes::laid(&wall, HeadJoints::Open)],
        Settings::default(),
    );
    assert_eq!(outcome.status, Status::Undecided, "{}", outcome.reason());
    let uniqueness = uniqueness(&outcome).expect("both ends are proved");
    assert!(!uniqueness.unique && uniqueness.relative_width > 0.03);
    let bracket = outcome.bracket().unwrap();
    assert!(bracket.lower < 0.3658 && bracket.upper > 0.3809);
}

/// paper-2 with head joints in contact: [0.557, 0.580], 4 % wide.
#[test]
fn the_tolerance_decides() {
    let scene = scenes::laid(&scenes::small_walls()[1].1, HeadJoints::Contact);
    let mut wide = Settings::default();
    wide.auto.tolerance = 0.05;
    let outcome = auto(std::slice::from_ref(&scene), wide);
    assert_eq!(outcome.status, Status::Bracketed, "{}", outcome.reason());
    let open = scenes::laid(&scenes::small_walls()[3].1, HeadJoints::Open);
    let outcome = auto(&[open], Settings::default());
    assert_eq!(outcome.status, Status::Undecided, "{}", outcome.reason());
}

/// Nothing taller than its part is modelled where the part proves it, and that is reported.
#[test]
fn a_scene_that_falls_or_locks_is_settled_by_the_first_program() {
    let walls = vec![
        scenes::rectangle(-1.0, 0.0, 0.0, 2.0),
        scenes::rectangle(1.0, 2.0, 0.0, 2.0),
    ];
    let block = scenes::homogeneous(scenes::rectangle(0.0, 1.0, 0.0, 1.0));
    let locked = scenes::scene(vec![block], walls, 0.7);
    let outcome = auto(&[locked], Settings::default());
    assert_eq!(outcome.status, Status::Stands, "{}", outcome.reason());
}

/// One start ends at 0.4246, within a tenth of λ_A; the sequential method lies lower, so that the
/// search goes on and finds that the multiplier is not unique.
#[test]
fn auto_listens_before_it_vouches() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/walls/lintels.toml");
    let case = find(path)
        .unwrap_or_else(|complaint| panic!("{complaint}"))
        .remove(0);
    let scene = [case.scene(HeadJoints::Contact)];
    let mut settings = Settings::default();
    settings.interval.starts = 1;
    settings.auto.tolerance = 0.1;
    let alone = answer(&scene, &Interval, settings).outcome;
    let outcome = auto(&scene, settings);
    let bracket = outcome.bracket().expect("both ends are proved");
    let stop_below = 0.9 * bracket.upper;
    assert!(
        alone
            .bracket()
            .is_some_and(|alone| alone.lower > stop_below)
    );
    assert_eq!(outcome.status, Status::Undecided, "{}", outcome.reason());
    assert!(bracket.lower < 0.41, "{bracket:?}");
    let listened = outcome.facts.iter().any(|fact| {
        matches!(
            fact,
            Fact::Auto(AutoFact::Saved {
                sequential: false,
                ..
            })
        )
    });
    assert!(listened, "{}", outcome.reason());
}
