//! A recorded collapse: the wall as laid as a drawing, and poses that a script moves its blocks by.

use serde::Serialize;

use super::frame::Frame;
use super::mechanism::DrawnMechanism;
use super::palette::{BEFORE, BLOCK_LINE};
use super::svg::{Path, Svg, style};
use super::wall::{outline, supports};
use crate::mechanics::Mechanism;
use crate::run::Row;
use crate::scene::{Point, Scene, Vector};

const FRAMES: usize = 48;

/// Steps that the farthest displacement is divided into.
const STEPS: f64 = 1e3;

/// Pixels that the replay is wide, its border, and how high it may be without it.
const WIDTH: f64 = 640.0;
const BORDER: f64 = 14.0;
const HIGHEST: f64 = 480.0;

/// A recorded collapse, ready to be played.
pub struct Replay {
    /// The wall as laid, one path a block in the group `bodies`.
    pub svg: String,
    /// Where each block is in each frame.
    pub poses: Poses,
    /// How far a corner has moved at most, in the scene's unit of length.
    pub farthest: f64,
}

/// What the script reads. Blocks move as they are, at the scale of the drawing.
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
    /// When each frame was seen, in √(L/g) since the collapse was called, L being the scene's unit of
    /// length.
    pub times: Vec<f64>,
    /// For each frame x, y (down) and rotation (clockwise) of each moving block, in steps.
    pub frames: Vec<Vec<i32>>,
}

/// The replay of an answer about a scene; `None` where it holds no recording.
pub fn replay(scene: &Scene, row: &Row, title: &str) -> Option<Replay> {
    let evidence = &row.outcome.evidence;
    let recording = evidence.observed()?.recording.as_ref()?;
    let kept = thinned(recording.frames.len());
    let frames: Vec<&Mechanism> = kept.iter().map(|&at| &recording.frames[at]).collect();
    let (mut farthest, mut low, mut high) = (0.0_f64, scene.bounds().0, scene.bounds().1);
    for (from, to) in frames.iter().flat_map(|frame| corners(scene, frame)) {
        farthest = farthest.max((to - from).norm());
        (low, high) = (low.inf(&to), high.sup(&to));
    }
    let scale = (WIDTH - 2.0 * BORDER) / (high.x - low.x);
    let scale = scale.min(HIGHEST / (high.y - low.y));
    let height = 2.0 * BORDER + scale * (high.y - low.y);
    let left = (WIDTH - scale * (high.x - low.x)) / 2.0;
    let frame = Frame {
        scale,
        corner: (low, [left, height - BORDER]),
    };
    let drawn = DrawnMechanism::new(scene, evidence.mechanism(), evidence.still());
    let times = kept.iter().map(|&at| at as f64 * recording.interval);
    Some(Replay {
        svg: as_laid(scene, &frame, &drawn.fills(), (low, high)).document([WIDTH, height], title),
        poses: poses(scene, &frames, times, farthest, &frame),
        farthest,
    })
}

/// Which of so many frames are kept: at most [`FRAMES`], evenly, the last one among them.
fn thinned(frames: usize) -> Vec<usize> {
    let count = frames.min(FRAMES);
    let last = frames.saturating_sub(1);
    let pick = |k: usize| k * last / count.saturating_sub(1).max(1);
    (0..count).map(pick).collect()
}

/// The corners of all blocks, and where a frame moves and turns them.
fn corners(scene: &Scene, frame: &Mechanism) -> impl Iterator<Item = (Point, Point)> {
    let blocks = scene.blocks().iter().zip(&frame.motions);
    blocks.flat_map(|(block, motion)| {
        let centre = block.shape.centroid();
        let (sin, cos) = motion.rotation.sin_cos();
        block.shape.corners().iter().map(move |corner| {
            let arm = corner - centre;
            let turned = Vector::new(cos * arm.x - sin * arm.y, sin * arm.x + cos * arm.y);
            (*corner, centre + turned + motion.velocity)
        })
    })
}

fn poses(
    scene: &Scene,
    frames: &[&Mechanism],
    times: impl Iterator<Item = f64>,
    farthest: f64,
    frame: &Frame,
) -> Poses {
    let length = (farthest / STEPS).max(f64::MIN_POSITIVE);
    let turn = length / scene.height();
    let steps = |mechanism: &Mechanism, block: usize| {
        let motion = mechanism.motions[block];
        let moved = motion.velocity / length;
        let turned = motion.rotation / turn;
        [moved.x, -moved.y, -turned].map(|value| value.round() as i32)
    };
    let moves = |&block: &usize| frames.iter().any(|frame| steps(frame, block) != [0; 3]);
    let blocks: Vec<usize> = (0..scene.blocks().len()).filter(moves).collect();
    let tenth = |v: f64| (v * 10.0).round() / 10.0;
    Poses {
        centres: (blocks.iter())
            .map(|&block| frame.at(scene.blocks()[block].shape.centroid()).map(tenth))
            .collect(),
        step: (length * frame.scale * 1e6).round() / 1e6,
        turn: (turn * 1e9).round() / 1e9,
        times: times.map(|time| (time * 1e3).round() / 1e3).collect(),
        frames: (frames.iter())
            .map(|frame| {
                blocks
                    .iter()
                    .flat_map(|&block| steps(frame, block))
                    .collect()
            })
            .collect(),
        blocks,
    }
}

/// The wall as laid, one path a block in the tint of its part, over its own outline and the ground.
fn as_laid(scene: &Scene, frame: &Frame, fills: &[&str], seen: (Point, Point)) -> Svg {
    let mut svg = Svg::default();
    let mut before = Path::default();
    let outlines: Vec<_> = (0..scene.blocks().len())
        .map(|block| outline(scene, frame, block))
        .collect();
    for outline in &outlines {
        before.add(outline, true);
    }
    svg.path(&before, style().line(BEFORE, 0.6), "");
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
