//! Towers of level blocks, each joint of which equilibrium determines: their multiplier is exact.

use crate::scene::{Block, Load, Point, Polygon, Scene, SceneParts, Vector};

/// A block of a tower.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stone {
    pub width: f64,
    pub height: f64,
    pub weight: f64,
}

/// Blocks above each other, about one axis, on level ground.
#[derive(Clone, Debug, PartialEq)]
pub struct Tower {
    /// Place of its axis.
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

    /// Height of its top.
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

/// The smallest multiplier of towers that do not touch.
pub fn multiplier(towers: &[Tower], friction: f64) -> f64 {
    let each = towers.iter().map(|tower| tower.multiplier(friction));
    each.fold(f64::INFINITY, f64::min)
}

/// The scene of towers side by side.
pub fn scene(towers: &[Tower], friction: f64) -> Scene {
    let blocks = towers.iter().flat_map(Tower::blocks).collect();
    assembled(blocks, vec![ground(towers)], friction)
}

/// Two equal towers that carry a slab from the left side of the one to the right side of the other.
///
/// Their multiplier is the smaller of μ and width over height of a tower, whatever the slab weighs:
/// turning about their toes, the towers lift and push it at their left corners, where it does not
/// slip. Its forces there share out so that each tower is at the point of turning, and every joint
/// above carries the same shear over less height.
#[derive(Clone, Debug, PartialEq)]
pub struct Capped {
    /// Width of a stone of the towers.
    pub width: f64,
    /// Height of a stone.
    pub height: f64,
    /// Stones of each tower.
    pub courses: usize,
    /// Weight of the slab over that of both towers.
    pub cap: f64,
}

impl Capped {
    /// The exact multiplier.
    pub fn multiplier(&self, friction: f64) -> f64 {
        friction.min(self.width / (self.courses as f64 * self.height))
    }

    /// The scene: the clear distance of the towers is twice their width.
    pub fn scene(&self, friction: f64) -> Scene {
        let tower = |axis| Tower::of_equal(axis, self.width, self.height, self.courses);
        let towers = [tower(self.width / 2.0), tower(3.5 * self.width)];
        let (width, bottom) = (4.0 * self.width, towers[0].top());
        let weight = self.cap * 2.0 * self.courses as f64;
        let slab = Block {
            shape: rectangle([0.0, width], [bottom, bottom + self.height]),
            loads: vec![load(width / 2.0, bottom + self.height / 2.0, weight)],
        };
        let mut blocks: Vec<Block> = towers.iter().flat_map(Tower::blocks).collect();
        blocks.push(slab);
        assembled(blocks, vec![ground(&towers)], friction)
    }
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
