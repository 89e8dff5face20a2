//! Walls for the tests of this folder.

use crate::scene::{HeadJoints, Own, Piece, Push, Scene, Wall};

/// A wall of these courses with head joints in contact.
pub(super) fn wall(courses: &[&[Piece]]) -> Scene {
    let wall = Wall {
        unit_length: 4.0,
        unit_height: 1.75,
        thickness: 1.0,
        unit_weight: 1.0,
        courses: courses.iter().map(|course| course.to_vec()).collect(),
        friction: 0.65.into(),
        overburden: 0.0,
        push: Push::Right,
        own: Own::default(),
    };
    wall.scene(HeadJoints::Contact).expect("it can be laid")
}
