//! A mechanism as it is drawn: rigid parts in tints, joints that open and slide.

use super::frame::{Displacement, Frame};
use super::palette::{BLOCK_LINE, LARGEST, OPENING, PARTS, SLIDING, STILL};
use super::parts::{RigidPart, in_words, parts, threshold, tints};
use super::path::{Path, Pixel};
use super::svg::{Svg, style};
use super::wall::line_width;
use crate::answer::Mechanism;
use crate::scene::{Scene, Side};

/// A mechanism as it is drawn.
pub struct DrawnMechanism<'a> {
    /// The mechanism, where there is one.
    pub mechanism: Option<&'a Mechanism>,
    /// Where it takes every point.
    pub displacement: Displacement<'a>,
    /// Its rigid parts, as from [`parts`].
    parts: Vec<RigidPart>,
    /// A tint for each part; `None` for what stands still.
    tints: Vec<Option<usize>>,
    /// Rate below which a joint is at rest.
    at_rest: f64,
}

impl<'a> DrawnMechanism<'a> {
    /// The mechanism that a method found, or the wall at rest.
    pub fn new(scene: &'a Scene, mechanism: Option<&'a Mechanism>, method: &str) -> Self {
        let still = Mechanism {
            motions: vec![Default::default(); scene.blocks().len()],
        };
        let threshold = threshold(method);
        let parts = parts(scene, mechanism.unwrap_or(&still), threshold);
        Self {
            mechanism,
            displacement: Displacement::new(scene, mechanism),
            tints: tints(scene, &parts, PARTS.len() + 1),
            parts,
            at_rest: threshold * mechanism.map_or(0.0, |mechanism| mechanism.fastest(scene)),
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

fn fill(tint: Option<usize>) -> &'static str {
    match tint {
        None => STILL,
        Some(0) => LARGEST,
        Some(other) => PARTS[other - 1],
    }
}

/// Blocks where the mechanism takes them, each rigid part in one tint.
pub fn blocks(svg: &mut Svg, frame: &Frame, scene: &Scene, drawn: &DrawnMechanism) {
    let outline = |part: &RigidPart| {
        let mut path = Path::default();
        for &block in &part.blocks {
            let corners = drawn.displacement.corners(block);
            let corners: Vec<Pixel> = corners.map(|p| frame.at(p)).collect();
            path.add(&corners, true);
        }
        path
    };
    let line = style().class("blocks").stroke(BLOCK_LINE);
    svg.open(line.stroke_width(line_width(scene, frame)), "");
    for (part, tint) in drawn.parts.iter().zip(&drawn.tints) {
        let words = match drawn.mechanism {
            Some(mechanism) => in_words(scene, mechanism, part),
            None => String::new(),
        };
        let style = style().class("part").fill(fill(*tint));
        svg.path(&outline(part), style, &words);
    }
    svg.close();
}

/// Marks on the joints that open (the gap filled) and on those that slide (a strong line), with how
/// many there are of each.
pub fn marks(svg: &mut Svg, frame: &Frame, scene: &Scene, drawn: &DrawnMechanism) {
    let Some(mechanism) = drawn.mechanism else {
        return;
    };
    let (mut open, mut slide) = (Path::default(), Path::default());
    let mut counts = [0; 2];
    for (joint, rate) in scene.joints().iter().zip(mechanism.joint_rates(scene)) {
        let on = |side: Side| {
            joint
                .ends
                .map(|end| frame.at(drawn.displacement.on(side, end)))
        };
        let ([a, b], [c, d]) = (on(joint.from), on(Side::Block(joint.to)));
        if rate.opening[0].max(rate.opening[1]) > drawn.at_rest {
            open.add(&[a, b, d, c], true);
            counts[0] += 1;
        }
        if rate.slip.abs() > drawn.at_rest {
            let middle = |p: Pixel, q: Pixel| [(p[0] + q[0]) / 2.0, (p[1] + q[1]) / 2.0];
            slide.add(&[middle(a, c), middle(b, d)], false);
            counts[1] += 1;
        }
    }
    let width = (2.2 * line_width(scene, frame)).clamp(0.6, 2.0);
    let gap = style().class("opening").fill(OPENING).fill_opacity(0.5);
    let gap = gap.stroke(OPENING).stroke_width(width).dashes("1 2");
    svg.path(&open, gap, &counted(counts[0], "open"));
    let line = style().class("sliding").hollow().stroke(SLIDING);
    let line = line.stroke_width(width).round_ends();
    svg.path(&slide, line, &counted(counts[1], "slide"));
}

fn counted(joints: usize, verb: &str) -> String {
    match joints {
        1 => format!("1 joint {verb}s"),
        _ => format!("{joints} joints {verb}"),
    }
}
