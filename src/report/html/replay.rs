//! The pushover's collapse, replayed: poses that a little script plays over a drawing.

use maud::{Markup, PreEscaped, html};
use serde::Serialize;

use crate::answer::Mechanism;
use crate::picture::{Displaced, Frame, Path, Px, Shown, escape, px};
use crate::run::{CaseResult, Row};
use crate::scene::{Point, Scene};

/// Most frames that are kept.
const FRAMES: usize = 48;

/// Steps that the fastest displacement is divided into.
const STEPS: f64 = 1e3;

/// Pixels that the replay is wide, and its border.
const WIDTH: f64 = 640.0;
const BORDER: f64 = 14.0;

/// What the script reads. Displacements are linear in the pose, as in the drawings.
#[derive(Serialize)]
struct Poses {
    /// Blocks that move, by their place in the drawing.
    blocks: Vec<usize>,
    /// Centroid of each of them, pixels.
    centres: Vec<[f64; 2]>,
    /// Pixels for a step of displacement.
    step: f64,
    /// Radians for a step of rotation.
    turn: f64,
    /// For each frame x, y (down) and rotation (clockwise) of each moving block, in steps.
    frames: Vec<Vec<i32>>,
}

/// The replay of a row that holds a recording.
pub fn replay(result: &CaseResult, row: &Row) -> Markup {
    let scene = result.scene(row);
    let frames = thinned(&row.outcome.recording);
    let Some(last) = frames.last() else {
        return html! {};
    };
    let displaced = Displaced::new(scene, Some(last));
    let (low, high) = displaced.bounds();
    let scale = (WIDTH - 2.0 * BORDER) / (high.x - low.x);
    let scale = scale.min(480.0 / (high.y - low.y));
    let height = 2.0 * BORDER + scale * (high.y - low.y);
    let left = (WIDTH - scale * (high.x - low.x)) / 2.0;
    let frame = Frame {
        scale,
        corner: (low, [left, height - BORDER]),
    };
    let fills = Shown::new(scene, row.outcome.mechanism.as_ref(), &row.method).fills();
    let poses = poses(scene, &frames, &displaced, &frame);
    // A string in a script must not be able to close it.
    let data = serde_json::to_string(&poses)
        .unwrap_or_default()
        .replace("</", "<\\/");
    let id = format!("replay-{}-{}", result.case.name, row.head_joints.name());
    let factor = crate::number::short(displaced.factor(), 0);
    let upper = row.outcome.bracket.map_or(0.0, |bracket| bracket.upper);
    let lambda = crate::number::number(upper, 5);
    html! {
        h3 id=(id) { "The collapse, replayed" }
        figure.replay aria-labelledby=(id) {
            (PreEscaped(stage(scene, &frame, [WIDTH, height], &result.case.name, &fills)))
            div.controls {
                button.play type="button" { "Play" }
                label { span { "Time" }
                    input type="range" min="0" max=(frames.len() - 1) value="0" step="1"
                        aria-label="Frame of the replay"; }
                output { "1 / " (frames.len()) }
            }
            figcaption { "Pushover at λ = " (lambda) ", " (row.head_joints.name()) " head joints: from the last "
                "rest until the collapse was called, displacements × " (factor) "." }
            script type="application/json" { (PreEscaped(data)) }
        }
    }
}

/// At most [`FRAMES`] frames, evenly, the last one among them.
fn thinned(recording: &[Mechanism]) -> Vec<&Mechanism> {
    let count = recording.len().min(FRAMES);
    let last = recording.len().saturating_sub(1);
    let pick = |k: usize| &recording[k * last / count.saturating_sub(1).max(1)];
    (0..count).map(pick).collect()
}

fn poses(scene: &Scene, frames: &[&Mechanism], displaced: &Displaced, frame: &Frame) -> Poses {
    let factor = displaced.factor();
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
fn stage(scene: &Scene, frame: &Frame, size: Px, name: &str, fills: &[&str]) -> String {
    let outline = |block: usize| {
        let mut path = Path::default();
        let corners = scene.blocks()[block].shape.corners().iter();
        let corners: Vec<Px> = corners.map(|&corner| frame.at(corner)).collect();
        path.add(&corners, true);
        path.d().to_owned()
    };
    let outlines: Vec<String> = (0..scene.blocks().len()).map(outline).collect();
    let [width, height] = size.map(px);
    let (low, high) = scene.bounds();
    let mut ground = Path::default();
    let [left, right] = [frame.at(low), frame.at(Point::new(high.x, low.y))];
    ground.add(
        &[[left[0] - 10.0, left[1]], [right[0] + 10.0, right[1]]],
        false,
    );
    let mut svg = format!(
        "<svg viewBox=\"0 0 {width} {height}\" width=\"{width}\" height=\"{height}\" role=\"img\" \
         aria-label=\"Collapse of {}\"><path class=\"ghost\" d=\"{}\"/>",
        escape(name),
        outlines.concat()
    );
    if !scene.supports().is_empty() && scene.coursing().is_some() {
        svg.push_str(&format!("<path class=\"ground\" d=\"{}\"/>", ground.d()));
    }
    svg.push_str("<g class=\"bodies\">");
    for (outline, fill) in outlines.iter().zip(fills) {
        svg.push_str(&format!("<path fill=\"{fill}\" d=\"{outline}\"/>"));
    }
    svg.push_str("</g></svg>");
    svg
}
