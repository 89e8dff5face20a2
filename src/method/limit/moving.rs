//! Where a support that moves begins: with the reaction at the other end of what equilibrium and
//! friction admit, so that no state of its motion lies before λ = 0.

use super::ending::Ending;
use super::program::Program;
use crate::scene::{Scene, Sense, SupportMotion};

/// Reactions that have no limit are taken to be this many times the weight.
const UNLIMITED: f64 = 10.0;

/// The scene with supports that move. λ = 0 stands for the largest admissible reaction where they move
/// away from the wall, for the least where they move against it; where no reaction holds the scene, for
/// none.
pub(crate) fn moving(scene: Scene, motion: &SupportMotion) -> Scene {
    let end = |sense: Sense| {
        let motion = SupportMotion {
            sense,
            ..motion.clone()
        };
        let scene = scene.clone().with_motion(&motion);
        let mut program = Program::new(&scene);
        match program.solve() {
            Ending::Solved(solution) => Some(solution.lambda * program.scale().multiplier),
            Ending::Unbounded => Some(f64::INFINITY),
            Ending::Infeasible(_) | Ending::GaveUp(_) => None,
        }
    };
    let ends = end(Sense::Against)
        .zip(end(Sense::Away))
        .map(|(most, least)| {
            let far = UNLIMITED * scene.total_weight();
            let least = (-least).max((-far).min(most - far));
            let most = most.min(far.max(far + least));
            match motion.sense {
                Sense::Away => (most, most - least),
                Sense::Against => (least, most - least),
            }
        });
    let (start, range) = ends.unwrap_or_default();
    scene.with_motion(motion).with_start(start, range)
}
