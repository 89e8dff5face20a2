//! The whole search: settle, then raise λ from rest to rest until the smallest step collapses.

use super::engine::{Contact, Engine, State};
use super::model::{Body, Model};
use super::settings::{GRID, Settings};

/// How a hold at constant λ ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Hold {
    /// Speeds fell below the limit and stayed there without help.
    Rest,
    /// Displaced beyond the limit and not slowing down.
    Collapse,
    /// Neither within the time allowed.
    Unclear,
}

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

/// Raises λ from rest to rest: by doubling while all goes well, by smaller steps after the first
/// failure. A large step overshoots, so its collapse only says that the step was too large.
pub fn search(engine: &mut Engine, model: &Model, settings: &Settings) -> Search {
    engine.multiplier = 0.0;
    match hold(
        engine,
        model,
        settings,
        settings.settled_speed,
        settings.fall,
    ) {
        Hold::Rest => {}
        Hold::Collapse => {
            let distance = settings.fall;
            return Search::Falls(format!(
                "under its weight alone a block moved by more than {distance} course heights and \
                 was not slowing down"
            ));
        }
        Hold::Unclear => {
            let time = settings.patience;
            return Search::Undecided(format!(
                "under its weight alone the scene did not come to rest within t = {time} √(H_c/g)"
            ));
        }
    }
    let settled = Seen::now(engine);
    let mut rest = engine.checkpoint();
    let mut seen = Seen::now(engine);
    let mut lower: u64 = 0;
    let mut increment = settings.first_increment;
    let mut failed = false;
    let mut unclear = false;
    loop {
        let target = lower + increment;
        if engine.steps > settings.budget {
            let lambda = lower as f64 / GRID;
            return Search::Undecided(format!(
                "gave up after the time steps allowed; last at rest at λ = {lambda}"
            ));
        }
        if target > settings.largest {
            let lambda = lower as f64 / GRID;
            return Search::Undecided(format!(
                "the scene still stands at λ = {lambda}; nothing larger is tried"
            ));
        }
        let finest = finest_increment(target, settings.tolerance);
        let last = increment <= finest || unclear;
        let limit = if last {
            settings.collapse
        } else {
            settings.runaway
        };
        // An unbalanced tenth of the smallest increment would reach this speed in a window.
        let slow = 0.1 * finest as f64 / GRID * settings.window;
        engine.multiplier = target as f64 / GRID;
        match hold(engine, model, settings, slow, limit) {
            Hold::Rest => {
                rest = engine.checkpoint();
                seen = Seen::now(engine);
                lower = target;
                unclear = false;
                if !failed {
                    increment = larger(increment);
                }
            }
            Hold::Collapse if last => {
                return Search::Found(Box::new(Found {
                    lower,
                    upper: target,
                    settled,
                    rest: seen,
                    collapsed: engine.states(),
                }));
            }
            Hold::Unclear if unclear => {
                let lambda = engine.multiplier;
                return Search::Undecided(format!(
                    "at λ = {lambda} the scene neither rests nor collapses within the time allowed"
                ));
            }
            Hold::Unclear if last => {
                // Perhaps too close to the limit to tell; a step twice as long may still tell.
                unclear = true;
                increment = 2 * finest;
                engine.restore(&rest);
            }
            Hold::Collapse | Hold::Unclear => {
                failed = true;
                increment = smaller(increment).max(finest);
                engine.restore(&rest);
            }
        }
    }
}

/// Holds λ until the blocks rest at speeds below `slow`, or move further than `limit` without
/// slowing down. Kinetic damping: whenever the kinetic energy falls, all blocks are stopped, so
/// that a step is followed quasi-statically; the last window must stay at rest without it.
fn hold(engine: &mut Engine, model: &Model, settings: &Settings, slow: f64, limit: f64) -> Hold {
    let from = engine.states();
    let steps = (settings.window / engine.dt()).ceil() as usize;
    let windows = (settings.patience / settings.window).ceil() as usize;
    let mut before = f64::INFINITY;
    let mut energy = 0.0;
    for _ in 0..windows {
        let damped = before > slow;
        let mut peak: f64 = 0.0;
        for _ in 0..steps {
            engine.step();
            if engine.broken {
                return Hold::Unclear;
            }
            let states = engine.states();
            let now = speed(model, &states);
            peak = peak.max(now);
            if displacement(model, &from, &states) > limit && now >= before {
                return Hold::Collapse;
            }
            let present = kinetic_energy(model, &states);
            let falling = present < settings.damp_below * energy;
            if damped && falling {
                engine.stop();
            }
            energy = if falling { 0.0 } else { present.max(energy) };
        }
        if !damped && peak <= slow {
            return Hold::Rest;
        }
        before = peak;
    }
    Hold::Unclear
}

/// Largest increment of the series 1, 2, 5, 10, … that is no more than `tolerance` of λ.
fn finest_increment(lambda: u64, tolerance: f64) -> u64 {
    let limit = lambda as f64 * tolerance;
    let mut increment = 1;
    while larger(increment) as f64 <= limit {
        increment = larger(increment);
    }
    increment
}

/// The next increment of the series 1, 2, 5, 10, …
fn larger(increment: u64) -> u64 {
    match leading_digit(increment) {
        2 => increment / 2 * 5,
        _ => increment * 2,
    }
}

/// Two back in the series 1, 2, 5, 10, …, but at least 1.
fn smaller(increment: u64) -> u64 {
    match leading_digit(increment) {
        5 => increment / 5,
        2 => increment / 4,
        _ => increment / 5,
    }
    .max(1)
}

fn leading_digit(mut number: u64) -> u64 {
    while number >= 10 {
        number /= 10;
    }
    number
}

/// Largest speed of any point of any block.
pub fn speed(model: &Model, states: &[State]) -> f64 {
    let of = |(state, block): (&State, &Body)| {
        let [x, y] = state.velocity;
        (x * x + y * y).sqrt() + state.spin.abs() * block.reach
    };
    states.iter().zip(&model.blocks).map(of).fold(0.0, f64::max)
}

/// Largest displacement of any point of any block.
pub fn displacement(model: &Model, from: &[State], to: &[State]) -> f64 {
    farthest(&model.blocks, from, to)
}

/// Largest displacement of any point of these blocks.
pub fn farthest(blocks: &[Body], from: &[State], to: &[State]) -> f64 {
    let of = |((a, b), block): ((&State, &State), &Body)| {
        let (x, y) = (b.position[0] - a.position[0], b.position[1] - a.position[1]);
        (x * x + y * y).sqrt() + (b.rotation - a.rotation).abs() * block.reach
    };
    from.iter().zip(to).zip(blocks).map(of).fold(0.0, f64::max)
}

/// Twice the kinetic energy.
fn kinetic_energy(model: &Model, states: &[State]) -> f64 {
    let of = |(state, block): (&State, &Body)| {
        let [x, y] = state.velocity;
        block.mass * (x * x + y * y) + block.inertia * state.spin * state.spin
    };
    states.iter().zip(&model.blocks).map(of).sum()
}
