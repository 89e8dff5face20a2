//! What every method gets: convex blocks with forces, joints, friction, and nothing else.

mod arch;
mod assembly;
mod bond;
mod derived;
mod friction;
mod joints;
mod parts;
mod polygon;
mod soundness;
mod wall;

pub use arch::Arch;
pub use assembly::{Assembly, Force, Forces, NamedBlock, Support};
pub(crate) use bond::{BONDS, Bond, LowestCourse};
pub use friction::Friction;
pub use joints::{Joint, JointClass, Side, TOUCHING};
pub use parts::{SceneError, SceneParts};
pub use polygon::{Point, Polygon, PolygonError, Vector};
pub use soundness::Unsound;
pub use wall::{Course, Irregularity, Piece, RegularWall, Wall, WallError};

/// Which way the live load pushes the wall.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Push {
    /// Towards +x: the toe is the lower right corner.
    Right,
    /// Towards −x.
    Left,
}

impl Push {
    /// +1 for a push to the right, −1 to the left.
    pub fn sign(self) -> f64 {
        match self {
            Push::Right => 1.0,
            Push::Left => -1.0,
        }
    }

    /// The word that cases use.
    pub fn name(self) -> &'static str {
        match self {
            Push::Right => "right",
            Push::Left => "left",
        }
    }
}

/// What the head joints (perpends) of a scene carry.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum HeadJoints {
    /// Coulomb contact.
    Contact,
    /// Nothing: dry-laid, the state before pushing.
    Open,
}

impl HeadJoints {
    /// The word that cases and the command line use.
    pub fn name(self) -> &'static str {
        match self {
            HeadJoints::Contact => "contact",
            HeadJoints::Open => "open",
        }
    }
}

/// What the crack slope of a coursed wall is measured with.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Coursing {
    /// Wall height H.
    pub height: f64,
    /// Overlap s = l/2.
    pub overlap: f64,
    /// Number of courses.
    pub courses: usize,
    /// Whether it is laid of units and halves alone, as the crack slope supposes.
    pub halves: bool,
}

/// A force on a block at a point that moves with it: constant part `dead`, and `λ · live`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Load {
    /// Where both parts act.
    pub point: Point,
    /// Dead force.
    pub dead: Vector,
    /// Live force for a multiplier of 1.
    pub live: Vector,
}

/// A rigid block.
#[derive(Clone, Debug, PartialEq)]
pub struct Block {
    /// Outline.
    pub shape: Polygon,
    /// The block's own weight with its live part first, then what it carries.
    pub loads: Vec<Load>,
}

/// Force x, force y and moment (counter-clockwise) about a block's centroid.
pub type Wrench = [f64; 3];

impl Block {
    /// Resultant of the dead forces about the centroid.
    pub fn dead(&self) -> Wrench {
        self.resultant(|load| load.dead)
    }

    /// Resultant of the live forces about the centroid, for a multiplier of 1.
    pub fn live(&self) -> Wrench {
        self.resultant(|load| load.live)
    }

    fn resultant(&self, part: impl Fn(&Load) -> Vector) -> Wrench {
        let centroid = self.shape.centroid();
        self.loads.iter().fold([0.0; 3], |[x, y, m], load| {
            let force = part(load);
            let arm = load.point - centroid;
            [x + force.x, y + force.y, m + arm.perp(&force)]
        })
    }
}

/// What only a coursed wall has: what its crack slope is measured with, and the closed form's wall.
#[derive(Clone, Debug, PartialEq)]
pub struct WallFacts {
    /// Height and overlap; `None` where no course is staggered against the next.
    pub coursing: Option<Coursing>,
    /// The regular wall of the closed form, or why this is none.
    pub regular: Result<RegularWall, Irregularity>,
}

/// The scene that all methods share. Forces, not masses; no g, no velocities. Made by
/// [`Scene::new`] alone, or from another scene.
#[derive(Clone, Debug, PartialEq)]
pub struct Scene {
    /// Blocks that may move.
    blocks: Vec<Block>,
    /// Shapes that never move: the ground, springers.
    supports: Vec<Polygon>,
    /// Every joint that can carry a force. With open head joints, those are not here.
    joints: Vec<Joint>,
    /// What the head joints carry.
    head_joints: HeadJoints,
    /// Direction of the live load.
    push: Push,
    /// What only a coursed wall has.
    wall: Option<WallFacts>,
}

impl Scene {
    /// Blocks that may move.
    pub fn blocks(&self) -> &[Block] {
        &self.blocks
    }

    /// Shapes that never move: the ground, springers.
    pub fn supports(&self) -> &[Polygon] {
        &self.supports
    }

    /// Every joint that can carry a force. With open head joints, those are not here.
    pub fn joints(&self) -> &[Joint] {
        &self.joints
    }

    /// What the head joints carry.
    pub fn head_joints(&self) -> HeadJoints {
        self.head_joints
    }

    /// What only a coursed wall has.
    pub fn wall(&self) -> Option<&WallFacts> {
        self.wall.as_ref()
    }

    /// Direction of the live load.
    pub fn push(&self) -> Push {
        self.push
    }

    /// Height and overlap of a staggered wall, which the crack slope is measured with.
    pub fn coursing(&self) -> Option<Coursing> {
        self.wall.as_ref()?.coursing
    }

    /// The wall's closed-form description, or why it has none. Only the macro-block needs it.
    ///
    /// # Errors
    /// [`Irregularity`], the first that was met.
    pub fn regular(&self) -> Result<&RegularWall, Irregularity> {
        let wall = self.wall.as_ref().ok_or(Irregularity::NotCoursed)?;
        wall.regular.as_ref().map_err(Clone::clone)
    }

    /// Sum of the magnitudes of all dead forces: the force unit of residuals.
    pub fn total_weight(&self) -> f64 {
        let loads = self.blocks.iter().flat_map(|block| &block.loads);
        loads.map(|load| load.dead.norm()).sum()
    }

    /// Sum of the magnitudes of all live forces for λ = 1.
    pub fn total_live(&self) -> f64 {
        let loads = self.blocks.iter().flat_map(|block| &block.loads);
        loads.map(|load| load.live.norm()).sum()
    }

    /// Lower-left and upper-right corner of all blocks.
    pub fn bounds(&self) -> (Point, Point) {
        let mut boxes = self.blocks.iter().map(|block| block.shape.bounds());
        let first = boxes.next().unwrap_or((Point::origin(), Point::origin()));
        boxes.fold(first, |(low, high), (l, h)| (low.inf(&l), high.sup(&h)))
    }

    /// Height of the blocks above their lowest point: the length unit of residuals.
    pub fn height(&self) -> f64 {
        let (low, high) = self.bounds();
        high.y - low.y
    }
}
