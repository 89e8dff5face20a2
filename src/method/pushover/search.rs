//! The whole search: settle, then raise λ from rest to rest until the smallest step collapses.

use super::engine::{Contact, Engine, State};
use super::hint::{Hint, finest_increment};
use super::hold::{Held, Hold};
use super::model::Model;
use super::parameters::{GRID, Parameters};

/// A bracket and what the self-checks need to know about it.
pub struct Found {
    /// Last λ at rest, in grid units.
    pub lower: u64,
    /// First λ that collapsed, from rest at `lower`, in grid units.
    pub upper: u64,
    /// Blocks settled under their weight.
    pub settled: Seen,
    /// Blocks at rest at `lower`.
    pub rest: Seen,
    /// Blocks when the collapse at `upper` was called.
    pub collapsed: Vec<State>,
    /// The collapse, where frames are asked for.
    pub frames: Vec<Vec<State>>,
}

/// What a rest state looked like.
pub struct Seen {
    /// Blocks.
    pub states: Vec<State>,
    /// Contacts.
    pub contacts: Vec<Contact>,
}

impl Seen {
    fn now(engine: &Engine) -> Self {
        Self {
            states: engine.states(),
            contacts: engine.contacts(),
        }
    }
}

/// How a search ended.
pub enum Search {
    /// With a bracket.
    Found(Box<Found>),
    /// Without one; why.
    Undecided(String),
    /// Under the own weight alone; the evidence.
    Falls(String),
}

/// Raises λ from rest to rest: by doubling until a step runs away, then to where the runaways
/// extrapolate the limit. That is only a hint of where to look: the bracket is a proved rest and a
/// collapse from it by a step no longer than the tolerance. A longer step overshoots, so its
/// collapse says no more than that the limit is near.
///
/// `slip` gives the largest slip of a joint between two states; a rest with more of it than the
/// parameters allow is a collapse too.
pub fn search(
    engine: &mut Engine,
    model: &Model,
    parameters: &Parameters,
    slip: impl Fn(&[State], &[State]) -> f64,
) -> Search {
    let mut hold = Hold::new(model, parameters);
    match hold.settle(engine) {
        Held::Rest => {}
        Held::Collapse { .. } => {
            let distance = parameters.fall;
            return Search::Falls(format!(
                "under its weight alone a block moved by more than {distance} course heights and \
                 was not slowing down"
            ));
        }
        Held::Unclear => {
            let time = parameters.patience;
            return Search::Undecided(format!(
                "under its weight alone the scene did not come to rest within t = {time} √(H_c/g)"
            ));
        }
    }
    let settled = Seen::now(engine);
    let mut rest = engine.checkpoint();
    let mut seen = Seen::now(engine);
    let mut hint = Hint::new(parameters.first_increment);
    let mut lower: u64 = 0;
    let mut unclear = false;
    loop {
        let finest = finest_increment(hint.near(lower), parameters.tolerance);
        let target = match unclear {
            true => lower + 2 * finest,
            false => hint.next(lower, finest),
        };
        let last = unclear || target - lower <= finest;
        if engine.steps > parameters.budget {
            let lambda = lower as f64 / GRID;
            return Search::Undecided(format!(
                "gave up after the time steps allowed; last at rest at λ = {lambda}"
            ));
        }
        if target > parameters.largest {
            let lambda = lower as f64 / GRID;
            return Search::Undecided(format!(
                "the scene still stands at λ = {lambda}; nothing larger is tried"
            ));
        }
        let held = match hold.step(engine, [lower, target], finest, last) {
            Held::Rest if slip(&settled.states, &engine.states()) > parameters.slip => {
                Held::Collapse { acceleration: 0.0 }
            }
            held => held,
        };
        match held {
            Held::Rest => {
                rest = engine.checkpoint();
                seen = Seen::now(engine);
                lower = target;
                unclear = false;
                hint.rested(lower, finest);
            }
            Held::Collapse { .. } if last => {
                return Search::Found(Box::new(Found {
                    lower,
                    upper: target,
                    settled,
                    rest: seen,
                    collapsed: engine.states(),
                    frames: hold.frames,
                }));
            }
            Held::Collapse { acceleration } => {
                hint.ran_away(target, acceleration);
                engine.restore(&rest);
            }
            Held::Unclear if unclear => {
                let lambda = engine.multiplier;
                return Search::Undecided(format!(
                    "at λ = {lambda} the scene neither rests nor collapses within the time allowed"
                ));
            }
            Held::Unclear => {
                // Perhaps too close to the limit to tell; a step twice as long may still tell.
                unclear = last;
                hint.ran_away(target, 0.0);
                engine.restore(&rest);
            }
        }
    }
}
