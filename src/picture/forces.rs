//! Contact forces over a wall.

use super::axes::round_below;
use super::frame::Frame;
use super::legend::arrow_paths;
use super::palette::{FORCE, THRUST};
use super::svg::{Path, Svg, style};
use super::wall::line_width;
use crate::mechanics::{CourseResultant, JointForce, thrust};
use crate::number::short;
use crate::scene::{Joint, JointClass, Point, Scene, Vector};

/// Part of the scene's height that the line of the largest contact force is long.
const LONGEST: f64 = 0.16;

/// Resultant of a joint's force on the block that the normal points into: where it acts, and it.
fn resultant(joint: &Joint, force: &JointForce) -> Option<(Point, Vector)> {
    let [n1, n2] = force.normal;
    let sum = n1 + n2;
    if sum <= 0.0 || joint.class == JointClass::Guide {
        return None;
    }
    let at = joint.ends[0] + (joint.ends[1] - joint.ends[0]) * (n2 / sum).clamp(0.0, 1.0);
    Some((at, joint.normal * sum + joint.tangent() * force.shear))
}

/// Magnitude of the largest contact force; 0 without forces.
pub fn largest(scene: &Scene, forces: Option<&[JointForce]>) -> f64 {
    let joints = scene.joints().iter().zip(forces.unwrap_or_default());
    let found = joints.filter_map(|(joint, force)| resultant(joint, force));
    found.map(|(_, force)| force.norm()).fold(0.0, f64::max)
}

/// Pixels for a unit of force; `None` where no joint carries any.
fn pixels(scene: &Scene, frame_scale: f64, largest: f64) -> Option<f64> {
    (largest > 0.0).then(|| LONGEST * scene.height() * frame_scale / largest)
}

/// A round force, and the pixels that its arrow is long in a drawing of this scale; `None` without
/// forces.
pub fn round_force(scene: &Scene, forces: &[JointForce], scale: f64) -> Option<(f64, f64)> {
    let largest = largest(scene, Some(forces));
    let pixels = pixels(scene, scale, largest)?;
    let round = round_below(largest);
    Some((round, round * pixels))
}

/// Contact forces as arrows through the point of each joint where they act, on the block that they point
/// into. Their length is proportional to the force.
pub fn forces(svg: &mut Svg, frame: &Frame, scene: &Scene, forces: &[JointForce]) {
    let largest = largest(scene, Some(forces));
    let Some(pixels) = pixels(scene, frame.scale, largest) else {
        return;
    };
    let width = (1.8 * line_width(scene, frame)).clamp(0.6, 1.4);
    let (mut shafts, mut heads) = (Path::default(), Path::default());
    let joints = scene.joints().iter().zip(forces);
    for (at, force) in joints.filter_map(|(joint, force)| resultant(joint, force)) {
        let [x, y] = frame.at(at);
        let [dx, dy] = [0.5 * pixels * force.x, -0.5 * pixels * force.y];
        if dx.hypot(dy) > 0.15 {
            let (from, to) = ([x - dx, y - dy], [x + dx, y + dy]);
            arrow_paths(from, to, width, &mut shafts, &mut heads);
        }
    }
    let words = format!("contact forces, the largest {}", short(largest, 4));
    let line = style().class("forces").line(FORCE, width).round_ends();
    svg.path(&shafts, line, &words);
    svg.path(&heads, style().class("heads").fill(FORCE), "");
}

/// Lines of thrust through chains of blocks, or through piers: what there is more of.
pub fn lines_of_thrust(svg: &mut Svg, frame: &Frame, scene: &Scene, forces: &[JointForce]) {
    let thrust = thrust(scene, forces);
    let mut path = Path::default();
    let piers = piers(&thrust.courses);
    let links = thrust.lines.iter().map(|line| line.len() - 1);
    // In a coursed wall a chain is but a lintel and what it bears on.
    if piers.len() > links.sum() {
        for (below, above) in piers {
            path.add(&[frame.at(below), frame.at(above)], false);
        }
    } else {
        for line in &thrust.lines {
            let line: Vec<_> = line.iter().map(|&point| frame.at(point)).collect();
            path.add(&line, false);
        }
    }
    let line = style().class("thrust").line(THRUST, 1.2).round_ends();
    svg.path(&path, line, "line of thrust");
}

/// Where the resultants of each pier act, from one of its bed joints to the next: as far as it stands on
/// one stretch of bed joints and carries one.
fn piers(courses: &[CourseResultant]) -> Vec<(Point, Point)> {
    let levels: Vec<_> = courses.chunk_by(|a, b| a.level == b.level).collect();
    let overlap =
        |a: &CourseResultant, b: &CourseResultant| a.ends[0] < b.ends[1] && b.ends[0] < a.ends[1];
    let mut found = Vec::new();
    for pair in levels.windows(2) {
        for below in pair[0] {
            let mut above = pair[1].iter().filter(|of| overlap(of, below));
            let (Some(over), None) = (above.next(), above.next()) else {
                continue;
            };
            let stands_on_one = pair[0].iter().filter(|of| overlap(of, over)).count() == 1;
            if let (Some(x), Some(next), true) = (below.x, over.x, stands_on_one) {
                found.push((Point::new(x, below.level), Point::new(next, over.level)));
            }
        }
    }
    found
}
