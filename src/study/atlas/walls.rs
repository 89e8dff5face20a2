//! Walls of the atlas, with what other codes found of them, and cases of the library.

use super::grid::Known;
use crate::answer::Bracket;
use crate::case::{Quantity, Reference, SourceKind, library};
use crate::method::{Kind, kind};
use crate::scene::{
    Course, Friction, HeadJoints, Own, Piece, Polygon, Push, Scene, SceneParts, Vector, Wall,
};

/// What multipliers are worth that HiGHS (1.15.1, simplex) computed, the lowest states by blending, as
/// `tests/reference/limit.py` does, from 9 to 30 starts of eight kinds.
pub const COMPUTED: f64 = 1e-5;

/// What [`running_bond`] is worth as a reference of the pushover too: all its answers lie within
/// 5e-4.
const OF_RUNNING_BOND: f64 = 1e-3;

/// Courses of [`running_bond`], and its multipliers, computed with HiGHS.
pub const RUNNING: [(usize, Known); 2] = [
    (6, Known::within(0.639969, OF_RUNNING_BOND)),
    (
        10,
        Known {
            associative: 0.562957,
            ..Known::within(0.562786, OF_RUNNING_BOND)
        },
    ),
];

/// Units of 4 × 1.75 and weight 1 in these courses, μ = 0.65.
pub fn wall(courses: Vec<Course>) -> Wall {
    Wall {
        unit_length: 4.0,
        unit_height: 1.75,
        thickness: 1.0,
        unit_weight: 1.0,
        courses,
        friction: Friction::from(0.65),
        overburden: 0.0,
        push: Push::Right,
        own: Own::default(),
    }
}

pub fn laid(wall: &Wall, head_joints: HeadJoints) -> Scene {
    let scene = wall.scene(head_joints);
    scene.expect("the atlas has walls that can be laid")
}

/// Running bond of 4 × 1.75 units, μ = 0.65, five units long: paper-1 has 6 courses and paper-2 10.
fn running(courses: usize) -> Wall {
    let whole: Course = vec![Piece::Unit; 5];
    let cut: Course = [&[Piece::Half][..], &whole[1..], &[Piece::Half]].concat();
    let course = |row: usize| match row % 2 {
        0 => cut.clone(),
        _ => whole.clone(),
    };
    wall((0..courses).map(course).collect())
}

/// Running bond of 4 × 1.75 units, μ = 0.65, five units long, with open head joints.
pub fn running_bond(courses: usize) -> Scene {
    laid(&running(courses), HeadJoints::Open)
}

/// The same in another unit of length, each unit of the wall as heavy as before.
pub fn running_bond_in(courses: usize, unit: f64) -> Scene {
    let wall = Wall {
        unit_length: 4.0 * unit,
        unit_height: 1.75 * unit,
        thickness: unit,
        ..running(courses)
    };
    laid(&wall, HeadJoints::Open)
}

/// Coefficients of friction, λ_A of [`running_bond`] of 6 courses with them, and its one collapse
/// state: from μ = 1 on it rocks, and no state slips.
pub const ROUGH: [(f64, f64, f64); 9] = [
    (0.1, 0.1, 0.1),
    (0.65, 0.639969, 0.639969),
    (1.0, 0.645962733, 0.645962733),
    (1.5, 0.766300067, 0.645962733),
    (3.0, 0.935183157, 0.645962733),
    (10.0, 1.012087987, 0.645962733),
    (1e2, 1.032929918, 0.645962733),
    (1e4, 1.034901038, 0.645962733),
    (1e6, 1.034920439, 0.645962733),
];

/// Running bond of 6 courses of this friction.
pub fn rough_bond(friction: f64) -> Scene {
    let wall = Wall {
        friction: Friction::from(friction),
        ..running(6)
    };
    laid(&wall, HeadJoints::Open)
}

/// The scene at another place, its joints searched afresh: its multiplier is the same.
pub fn moved(scene: &Scene, by: f64) -> Scene {
    let by = Vector::new(by, 0.0);
    let shape = |shape: &Polygon| {
        let corners = shape.corners().iter().map(|corner| corner + by);
        Polygon::new(corners.collect()).expect("the atlas stays where blocks have digits left")
    };
    let supports = scene.supports().iter().map(shape).collect();
    let mut blocks = scene.blocks().to_vec();
    for block in &mut blocks {
        block.shape = shape(&block.shape);
        for load in &mut block.loads {
            load.point += by;
        }
    }
    let friction = scene.joints().first().map_or(0.0, |joint| joint.friction);
    let moved = Scene::new(SceneParts {
        push: scene.push(),
        wall: scene.wall().cloned(),
        ..SceneParts::new(blocks, supports, friction)
    });
    let moved = moved.expect("the atlas has proper numbers");
    moved.with_head_joints(scene.head_joints())
}

/// The scene of the library's case of this name with what is known of it; `None` where there is no such
/// case, or its references leave λ_A or the lowest state open.
pub fn of_library(name: &str, head_joints: HeadJoints) -> Option<(Scene, Known)> {
    let case = library().into_iter().find(|case| case.name == name)?;
    let about = |r: &&Reference| {
        r.head_joints.is_none_or(|only| only == head_joints)
            && r.kind != SourceKind::Published
            && r.deviation.is_none()
    };
    let value = |of: Kind, quantities: [Quantity; 2]| {
        let mut about = case.references.iter().filter(about);
        about.find(|r| kind(&r.method) == of && quantities.contains(&r.quantity))
    };
    use Quantity::{Lambda, Lower, Upper};
    let bound = value(Kind::AssociativeBounds, [Lambda; 2])?;
    let lowest = value(Kind::CollapseStates, [Lower, Lambda])?;
    let highest = value(Kind::CollapseStates, [Upper, Lambda]).unwrap_or(lowest);
    let accuracy = [bound, lowest, highest].map(|r| r.tolerance / r.value);
    let known = Known {
        states: Bracket {
            lower: lowest.value,
            upper: highest.value,
        },
        associative: bound.value,
        accuracy: accuracy.into_iter().fold(0.0, f64::max),
    };
    Some((case.scene(head_joints), known))
}
