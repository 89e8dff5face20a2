//! Walls for the tests of this folder.

use crate::scene::{HeadJoints, OfBlocks, Piece, Push, Scene, Wall};

/// hh,1,hh of square blocks, whose lowest state with head joints in contact is known from elsewhere.
pub(super) fn small_wall(head_joints: HeadJoints) -> Scene {
    use Piece::{Half, Unit};
    let wall = Wall {
        unit_length: 4.0,
        unit_height: 4.0,
        thickness: 1.0,
        unit_weight: 1.0,
        courses: vec![vec![Half, Half], vec![Unit], vec![Half, Half]],
        friction: 0.65.into(),
        overburden: 0.0,
        push: Push::Right,
        of_blocks: OfBlocks::default(),
    };
    wall.scene(head_joints).expect("it can be laid")
}

/// The lowest states of that wall.
pub(super) const LOWEST_OF_SMALL_WALL: f64 = 0.264_706;

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
