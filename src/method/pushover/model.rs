//! The scene without dimensions: lengths in course heights, forces in mean block weights, g = 1.
//!
//! Engines carry lengths of their own (prediction distances, slops), so a scene in millimetres
//! or far from the origin would fail by construction; here every scene looks alike.

use super::groups::{Surface, surfaces};
use crate::answer::PushoverFact;
use crate::scene::{Point, Polygon, Scene, Side, Vector};

/// A force at a point that turns with its block.
pub struct Force {
    /// From the centroid to the point.
    pub arm: [f64; 2],
    /// Constant part.
    pub dead: [f64; 2],
    /// Part for a multiplier of 1.
    pub live: [f64; 2],
}

/// A block as the engine sees it.
pub struct Body {
    /// Its place in the scene.
    pub index: usize,
    /// Centroid.
    pub centre: [f64; 2],
    /// Corners of the collision shape relative to the centroid, counter-clockwise.
    pub outline: Vec<[f64; 2]>,
    /// Mass, by area: the multiplier does not depend on masses, and masses in proportion to uneven
    /// loads would keep the contact solver from converging.
    pub mass: f64,
    /// Moment of inertia about the centroid.
    pub inertia: f64,
    /// Largest distance of a corner from the centroid.
    pub reach: f64,
    /// What it collides with, and how rough it is.
    pub surfaces: Vec<Surface>,
    /// Forces.
    pub loads: Vec<Force>,
}

/// A support as the engine sees it.
pub struct Support {
    /// What it is in the scene: a support, or a block that is held fixed.
    pub side: Side,
    /// Centroid.
    pub centre: [f64; 2],
    /// Corners relative to the centroid, counter-clockwise.
    pub outline: Vec<[f64; 2]>,
    /// What it collides with, and how rough it is.
    pub surfaces: Vec<Surface>,
}

/// The dimensionless scene.
pub struct Model {
    /// Blocks that may move, in the scene's order.
    pub blocks: Vec<Body>,
    /// Supports in the scene's order, then blocks held fixed.
    pub supports: Vec<Support>,
    /// Course height: the median block height, in the scene's length unit.
    pub length: f64,
    /// Number of courses that fit into the height.
    pub courses: f64,
    /// Sum of the dead forces of the blocks that may move.
    pub dead: [f64; 2],
    /// Sum of their live forces for a multiplier of 1.
    pub live: [f64; 2],
}

/// Range of a block's mass, in mean masses.
const MASS_RANGE: [f64; 2] = [0.05, 20.0];

/// Course heights within which blocks without a joint must be kept from colliding.
const NEAR: f64 = 0.2;

/// Course heights by which the sides of other shapes than level rectangles are moved outwards:
/// where two polygons touch exactly, the engine finds a normal of rounding errors.
const OVERLAP: f64 = 1e-6;

impl Model {
    /// Scales the scene. Blocks that are `frozen` become supports.
    ///
    /// # Errors
    /// What this method cannot honour in the scene.
    pub fn new(scene: &Scene, frozen: &[bool]) -> Result<Self, PushoverFact> {
        if scene.blocks().is_empty() {
            return Err(PushoverFact::NoBlocks);
        }
        let (low, high) = scene.bounds();
        let length = course_height(scene);
        let force = scene.total_weight() / scene.blocks().len() as f64;
        if force <= 0.0 {
            return Err(PushoverFact::NoWeight);
        }
        let areas: f64 = scene.blocks().iter().map(|block| block.shape.area()).sum();
        let area = areas / scene.blocks().len() as f64;
        let point = |p: Point| -> [f64; 2] { ((p - low) / length).into() };
        let vector = |v: Vector| -> [f64; 2] { (v / force).into() };
        let surfaces = surfaces(scene, NEAR * length)?;
        let supports = scene.supports().iter().zip(surfaces.supports).enumerate();
        let mut supports: Vec<Support> = supports
            .map(|(index, (shape, surfaces))| Support {
                side: Side::Support(index),
                centre: point(shape.centroid()),
                outline: outline(shape, length),
                surfaces,
            })
            .collect();
        let mut blocks = Vec::with_capacity(scene.blocks().len());
        for (index, (block, surfaces)) in scene.blocks().iter().zip(surfaces.blocks).enumerate() {
            let shape = &block.shape;
            let centroid = shape.centroid();
            let outline = outline(shape, length);
            if frozen.get(index) == Some(&true) {
                let centre = point(centroid);
                supports.push(Support {
                    side: Side::Block(index),
                    centre,
                    outline,
                    surfaces,
                });
                continue;
            }
            let mass = (shape.area() / area).clamp(MASS_RANGE[0], MASS_RANGE[1]);
            let loads = block.loads.iter().map(|load| Force {
                arm: ((load.point - centroid) / length).into(),
                dead: vector(load.dead),
                live: vector(load.live),
            });
            let corners = shape.corners().iter();
            let reach = corners.map(|c| (c - centroid).norm()).fold(0.0, f64::max);
            blocks.push(Body {
                index,
                centre: point(centroid),
                outline,
                mass,
                inertia: mass * gyration_squared(shape) / (length * length),
                reach: reach / length,
                surfaces,
                loads: loads.collect(),
            });
        }
        let sum = |part: fn(&Force) -> [f64; 2]| {
            let loads = blocks.iter().flat_map(|block: &Body| &block.loads);
            loads
                .map(part)
                .fold([0.0; 2], |[x, y], f| [x + f[0], y + f[1]])
        };
        Ok(Self {
            dead: sum(|load| load.dead),
            live: sum(|load| load.live),
            supports,
            blocks,
            length,
            courses: ((high.y - low.y) / length).max(1.0),
        })
    }
}

/// Median height of the blocks.
fn course_height(scene: &Scene) -> f64 {
    let height = |block: &crate::scene::Block| {
        let (low, high) = block.shape.bounds();
        high.y - low.y
    };
    let mut heights: Vec<f64> = scene.blocks().iter().map(height).collect();
    heights.sort_by(f64::total_cmp);
    heights[heights.len() / 2]
}

/// Corners relative to the centroid.
fn outline(shape: &Polygon, length: f64) -> Vec<[f64; 2]> {
    let centroid = shape.centroid();
    // Each side as outward unit normal and distance from the centroid.
    let side = |(a, b): (Point, Point)| {
        let along = (b - a).normalize();
        let normal = Vector::new(along.y, -along.x);
        (normal, (a - centroid).dot(&normal) / length)
    };
    let mut sides: Vec<(Vector, f64)> = shape.edges().map(side).collect();
    let level = |&(n, _): &(Vector, f64)| n.x.abs().min(n.y.abs()) < 1e-9;
    if !sides.iter().all(level) {
        sides.iter_mut().for_each(|side| side.1 += OVERLAP);
    }
    let count = sides.len();
    let corner = |i: usize| {
        let ((n, d), (m, e)) = (sides[(i + count - 1) % count], sides[i]);
        // The point p with p·n = d and p·m = e.
        let det = n.perp(&m);
        [(d * m.y - e * n.y) / det, (e * n.x - d * m.x) / det]
    };
    (0..count).map(corner).collect()
}

/// Square of the radius of gyration of a uniform polygon about its centroid.
fn gyration_squared(shape: &Polygon) -> f64 {
    let centroid = shape.centroid();
    let (mut moment, mut area) = (0.0, 0.0);
    for (a, b) in shape.edges() {
        let (a, b) = (a - centroid, b - centroid);
        let double = a.perp(&b);
        moment += double * (a.dot(&a) + a.dot(&b) + b.dot(&b)) / 12.0;
        area += double / 2.0;
    }
    moment / area
}
