//! Towers of level blocks, each joint of which equilibrium determines: their multiplier is exact.

use crate::scene::{Block, Load, Point, Polygon, Scene, SceneParts, Vector};

#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stone {
    pub width: f64,
    pub height: f64,
    pub weight: f64,
}

/// Blocks above each other, about one axis, on level ground.
#[derive(Clone, Debug, PartialEq)]
pub struct Tower {
    pub axis: f64,
    /// From bottom to top.
    pub stones: Vec<Stone>,
    /// Load on its top, dead and live.
    pub load: f64,
}

impl Tower {
    /// Equal stones of weight 1 and no load.
    pub fn of_equal(axis: f64, width: f64, height: f64, count: usize) -> Self {
        let stone = Stone {
            width,
            height,
            weight: 1.0,
        };
        Self {
            axis,
            stones: vec![stone; count],
            load: 0.0,
        }
    }

    /// The exact multiplier: at each joint, what lies above slides at λ = μ and rocks about its edge
    /// at half the joint's width over the height of its centre; the smallest of all. Every joint's
    /// force is determined by equilibrium, so that friction with and without dilatancy give the same.
    pub fn multiplier(&self, friction: f64) -> f64 {
        let (mut weight, mut moment) = (self.load, 0.0);
        let mut lowest = friction;
        // From the top, the moment about the joint below each stone.
        for (index, stone) in self.stones.iter().enumerate().rev() {
            moment += weight * stone.height + stone.weight * stone.height / 2.0;
            weight += stone.weight;
            let below = index.checked_sub(1).map(|below| self.stones[below].width);
            let joint = below.map_or(stone.width, |width| width.min(stone.width));
            lowest = lowest.min(weight * joint / 2.0 / moment);
        }
        lowest
    }

    pub fn top(&self) -> f64 {
        self.stones.iter().map(|stone| stone.height).sum()
    }

    /// Half the width of its widest stone.
    fn reach(&self) -> f64 {
        let widths = self.stones.iter().map(|stone| stone.width);
        widths.fold(0.0, f64::max) / 2.0
    }

    fn blocks(&self) -> Vec<Block> {
        let mut bottom = 0.0;
        let block = |stone: &Stone| {
            let top = bottom + stone.height;
            let sides = [-0.5, 0.5].map(|half| self.axis + half * stone.width);
            let block = Block {
                shape: rectangle(sides, [bottom, top]),
                loads: vec![load(self.axis, (bottom + top) / 2.0, stone.weight)],
            };
            bottom = top;
            block
        };
        let mut blocks: Vec<Block> = self.stones.iter().map(block).collect();
        if let Some(highest) = blocks.last_mut().filter(|_| self.load > 0.0) {
            highest.loads.push(load(self.axis, bottom, self.load));
        }
        blocks
    }
}

pub fn multiplier(towers: &[Tower], friction: f64) -> f64 {
    let each = towers.iter().map(|tower| tower.multiplier(friction));
    each.fold(f64::INFINITY, f64::min)
}

pub fn scene(towers: &[Tower], friction: f64) -> Scene {
    let blocks = towers.iter().flat_map(Tower::blocks).collect();
    assembled(blocks, vec![ground(towers)], friction)
}

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
    fn towers(&self) -> Vec<Tower> {
        let column = |column: usize| {
            let axis = column as f64 * (self.width + self.gap) + self.width / 2.0;
            let mut tower = Tower::of_equal(axis, self.width, self.height, self.courses);
            if let Some(top) = tower.stones.last_mut() {
                top.weight = self.mass_ratio;
            }
            let weights = tower.stones.iter().map(|stone| stone.weight);
            tower.load = self.overburden * weights.sum::<f64>();
            tower
        };
        (0..self.count).map(column).collect()
    }

    /// The exact multiplier of the tower, see `Tower::multiplier`.
    pub fn multiplier(&self) -> f64 {
        multiplier(&self.towers(), self.friction)
    }

    /// The scene.
    pub fn scene(&self) -> Scene {
        scene(&self.towers(), self.friction)
    }
}

/// Two equal towers of four stones that carry a slab, `cap` times as heavy as both, from the left side
/// of the one to the right side of the other: the clear distance of the towers is twice their width.
/// The exact multiplier, and the scene.
///
/// The multiplier is the smaller of μ and width over height of a tower, whatever the slab weighs:
/// turning about their toes, the towers lift and push it at their left corners, where it does not slip.
/// Its forces there share out so that each tower is at the point of turning, and every joint above
/// carries the same shear over less height.
pub fn capped(cap: f64, friction: f64) -> (f64, Scene) {
    let towers = [0.5, 3.5].map(|axis| Tower::of_equal(axis, 1.0, 0.5, 4));
    let bottom = towers[0].top();
    let slab = Block {
        shape: rectangle([0.0, 4.0], [bottom, bottom + 0.5]),
        loads: vec![load(2.0, bottom + 0.25, 8.0 * cap)],
    };
    let mut blocks: Vec<Block> = towers.iter().flat_map(Tower::blocks).collect();
    blocks.push(slab);
    let scene = assembled(blocks, vec![ground(&towers)], friction);
    (friction.min(1.0 / bottom), scene)
}

/// Level ground that reaches beyond all towers.
fn ground(towers: &[Tower]) -> Polygon {
    let right = towers.iter().map(|tower| tower.axis + tower.reach());
    let right = right.fold(0.0, f64::max);
    let thick = towers.iter().map(Tower::top).fold(0.0, f64::max);
    rectangle([-right, 2.0 * right], [-thick, 0.0])
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
