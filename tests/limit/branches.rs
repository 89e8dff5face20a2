//! Walls with several branches of collapse states, which single methods miss.

use crate::scenes;

use trilith::answer::Status;
use trilith::method::limit::Interval;
use trilith::method::{Method, Settings};
use trilith::scene::HeadJoints;

/// With open head joints λ_A of this bond is 0.38095, and states without dilatancy reach down to
/// 0.36571: there the sequential method settles, and the pushover stands up to 0.3677. A search
/// that follows the gap alone ended at 0.38095 from each of 40 starts.
#[test]
fn the_lower_branch_of_an_irregular_bond_is_found() {
    let wall = scenes::wall(&["h1h", "1hh", "h1h", "hh1", "h1h"], 0.65);
    let scene = wall.scene(HeadJoints::Open).expect("the wall can be laid");
    let outcome = Interval.solve(&scene, &Settings::default());
    assert_eq!(outcome.status, Status::Verified);
    let bracket = outcome.bracket().expect("verified states have a bracket");
    assert!(bracket.lower < 0.3658, "{bracket:?}");
    assert!(bracket.upper > 0.3809, "{bracket:?}");
}
