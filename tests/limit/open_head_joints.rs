//! What is said where a scene falls because its head joints are open.

use crate::scenes::{ground, homogeneous, polygon, rectangle, scene};
use trilith::answer::{Fact, Outcome, Status};
use trilith::inside::JudgedFact;
use trilith::judge::judge;
use trilith::method::limit::Associative;
use trilith::method::pushover::Pushover;
use trilith::method::{Method, Settings};
use trilith::scene::{HeadJoints, Scene};

/// A stone between two piers, held by the plumb joints at its sides alone: it slides down between
/// them where they are smooth, and where they are open.
fn hung(friction: f64) -> Scene {
    let stones = vec![
        homogeneous(rectangle(0.0, 1.0, 0.0, 2.0)),
        homogeneous(rectangle(1.0, 2.0, 1.0, 2.0)),
        homogeneous(rectangle(2.0, 3.0, 0.0, 2.0)),
    ];
    scene(stones, vec![ground()], friction)
}

fn judged(method: &dyn Method, scene: &Scene) -> Outcome {
    let mut outcome = method.solve(scene, &Settings::default());
    judge(scene, &mut outcome);
    outcome
}

fn left_out(outcome: &Outcome) -> Option<usize> {
    outcome.facts.iter().find_map(|fact| match fact {
        Fact::Judged(JudgedFact::OpenHeadJoints { count }) => Some(*count),
        _ => None,
    })
}

#[test]
fn a_scene_that_falls_with_open_head_joints_says_so() {
    let open = hung(0.6).with_head_joints(HeadJoints::Open);
    for method in [&Associative as &dyn Method, &Pushover] {
        let outcome = judged(method, &open);
        assert_eq!(outcome.status, Status::Falls, "{}", outcome.reason());
        assert_eq!(left_out(&outcome), Some(2), "{}", method.name());
        assert!(outcome.reason().contains("2 open head joints"));
    }
    // The same without any: what falls then falls for another reason.
    let outcome = judged(&Associative, &hung(0.0));
    assert_eq!(left_out(&outcome), None);
}

/// Steep joints of voussoirs are no head joints: an arch stands with open ones as in contact.
#[test]
fn steep_joints_of_voussoirs_are_not_left_out() {
    let keystone = polygon(&[(1.4, 1.0), (1.6, 1.0), (1.7, 2.0), (1.3, 2.0)]);
    let left = polygon(&[(0.0, 0.0), (1.0, 0.0), (1.4, 1.0), (1.3, 2.0), (0.0, 2.0)]);
    let right = polygon(&[(2.0, 0.0), (3.0, 0.0), (3.0, 2.0), (1.7, 2.0), (1.6, 1.0)]);
    let stones = [left, keystone, right].map(homogeneous).to_vec();
    let arch = scene(stones, vec![ground()], 0.6);
    let open = arch.clone().with_head_joints(HeadJoints::Open);
    assert_eq!(open.left_out(), 0);
    assert_eq!(open.joints(), arch.joints());
}
