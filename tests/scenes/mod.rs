//! Scenes shared by the tests of the limit analysis: arches, loose blocks, walls, and the changes
//! of place and unit that leave the multiplier as it is.

#![allow(dead_code, reason = "every test binary uses its own part")]

use trilith::scene::{
    Arch, Block, Course, Forces, HeadJoints, Load, Own, Piece, Point, Polygon, Push, Scene,
    SceneParts, Vector, Wall, WallFacts,
};

/// A scene of blocks and supports with one coefficient of friction, pushed to the right.
pub fn scene(blocks: Vec<Block>, supports: Vec<Polygon>, friction: f64) -> Scene {
    Scene::new(SceneParts::new(blocks, supports, friction)).expect("the numbers are proper")
}

/// A block whose weight acts at `centre`, downwards and, live, to the right.
pub fn weighted(shape: Polygon, weight: f64, centre: Point) -> Block {
    let load = Load {
        point: centre,
        dead: Vector::new(0.0, -weight),
        live: Vector::new(weight, 0.0),
    };
    Block {
        shape,
        loads: vec![load],
    }
}

/// A block of specific weight 1.
pub fn homogeneous(shape: Polygon) -> Block {
    let (area, centroid) = (shape.area(), shape.centroid());
    weighted(shape, area, centroid)
}

/// The rectangle `[x0, x1] × [y0, y1]`.
pub fn rectangle(x0: f64, x1: f64, y0: f64, y1: f64) -> Polygon {
    Polygon::rectangle(x0, x1, y0, y1).expect("a proper rectangle")
}

/// A convex polygon from coordinates.
pub fn polygon(corners: &[(f64, f64)]) -> Polygon {
    let points = corners.iter().map(|&(x, y)| Point::new(x, y));
    Polygon::new(points.collect()).expect("a proper polygon")
}

/// Level ground, top at y = 0.
pub fn ground() -> Polygon {
    rectangle(-100.0, 100.0, -1.0, 0.0)
}

/// A circular arch of mean radius 1, pushed to the right: `ratio` is thickness over mean radius,
/// `embrace` its angle in degrees.
pub fn arch(ratio: f64, embrace: f64, voussoirs: u32, friction: f64) -> Scene {
    let arch = Arch {
        mean_radius: 1.0,
        thickness: ratio,
        embrace,
        voussoirs,
        specific_weight: 1.0,
        friction: friction.into(),
        forces: Forces::default(),
    };
    let assembly = arch.assembly().expect("a proper arch");
    assembly
        .scene(HeadJoints::Contact, Push::Right)
        .expect("the numbers are proper")
}

