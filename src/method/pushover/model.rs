//! The scene without dimensions: lengths in course heights, forces in mean block weights, g = 1, and
//! live loads that for a multiplier λ* of 1 add up to the dead ones.
//!
//! Physics engines carry lengths of their own (prediction distances, slops), so a scene in millimetres
//! or far from the origin would fail by construction; here every scene looks alike.

use super::faces::{Face, faces};
use super::mass::{Inert, inert};
use super::portion::Portion;
use super::tuned::Tuned;
use crate::answer::{Bracket, PushoverFact};
use crate::mechanics::reach;
use crate::scene::{Block, Point, Polygon, Scene, Side, Vector, multiplier_unit};

/// A force at a point that turns with its block.
pub struct BodyForce {
    /// From the block's centre to the point.
    pub arm: [f64; 2],
    /// Constant part.
    pub dead: [f64; 2],
    /// Part for a multiplier λ* of 1.
    pub live: [f64; 2],
}

/// A block as rapier sees it.
pub struct MovingBody {
    /// Its place in the scene.
    pub index: usize,
    /// Centroid, or the point that a support turns about.
    pub centre: [f64; 2],
    /// Whether that point stays where it is.
    pub is_pinned: bool,
    /// Its centroid relative to the centre.
    pub centroid: [f64; 2],
    /// Its faces, with middles relative to the centre.
    pub faces: Vec<Face>,
    /// Mass, in mean weights over g.
    pub mass: f64,
    /// Moment of inertia about the centre.
    pub inertia: f64,
    /// Largest distance of a corner from the centre.
    pub reach: f64,
    /// What its displacements are magnified by before they are judged.
    pub smallness: f64,
    /// What its speeds are magnified by before they are judged.
    pub slowness: f64,
    /// Forces.
    pub loads: Vec<BodyForce>,
}

/// The dimensionless scene.
pub struct Model<'a> {
    /// The scene itself.
    pub scene: &'a Scene,
    /// What of it is pushed.
    pub portion: &'a Portion,
    /// Blocks that may move, in the scene's order.
    pub blocks: Vec<MovingBody>,
    /// Faces of supports and of blocks held fixed.
    pub fixed: Vec<Face>,
    /// Joints that have faces, by their places in the scene.
    pub joints: Vec<usize>,
    /// Course height: the median block height, in the scene's length unit.
    pub length: f64,
    /// Number of courses that fit into the height.
    pub courses: f64,
    /// The smaller of width and height, in course heights.
    pub extent: f64,
    /// Sum of the dead forces of the blocks that may move; a pin takes those of its block.
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

impl<'a> Model<'a> {
    /// Scales a portion of the scene. Blocks that it holds fixed become supports.
    ///
    /// # Errors
    /// What this method cannot honour in the scene.
    pub fn new(
        scene: &'a Scene,
        portion: &'a Portion,
        tuned: &Tuned,
    ) -> Result<Self, PushoverFact> {
        let units = Units::of(scene, portion)?;
        let inert = inert(
            scene,
            portion,
            [units.force, units.area, units.length],
            tuned,
        )?;
        let faces = faces(scene, portion, (units.origin, units.length))?;
        let free = (scene.blocks().iter().enumerate()).filter(|&(index, _)| portion.is_free(index));
        let mut blocks: Vec<MovingBody> = free
            .map(|(index, block)| units.body((index, block), scene.pin(index), inert[index]))
            .collect();
        let mut joints: Vec<usize> = faces.iter().map(|face| face.joint).collect();
        joints.dedup();
        let mut fixed = Vec::new();
        for face in faces {
            let of = |block: &MovingBody| Side::Block(block.index);
            // In the scene's order, so that they can be searched.
            match blocks.binary_search_by_key(&face.body, of) {
                Ok(place) => {
                    let [x, y] = blocks[place].centre;
                    let centre = [face.centre[0] - x, face.centre[1] - y];
                    blocks[place].faces.push(Face { centre, ..face });
                }
                Err(_) => fixed.push(face),
            }
        }
        Ok(Self {
            scene,
            portion,
            smallness: blocks
                .iter()
                .map(|block| block.smallness)
                .fold(1.0, f64::max),
            dead: total(&blocks, |load| load.dead),
            live: total(&blocks, |load| load.live),
            fixed,
            joints,
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
        let (low, high) = portion.bounds(scene);
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

    fn body(
        &self,
        (index, block): (usize, &Block),
        pin: Option<Point>,
        inert: Inert,
    ) -> MovingBody {
        let shape = &block.shape;
        let centre = pin.unwrap_or(shape.centroid());
        let centroid = shape.centroid() - centre;
        let mass = inert.mass;
        let gyration = gyration_squared(shape) + centroid.norm_squared();
        let loads = block.loads.iter().map(|load| BodyForce {
            arm: ((load.point - centre) / self.length).into(),
            dead: self.vector(load.dead),
            live: self.vector(load.live * self.multiplier),
        });
        MovingBody {
            index,
            centre: self.point(centre),
            is_pinned: pin.is_some(),
            centroid: (centroid / self.length).into(),
            faces: Vec::new(),
            mass,
            inertia: mass * gyration / (self.length * self.length),
            reach: (reach(block) + centroid.norm()) / self.length,
            smallness: inert.smallness,
            slowness: inert.slowness,
            loads: loads.collect(),
        }
    }
}

/// Sum of a part of all forces on bodies that no pin holds.
fn total(blocks: &[MovingBody], part: fn(&BodyForce) -> [f64; 2]) -> [f64; 2] {
    let free = blocks.iter().filter(|block| !block.is_pinned);
    let loads = free.flat_map(|block| &block.loads);
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
