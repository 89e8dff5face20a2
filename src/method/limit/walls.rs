//! Walls for the tests of this folder.

use crate::scene::{HeadJoints, Own, Piece, Push, Scene, Wall};

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
        own: Own::default(),
    };
    wall.scene(head_joints).expect("it can be laid")
}

/// The lowest states of that wall.
pub(super) const LOWEST_OF_SMALL_WALL: f64 = 0.264_706;

/// Courses of three units each, stacked joint above joint, with head joints in contact and a load on
/// top.
pub(super) fn wall(courses: usize, push: Push) -> Scene {
    let wall = Wall {
        overburden: 1.0,
        push,
        ..laid(&vec!["111"; courses])
    };
    wall.scene(HeadJoints::Contact).expect("it can be laid")
}

/// A wall of these courses, a letter a piece, with head joints in contact and a load on top.
pub(super) fn bonded(courses: &[&str]) -> Scene {
    let scene = laid(courses).scene(HeadJoints::Contact);
    scene.expect("it can be laid")
}

fn laid(courses: &[&str]) -> Wall {
    let piece = |letter| match letter {
        'h' => Piece::Half,
        'g' => Piece::Gap,
        _ => Piece::Unit,
    };
    Wall {
        unit_length: 4.0,
        unit_height: 1.75,
        thickness: 1.0,
        unit_weight: 1.0,
        courses: courses
            .iter()
            .map(|course| course.chars().map(piece).collect())
            .collect(),
        friction: 0.65.into(),
        overburden: 0.5,
        push: Push::Right,
        own: Own::default(),
    }
}
