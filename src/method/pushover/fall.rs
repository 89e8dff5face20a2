//! What the blocks do once the collapse has been called: the motion itself, without damping.

use super::measure::moved;
use super::model::{GRID, Model};
use super::physics::{BodyState, Physics};

/// Course heights that some point moves until enough has been seen.
const FAR: f64 = 1.0;

/// Time in √(H_c/g) after which nothing more is waited for.
const LONGEST: f64 = 100.0;

/// States of all blocks, a constant time apart.
pub struct Fall {
    /// From when the collapse was called.
    pub frames: Vec<Vec<BodyState>>,
    /// Time between two of them, in √(H_c/g).
    pub interval: f64,
}

/// Lets the blocks move at a constant λ*, in grid units, until some point is a course height from
/// where it was at `from`. Keeps at least `least` frames, and fewer than twice as many, of a motion
/// that takes so many time steps. The steps are none of the search's and are not counted.
pub fn fall(
    physics: &mut Physics,
    model: &Model,
    load: u64,
    from: &[BodyState],
    least: usize,
) -> Fall {
    let counted = physics.steps;
    physics.multiplier = load as f64 / GRID;
    let mut stride = 1;
    let mut frames = vec![physics.states()];
    let steps = (LONGEST / physics.dt()) as usize;
    for step in 1..=steps {
        physics.step();
        if physics.broken {
            break;
        }
        let states = physics.states();
        let mut blocks = model.blocks.iter().zip(from.iter().zip(&states));
        let far = blocks.any(|(block, (from, to))| moved(block, from, to) >= FAR);
        if step.is_multiple_of(stride) {
            frames.push(states);
        }
        if frames.len() >= 2 * least {
            frames = frames.into_iter().step_by(2).collect();
            stride *= 2;
        }
        if far {
            break;
        }
    }
    physics.steps = counted;
    Fall {
        frames,
        interval: stride as f64 * physics.dt(),
    }
}
