//! What only a coursed wall has: what its crack is measured with, and the wall of the closed form.

use serde::{Deserialize, Serialize};

/// What the crack slope of a coursed wall is measured with.
#[derive(Clone, Debug, PartialEq)]
pub struct Coursing {
    /// Wall height H.
    pub height: f64,
    /// Heights of the tops of the courses above the lowest point, from bottom to top.
    pub levels: Vec<f64>,
    /// Overlap s = l/2.
    pub overlap: f64,
    /// Whether it is laid of units and halves alone, as the crack slope supposes.
    pub halves: bool,
}

impl Coursing {
    /// How many courses there are up to a height above the lowest point.
    pub(crate) fn courses_up_to(&self, height: f64) -> usize {
        // As exact as any height that comes from moved or scaled corners.
        let near = 1e-6 * self.height;
        self.levels.partition_point(|&level| level <= height + near)
    }
}

/// The regular wall of the closed form (paper, Figs. 1-3).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RegularWall {
    /// Height H.
    pub height: f64,
    /// Width L.
    pub length: f64,
    /// Overlap s of units in adjacent courses.
    pub overlap: f64,
    /// Height h of a unit.
    pub unit_height: f64,
    /// Thickness b.
    pub thickness: f64,
    /// Specific weight γ.
    pub specific_weight: f64,
    /// Overburden p, force per area.
    pub overburden: f64,
    /// Coefficient of friction f.
    pub friction: f64,
}

/// Why a wall is not a regular one.
#[allow(missing_docs, reason = "the sentence of each says it")]
#[derive(Clone, Debug, PartialEq, thiserror::Error, Serialize, Deserialize)]
pub enum Irregularity {
    #[error("a single course has no stagger line")]
    SingleCourse,
    /// The course (from 1, bottom to top) breaks the running bond.
    #[error("course {0} is not laid in regular running bond")]
    NotRunningBond(usize),
    /// The course (from 1, bottom to top) holds pieces by which units do not lap by half.
    #[error(
        "course {0} has pieces that are neither units nor halves: the closed form assumes an overlap s = l/2"
    )]
    NotHalves(usize),
    /// Bed joints and base joint of different friction, of which Eq. (1) knows one.
    #[error(
        "the bed joints and the base differ in friction, and the closed form knows one coefficient"
    )]
    Friction,
    #[error("some joints have a friction of their own, and the closed form knows one coefficient")]
    OwnFriction,
    /// The course (from 1, bottom to top) is higher or lower than a unit.
    #[error("course {0} is not as high as a unit: the closed form knows one height of courses")]
    Height(usize),
    /// Weights act upwards or downwards too as they push.
    #[error("the push acts up or down as well, and the closed form knows it sideways alone")]
    PushedVertically,
    #[error("some blocks have weights or loads of their own, which the closed form does not know")]
    OwnLoads,
    #[error("course {0} is not as wide as the first")]
    Width(usize),
    #[error("a support moves, and the closed form knows pushes alone")]
    SupportMoves,
    #[error("the scene is not a coursed wall")]
    NotCoursed,
}

/// What only a coursed wall has: what its crack slope is measured with, and the closed form's wall.
#[derive(Clone, Debug, PartialEq)]
pub struct WallFacts {
    /// Height and overlap; `None` where no course is staggered against the next.
    pub coursing: Option<Coursing>,
    /// The regular wall of the closed form, or why this is none.
    pub regular: Result<RegularWall, Irregularity>,
}
