//! The scenes of the atlas: columns, whose multiplier is exact, and walls with a stored one.

use crate::scene::{
    Block, Course, Friction, HeadJoints, Load, Piece, Point, Polygon, Push, Scene, SceneParts,
    Vector, Wall,
};

/// Columns of equal blocks side by side, in one unit of length and one of force.
#[derive(Clone, Debug, PartialEq)]
pub struct Columns {
    /// Blocks of each column.
    pub courses: usize,
    /// Width of a block.
    pub width: f64,
    /// Height of a block.
    pub height: f64,
    /// Weight of the top block over that of each other one.
    pub mass_ratio: f64,
    /// Load on the top, dead and live, over the weight of the column.
    pub overburden: f64,
    /// Coefficient of friction.
    pub friction: f64,
    /// Number of columns.
    pub count: usize,
    /// Distance between columns.
    pub gap: f64,
}

impl Default for Columns {
    fn default() -> Self {
        Self {
            courses: 3,
            width: 1.0,
            height: 0.5,
            mass_ratio: 1.0,
            overburden: 0.0,
            friction: 0.6,
            count: 1,
            gap: 0.1,
        }
    }
}

impl Columns {
    fn weights(&self) -> Vec<f64> {
        let mut weights = vec![1.0; self.courses];
        if let Some(top) = weights.last_mut() {
            *top = self.mass_ratio;
        }
        weights
    }

    /// The load on the top.
    fn surcharge(&self) -> f64 {
        self.overburden * self.weights().iter().sum::<f64>()
    }

    /// The exact multiplier: at each joint, what lies above slides at λ = μ and rocks about its edge
    /// at half the width over the height of its centre; the smallest of all. Every joint's force is
    /// determined by equilibrium, so that friction with and without dilatancy give the same.
    pub fn multiplier(&self) -> f64 {
        let weights = self.weights();
        let rocking = (0..self.courses).map(|joint| {
            let (mut weight, mut moment) = (self.surcharge(), 0.0);
            moment += weight * (self.courses - joint) as f64 * self.height;
            for (course, own) in weights.iter().enumerate().skip(joint) {
                weight += own;
                moment += own * (course as f64 - joint as f64 + 0.5) * self.height;
            }
            weight * self.width / 2.0 / moment
        });
        rocking.fold(self.friction, f64::min)
    }

    /// The scene.
    pub fn scene(&self) -> Scene {
        let weights = self.weights();
        let mut blocks = Vec::new();
        for column in 0..self.count {
            let left = column as f64 * (self.width + self.gap);
            for (course, &weight) in weights.iter().enumerate() {
                let bottom = course as f64 * self.height;
                let middle = left + self.width / 2.0;
                let mut loads = vec![load(middle, bottom + self.height / 2.0, weight)];
                if course + 1 == self.courses && self.overburden > 0.0 {
                    loads.push(load(middle, bottom + self.height, self.surcharge()));
                }
                let shape = rectangle([left, left + self.width], [bottom, bottom + self.height]);
                blocks.push(Block { shape, loads });
            }
        }
        let wide = self.count as f64 * (self.width + self.gap);
        let ground = rectangle([-wide, 2.0 * wide], [-self.height, 0.0]);
        assembled(blocks, vec![ground], self.friction)
    }
}

fn load(x: f64, y: f64, weight: f64) -> Load {
    Load {
        point: Point::new(x, y),
        dead: Vector::new(0.0, -weight),
        live: Vector::new(weight, 0.0),
    }
}

fn rectangle([left, right]: [f64; 2], [bottom, top]: [f64; 2]) -> Polygon {
    Polygon::rectangle(left, right, bottom, top).expect("the atlas has proper blocks")
}

fn assembled(blocks: Vec<Block>, supports: Vec<Polygon>, friction: f64) -> Scene {
    let scene = Scene::new(SceneParts::new(blocks, supports, friction));
    scene.expect("the atlas has proper numbers")
}

/// Running bond of 4 × 1.75 units, μ = 0.65, five units long, with open head joints: paper-1 has 6
/// courses and paper-2 10.
pub fn running_bond(courses: usize) -> Scene {
    running_bond_in(courses, 1.0)
}

/// The same in another unit of length, each unit of the wall as heavy as before.
pub fn running_bond_in(courses: usize, unit: f64) -> Scene {
    let whole: Course = vec![Piece::Unit; 5];
    let cut: Course = [&[Piece::Half][..], &whole[1..], &[Piece::Half]].concat();
    let course = |row: usize| match row % 2 {
        0 => cut.clone(),
        _ => whole.clone(),
    };
    let wall = Wall {
        unit_length: 4.0 * unit,
        unit_height: 1.75 * unit,
        thickness: unit,
        unit_weight: 1.0,
        courses: (0..courses).map(course).collect(),
        friction: Friction::from(0.65),
        overburden: 0.0,
        push: Push::Right,
    };
    wall.scene(HeadJoints::Open)
        .expect("running bond can be laid")
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
