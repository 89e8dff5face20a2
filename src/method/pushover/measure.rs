//! How far and how fast: pure functions of states.

use super::engine::BodyState;
use super::model::{EngineBody, Model};

/// Largest speed of any point of any block.
pub fn speed(model: &Model, states: &[BodyState]) -> f64 {
    let of = |(state, block): (&BodyState, &EngineBody)| {
        let [x, y] = state.velocity;
        (x * x + y * y).sqrt() + state.spin.abs() * block.reach
    };
    states.iter().zip(&model.blocks).map(of).fold(0.0, f64::max)
}

/// Largest displacement of any point of any block.
pub fn displacement(model: &Model, from: &[BodyState], to: &[BodyState]) -> f64 {
    farthest(&model.blocks, from, to)
}

/// Largest displacement of any point of these blocks.
pub fn farthest(blocks: &[EngineBody], from: &[BodyState], to: &[BodyState]) -> f64 {
    let of = |((a, b), block): ((&BodyState, &BodyState), &EngineBody)| {
        let (x, y) = (b.position[0] - a.position[0], b.position[1] - a.position[1]);
        (x * x + y * y).sqrt() + (b.rotation - a.rotation).abs() * block.reach
    };
    from.iter().zip(to).zip(blocks).map(of).fold(0.0, f64::max)
}

/// Twice the kinetic energy.
pub fn twice_kinetic_energy(model: &Model, states: &[BodyState]) -> f64 {
    let of = |(state, block): (&BodyState, &EngineBody)| {
        let [x, y] = state.velocity;
        block.mass * (x * x + y * y) + block.inertia * state.spin * state.spin
    };
    states.iter().zip(&model.blocks).map(of).sum()
}
