//! Mechanisms of scenes that fall under their own weight, also where weights differ so much that a
//! program over the whole scene does not see the light blocks.

use super::equilibration::{UnitPower, needs_own_units};
use super::program::Program;
use super::reduction::ScenePart;
use super::scale::Scale;
use crate::answer::Work;
use crate::mechanics::{BlockResidual, Mechanism, Motion, VERIFIED_RESIDUAL, falling_violation};
use crate::scene::{Scene, Vector, connected};

/// Openings beyond the flow rule, the mechanism's total opening and slip being 1: first enough to
/// cover what the solver leaves, then none, for scenes that do not fall by much.
const OPENINGS: [f64; 2] = [1e-10, 0.0];

/// Blocks slower than this part of the fastest are taken to rest.
const RESTING: f64 = 1e-6;

/// Programs for the own weight, one after the other: the mechanisms of those before may prove
/// nothing. Where blocks have units of their own in a program, those at rest and those that fall can
/// pull it apart, so that others come after, and one unit for all at last.
pub(super) fn programs(scene: &Scene) -> impl Iterator<Item = Program> + '_ {
    let powers: &[UnitPower] = if needs_own_units(scene) {
        &[
            UnitPower::CubeRoot,
            UnitPower::SquareRoot,
            UnitPower::Common,
        ]
    } else {
        &[UnitPower::CubeRoot]
    };
    let attempts = (powers.iter()).flat_map(|&power| OPENINGS.map(|opening| (power, opening)));
    let attempts = attempts.map(move |(power, opening)| {
        let mut program = Program::with_slack(scene, 0.0, power);
        program.set_opening(opening);
        program
    });
    // What guides a support locks, so that the solver may see no limit of the slack.
    let guided = scene.reaction().into_iter();
    attempts.chain(guided.map(move |_| Program::at_multiplier(scene, 0.0, Scale::of(scene))))
}

/// Whether a mechanism proves that the scene falls.
pub(super) fn proves(scene: &Scene, mechanism: &Mechanism) -> bool {
    falling_violation(scene, mechanism) <= VERIFIED_RESIDUAL
        && BlockResidual::of_flow(scene, mechanism).is_small()
}

/// The mechanism of blocks that no chain of joints connects with a support: they drift along their
/// own dead loads, all at one velocity, so that no joint opens or slips. No program is needed, and
/// none that asks for openings sees it.
pub(super) fn adrift(scene: &Scene) -> Option<Mechanism> {
    let held = connected(scene.blocks().len(), scene.joints());
    let loose = || (scene.blocks().iter().zip(&held)).filter(|(_, held)| !**held);
    let pull = loose().fold(Vector::zeros(), |sum, (block, _)| {
        let [x, y, _] = block.dead();
        sum + Vector::new(x, y)
    });
    let velocity = pull.try_normalize(0.0)?;
    let motions = held.iter().map(|&held| Motion {
        velocity: if held { Vector::zeros() } else { velocity },
        rotation: 0.0,
    });
    Some(Mechanism {
        motions: motions.collect(),
    })
}

/// A mechanism of the whole scene that proves its fall, found on a part of it while every other
/// block is held: what falls then falls whatever the others do, for they rest in this mechanism.
///
/// Parts are the blocks that `moved` in mechanisms that prove nothing, then the blocks lighter than
/// the heaviest one by a decade, by two, and so on. Each is a program of its own in units of its own.
pub(super) fn of_a_part(scene: &Scene, moved: &[Mechanism], work: &mut Work) -> Option<Mechanism> {
    let mut parts = lighter(scene);
    parts.reverse();
    parts.extend(moved.iter().map(|m| m.moving(scene, RESTING)));
    let mut seen: Vec<Vec<bool>> = vec![vec![true; scene.blocks().len()]];
    while let Some(kept) = parts.pop() {
        if seen.contains(&kept) || !kept.contains(&true) {
            continue;
        }
        let part = ScenePart::new(scene, &kept);
        for mut program in programs(&part.scene) {
            // On which the dead load does the most work for its openings and slips.
            let Some(velocity) = program.solve_counted(work).velocity() else {
                continue;
            };
            let mechanism = part.extend(scene, &program.scale().mechanism(&velocity));
            if proves(scene, &mechanism) {
                return Some(mechanism);
            }
            parts.push(mechanism.moving(scene, RESTING));
        }
        seen.push(kept);
    }
    None
}

/// Sets of blocks: those lighter than the heaviest by a decade, by two, down to the lightest.
fn lighter(scene: &Scene) -> Vec<Vec<bool>> {
    let weights = scene.blocks().iter().map(|block| {
        let [x, y, _] = block.dead();
        x.hypot(y)
    });
    let weights: Vec<f64> = weights.collect();
    let heaviest = weights.iter().copied().fold(0.0, f64::max);
    let decades = (1..).map(|decade| heaviest * 10f64.powi(-decade));
    let sets = decades.map(|limit| weights.iter().map(|&w| w < limit).collect::<Vec<bool>>());
    let mut sets: Vec<_> = sets.take_while(|set| set.contains(&true)).collect();
    sets.dedup();
    sets
}

/// Names of the blocks that come down, in the scene's order. Blocks that only make way for them are
/// not named; empty where all come down.
pub(super) fn names(scene: &Scene, mechanism: &Mechanism) -> Vec<String> {
    let powers = scene.blocks().iter().zip(&mechanism.motions);
    let powers = powers.map(|(block, motion)| {
        let [x, y, moment] = block.dead();
        let weight = x.hypot(y);
        // Over the weight, so that a light block counts like a heavy one.
        (x * motion.velocity.x + y * motion.velocity.y + moment * motion.rotation) / weight
    });
    let powers: Vec<f64> = powers.collect();
    let least = RESTING * powers.iter().copied().fold(0.0, f64::max);
    let falling = (0..powers.len()).filter(|&index| powers[index] > least);
    let falling: Vec<usize> = falling.collect();
    if falling.len() == powers.len() {
        return Vec::new();
    }
    falling
        .into_iter()
        .map(|index| scene.block_name(index))
        .collect()
}
