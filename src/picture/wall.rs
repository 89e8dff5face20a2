//! The wall itself: supports, blocks over their outline, joints that slide and open, forces.

use super::frame::{Displaced, Frame, clipped};
use super::palette::{
    BEFORE, BLOCK_LINE, FORCE, LARGEST, OPENING, PARTS, SLIDING, STILL, SUPPORT, SUPPORT_LINE,
};
use super::parts::{Part, in_words, parts, threshold, tints};
use super::svg::{Path, Px, Svg};
use crate::answer::{JointForce, Mechanism};
use crate::scene::{Point, Scene, Side, Vector};

/// Width of the thin outlines, which grows with the size that blocks are seen in.
fn line_width(scene: &Scene, frame: &Frame) -> f64 {
    let mean = scene
        .blocks()
        .iter()
        .map(|block| block.shape.area())
        .sum::<f64>()
        / scene.blocks().len() as f64;
    (frame.scale * mean.sqrt() / 40.0).clamp(0.25, 0.9)
}

/// Supports as far as `low` to `high` shows them: flat shapes under a strong edge.
pub fn supports(svg: &mut Svg, scene: &Scene, frame: &Frame, [low, high]: [Point; 2]) {
    let mut shapes = Path::default();
    let mut edges = Path::default();
    for support in scene.supports() {
        let seen = clipped(support, low, high);
        let points: Vec<Px> = seen.iter().map(|&corner| frame.at(corner)).collect();
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
    let fill = format!("class=\"support\" fill=\"{SUPPORT}\"");
    svg.path(&shapes, fill, "support: never moves");
    let line = format!("fill=\"none\" stroke=\"{SUPPORT_LINE}\" stroke-width=\"1.6\"");
    svg.path(&edges, line, "");
}

/// Outlines of all blocks in their place.
pub fn outlines(svg: &mut Svg, scene: &Scene, frame: &Frame) {
    let mut path = Path::default();
    for block in scene.blocks() {
        let corners: Vec<Px> = block.shape.corners().iter().map(|&p| frame.at(p)).collect();
        path.add(&corners, true);
    }
    let width = super::svg::px(line_width(scene, frame));
    let attributes =
        format!("class=\"before\" fill=\"none\" stroke=\"{BEFORE}\" stroke-width=\"{width}\"");
    svg.path(&path, attributes, "");
}

/// Blocks where `displaced` shows them, each rigid part in one tint.
pub fn blocks(svg: &mut Svg, frame: &Frame, scene: &Scene, shown: &Shown) {
    let width = super::svg::px(line_width(scene, frame));
    let outline = |part: &Part| {
        let mut path = Path::default();
        for &block in &part.blocks {
            let corners: Vec<Px> = shown
                .displaced
                .corners(block)
                .map(|p| frame.at(p))
                .collect();
            path.add(&corners, true);
        }
        path
    };
    svg.open(format!(
        "class=\"blocks\" stroke=\"{BLOCK_LINE}\" stroke-width=\"{width}\""
    ));
    for (part, tint) in shown.parts.iter().zip(&shown.tints) {
        let fill = fill(*tint);
        let words = match shown.mechanism {
            Some(mechanism) => in_words(scene, mechanism, part),
            None => String::new(),
        };
        svg.path(
            &outline(part),
            format!("class=\"part\" fill=\"{fill}\""),
            &words,
        );
    }
    svg.close();
}

fn fill(tint: Option<usize>) -> &'static str {
    match tint {
        None => STILL,
        Some(0) => LARGEST,
        Some(other) => PARTS[other - 1],
    }
}

/// A mechanism as it is shown.
pub struct Shown<'a> {
    /// The mechanism, where there is one.
    pub mechanism: Option<&'a Mechanism>,
    /// Where it takes every point.
    pub displaced: Displaced<'a>,
    /// Its rigid parts, as from [`parts`].
    pub parts: Vec<Part>,
    /// A tint for each part; `None` for what stands still.
    pub tints: Vec<Option<usize>>,
    /// Rate below which a joint is at rest.
    limit: f64,
}

impl<'a> Shown<'a> {
    /// The mechanism that a method found, or the wall at rest.
    pub fn new(scene: &'a Scene, mechanism: Option<&'a Mechanism>, method: &str) -> Self {
        let still = Mechanism {
            motions: vec![Default::default(); scene.blocks().len()],
        };
        let threshold = threshold(method);
        let parts = parts(scene, mechanism.unwrap_or(&still), threshold);
        Self {
            mechanism,
            displaced: Displaced::new(scene, mechanism),
            tints: tints(scene, &parts, PARTS.len() + 1),
            parts,
            limit: threshold * mechanism.map_or(0.0, |mechanism| mechanism.fastest(scene)),
        }
    }

