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

/// A number of a result.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Quantity {
    /// The collapse multiplier: both ends of the bracket.
    Lambda,
    /// The lower end of the bracket.
    Lower,
    /// The upper end of the bracket.
    Upper,
    /// Slope of the crack.
    TanBeta,
    /// Width that moves as one rigid body along the top, in the case's unit of length.
    C,
    /// Width that moves at all along the top.
    E,
    /// The reaction of a support that moves: both ends of the bracket.
    Reaction,
    /// 1 where the scene stands under its dead load, 0 where it falls.
    AtRest,
}

impl Quantity {
    /// Every quantity.
    pub(crate) const ALL: [Quantity; 8] = [
        Quantity::Lambda,
        Quantity::Lower,
        Quantity::Upper,
        Quantity::TanBeta,
        Quantity::C,
        Quantity::E,
        Quantity::Reaction,
        Quantity::AtRest,
    ];

    /// What it is, in words.
    pub fn words(self) -> &'static str {
        self.name_and_words().1
    }

    /// The word in case files.
    pub fn name(self) -> &'static str {
        self.name_and_words().0
    }

    fn name_and_words(self) -> (&'static str, &'static str) {
        match self {
            Quantity::Lambda => ("lambda", "λ"),
            Quantity::Lower => ("lower", "the lower λ"),
            Quantity::Upper => ("upper", "the upper λ"),
            Quantity::TanBeta => ("tan_beta", "tan β"),
            Quantity::C => ("c", "the width c"),
            Quantity::E => ("e", "the width e"),
            Quantity::Reaction => ("reaction", "the reaction"),
            Quantity::AtRest => ("at_rest", "the rest under its own weight"),
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
