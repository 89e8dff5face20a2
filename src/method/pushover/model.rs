//! The scene without dimensions: lengths in course heights, forces in mean block weights, g = 1, and
//! live loads that for a multiplier λ* of 1 add up to the dead ones.
//!
//! Physics engines carry lengths of their own (prediction distances, slops), so a scene in millimetres
//! or far from the origin would fail by construction; here every scene looks alike.

use super::groups::{Surface, surfaces};
use super::mass::{Inert, inert};
use super::portion::{Portion, Role};
use super::tuned::Tuned;
use crate::answer::{Bracket, PushoverFact};
use crate::mechanics::reach;
use crate::scene::{Block, Point, Polygon, Scene, Side, Vector, multiplier_unit};

/// A force at a point that turns with its block.
pub struct BodyForce {
    /// From the centroid to the point.
    pub arm: [f64; 2],
    /// Constant part.
    pub dead: [f64; 2],
    /// Part for a multiplier λ* of 1.
    pub live: [f64; 2],
}

/// Corners of a convex piece.
pub type Outline = Vec<[f64; 2]>;

/// A block as rapier sees it.
pub struct MovingBody {
    /// Its place in the scene.
    pub index: usize,
    /// Centroid.
    pub centre: [f64; 2],
    /// Convex pieces of the collision shape: corners relative to the centroid, counter-clockwise.
    pub outlines: Vec<Outline>,
    /// Mass, in mean weights over g.
    pub mass: f64,
    /// Moment of inertia about the centroid.
    pub inertia: f64,
    /// Largest distance of a corner from the centroid.
    pub reach: f64,
    /// What its displacements are magnified by before they are judged.
    pub smallness: f64,
    /// What its speeds are magnified by before they are judged.
    pub slowness: f64,
    /// What it collides with, and how rough it is.
    pub surfaces: Vec<Surface>,
    /// Forces.
    pub loads: Vec<BodyForce>,
}

/// A support as rapier sees it.
pub struct FixedBody {
    /// What it is in the scene: a support, or a block that is held fixed.
    pub side: Side,
    /// Centroid.
    pub centre: [f64; 2],
    /// Convex pieces: corners relative to the centroid, counter-clockwise.
    pub outlines: Vec<Outline>,
    /// What it collides with, and how rough it is.
    pub surfaces: Vec<Surface>,
}

/// The dimensionless scene.
pub struct Model {
    /// Blocks that may move, in the scene's order.
    pub blocks: Vec<MovingBody>,
    /// Supports in the scene's order, then blocks held fixed.
    pub supports: Vec<FixedBody>,
    /// Course height: the median block height, in the scene's length unit.
    pub length: f64,
    /// Number of courses that fit into the height.
    pub courses: f64,
    /// The smaller of width and height, in course heights.
    pub extent: f64,
    /// Sum of the dead forces of the blocks that may move.
    pub dead: [f64; 2],
    /// Sum of their live forces for a multiplier λ* of 1.
    pub live: [f64; 2],
    /// λ for a multiplier λ* of 1.
    pub multiplier: f64,
    /// Of the smallest block that may move: what distances for blocks of ordinary size are divided by.
    pub smallness: f64,
}

/// λ* is a whole number of these, and λ where every block's live load is its weight; such brackets
/// then print exactly with five decimals.
pub const GRID: f64 = 1e5;

/// Course heights within which blocks without a joint must be kept from colliding.
const NEAR: f64 = 0.2;

/// Course heights by which the sides of other shapes than level rectangles are moved outwards:
/// where two polygons touch exactly, rapier finds a normal of rounding errors.
const OVERLAP: f64 = 1e-6;

impl Model {
    /// Scales a portion of the scene. Blocks that it holds fixed become supports.
    ///
    /// # Errors
    /// What this method cannot honour in the scene.
    pub fn new(scene: &Scene, portion: &Portion, tuned: &Tuned) -> Result<Self, PushoverFact> {
        let units = Units::of(scene, portion)?;
        let inert = inert(
            scene,
            portion,
            [units.force, units.area, units.length],
            tuned,
        )?;
        let surfaces = surfaces(scene, NEAR * units.length)?;
        let supports = scene.supports().iter().zip(surfaces.supports).enumerate();
        let mut supports: Vec<FixedBody> = supports
            .map(|(index, (shape, surfaces))| units.support(Side::Support(index), shape, surfaces))
            .collect();
        let mut blocks = Vec::with_capacity(scene.blocks().len());
        for (index, (block, surfaces)) in scene.blocks().iter().zip(surfaces.blocks).enumerate() {
            match portion.role(index) {
                Role::Fixed => {
                    supports.push(units.support(Side::Block(index), &block.shape, surfaces));
                }
                Role::Free => blocks.push(units.body(index, block, inert[index], surfaces)),
                Role::Absent => {}
            }
        }
        Ok(Self {
            smallness: blocks
                .iter()
                .map(|block| block.smallness)
                .fold(1.0, f64::max),
            dead: total(&blocks, |load| load.dead),
            live: total(&blocks, |load| load.live),
            supports,
            blocks,
            length: units.length,
            multiplier: units.multiplier,
            extent: units.extent / units.length,
            courses: (units.height / units.length).max(1.0),
        })
    }

