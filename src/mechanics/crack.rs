//! The crack slope of a wall, read from how its blocks move.

use serde::{Deserialize, Serialize};

use super::mechanism::Mechanism;
use crate::scene::{Push, Scene};

/// Crack slope of a wall (paper, Fig. 5), with what it is made of.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Crack {
    /// Width that moves as one rigid body along the top, from the edge above the toe.
    pub c: Option<f64>,
    /// Width that moves at all along the top, from the same edge; e ≥ c.
    pub e: Option<f64>,
    /// tan β = ((c + e)/2 − s) / H.
    pub tan_beta: f64,
    /// False where c or e changes with the threshold.
    pub sharp: bool,
}

/// Blocks along the top by distance from the edge that the push points to, and how far each reaches.
fn top_blocks(scene: &Scene) -> Vec<(usize, f64)> {
    let (low, high) = scene.bounds();
    let tolerance = 1e-6 * (high.y - low.y);
    let edge = match scene.push() {
        Push::Right => high.x,
        Push::Left => low.x,
    };
    let mut top: Vec<(f64, f64, usize)> = Vec::new();
    for (i, block) in scene.blocks().iter().enumerate() {
        let (l, h) = block.shape.bounds();
        if (h.y - high.y).abs() < tolerance {
            let span = [(l.x - edge).abs(), (h.x - edge).abs()];
            top.push((span[0].min(span[1]), span[0].max(span[1]), i));
        }
    }
    top.sort_by(|a, b| a.0.total_cmp(&b.0));
    top.into_iter()
        .map(|(_, far, block)| (block, far))
        .collect()
}

/// Rotation times height, relative to the largest displacement, up to which what moves at the top
/// slides and does not rock. Walls that rock show 0.8 and more, walls that slide on a bed joint
/// 3e-3 and less, in the pushover too (`tests/pushover/cracks.rs`).
const SLIDES: f64 = 0.03;

/// Whether the top slides off as a whole course. Its blocks then move at any speeds one beside the
/// other, so that c means nothing, and no crack rises from the toe.
fn slides(scene: &Scene, mechanism: &Mechanism, height: f64) -> bool {
    let limit = SLIDES * mechanism.fastest(scene);
    let top = top_blocks(scene).into_iter();
    let turn = top.map(|(block, _)| mechanism.motions[block].rotation.abs() * height);
    turn.fold(0.0, f64::max) <= limit
}

/// c and e: blocks move at all beyond the first speed, and against the first block beyond the
/// second. `None` where nothing moves at the edge.
fn widths(scene: &Scene, mechanism: &Mechanism, beyond: [f64; 2]) -> Option<(f64, f64)> {
    let top = top_blocks(scene);
    let first = top.first()?.0;
    let reach = |ends: &dyn Fn(usize) -> bool| {
        let part = top.iter().take_while(|&&(block, _)| !ends(block));
        part.map(|&(_, far)| far).fold(0.0, f64::max)
    };
    let e = reach(&|block| mechanism.speed(scene, block, None) <= beyond[0]);
    let c = reach(&|block| mechanism.speed(scene, block, Some(first)) > beyond[1]);
    (e > 0.0).then_some((c.min(e), e))
}

/// The crack of these widths, and whether they are sharp; `None` where the scene is no wall of units and
/// halves, where nothing moves at its top edge, and where the top slides and nothing there turns.
fn crack(
    scene: &Scene,
    mechanism: &Mechanism,
    widths: impl FnOnce(f64) -> Option<((f64, f64), bool)>,
) -> Option<Crack> {
    let wall = scene.coursing().filter(|wall| wall.halves)?;
    if slides(scene, mechanism, wall.height) {
        return None;
    }
    let ((c, e), sharp) = widths(wall.height)?;
    Some(Crack {
        c: Some(c),
        e: Some(e),
        tan_beta: ((c + e) / 2.0 - wall.overlap) / wall.height,
        sharp,
    })
}

/// Crack slope at two thresholds (fractions of the largest corner velocity), the finer one reported.
pub fn crack_slope(scene: &Scene, mechanism: &Mechanism, thresholds: [f64; 2]) -> Option<Crack> {
    crack(scene, mechanism, |height| {
        let at = |threshold| widths(scene, mechanism, [threshold * mechanism.fastest(scene); 2]);
        let (c, e) = at(thresholds[0])?;
        let near = |a: f64, b: f64| (a - b).abs() < 1e-6 * height;
        let same = |(c2, e2): (f64, f64)| near(c2, c) && near(e2, e);
        Some(((c, e), at(thresholds[1]).is_some_and(same)))
    })
}

/// Crack slope of displacements, which hold elastic movements beside the collapse: what stands
/// still is told from what moves by the widest gap between movements along the top, on a scale of
/// ratios, and no threshold. Not sharp where that gap is narrower than a factor of 10, or not twice
/// as wide as the next one, or where what moves is not in one piece.
pub fn crack_slope_by_gap(scene: &Scene, mechanism: &Mechanism) -> Option<Crack> {
    crack(scene, mechanism, |_| {
        let fastest = mechanism.fastest(scene);
        let top = top_blocks(scene);
        let first = top.first()?.0;
        let speeds = |reference| -> Vec<f64> {
            let speed = |&(block, _): &(usize, f64)| mechanism.speed(scene, block, reference);
            top.iter().map(|block| speed(block) / fastest).collect()
        };
        let (own, relative) = (speeds(None), speeds(Some(first)));
        let gaps = [widest_gap(&own), widest_gap(&relative)];
        let limits = gaps.map(|(limit, _)| limit);
        let found = widths(scene, mechanism, limits.map(|limit| limit * fastest))?;
        // Moving first, then still; and against the first block the other way round.
        let one_piece = own.is_sorted_by_key(|&v| v <= limits[0])
            && relative.is_sorted_by_key(|&v| v > limits[1]);
        Some((found, one_piece && gaps.iter().all(|&(_, clear)| clear)))
    })
}

/// The middle of the widest gap between movements relative to the largest, and whether it is clear.
/// Smaller movements than elastic ones are none: both ends of the scale count, so that all or none
/// may move.
fn widest_gap(movements: &[f64]) -> (f64, bool) {
    const NONE: f64 = 1e-4;
    let scale = movements.iter().map(|&v| v.max(NONE)).chain([NONE, 1.0]);
    let mut scale: Vec<f64> = scale.collect();
    scale.sort_by(f64::total_cmp);
    let gaps = scale.windows(2).map(|pair| (pair[1] / pair[0], pair));
    let mut gaps: Vec<(f64, &[f64])> = gaps.collect();
    gaps.sort_by(|a, b| b.0.total_cmp(&a.0));
    let next = gaps.get(1).map_or(1.0, |gap| gap.0);
    let (ratio, ends) = gaps[0];
    let clear = ratio >= 10.0 && ratio >= 2.0 * next;
    ((ends[0] * ends[1]).sqrt(), clear)
}

/// Thresholds for velocities of a linear program: 1e-6 as defined, repeated at 1e-4.
pub const VELOCITY_THRESHOLDS: [f64; 2] = [1e-6, 1e-4];
