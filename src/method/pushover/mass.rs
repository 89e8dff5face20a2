//! Masses, which a multiplier does not depend on, and by how much a block's movement is to be
//! magnified before it is judged, so that a light or a small block is seen beside heavy ones.

use super::portion::Portion;
use super::tuned::Tuned;
use crate::answer::PushoverFact;
use crate::mechanics::reach;
use crate::scene::{Block, JointClass, Scene, Side};

/// What rapier is told of one block, and what its motion is judged by.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Inert {
    /// Mass, in mean weights over g. By area: masses in proportion to uneven loads would keep the
    /// contact solver from converging. A light block that carries nothing heavier has less, so that
    /// it moves no more slowly than others. In a tall scene it grows with the depth below the top.
    pub mass: f64,
    /// By how much smaller the block is than a small one; 1 for others.
    pub smallness: f64,
    /// By how much more slowly than g its own weight accelerates it; at least 1.
    pub slowness: f64,
}

/// For every block of a portion, in the scene's order, what rapier is told of it; weights and
/// areas are divided by `force` and `area`, lengths by `length`.
///
/// # Errors
/// Weights too unequal to be judged beside each other.
pub fn inert(
    scene: &Scene,
    portion: &Portion,
    [force, area, length]: [f64; 3],
    tuned: &Tuned,
) -> Result<Vec<Inert>, PushoverFact> {
    let weights: Vec<f64> = scene.blocks().iter().map(|b| weight(b) / force).collect();
    refuse_unequal(scene, portion, &weights, tuned.most_unequal)?;
    let carried = heaviest_carried(scene, &weights);
    let deeper = heavier_by_depth(scene, portion, length, tuned);
    let of = |(index, block): (usize, &Block)| {
        let by_area = (block.shape.area() / area).clamp(tuned.masses[0], tuned.masses[1]);
        let smallness = (tuned.small * length / (2.0 * reach(block))).max(1.0);
        let (weight, carried) = (weights[index], carried[index]);
        let needed = (weight * smallness).max(carried.min(1.0));
        let light = needed < tuned.light * by_area && weight > 0.0;
        let mass = if light { needed } else { by_area };
        // Of blocks of ordinary weight nothing is magnified, and those without weight hang on others.
        let slow = weight > 0.0 && weight < tuned.light * mass;
        let slowness = if slow { mass / weight } else { 1.0 };
        Inert {
            mass: mass * deeper[index],
            smallness,
            slowness: slowness.min(tuned.most_unequal),
        }
    };
    Ok(scene.blocks().iter().enumerate().map(of).collect())
}

/// What every block's mass is multiplied by: 1, or in a tall scene the square of its depth below the top.
///
/// Sweeps over the contacts let an error fade as heat does in a bar that is cold at one end: in n courses of
/// equal masses its slowest part keeps 1 - (π/2n)² a sweep, and 1 - (π/n)² where masses grow with the square
/// of the depth. What the sweeps leave makes courses creep along their beds, which a tall wall does not stand.
/// The moment of inertia about the base stays as it is, and with it the time in which the scene rocks.
fn heavier_by_depth(scene: &Scene, portion: &Portion, length: f64, tuned: &Tuned) -> Vec<f64> {
    let height = |block: &Block| block.shape.centroid().y;
    let [low, high] = <[_; 2]>::from(portion.bounds(scene)).map(|corner| corner.y);
    if (high - low) / length < tuned.swaying {
        return vec![1.0; scene.blocks().len()];
    }
    // 1 in the top course.
    let factor = |block: &Block| {
        let course = (high - height(block)) / length + 0.5;
        course.max(1.0).powf(tuned.depth_power)
    };
    let inertia = |block: &Block| block.shape.area() * (height(block) - low).powi(2);
    let plain: f64 = portion.present(scene).map(inertia).sum();
    let deeper = |block: &Block| factor(block) * inertia(block);
    let deeper: f64 = portion.present(scene).map(deeper).sum();
    let factors = scene.blocks().iter().map(factor);
    factors.map(|factor| factor * plain / deeper).collect()
}

/// Magnitudes of a block's dead forces.
fn weight(block: &Block) -> f64 {
    block.loads.iter().map(|load| load.dead.norm()).sum()
}

fn refuse_unequal(
    scene: &Scene,
    portion: &Portion,
    weights: &[f64],
    most: f64,
) -> Result<(), PushoverFact> {
    let free = (0..weights.len()).filter(|&i| portion.is_free(i) && weights[i] > 0.0);
    let by_weight = |a: &usize, b: &usize| weights[*a].total_cmp(&weights[*b]);
    let (Some(light), Some(heavy)) = (free.clone().min_by(by_weight), free.max_by(by_weight))
    else {
        return Ok(());
    };
    let ratio = weights[heavy] / weights[light];
    if ratio <= most * (1.0 + 1e-9) {
        return Ok(());
    }
    Err(PushoverFact::UnequalWeights {
        light: scene.block_name(light),
        heavy: scene.block_name(heavy),
        ratio,
        most,
    })
}

/// For every block the heaviest of those that it may have to carry: what lies on it or beside it,
/// what lies on or beside that, and so on.
fn heaviest_carried(scene: &Scene, weights: &[f64]) -> Vec<f64> {
    let mut upwards: Vec<[usize; 2]> = Vec::new();
    for joint in scene.joints() {
        let Side::Block(from) = joint.from else {
            continue;
        };
        let (from, to) = match joint.normal.y < 0.0 {
            true => (joint.to, from),
            false => (from, joint.to),
        };
        upwards.push([from, to]);
        if joint.class == JointClass::Head {
            upwards.push([to, from]);
        }
    }
    let mut carried = vec![0.0; weights.len()];
    // What is passed on only grows, and there are finitely many weights.
    loop {
        let mut changed = false;
        for &[from, to] in &upwards {
            let above = weights[to].max(carried[to]);
            if above > carried[from] {
                carried[from] = above;
                changed = true;
            }
        }
        if !changed {
            return carried;
        }
    }
}