    /// λ of a λ* in grid units.
    pub fn lambda(&self, grid: u64) -> f64 {
        grid as f64 / GRID * self.multiplier
    }

    /// A bracket of λ as λ* in grid units.
    pub fn in_grid(&self, at: Bracket) -> [u64; 2] {
        [at.lower, at.upper].map(|lambda| (lambda / self.multiplier * GRID).round() as u64)
    }
}

/// What lengths, forces and areas of a portion are divided by.
struct Units {
    origin: Point,
    /// Of the portion, in the scene's length unit.
    height: f64,
    /// The smaller of its width and its height.
    extent: f64,
    /// Course height.
    length: f64,
    /// Mean block weight.
    force: f64,
    /// Mean block area.
    area: f64,
    /// λ at which the live loads add up to the dead ones.
    multiplier: f64,
}

impl Units {
    fn of(scene: &Scene, portion: &Portion) -> Result<Self, PushoverFact> {
        let blocks: Vec<&Block> = portion.present(scene).collect();
        if blocks.is_empty() {
            return Err(PushoverFact::NoBlocks);
        }
        let count = blocks.len() as f64;
        let [dead, live] = portion.forces(scene);
        if dead <= 0.0 {
            return Err(PushoverFact::NoWeight);
        }
        let boxes = blocks.iter().map(|block| block.shape.bounds());
        let (low, high) = boxes.fold(blocks[0].shape.bounds(), |(low, high), (l, h)| {
            (low.inf(&l), high.sup(&h))
        });
        let areas: f64 = blocks.iter().map(|block| block.shape.area()).sum();
        Ok(Self {
            origin: low,
            height: high.y - low.y,
            extent: (high - low).min(),
            length: course_height(&blocks),
            force: dead / count,
            area: areas / count,
            multiplier: multiplier_unit(dead, live),
        })
    }

    fn point(&self, point: Point) -> [f64; 2] {
        ((point - self.origin) / self.length).into()
    }

    fn vector(&self, force: Vector) -> [f64; 2] {
        (force / self.force).into()
    }

    fn support(&self, side: Side, shape: &Polygon, surfaces: Vec<Surface>) -> FixedBody {
        FixedBody {
            side,
            centre: self.point(shape.centroid()),
            outlines: outlines(shape, self.length),
            surfaces,
        }
    }

    fn body(
        &self,
        index: usize,
        block: &Block,
        inert: Inert,
        surfaces: Vec<Surface>,
    ) -> MovingBody {
        let shape = &block.shape;
        let centroid = shape.centroid();
        let mass = inert.mass;
        let loads = block.loads.iter().map(|load| BodyForce {
            arm: ((load.point - centroid) / self.length).into(),
            dead: self.vector(load.dead),
            live: self.vector(load.live * self.multiplier),
        });
        MovingBody {
            index,
            centre: self.point(centroid),
            outlines: outlines(shape, self.length),
            mass,
            inertia: mass * gyration_squared(shape) / (self.length * self.length),
            reach: reach(block) / self.length,
            smallness: inert.smallness,
            slowness: inert.slowness,
            surfaces,
            loads: loads.collect(),
        }
    }
}

/// Sum of a part of all forces.
fn total(blocks: &[MovingBody], part: fn(&BodyForce) -> [f64; 2]) -> [f64; 2] {
    let loads = blocks.iter().flat_map(|block| &block.loads);
    let add = |[x, y]: [f64; 2], force: [f64; 2]| [x + force[0], y + force[1]];
    loads.map(part).fold([0.0; 2], add)
}

/// Median height of the blocks.
fn course_height(blocks: &[&Block]) -> f64 {
    let height = |block: &&Block| {
        let (low, high) = block.shape.bounds();
        high.y - low.y
    };
    let mut heights: Vec<f64> = blocks.iter().map(height).collect();
    heights.sort_by(f64::total_cmp);
    heights[heights.len() / 2]
}

/// Convex pieces of a shape, exactly: their inner sides lie on each other.
fn outlines(shape: &Polygon, length: f64) -> Vec<Outline> {
    let whole = outline(shape, length);
    let pieces = shape.convex_pieces().into_iter();
    pieces
        .map(|piece| piece.into_iter().map(|corner| whole[corner]).collect())
        .collect()
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