/// The four walls of Ferris & Tin-Loi (Int. J. Mech. Sci. 43 (2001) 209-224), the first two being
/// the paper's: name and courses from bottom to top (`1` a unit, `h` a half, `g` a gap).
pub fn small_walls() -> [(&'static str, Wall); 4] {
    let repeated = |pair: [&'static str; 2], times| pair.repeat(times);
    let (whole, cut) = ("1111", "h111h");
    let (we, wu) = ("1hgh1", "h1g1h");
    let threes = [whole, cut, whole, wu, we, wu, we, wu, whole, cut, whole];
    let (e, u, we, wu) = ("h1111h", "11111", "hhghhghh", "1g1g1");
    let fours = [e, u, e, wu, we, wu, we, wu, e, u, e];
    [
        ("paper-1", wall(&repeated(["h1111h", "11111"], 3), 0.65)),
        ("paper-2", wall(&repeated(["h1111h", "11111"], 5), 0.65)),
        ("openings-3", wall(&threes, 0.65)),
        ("openings-4", wall(&fours, 0.65)),
    ]
}

/// A wall of 4 × 1.75 units of weight 1.
pub fn wall(courses: &[&str], friction: f64) -> Wall {
    let piece = |letter| match letter {
        '1' => Piece::Unit,
        'h' => Piece::Half,
        'g' => Piece::Gap,
        other => panic!("no piece is called {other}"),
    };
    Wall {
        unit_length: 4.0,
        unit_height: 1.75,
        thickness: 1.0,
        unit_weight: 1.0,
        courses: courses
            .iter()
            .map(|course| course.chars().map(piece).collect::<Course>())
            .collect(),
        friction: friction.into(),
        overburden: 0.0,
        push: Push::Right,
        own: Own::default(),
    }
}

/// Running bond of 3 × 1 units, the half-unit course first, as in paper-3 (48 × 24).
pub fn running_bond(courses: usize, units: usize, friction: f64) -> Wall {
    let whole: Course = vec![Piece::Unit; units];
    let cut: Course = [&[Piece::Half][..], &whole[1..], &[Piece::Half]].concat();
    Wall {
        unit_length: 3.0,
        unit_height: 1.0,
        courses: (0..courses)
            .map(|row| {
                if row % 2 == 0 {
                    cut.clone()
                } else {
                    whole.clone()
                }
            })
            .collect(),
        ..wall(&["1"], friction)
    }
}

/// A wall's scene.
pub fn laid(wall: &Wall, head_joints: HeadJoints) -> Scene {
    wall.scene(head_joints).expect("the wall can be laid")
}

/// The parts of the scene with every point and every force changed. One coefficient of friction for
/// all joints is taken over.
fn changed(
    scene: &Scene,
    place: impl Fn(Point) -> Point,
    force: impl Fn(Vector) -> Vector,
) -> SceneParts {
    let moved = |shape: &Polygon| {
        let corners = shape.corners().iter().map(|&corner| place(corner));
        Polygon::new(corners.collect()).expect("the shape stays proper")
    };
    let blocks = (scene.blocks().iter())
        .map(|block| Block {
            shape: moved(&block.shape),
            loads: (block.loads.iter())
                .map(|load| Load {
                    point: place(load.point),
                    dead: force(load.dead),
                    live: force(load.live),
                })
                .collect(),
        })
        .collect();
    let supports = scene.supports().iter().map(moved).collect();
    SceneParts {
        push: scene.push(),
        wall: scene.wall().cloned(),
        ..SceneParts::new(blocks, supports, scene.joints()[0].friction)
    }
}

/// A scene of these parts, its joints searched afresh, with the head joints of another.
fn again(scene: &Scene, parts: SceneParts) -> Scene {
    let again = Scene::new(parts).expect("the numbers stay proper");
    again.with_head_joints(scene.head_joints())
}

/// The scene somewhere else.
pub fn shifted(scene: &Scene, by: Vector) -> Scene {
    again(scene, changed(scene, |point| point + by, |force| force))
}

/// Lengths and forces in other units.
pub fn scaled(scene: &Scene, length: f64, weight: f64) -> Scene {
    let mut scaled = changed(
        scene,
        |point| Point::from(point.coords * length),
        |force| force * weight,
    );
    if let Some(WallFacts {
        coursing: Some(coursing),
        ..
    }) = &mut scaled.wall
    {
        coursing.height *= length;
        coursing.overlap *= length;
    }
    again(scene, scaled)
}

/// Left and right exchanged.
pub fn mirrored(scene: &Scene) -> Scene {
    let mut mirrored = changed(
        scene,
        |point| Point::new(-point.x, point.y),
        |force| Vector::new(-force.x, force.y),
    );
    mirrored.push = match scene.push() {
        Push::Right => Push::Left,
        Push::Left => Push::Right,
    };
    again(scene, mirrored)
}

/// Every load of blocks whose top is the scene's, times `factor`.
pub fn with_heavy_top(scene: &Scene, factor: f64) -> Scene {
    let top = scene.bounds().1.y - 1e-6 * scene.height();
    scene.clone().with_loads(|load, shape| {
        if shape.bounds().1.y > top {
            load.dead *= factor;
            load.live *= factor;
        }
    })
}
