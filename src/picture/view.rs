//! What a drawing is asked to show.

use std::borrow::Cow;

use crate::method::Kind;
use crate::run::Row;
use crate::scene::Scene;

/// One method's answer for one scene.
#[derive(Clone)]
pub struct View<'a> {
    /// The scene that the answer is about.
    pub scene: &'a Scene,
    /// The answer for that scene alone.
    pub row: Cow<'a, Row>,
    /// tan β of the macro-block model, where it has one for this scene.
    pub macro_slope: Option<f64>,
}

impl View<'_> {
    /// Whether the answer is the closed form's, which has a macro-block instead of a mechanism.
    pub(super) fn is_macro_block(&self) -> bool {
        self.row.kind() == Kind::ClosedForm && self.row.crack.is_some()
    }
}

/// What a drawing shows beside the mechanisms.
#[derive(Clone, Copy, Debug)]
pub struct Options {
    /// Contact forces of each view that has them, in a picture of their own beside the mechanism:
    /// they balance in the wall as it stands.
    pub forces: bool,
    /// The names of the blocks, as answers use them.
    pub labels: bool,
    /// A heading over all, and a legend below.
    pub framed: bool,
    /// Pixels that a picture is wide.
    pub width: f64,
    /// Pixels for a unit of length, so that several drawings share it; else as large as fits.
    pub scale: Option<f64>,
    /// Least pixels that a picture is high, so that several drawings stand on one line.
    pub height: f64,
}

impl Options {
    /// For so many pictures side by side.
    pub fn for_pictures(count: usize) -> Self {
        Self {
            forces: false,
            labels: false,
            framed: true,
            width: match count {
                0 | 1 => 640.0,
                2 => 480.0,
                _ => 400.0,
            },
            scale: None,
            height: 0.0,
        }
    }
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Contents {
    Mechanism,
    Forces,
}
