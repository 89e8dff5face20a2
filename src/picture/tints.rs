//! Tints of rigid parts: neighbours get different ones.

use crate::mechanics::RigidPart;
use crate::scene::{Scene, Side};

/// Gap between blocks that count as neighbours, as a part of the smaller one's smaller side.
const NEAR: f64 = 0.05;

/// A tint for each part, one of so many `tints`: parts beside each other get different ones, whether
/// or not there is a joint between them. `None` for what stands still and `Some(0)` for the largest part
/// that moves, which no other part shares. Nothing where there are too few tints.
pub fn tints(scene: &Scene, parts: &[RigidPart], tints: usize) -> Option<Vec<Option<usize>>> {
    let beside = neighbours(scene, parts);
    let moving = (0..parts.len()).filter(|&part| parts[part].moves);
    let mut order: Vec<usize> = moving.collect();
    let largest = order.first().copied();
    let mut given = vec![None; parts.len()];
    if let Some(largest) = largest {
        given[largest] = Some(0);
        order.remove(0);
    }
    // The part with the most neighbours first: it is the hardest to please.
    order.sort_by_key(|&part| std::cmp::Reverse(beside[part].len()));
    // Going round the palette, so that all of it is used.
    for (at, &part) in order.iter().enumerate() {
        let palette = (0..tints - 1).map(|step| Some(1 + (at + step) % (tints - 1)));
        let is_free =
            |tint: &Option<usize>| beside[part].iter().all(|&other| given[other] != *tint);
        given[part] = palette.into_iter().find(is_free)?;
    }
    Some(given)
}

/// The parts beside each part: those with a joint between them, and those of blocks that are near each
/// other, as across head joints that are open.
fn neighbours(scene: &Scene, parts: &[RigidPart]) -> Vec<Vec<usize>> {
    let mut part_of = vec![0; scene.blocks().len()];
    for (index, part) in parts.iter().enumerate() {
        for &block in &part.blocks {
            part_of[block] = index;
        }
    }
    let mut beside: Vec<Vec<usize>> = vec![Vec::new(); parts.len()];
    let mut add = |a: usize, b: usize| {
        let (a, b) = (part_of[a], part_of[b]);
        if a != b && !beside[a].contains(&b) {
            beside[a].push(b);
            beside[b].push(a);
        }
    };
    for joint in scene.joints() {
        if let Side::Block(from) = joint.from {
            add(from, joint.to);
        }
    }
    let boxes: Vec<[f64; 4]> = (scene.blocks().iter())
        .map(|block| {
            let (low, high) = block.shape.bounds();
            [low.x, low.y, high.x, high.y]
        })
        .collect();
    for (a, one) in boxes.iter().enumerate() {
        for (b, other) in boxes.iter().enumerate().skip(a + 1) {
            if are_near(one, other) {
                add(a, b);
            }
        }
    }
    beside
}

/// Whether two boxes share a stretch of an edge.
fn are_near(a: &[f64; 4], b: &[f64; 4]) -> bool {
    let side = |r: &[f64; 4]| (r[2] - r[0]).min(r[3] - r[1]);
    let near = NEAR * side(a).min(side(b));
    let shared = |axis: usize| a[axis + 2].min(b[axis + 2]) - a[axis].max(b[axis]);
    let [x, y] = [shared(0), shared(1)];
    x > -near && y > -near && (x > near || y > near)
}
