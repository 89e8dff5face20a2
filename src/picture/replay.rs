//! A recorded collapse: the wall at rest as a drawing, and poses that a script moves its blocks by.

use serde::Serialize;

use super::frame::{Displacement, Frame};
use super::mechanism::DrawnMechanism;
use super::palette::{BEFORE, BLOCK_LINE};
use super::path::Path;
use super::svg::{Svg, style};
use super::wall::{outline, supports};
use crate::answer::Mechanism;
use crate::run::Row;
use crate::scene::{Point, Scene, Vector};

/// Most frames that are kept.
const FRAMES: usize = 48;

/// Steps that the fastest displacement is divided into.
const STEPS: f64 = 1e3;

/// Pixels that the replay is wide, its border, and how high it may be without it.
const WIDTH: f64 = 640.0;
const BORDER: f64 = 14.0;
const HIGHEST: f64 = 480.0;

/// A recorded collapse, ready to be played.
pub struct Replay {
    /// The wall at rest, one path a block in the group `bodies`.
    pub svg: String,
    /// How far each block has moved in each frame.
    pub poses: Poses,
    /// What displacements are multiplied by.
    pub factor: f64,
}

/// What the script reads. Displacements are linear in the pose, as in the drawings.
#[derive(Serialize)]
pub struct Poses {
    /// Blocks that move, by their place in the drawing.
    blocks: Vec<usize>,
    /// Centroid of each of them, pixels.
    centres: Vec<[f64; 2]>,
    /// Pixels for a step of displacement.
    step: f64,
    /// Radians for a step of rotation.
    turn: f64,
    /// For each frame x, y (down) and rotation (clockwise) of each moving block, in steps.
    pub frames: Vec<Vec<i32>>,
}

/// The replay of an answer about a scene; `None` where it holds no recording.
pub fn replay(scene: &Scene, row: &Row, title: &str) -> Option<Replay> {
    let frames = thinned(&row.outcome.recording);
    let displacement = Displacement::new(scene, Some(*frames.last()?));
    let (low, high) = displacement.bounds();
    let scale = (WIDTH - 2.0 * BORDER) / (high.x - low.x);
    let scale = scale.min(HIGHEST / (high.y - low.y));
    let height = 2.0 * BORDER + scale * (high.y - low.y);
    let left = (WIDTH - scale * (high.x - low.x)) / 2.0;
    let frame = Frame {
        scale,
        corner: (low, [left, height - BORDER]),
    };
    let drawn = DrawnMechanism::new(scene, row.outcome.mechanism.as_ref(), &row.method);
    Some(Replay {
        svg: at_rest(scene, &frame, &drawn.fills(), (low, high)).document([WIDTH, height], title),
        poses: poses(scene, &frames, &displacement, &frame),
        factor: displacement.factor(),
    })
}

/// At most [`FRAMES`] frames, evenly, the last one among them.
fn thinned(recording: &[Mechanism]) -> Vec<&Mechanism> {
    let count = recording.len().min(FRAMES);
    let last = recording.len().saturating_sub(1);
    let pick = |k: usize| &recording[k * last / count.saturating_sub(1).max(1)];
    (0..count).map(pick).collect()
}

fn poses(
    scene: &Scene,
    frames: &[&Mechanism],
    displacement: &Displacement,
    frame: &Frame,
) -> Poses {
    let factor = displacement.factor();
    let fastest = frames.last().map_or(0.0, |last| last.fastest(scene));
    let length = (factor * fastest / STEPS).max(f64::MIN_POSITIVE);
    let turn = length / scene.height();
    let steps = |mechanism: &Mechanism, block: usize| {
        let motion = mechanism.motions[block];
        let moved = motion.velocity * (factor / length);
        let turned = motion.rotation * (factor / turn);
        [moved.x, -moved.y, -turned].map(|value| value.round() as i32)
    };
    let moves = |&block: &usize| {
        frames
            .iter()
            .any(|f| steps(f, block).iter().any(|&v| v != 0))
    };
    let blocks: Vec<usize> = (0..scene.blocks().len()).filter(moves).collect();
    let tenth = |v: f64| (v * 10.0).round() / 10.0;
    Poses {
        centres: blocks
            .iter()
            .map(|&block| frame.at(scene.blocks()[block].shape.centroid()).map(tenth))
            .collect(),
        step: (length * frame.scale * 1e6).round() / 1e6,
        turn: (turn * 1e9).round() / 1e9,
        frames: frames
            .iter()
            .map(|mechanism| {
                blocks
                    .iter()
                    .flat_map(|&block| steps(mechanism, block))
                    .collect()
            })
            .collect(),
        blocks,
    }
}

/// The wall at rest, one path a block in the tint of its part, over its own outline and the ground.
fn at_rest(scene: &Scene, frame: &Frame, fills: &[&str], seen: (Point, Point)) -> Svg {
    let mut svg = Svg::default();
    let mut before = Path::default();
    let outlines: Vec<_> = (0..scene.blocks().len())
        .map(|block| outline(scene, frame, block))
        .collect();
    for outline in &outlines {
        before.add(outline, true);
    }
    svg.path(
        &before,
        style().hollow().stroke(BEFORE).stroke_width(0.6),
        "",
    );
    let (low, high) = seen;
    let reach = Vector::new(BORDER, BORDER) / frame.scale;
    supports(&mut svg, scene, frame, [low - reach, high + reach]);
    let line = style().class("bodies").stroke(BLOCK_LINE).stroke_width(0.6);
    svg.open(line, "");
    for (outline, fill) in outlines.iter().zip(fills) {
        svg.path(&Path::through(outline, true), style().fill(fill), "");
    }
    svg.close();
    svg
}
