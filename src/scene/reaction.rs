//! What λ says where a support moves.

use serde::{Deserialize, Serialize};

use crate::number::{above, below};
use crate::text::worded;

worded! {
    /// Which way a support moves.
    #[derive(Serialize, Deserialize)]
    Sense {
        /// Away from the wall: its reaction falls.
        Away = "away",
        /// Against the wall: its reaction rises.
        Against = "against",
    }
}

/// What λ says in a scene with a support that moves: λ is the change of the support's reaction from
/// the one that it begins with, which λ = 0 stands for.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Reaction {
    /// The support's name.
    pub support: String,
    /// The reaction that it begins with, in the case's unit of force, positive towards the wall.
    pub start: f64,
    /// Whether that is the end of the reactions that equilibrium and friction admit, as a linear program
    /// finds it; else they have no such end, and it stands for a large one.
    pub limited: bool,
    /// How far λ can be with associative friction, roughly: a program says so, and nothing proves it.
    pub range: f64,
    /// Whether it falls or rises from there.
    pub sense: Sense,
    /// Weight of the scene without its live load, in the same unit.
    pub weight: f64,
}

impl Reaction {
    /// +1 where the reaction rises with λ, −1 where it falls.
    pub fn sign(&self) -> f64 {
        match self.sense {
            Sense::Away => -1.0,
            Sense::Against => 1.0,
        }
    }

    /// The reaction at a λ, in the case's unit of force.
    pub fn at(&self, lambda: f64) -> f64 {
        self.start + self.sign() * lambda
    }

    /// The same with fixed decimals, rounded towards where it begins.
    pub fn inwards(&self, lambda: f64, decimals: usize) -> String {
        match self.sense {
            Sense::Away => above(self.at(lambda), decimals),
            Sense::Against => below(self.at(lambda), decimals),
        }
    }
}
