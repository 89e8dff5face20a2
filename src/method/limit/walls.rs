//! Walls for the tests of this folder.

use crate::scene::{HeadJoints, OfBlocks, Piece, Push, Scene, Wall};

/// Courses of three units each, stacked joint above joint, with head joints in contact and a load on
/// top.
pub(super) fn wall(courses: usize, push: Push) -> Scene {
    let wall = Wall {
        unit_length: 4.0,
        unit_height: 1.75,
        thickness: 1.0,
        unit_weight: 1.0,
        courses: vec![vec![Piece::Unit; 3]; courses],
        friction: 0.65.into(),
        overburden: 1.0,
        push,
        of_blocks: OfBlocks::default(),
    };
    wall.scene(HeadJoints::Contact).expect("it can be laid")
}
