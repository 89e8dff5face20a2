//! How the programs of a search are written and solved.

use crate::method::limit::equilibration::{UnitPower, unit_powers};
use crate::method::settings::Engine;
use crate::scene::Scene;

/// How far the solver refines its linear systems.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Refinement {
    /// A quarter less time, and enough for most scenes.
    Rough,
    /// As far as it can.
    Full,
}

/// How the programs of a search are written and solved.
#[derive(Clone, Copy, Debug)]
pub(super) struct Numerics {
    /// Units of unequal blocks.
    pub(super) power: UnitPower,
    /// What solves them.
    pub(super) engine: Engine,
    /// How far Clarabel refines.
    pub(super) refinement: Refinement,
}

impl Numerics {
    /// Those that are tried first, enough for most scenes.
    pub(super) fn first(engine: Engine) -> Numerics {
        Numerics {
            power: UnitPower::CubeRoot,
            engine,
            refinement: Refinement::Rough,
        }
    }

    /// Those that are tried on a scene one after the other, until one of them finds a state: after the
    /// first ones Clarabel with full refinement, by each way to even out unequal blocks.
    pub(super) fn of(scene: &Scene, engine: Engine) -> Vec<Numerics> {
        let powers = unit_powers(scene);
        let refined = powers.iter().map(|&power| Numerics {
            power,
            engine: Engine::Clarabel,
            refinement: Refinement::Full,
        });
        // Programs of unequal blocks are refined in full by Clarabel anyway.
        let first =
            (engine == Engine::Structured || powers.len() == 1).then(|| Self::first(engine));
        first.into_iter().chain(refined).collect()
    }
}
