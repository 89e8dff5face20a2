//! How far and how fast: pure functions of states. What light and small blocks do is magnified, so
//! that it is seen beside heavy ones.

use super::model::{BodyForce, Model, MovingBody};
use super::physics::BodyState;

/// Largest speed of any point of any block.
pub fn speed(model: &Model, states: &[BodyState]) -> f64 {
    let of = |(state, block): (&BodyState, &MovingBody)| {
        let [x, y] = state.velocity;
        block.slowness * ((x * x + y * y).sqrt() + state.spin.abs() * block.reach)
    };
    states.iter().zip(&model.blocks).map(of).fold(0.0, f64::max)
}

/// Largest displacement of any point of any block.
pub fn displacement(model: &Model, from: &[BodyState], to: &[BodyState]) -> f64 {
    let of = |((a, b), block): ((_, _), &MovingBody)| block.smallness * moved(block, a, b);
    let moved = from.iter().zip(to).zip(&model.blocks).map(of);
    moved.fold(0.0, f64::max)
}

/// Largest displacement of any point of a block, not magnified.
pub fn moved(block: &MovingBody, from: &BodyState, to: &BodyState) -> f64 {
    let [x, y] = [0, 1].map(|axis| to.position[axis] - from.position[axis]);
    (x * x + y * y).sqrt() + (to.rotation - from.rotation).abs() * block.reach
}

/// Twice the kinetic energy, blocks of less mass than `seen` counting as if they had that.
pub fn twice_kinetic_energy(model: &Model, states: &[BodyState], seen: f64) -> f64 {
    let of = |(state, block): (&BodyState, &MovingBody)| {
        twice_energy(block, state)
            * (block.slowness * block.slowness * (seen / block.mass).max(1.0))
    };
    states.iter().zip(&model.blocks).map(of).sum()
}

/// Kinetic energy.
pub fn kinetic_energy(model: &Model, states: &[BodyState]) -> f64 {
    let blocks = states.iter().zip(&model.blocks);
    let twice = blocks.map(|(state, block)| twice_energy(block, state));
    twice.sum::<f64>() / 2.0
}

fn twice_energy(block: &MovingBody, state: &BodyState) -> f64 {
    let [x, y] = state.velocity;
    block.mass * (x * x + y * y) + block.inertia * state.spin * state.spin
}

/// Work of the live loads at a λ* of 1 from one state to another, to first order.
pub fn live_work(model: &Model, from: &[BodyState], to: &[BodyState]) -> f64 {
    let of = |((a, b), block): ((&BodyState, &BodyState), &MovingBody)| -> f64 {
        let turn = b.rotation - a.rotation;
        let [x, y] = [0, 1].map(|axis| b.position[axis] - a.position[axis]);
        let along = |force: &BodyForce| {
            let [arm_x, arm_y] = force.arm;
            force.live[0] * (x - turn * arm_y) + force.live[1] * (y + turn * arm_x)
        };
        block.loads.iter().map(along).sum()
    };
    from.iter().zip(to).zip(&model.blocks).map(of).sum()
}
