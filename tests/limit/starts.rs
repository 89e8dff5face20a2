//! Starts of the interval's search: nearly all end in a verified state, every other ending named.

use crate::scenes::{laid, small_walls};
use trilith::answer::Status;
use trilith::inside::{SearchEnding, SearchFailure, SearchStart};
use trilith::judge::judge;
use trilith::method::limit::Interval;
use trilith::method::{Method, Settings};
use trilith::scene::{HeadJoints, Scene};

/// Verified starts, each at a λ above zero; all others must end with a name.
fn verified_starts(scene: &Scene, starts: usize) -> usize {
    let mut settings = Settings::default();
    settings.interval.starts = starts;
    let mut outcome = Interval.solve(scene, &settings);
    let residual = judge(scene, &mut outcome).residual();
    assert_eq!(outcome.status, Status::Verified, "{}", outcome.reason());
    assert!(residual.is_some_and(|residual| residual <= 1e-8));
    let search = outcome.search().expect("starts are reported");
    for start in &search.starts {
        if let SearchEnding::Verified { lowest, .. } = start.ending {
            assert!((0.0..1.0).contains(&lowest), "{start:?}");
        }
    }
    let failed = SearchFailure::ALL.map(|failure| search.failed(failure));
    let (verified, failed) = (search.verified(), failed.iter().sum::<usize>());
    assert_eq!(search.starts.len(), starts, "{search}");
    assert_eq!(verified + failed, starts, "{search}");
    verified
}

fn assert_most_are_verified(starts: usize) {
    for (name, wall) in small_walls() {
        for head_joints in [HeadJoints::Contact, HeadJoints::Open] {
            let verified = verified_starts(&laid(&wall, head_joints), starts);
            println!("{name} {}: {verified} of {starts}", head_joints.name());
            assert!(
                verified * 100 >= starts * 95,
                "{name}: {verified} of {starts}"
            );
        }
    }
}

#[test]
fn four_starts_end_verified() {
    assert_most_are_verified(4);
}

#[test]
#[ignore = "minutes: 1600 starts, each one followed down"]
fn two_hundred_starts_end_verified() {
    assert_most_are_verified(200);
}

/// States of neighbours are followed beside the starts that a user asks for, however few.
#[test]
fn neighbours_come_beside_the_starts_asked_for() {
    let (_, wall) = small_walls().into_iter().next().expect("there are some");
    let scene = laid(&wall, HeadJoints::Contact);
    for starts in 1..4 {
        let mut settings = Settings::default();
        settings.interval.starts = starts;
        let alone = Interval.solve(&scene, &settings);
        let forces = alone.evidence.forces().expect("of the lowest state").1;
        let unit = scene.total_weight();
        let normal = forces.iter().map(|f| (f.normal[0] + f.normal[1]) / unit);
        let outcome = Interval.solve_from(&scene, &settings, &[normal.collect()]);
        let search = outcome.search().expect("starts are reported");
        let kinds = search.starts.iter().map(|ending| ending.start);
        let neighbours = kinds.filter(|&start| start == SearchStart::Neighbour);
        assert_eq!(neighbours.count(), 1, "{starts} starts");
        assert_eq!(search.starts.len(), starts + 1);
    }
}
