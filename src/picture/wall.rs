//! The wall in its place: supports, and outlines of the blocks.

use super::frame::Frame;
use super::palette::{BEFORE, FRICTION, SUPPORT, SUPPORT_LINE};
use super::svg::{Path, Pixel, Svg, style};
use crate::scene::{Joint, JointClass, Point, Polygon, Scene, Vector};

/// Width of the thin outlines, which grows with the size that blocks are seen in.
pub fn line_width(scene: &Scene, frame: &Frame) -> f64 {
    let areas = scene.blocks().iter().map(|block| block.shape.area());
    let mean = areas.sum::<f64>() / scene.blocks().len() as f64;
    (frame.scale * mean.sqrt() / 40.0).clamp(0.25, 0.9)
}

/// Supports as far as `low` to `high` shows them: flat shapes under a strong edge. They are cut here
/// and not by a `clipPath`, whose identifier would have to differ between all drawings of a page.
pub fn supports(svg: &mut Svg, scene: &Scene, frame: &Frame, [low, high]: [Point; 2]) {
    let mut shapes = Path::default();
    let mut edges = Path::default();
    for (_, support) in scene.still_supports() {
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
    svg.path(&edges, style().line(SUPPORT_LINE, 1.6), "");
}

/// The outline of one block in its place.
pub fn outline(scene: &Scene, frame: &Frame, block: usize) -> Vec<Pixel> {
    let corners = scene.blocks()[block].shape.corners().iter();
    corners.map(|&corner| frame.at(corner)).collect()
}

pub fn outlines(svg: &mut Svg, scene: &Scene, frame: &Frame) {
    let mut path = Path::default();
    for block in 0..scene.blocks().len() {
        path.add(&outline(scene, frame, block), true);
    }
    let line = style()
        .class("before")
        .line(BEFORE, line_width(scene, frame));
    svg.path(&path, line, "");
}

/// The part of a polygon that lies in a box; empty where none does. Parts of one that bends inwards are
/// joined along the box.
fn clipped(polygon: &Polygon, low: Point, high: Point) -> Vec<Point> {
    let mut corners = polygon.corners().to_vec();
    // Half-planes n·p ≤ d.
    let sides = [
        (Vector::new(1.0, 0.0), high.x),
        (Vector::new(-1.0, 0.0), -low.x),
        (Vector::new(0.0, 1.0), high.y),
        (Vector::new(0.0, -1.0), -low.y),
    ];
    for (normal, distance) in sides {
        let beyond = |p: &Point| normal.dot(&p.coords) - distance;
        let mut kept = Vec::with_capacity(corners.len() + 1);
        for (i, a) in corners.iter().enumerate() {
            let b = &corners[(i + 1) % corners.len()];
            let (out_a, out_b) = (beyond(a), beyond(b));
            if out_a <= 0.0 {
                kept.push(*a);
            }
            if (out_a < 0.0 && out_b > 0.0) || (out_a > 0.0 && out_b < 0.0) {
                // Exactly on the line, by which it is known that the cut made this edge.
                let mut cut = a + (b - a) * (out_a / (out_a - out_b));
                let axis = if normal.x == 0.0 { 1 } else { 0 };
                cut[axis] = distance * normal[axis];
                kept.push(cut);
            }
        }
        corners = kept;
    }
    corners
}

/// Joints whose friction is not what most of their class have, the rough and the smooth ones apart.
pub fn own_frictions(scene: &Scene) -> Vec<(f64, Vec<&Joint>)> {
    let mut found: Vec<(f64, Vec<&Joint>)> = Vec::new();
    for class in JointClass::ALL {
        let mut of_class: Vec<(f64, Vec<&Joint>)> = Vec::new();
        for joint in scene.joints().iter().filter(|joint| joint.class == class) {
            add(&mut of_class, joint.friction, [joint]);
        }
        // Of two that are as frequent the smaller one is the odd one.
        of_class.sort_by(|a, b| {
            (a.1.len(), a.0)
                .partial_cmp(&(b.1.len(), b.0))
                .expect("finite")
        });
        of_class.pop();
        for (friction, joints) in of_class {
            add(&mut found, friction, joints);
        }
    }
    found.sort_by(|a, b| a.0.total_cmp(&b.0));
    found
}

fn add<'a>(
    to: &mut Vec<(f64, Vec<&'a Joint>)>,
    friction: f64,
    joints: impl IntoIterator<Item = &'a Joint>,
) {
    match to.iter_mut().find(|(known, _)| *known == friction) {
        Some((_, known)) => known.extend(joints),
        None => to.push((friction, joints.into_iter().collect())),
    }
}

/// Marks on the joints that have a friction of their own, in their place.
pub fn frictions(svg: &mut Svg, scene: &Scene, frame: &Frame) {
    for (friction, joints) in own_frictions(scene) {
        let mut path = Path::default();
        for joint in joints {
            path.add(&joint.ends.map(|end| frame.at(end)), false);
        }
        let line = style().class("friction").line(FRICTION, 2.0).dashes("5 3");
        svg.path(&path, line, &format!("friction {friction}"));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_support_is_cut_to_the_drawing() {
        let ground = Polygon::rectangle(-50.0, 50.0, -3.0, 0.0).unwrap();
        let seen = clipped(&ground, Point::new(-1.0, -1.0), Point::new(9.0, 4.0));
        let area: f64 = (0..4)
            .map(|i| seen[i].coords.perp(&seen[(i + 1) % 4].coords))
            .sum();
        assert_eq!((seen.len(), area / 2.0), (4, 10.0));
        assert!(clipped(&ground, Point::new(0.0, 1.0), Point::new(1.0, 2.0)).is_empty());
    }
}
