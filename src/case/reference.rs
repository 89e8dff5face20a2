//! Values that results are compared with.

use crate::method::METHODS;
use crate::scene::HeadJoints;
use crate::text::worded;

/// A value that a result is compared with.
#[derive(Clone, Debug, PartialEq)]
pub struct Reference {
    /// Name of the method.
    pub method: String,
    /// The setting it holds for; `None` stands for every setting of the case.
    pub head_joints: Option<HeadJoints>,
    /// Which number of the result.
    pub quantity: Quantity,
    /// The number; not negative.
    pub value: f64,
    /// Absolute; positive.
    pub tolerance: f64,
    /// Where the value was printed, or which code computed it.
    pub source: String,
    /// What kind of source that is.
    pub kind: SourceKind,
    /// Free text; may be empty.
    pub note: String,
    /// Set on a known deviation: the reason why the value is expected *not* to be met.
    pub deviation: Option<String>,
}

/// The methods that a reference can name: all of them, in the order of tables.
pub(super) fn known_method_names() -> impl Iterator<Item = &'static str> {
    METHODS.iter().map(|method| method.name())
}

worded! {
    /// A number of a result.
    #[derive(PartialOrd, Ord)]
    Quantity {
        /// The collapse multiplier: both ends of the bracket.
        Lambda = "lambda",
        /// The lower end of the bracket.
        Lower = "lower",
        /// The upper end of the bracket.
        Upper = "upper",
        /// Slope of the crack.
        TanBeta = "tan_beta",
        /// Width that moves as one rigid body along the top, in the case's unit of length.
        C = "c",
        /// Width that moves at all along the top.
        E = "e",
        /// The reaction of a support that moves: both ends of the bracket.
        Reaction = "reaction",
        /// 1 where the scene stands under its dead load, 0 where it falls.
        AtRest = "at_rest",
    }
}

impl Quantity {
    /// What it is, in words.
    pub fn words(self) -> &'static str {
        match self {
            Quantity::Lambda => "λ",
            Quantity::Lower => "the lower λ",
            Quantity::Upper => "the upper λ",
            Quantity::TanBeta => "tan β",
            Quantity::C => "the width c",
            Quantity::E => "the width e",
            Quantity::Reaction => "the reaction",
            Quantity::AtRest => "the rest under its own weight",
        }
    }
}

worded! {
    /// What stands behind a reference; ordered as tables prefer them.
    #[derive(PartialOrd, Ord)]
    SourceKind {
        /// Printed in the literature.
        Published = "published",
        /// An exact answer.
        Analytic = "analytic",
        /// Computed by another code.
        Independent = "independent",
    }
}
