//! Walls for the tests of this folder.

use crate::scene::{HeadJoints, Push, Scene, Wall};

/// hh,1,hh of square blocks, whose lowest state with head joints in contact is known from elsewhere.
pub(super) fn small_wall(head_joints: HeadJoints) -> Scene {
    let wall = Wall::laid([4.0, 4.0], 0.65, &["hh", "1", "hh"]);
    wall.scene(head_joints).expect("it can be laid")
}

/// The lowest states of that wall.
pub(super) const LOWEST_OF_SMALL_WALL: f64 = 0.264_706;

/// Courses of three units each, stacked joint above joint, with head joints in contact and a load on
/// top.
pub(super) fn wall(courses: usize, push: Push) -> Scene {
    laid(&vec!["111"; courses], 1.0, push)
}

/// A wall of these courses, a letter a piece, with head joints in contact and a load on top.
pub(super) fn bonded(courses: &[&str]) -> Scene {
    laid(courses, 0.5, Push::Right)
}

fn laid(courses: &[&str], overburden: f64, push: Push) -> Scene {
    let wall = Wall {
        overburden,
        push,
        ..Wall::laid([4.0, 1.75], 0.65, courses)
    };
    wall.scene(HeadJoints::Contact).expect("it can be laid")
}