    /// The colour of every block.
    pub fn fills(&self) -> Vec<&'static str> {
        let count = self.parts.iter().map(|part| part.blocks.len()).sum();
        let mut fills = vec![STILL; count];
        for (part, tint) in self.parts.iter().zip(&self.tints) {
            for &block in &part.blocks {
                fills[block] = fill(*tint);
            }
        }
        fills
    }
}

/// Marks on the joints that open (the gap filled) and on those that slide (a strong line), with how
/// many there are of each.
pub fn marks(svg: &mut Svg, frame: &Frame, scene: &Scene, shown: &Shown) {
    let Some(mechanism) = shown.mechanism else {
        return;
    };
    let (mut open, mut slide) = (Path::default(), Path::default());
    let mut counts = [0; 2];
    for (joint, rate) in scene.joints().iter().zip(mechanism.joint_rates(scene)) {
        let on = |side: Side| {
            joint
                .ends
                .map(|end| frame.at(shown.displaced.on(side, end)))
        };
        let ([a, b], [c, d]) = (on(joint.from), on(Side::Block(joint.to)));
        if rate.opening[0].max(rate.opening[1]) > shown.limit {
            open.add(&[a, b, d, c], true);
            counts[0] += 1;
        }
        if rate.slip.abs() > shown.limit {
            let middle = |p: Px, q: Px| [(p[0] + q[0]) / 2.0, (p[1] + q[1]) / 2.0];
            slide.add(&[middle(a, c), middle(b, d)], false);
            counts[1] += 1;
        }
    }
    let width = super::svg::px((2.2 * line_width(scene, frame)).clamp(0.6, 2.0));
    svg.path(
        &open,
        format!(
            "class=\"opening\" fill=\"{OPENING}\" fill-opacity=\"0.5\" stroke=\"{OPENING}\" \
             stroke-width=\"{width}\" stroke-dasharray=\"1 2\""
        ),
        &counted(counts[0], "open"),
    );
    svg.path(
        &slide,
        format!(
            "class=\"sliding\" fill=\"none\" stroke=\"{SLIDING}\" stroke-width=\"{width}\" \
             stroke-linecap=\"round\""
        ),
        &counted(counts[1], "slide"),
    );
}

fn counted(joints: usize, verb: &str) -> String {
    match joints {
        1 => format!("1 joint {verb}s"),
        _ => format!("{joints} joints {verb}"),
    }
}

/// Resultant of a joint's force on the block that the normal points into: where it acts, and it.
fn resultant(joint: &crate::scene::Joint, force: &JointForce) -> Option<(Point, Vector)> {
    let [n1, n2] = force.normal;
    let sum = n1 + n2;
    if sum <= 0.0 {
        return None;
    }
    let at = joint.ends[0] + (joint.ends[1] - joint.ends[0]) * (n2 / sum).clamp(0.0, 1.0);
    Some((at, joint.normal * sum + joint.tangent() * force.shear))
}

/// Magnitude of the largest contact force; 0 without forces.
pub fn largest_force(scene: &Scene, forces: Option<&[JointForce]>) -> f64 {
    let joints = scene.joints().iter().zip(forces.unwrap_or_default());
    let found = joints.filter_map(|(joint, force)| resultant(joint, force));
    found.map(|(_, force)| force.norm()).fold(0.0, f64::max)
}

/// Contact forces as lines through the point of each joint where they act, as long as they are
/// large.
pub fn forces(svg: &mut Svg, frame: &Frame, scene: &Scene, forces: &[JointForce]) {
    let largest = largest_force(scene, Some(forces));
    if largest <= 0.0 {
        return;
    }
    let longest = LONGEST_FORCE * scene.height();
    let mut path = Path::default();
    let joints = scene.joints().iter().zip(forces);
    for (at, force) in joints.filter_map(|(joint, force)| resultant(joint, force)) {
        let half = force * (0.5 * longest / largest);
        if half.norm() * frame.scale > 0.15 {
            path.add(&[frame.at(at - half), frame.at(at + half)], false);
        }
    }
    let width = super::svg::px((1.8 * line_width(scene, frame)).clamp(0.6, 1.6));
    let attributes = format!(
        "class=\"forces\" fill=\"none\" stroke=\"{FORCE}\" stroke-width=\"{width}\" \
         stroke-linecap=\"round\""
    );
    let words = format!(
        "contact forces, the largest {}",
        crate::number::short(largest, 4)
    );
    svg.path(&path, attributes, &words);
}

/// Part of the scene's height that the line of the largest contact force is long.
const LONGEST_FORCE: f64 = 0.16;
