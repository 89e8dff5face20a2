//! The wall in its place: supports, and outlines of the blocks.

use super::frame::{Frame, clipped};
use super::palette::{BEFORE, SUPPORT, SUPPORT_LINE};
use super::path::{Path, Pixel};
use super::svg::{Svg, style};
use crate::scene::{Point, Scene};

/// Width of the thin outlines, which grows with the size that blocks are seen in.
pub fn line_width(scene: &Scene, frame: &Frame) -> f64 {
    let mean = scene
        .blocks()
        .iter()
        .map(|block| block.shape.area())
        .sum::<f64>()
        / scene.blocks().len() as f64;
    (frame.scale * mean.sqrt() / 40.0).clamp(0.25, 0.9)
}

/// Supports as far as `low` to `high` shows them: flat shapes under a strong edge. They are cut here
/// and not by a `clipPath`, whose identifier would have to differ between all drawings of a page.
pub fn supports(svg: &mut Svg, scene: &Scene, frame: &Frame, [low, high]: [Point; 2]) {
    let mut shapes = Path::default();
    let mut edges = Path::default();
    for support in scene.still_supports() {
        let seen = clipped(&support, low, high);
        let points: Vec<Pixel> = seen.iter().map(|&corner| frame.at(corner)).collect();
        shapes.add(&points, true);
        // The edges that the cut left, not those that it made.
        for (i, a) in seen.iter().enumerate() {
            let b = seen[(i + 1) % seen.len()];
            let on = |x: fn(&Point) -> f64, at: f64| x(a) == at && x(&b) == at;
            let cut = on(|p| p.x, low.x) || on(|p| p.x, high.x);
            if !(cut || on(|p| p.y, low.y) || on(|p| p.y, high.y)) {
                edges.add(&[frame.at(*a), frame.at(b)], false);
            }
        }
    }
    let fill = style().class("support").fill(SUPPORT);
    svg.path(&shapes, fill, "support: never moves");
    let line = style().hollow().stroke(SUPPORT_LINE).stroke_width(1.6);
    svg.path(&edges, line, "");
}

/// The outline of one block in its place.
pub fn outline(scene: &Scene, frame: &Frame, block: usize) -> Vec<Pixel> {
    let corners = scene.blocks()[block].shape.corners().iter();
    corners.map(|&corner| frame.at(corner)).collect()
}

/// Outlines of all blocks in their place.
pub fn outlines(svg: &mut Svg, scene: &Scene, frame: &Frame) {
    let mut path = Path::default();
    for block in 0..scene.blocks().len() {
        path.add(&outline(scene, frame, block), true);
    }
    let line = style().class("before").hollow().stroke(BEFORE);
    svg.path(&path, line.stroke_width(line_width(scene, frame)), "");
}
