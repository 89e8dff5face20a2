//! Equilibrium under the own weight by vertical forces alone, from the top block down: a proof that
//! costs no program, for walls of level beds.

use crate::mechanics::JointForce;
use crate::scene::{Joint, Scene};

/// Largest sideways part of a level joint's normal; the judge decides what it may be.
const LEVEL: f64 = 1e-9;

/// Corner of a joint on which a block rests.
#[derive(Clone, Copy)]
struct Rest {
    joint: usize,
    end: usize,
    x: f64,
}

/// Vertical forces in level joints that hold every block, or `None` where a block's resultant falls
/// outside what carries it. That proves nothing: another distribution, or friction, may hold it.
pub(super) fn forces(scene: &Scene) -> Option<Vec<JointForce>> {
    let mut rests: Vec<Vec<Rest>> = vec![Vec::new(); scene.blocks().len()];
    for (j, joint) in scene.joints().iter().enumerate() {
        if let Some(above) = block_above(joint) {
            rests[above].extend((0..2).map(|end| Rest {
                joint: j,
                end,
                x: joint.ends[end].x,
            }));
        }
    }
    // A block's centroid lies above its level joints downwards.
    let height = |block: &usize| scene.blocks()[*block].shape.centroid().y;
    let mut order: Vec<usize> = (0..scene.blocks().len()).collect();
    order.sort_by(|a, b| height(b).total_cmp(&height(a)));
    // Weight and its moment about the block's own centroid, growing with what comes from above.
    let mut carried: Vec<(f64, f64)> = (scene.blocks().iter())
        .map(|block| {
            let [_, down, moment] = block.dead();
            (-down, -moment)
        })
        .collect();
    let mut forces = vec![JointForce::default(); scene.joints().len()];
    let mut done = vec![false; scene.blocks().len()];
    for block in order {
        done[block] = true;
        let centre = scene.blocks()[block].shape.centroid().x;
        let (weight, moment) = carried[block];
        for (rest, n) in distribute(&rests[block], weight, centre + moment / weight)? {
            forces[rest.joint].normal[rest.end] = n;
            if let Some(below) = block_below(&scene.joints()[rest.joint]) {
                // One that bends inwards may carry a block whose centroid is lower than its own.
                if done[below] {
                    return None;
                }
                let arm = rest.x - scene.blocks()[below].shape.centroid().x;
                carried[below].0 += n;
                carried[below].1 += n * arm;
            }
        }
    }
    Some(forces)
}

fn block_above(joint: &Joint) -> Option<usize> {
    match joint.normal {
        normal if normal.x.abs() > LEVEL => None,
        normal if normal.y > 0.0 => Some(joint.to),
        _ => joint.from.block(),
    }
}

fn block_below(joint: &Joint) -> Option<usize> {
    match joint.normal.y < 0.0 {
        true => Some(joint.to),
        false => joint.from.block(),
    }
}

/// Compression at the corners with the resultant `weight` at `x`: a linear distribution where that
/// needs no tension, else all of it on the corners next to `x`; `None` outside all corners.
fn distribute(rests: &[Rest], weight: f64, x: f64) -> Option<Vec<(Rest, f64)>> {
    let count = rests.len() as f64;
    let mean = rests.iter().map(|rest| rest.x).sum::<f64>() / count;
    let spread: f64 = rests.iter().map(|rest| (rest.x - mean).powi(2)).sum();
    let linear = |rest: &Rest| weight * (1.0 / count + (x - mean) * (rest.x - mean) / spread);
    if rests.iter().all(|rest| linear(rest) >= 0.0) && !rests.is_empty() {
        return Some(rests.iter().map(|rest| (*rest, linear(rest))).collect());
    }
    let by_x = |a: &&Rest, b: &&Rest| a.x.total_cmp(&b.x);
    let left = rests.iter().filter(|rest| rest.x <= x).max_by(by_x)?;
    let right = rests.iter().filter(|rest| rest.x > x).min_by(by_x)?;
    let share = (x - left.x) / (right.x - left.x);
    Some(vec![
        (*left, weight * (1.0 - share)),
        (*right, weight * share),
    ])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mechanics::StaticResidual;
    use crate::method::limit::walls::bonded;

    /// Statics: no tolerance beyond rounding.
    #[test]
    fn a_wall_with_a_gap_is_held_without_a_program() {
        let scene = bonded(&["111", "h11h", "1g1", "h11h"]);
        let forces = forces(&scene).expect("vertical forces hold it");
        assert!(StaticResidual::of(&scene, &forces, 0.0).largest() < 1e-14);
    }

    #[test]
    fn an_overhang_beyond_its_bed_is_not_held() {
        assert!(forces(&bonded(&["h", "11"])).is_none());
    }
}
