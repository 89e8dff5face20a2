//! What a drawing does not say.

use crate::case::heal::Reach;
use crate::scene::{HeadJoints, Push};

/// How a drawing is read.
#[derive(Clone, Debug, PartialEq)]
pub struct DrawingOptions {
    /// The layer of what never moves; without one a layer `support` or `ground`, else the lowest wide
    /// outline.
    pub support: Option<String>,
    /// Layers that are not read.
    pub without: Vec<String>,
    /// Edges that face each other within this part of the smaller block's extent are made to touch, up
    /// to 0.01; 0 heals nothing.
    pub tolerance: f64,
    /// Gaps up to this width in metres, and up to a tenth of the smaller block's extent, are closed to
    /// one line in their middle; `None` leaves the closing to `tolerance`.
    pub gap: Option<f64>,
    /// Chords of an arc are nearer to it than this part of its radius.
    pub chord: f64,
    /// Length of a drawing unit in metres, instead of what the header says.
    pub metres: Option<f64>,
    /// Coefficient of friction of every joint; `None` where it is to be filled in.
    pub friction: Option<f64>,
    /// Weight over the area of the elevation.
    pub specific_weight: f64,
    /// The directions that the case is pushed in.
    pub pushes: Vec<Push>,
    /// What its head joints carry.
    pub head_joints: Vec<HeadJoints>,
}

impl DrawingOptions {
    /// How far apart edges may be that are laid on one line.
    pub(super) fn reach(&self) -> Reach {
        let tolerance = Reach::of_tolerance(self.tolerance);
        self.gap.map_or(tolerance, Reach::of_gap)
    }
}

impl Default for DrawingOptions {
    fn default() -> Self {
        Self {
            support: None,
            without: Vec::new(),
            tolerance: 5e-3,
            gap: None,
            chord: 1e-3,
            metres: None,
            friction: None,
            specific_weight: 1.0,
            pushes: vec![Push::Right],
            head_joints: vec![HeadJoints::Contact],
        }
    }
}
