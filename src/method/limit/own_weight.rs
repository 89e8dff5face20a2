//! Whether a scene stands under its own weight, and whether any push can collapse it, with the
//! proof of either answer. What the solver reports is no proof: every state and mechanism is
//! tested here by the residuals that the judge computes.

use super::ending::Ending;
use super::falling;
use super::program::{Margins, Program};
use super::scale::Scale;
use super::vertical;
use crate::answer::{Evidence, LimitFact, Outcome, Standing, Status, Work};
use crate::mechanics::{
    BlockResidual, JointForce, Mechanism, StaticResidual, VERIFIED_RESIDUAL, live_unit,
};
use crate::scene::Scene;

/// Forces of every joint at λ = 0, or the outcome `falls` with a mechanism that moves under the
/// dead load alone, or `undecided`.
///
/// A scene that some λ ≠ 0 would hold falls nevertheless, so that a feasible program for λ_A says
/// nothing. Walls of level beds are mostly settled from top to bottom without a program.
pub(super) fn own_weight(scene: &Scene, work: &mut Work) -> Result<Vec<JointForce>, Box<Outcome>> {
    let stands = |forces: &[JointForce]| {
        let statics = StaticResidual::of(scene, forces, 0.0).largest();
        statics <= VERIFIED_RESIDUAL && BlockResidual::of_forces(scene, forces, 0.0).is_small()
    };
    if let Some(forces) = vertical::forces(scene).filter(|forces| stands(forces)) {
        return Ok(forces);
    }
    if let Some(mechanism) = falling::adrift(scene).filter(|m| falling::proves(scene, m)) {
        return Err(falls(scene, mechanism));
    }
    let mut solver = None;
    let mut moved = Vec::new();
    for mut program in falling::programs(scene) {
        let velocity = match program.solve_counted(work) {
            Ending::Solved(solution) => {
                let forces = program.scale().forces(&solution.forces);
                if stands(&forces) {
                    return Ok(forces);
                }
                solution.velocity
            }
            // No forces at all, not even tensile ones.
            Ending::Infeasible(certificate) => certificate,
            ending @ (Ending::Unbounded | Ending::GaveUp(_)) => {
                solver = Some(ending.kind());
                continue;
            }
        };
        let mechanism = program.scale().mechanism(&velocity);
        if falling::proves(scene, &mechanism) {
            return Err(falls(scene, mechanism));
        }
        moved.push(mechanism);
    }
    if let Some(mechanism) = falling::of_a_part(scene, &moved, work) {
        return Err(falls(scene, mechanism));
    }
    let undecided = LimitFact::OwnWeightUndecided { solver };
    Err(Box::new(Outcome::without_number(
        Status::Undecided,
        undecided,
    )))
}

/// The outcome `falls`, which the mechanism proves.
fn falls(scene: &Scene, mechanism: Mechanism) -> Box<Outcome> {
    let first = falling::names(scene, &mechanism);
    let falls = Outcome::with(Status::Falls, Evidence::Falls { mechanism });
    Box::new(falls.because(LimitFact::MovesUnpushed { first }))
}

/// The outcome of a scene whose program for λ_A has no optimum although `at_rest` holds it at
/// λ = 0: `stands` for associative friction where a ray of forces proves that, else `undecided`.
pub(super) fn without_optimum(
    scene: &Scene,
    ending: &Ending,
    at_rest: Vec<JointForce>,
    work: &mut Work,
) -> Outcome {
    let ray = matches!(ending, Ending::Unbounded).then(|| ray(scene, work));
    match ray.flatten() {
        Some(ray) => stands(Standing::Associative, at_rest, ray),
        None => Outcome::without_number(Status::Undecided, LimitFact::NoOptimum(ending.kind())),
    }
}

fn stands(standing: Standing, at_rest: Vec<JointForce>, ray: Vec<JointForce>) -> Outcome {
    let evidence = Evidence::Stands {
        standing,
        at_rest,
        ray,
    };
    Outcome::with(Status::Stands, evidence).because(LimitFact::ForcesWithoutLimit)
}

/// The outcome `stands` for friction without dilatancy, where forces without any shear carry the
/// live load: they exist where no mechanism opens all joints or leaves them closed while the push
/// does work on it (Farkas), and then nothing can collapse. A ray that needs friction proves nothing
/// here: a joint that slips without opening need not carry it.
pub(super) fn stands_without_dilatancy(
    scene: &Scene,
    at_rest: &[JointForce],
    work: &mut Work,
) -> Option<Outcome> {
    let smooth = scene.clone().with_friction(|_, _| 0.0);
    let ray = ray(&smooth, work)?;
    Some(stands(Standing::WithoutFriction, at_rest.to_vec(), ray))
}

/// Forces that balance the live load for λ = 1 and nothing else, within friction: they can be added
/// to any state without limit, so that λ_A has none. Where the solver says so and no such forces are
/// proved, it is the solver's word alone.
pub(super) fn ray(scene: &Scene, work: &mut Work) -> Option<Vec<JointForce>> {
    if scene.total_live() == 0.0 {
        // Nothing pushes, and no forces balance nothing; a program leaves its noise.
        return Some(vec![JointForce::default(); scene.joints().len()]);
    }
    let pushed = scene.clone().with_loads(|load, _| load.dead = load.live);
    let scale = Scale {
        force: live_unit(scene),
        length: scene.height(),
        multiplier: 1.0,
    };
    let mut of_scene = None;
    for margins in [Some(Margins::OF_FORCES), None] {
        let mut program = Program::at_multiplier(&pushed, 0.0, scale);
        if let Some(margins) = margins {
            program.set_margins(margins);
        }
        if let Ending::Solved(solution) = program.solve_counted(work) {
            let ray = scale.forces(&solution.forces);
            for ray in [without_noise(&ray), ray] {
                if StaticResidual::of_ray(scene, &ray).largest() > VERIFIED_RESIDUAL {
                    continue;
                }
                if BlockResidual::of_ray(scene, &ray).is_small() {
                    return Some(ray);
                }
                of_scene.get_or_insert(ray);
            }
        }
    }
    of_scene
}

/// Share of the largest force below which forces of a ray are what a program leaves where nothing
/// pushes: of those, blocks would be out of balance by as much as they carry.
const NOISE: f64 = 1e-9;

fn without_noise(ray: &[JointForce]) -> Vec<JointForce> {
    let size = |force: &JointForce| {
        let [n1, n2] = force.normal.map(f64::abs);
        n1.max(n2).max(force.shear.abs())
    };
    let largest = ray.iter().map(size).fold(0.0, f64::max);
    let is_noise = |force: &JointForce| size(force) < NOISE * largest;
    let cleaned = ray.iter().map(|force| match is_noise(force) {
        true => JointForce::default(),
        false => *force,
    });
    cleaned.collect()
}
