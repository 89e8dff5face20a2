//! The rigorous outer bound from below, so that nobody takes the lowest state found for one.

use crate::answer::Work;
use crate::mechanics::{JointForce, Mechanism, Motion, StaticResidual, VERIFIED_RESIDUAL};
use crate::method::limit::ending::Ending;
use crate::method::limit::program::Program;
use crate::scene::{Scene, Vector};

/// λ of forces without friction, which no collapse multiplier undercuts; `None` where the scene
/// needs friction to stand, or where such forces are not proved. On a wall with a level base it is 0
/// and never tight.
///
/// `at_rest` are forces at λ = 0. Where they need no friction, and the whole scene can slide with
/// the push without closing a joint, λ is 0 without a program.
pub(super) fn frictionless(scene: &Scene, at_rest: &[JointForce], work: &mut Work) -> Option<f64> {
    if at_rest.iter().all(|force| force.shear == 0.0) && slides_freely(scene) {
        return Some(0.0);
    }
    let smooth = scene.clone().with_friction(|_, _| 0.0);
    let mut program = Program::new(&smooth);
    let Ending::Solved(solution) = program.solve_counted(work) else {
        return None;
    };
    // Forces without friction prove their own λ and nothing above it; what the solver reports does not.
    let forces = program.scale().forces(&solution.forces);
    let lambda = solution.lambda * program.scale().multiplier;
    let residual = StaticResidual::of(&smooth, &forces, lambda);
    (residual.largest() <= VERIFIED_RESIDUAL).then_some(lambda)
}

/// Whether all blocks can move sideways together, with the push and against nothing but friction.
fn slides_freely(scene: &Scene) -> bool {
    let sideways = Motion {
        velocity: Vector::new(scene.push().sign(), 0.0),
        rotation: 0.0,
    };
    let mechanism = Mechanism {
        motions: vec![sideways; scene.blocks().len()],
    };
    let rates = mechanism.joint_rates(scene);
    let level = rates
        .iter()
        .all(|rate| rate.opening.iter().all(|&opening| opening == 0.0));
    let dead = scene.blocks().iter().map(|block| block.dead()[0]);
    level && dead.sum::<f64>() == 0.0
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::method::limit::own_weight::own_weight;
    use crate::method::limit::walls::wall;
    use crate::scene::Push;

    #[test]
    fn a_wall_on_a_level_base_has_no_bound_but_zero() {
        let scene = wall(2, Push::Left);
        let mut work = Work::default();
        let at_rest = own_weight(&scene, &mut work).expect("it stands");
        assert_eq!(frictionless(&scene, &at_rest, &mut work), Some(0.0));
        assert_eq!(work.programs, 0);
    }
}
