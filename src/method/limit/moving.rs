//! Where a support that moves begins: with the reaction at the other end of what equilibrium and
//! friction admit, so that no state of its motion lies before λ = 0.

use super::ending::Ending;
use super::program::Program;
use crate::scene::{Scene, Sense, SupportMotion};

/// Reactions that have no limit are taken to be this many times the weight.
const UNLIMITED: f64 = 2.0;

/// Part of the admissible reactions by which the first lies inside of the end: at the end itself nothing
/// proves that the scene stands (16 of 200 random scenes). Ends that are verified are as far apart. It is no
/// power of ten, so that short numbers do not lie on the edge of the next rounding.
const INSIDE: f64 = 1.1e-6;

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
            let low = (-least).max((-far).min(most - far));
            let high = most.min(far.max(far + low));
            let inside = INSIDE * (high - low);
            // The last digits of a solver are none of the scene, whose certificates are kept.
            let digit = 10f64.powf(inside.log10().floor());
            let rounded = |reaction: f64| match digit > 0.0 {
                true => (reaction / digit).round() * digit,
                false => reaction,
            };
            match motion.sense {
                Sense::Away => (rounded(high - inside), high - low, high == most),
                Sense::Against => (rounded(low + inside), high - low, low == -least),
            }
        });
    let (start, range, limited) = ends.unwrap_or_default();
    scene.with_motion(motion).with_start(start, range, limited)
}
